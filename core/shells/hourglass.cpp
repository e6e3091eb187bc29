// SPDX-License-Identifier: BSD-3-Clause
#include "core/shells/hourglass.h"

namespace birdstrike {

namespace {

double dot(const PerCorner& a, const PerCorner& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

void turn_by(double angle, double& x, double& y)
{
  const double before = x;
  x -= angle * y;
  y += angle * before;
}

} // namespace

HourglassModuli hourglass_moduli(const ElementGeometry& g, double young, double shear_modulus,
                                 double thickness, double coefficient)
{
  const double bb = dot(g.bx, g.bx) + dot(g.by, g.by), t3 = thickness * thickness * thickness;
  return {coefficient * young * thickness * g.area * bb / 8,
          coefficient * shear_correction * shear_modulus * t3 * bb / 12,
          coefficient * young * t3 * g.area * bb / 192};
}

PerCorner hourglass_pattern(const ElementGeometry& g)
{
  constexpr PerCorner h{1, -1, 1, -1};
  const double hx = dot(h, g.x), hy = dot(h, g.y);
  PerCorner pattern;
  for (int k = 0; k < 4; ++k)
    pattern[k] = h[k] - hx * g.bx[k] - hy * g.by[k];
  return pattern;
}

double advance(HourglassForces& f, const HourglassModuli& moduli, const ElementGeometry& g,
               const CornerMotion& m, double turn, double dt)
{
  turn_by(turn, f.membrane_x, f.membrane_y);
  turn_by(turn, f.bend_x, f.bend_y);
  const PerCorner pattern = hourglass_pattern(g);
  // Spins about axes 1 and 2 move corners at heights of +-warp, which is the pattern times 4 warp.
  const double tilt_x = 4 * g.warp * dot(g.bx, m.vz), tilt_y = 4 * g.warp * dot(g.by, m.vz);
  double work = 0;
  const auto step = [&](double& force, double modulus, double rate) {
    const double motion = dt * rate, before = force;
    force += modulus * motion;
    work += 0.5 * (before + force) * motion;
  };
  step(f.membrane_x, moduli.membrane, dot(pattern, m.vx) + tilt_x);
  step(f.membrane_y, moduli.membrane, dot(pattern, m.vy) + tilt_y);
  step(f.lift, moduli.lift, dot(pattern, m.vz));
  step(f.bend_x, moduli.bend, dot(pattern, m.wx));
  step(f.bend_y, moduli.bend, dot(pattern, m.wy));
  return work;
}

void add_forces(const HourglassForces& f, const ElementGeometry& g, CornerForces& c)
{
  const PerCorner pattern = hourglass_pattern(g);
  for (int k = 0; k < 4; ++k) {
    c.fx[k] += pattern[k] * f.membrane_x;
    c.fy[k] += pattern[k] * f.membrane_y;
    c.fz[k] += pattern[k] * f.lift + 4 * g.warp * (g.bx[k] * f.membrane_x + g.by[k] * f.membrane_y);
    c.mx[k] += pattern[k] * f.bend_x;
    c.my[k] += pattern[k] * f.bend_y;
  }
}

} // namespace birdstrike
