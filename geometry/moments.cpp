// SPDX-License-Identifier: GPL-3.0-or-later
// Volume, centre and inertia of bodies.
#include "geometry/moments.h"

#include "geometry/measure.h"

namespace birdstrike {

void Moments::add(double much, const Vector3& at, const Matrix3& spread)
{
  amount += much;
  first += much * at;
  second += much * at * at.transpose() + spread;
}

Moments& Moments::operator+=(const Moments& other)
{
  amount += other.amount;
  first += other.first;
  second += other.second;
  return *this;
}

Moments& Moments::operator-=(const Moments& other) { return *this += other * -1; }

Moments Moments::operator*(double factor) const { return {factor * amount, factor * first, factor * second}; }

Vector3 Moments::centre() const { return amount != 0 ? Vector3(first / amount) : Vector3(Vector3::Zero()); }

Matrix3 Moments::inertia() const
{
  const Vector3 middle = centre();
  const Matrix3 about = second - amount * middle * middle.transpose();
  return about.trace() * Matrix3::Identity() - about;
}

// A tetrahedron from the origin: its integral of x x^T is V/20 (s s^T + a a^T + b b^T + c c^T), s = a + b + c.
Moments moments_of(const SurfacePart& part)
{
  const Vector3 origin = bounding_box(part).centre(); // far from it the sums would lose digits
  Moments sum;
  for (const auto& t : part.triangles) {
    const Vector3 a = part.points[t[0]] - origin, b = part.points[t[1]] - origin,
                  c = part.points[t[2]] - origin;
    const double volume = a.dot(b.cross(c)) / 6;
    const Vector3 s = a + b + c;
    sum.amount += volume;
    sum.first += 0.25 * volume * s;
    sum.second +=
        volume / 20 * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  Moments moved;
  moved.amount = sum.amount;
  moved.first = sum.first + sum.amount * origin;
  moved.second = sum.second + origin * sum.first.transpose() + sum.first * origin.transpose() +
                 sum.amount * origin * origin.transpose();
  return moved;
}

} // namespace birdstrike
