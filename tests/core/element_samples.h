// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of single shell elements, for the tests of their kinematics.
#pragma once

#include "core/shells/element_kinematics.h"

#include <random>

namespace birdstrike::samples {

//! Numbers in -1 ... 1, the same in every run.
class Numbers
{
public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double operator()() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  Vector3 vector() { return {(*this)(), (*this)(), (*this)()}; }

private:
  std::mt19937 engine_;
};

//! Velocity and spin of the first \p n corners, as functions of their places in the element's axes.
template <class Velocity, class Spin>
CornerMotion motion_of(const ElementGeometry& g, int n, const Velocity& velocity, const Spin& spin)
{
  CornerMotion m{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
    const Vector3 place(g.x[k], g.y[k], g.z[k]), v = velocity(place), w = spin(place);
    m.vx[k] = v[0];
    m.vy[k] = v[1];
    m.vz[k] = v[2];
    m.wx[k] = w[0];
    m.wy[k] = w[1];
    m.wz[k] = w[2];
  }
  return m;
}

//! Power of corner forces [W].
inline double power(const CornerForces& f, const CornerMotion& m)
{
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k)
    sum += f.fx[k] * m.vx[k] + f.fy[k] * m.vy[k] + f.fz[k] * m.vz[k] + f.mx[k] * m.wx[k] + f.my[k] * m.wy[k] +
           f.mz[k] * m.wz[k];
  return sum;
}

//! Power of resultants over an area [W].
inline double power(const Resultants& s, const StrainRates& r, double area)
{
  double sum = s.drill * r.drill;
  for (int k = 0; k < 3; ++k)
    sum += s.force[k] * r.membrane[k] + s.moment[k] * r.curvature[k];
  return area * (sum + s.shear[0] * r.shear[0] + s.shear[1] * r.shear[1]);
}

inline Resultants random_resultants(Numbers& next)
{
  return {{next(), next(), next()}, {next(), next(), next()}, {next(), next()}, next()};
}

} // namespace birdstrike::samples
