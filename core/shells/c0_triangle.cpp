// SPDX-License-Identifier: BSD-3-Clause
#include "core/shells/c0_triangle.h"

#include <cmath>

namespace birdstrike {

namespace {

//! Shear at the centroid from the shears of the sides, g = w_b - w_a + d . (beta_a + beta_b) / 2 with
//! beta = (wy, -wx): along side 0-1 it is g01 + c / 3 and along 0-2 g02 - c / 3, c = g02 - g01 - g12.
struct Shear
{
  PerCorner yz_z{}, yz_x{}, yz_y{}; //!< gamma yz over vz, wx, wy of the corners
  PerCorner zx_z{}, zx_x{}, zx_y{};
  PerCorner closure_z{}, closure_x{}, closure_y{}; //!< c over the same
};

Shear shear_of(const ElementGeometry& g)
{
  struct Side
  {
    PerCorner z{}, x{}, y{};
  };
  const auto side = [&g](int a, int b) {
    Side s;
    const double dx = g.x[b] - g.x[a], dy = g.y[b] - g.y[a];
    s.z[a] = -1;
    s.z[b] = 1;
    s.x[a] = s.x[b] = -0.5 * dy;
    s.y[a] = s.y[b] = 0.5 * dx;
    return s;
  };
  const Side s01 = side(0, 1), s02 = side(0, 2), s12 = side(1, 2);
  const double x1 = g.x[1] - g.x[0], y1 = g.y[1] - g.y[0], x2 = g.x[2] - g.x[0], y2 = g.y[2] - g.y[0];
  const double f = 1 / (x1 * y2 - x2 * y1); // of (zx, yz) from what they are along the two sides
  Shear out;
  const auto combine = [&](PerCorner Side::*part, PerCorner& zx, PerCorner& yz, PerCorner& closure) {
    for (int k = 0; k < 3; ++k) {
      const double c = (s02.*part)[k] - (s01.*part)[k] - (s12.*part)[k];
      const double along1 = (s01.*part)[k] + c / 3, along2 = (s02.*part)[k] - c / 3;
      zx[k] = f * (y2 * along1 - y1 * along2);
      yz[k] = f * (x1 * along2 - x2 * along1);
      closure[k] = c;
    }
  };
  combine(&Side::z, out.zx_z, out.yz_z, out.closure_z);
  combine(&Side::x, out.zx_x, out.yz_x, out.closure_x);
  combine(&Side::y, out.zx_y, out.yz_y, out.closure_y);
  return out;
}

double dot(const PerCorner& a, const PerCorner& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

} // namespace

ElementGeometry triangle_geometry(const std::array<Vector3, 4>& corners)
{
  ElementGeometry g{};
  const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
  const Vector3 side = corners[1] - corners[0];
  const Vector3 normal = side.cross(corners[2] - corners[0]).normalized();
  g.axes.col(0) = side.normalized();
  g.axes.col(1) = normal.cross(g.axes.col(0));
  g.axes.col(2) = normal;
  for (int k = 0; k < 3; ++k) {
    const Vector3 from = corners[k] - middle;
    g.x[k] = from.dot(g.axes.col(0));
    g.y[k] = from.dot(g.axes.col(1));
  }
  const double twice = (g.x[1] - g.x[0]) * (g.y[2] - g.y[0]) - (g.x[2] - g.x[0]) * (g.y[1] - g.y[0]);
  g.area = 0.5 * twice;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    g.bx[k] = (g.y[next] - g.y[last]) / twice;
    g.by[k] = (g.x[last] - g.x[next]) / twice;
  }
  return g;
}

TriangleRates triangle_strain_rates(const ElementGeometry& g, const CornerMotion& m)
{
  const Shear s = shear_of(g);
  const double vx_y = dot(g.by, m.vx), vy_x = dot(g.bx, m.vy);
  TriangleRates t;
  StrainRates& r = t.rates;
  r.membrane[0] = dot(g.bx, m.vx);
  r.membrane[1] = dot(g.by, m.vy);
  r.membrane[2] = vx_y + vy_x;
  r.curvature[0] = dot(g.bx, m.wy);
  r.curvature[1] = -dot(g.by, m.wx);
  r.curvature[2] = dot(g.by, m.wy) - dot(g.bx, m.wx);
  r.shear[0] = dot(s.yz_z, m.vz) + dot(s.yz_x, m.wx) + dot(s.yz_y, m.wy);
  r.shear[1] = dot(s.zx_z, m.vz) + dot(s.zx_x, m.wx) + dot(s.zx_y, m.wy);
  r.drill = (m.wz[0] + m.wz[1] + m.wz[2]) / 3 - 0.5 * (vy_x - vx_y);
  r.spin = 0.5 * (vy_x - vx_y) - (m.vy[1] - m.vy[0]) / (g.x[1] - g.x[0]);
  t.closure = dot(s.closure_z, m.vz) + dot(s.closure_x, m.wx) + dot(s.closure_y, m.wy);
  return t;
}

CornerForces triangle_forces(const ElementGeometry& g, const Resultants& r, double closure_force)
{
  const Shear s = shear_of(g);
  const double a = g.area;
  CornerForces c{};
  for (int k = 0; k < 3; ++k) {
    c.fx[k] = a * (g.bx[k] * r.force[0] + g.by[k] * (r.force[2] + 0.5 * r.drill));
    c.fy[k] = a * (g.by[k] * r.force[1] + g.bx[k] * (r.force[2] - 0.5 * r.drill));
    c.mz[k] = a / 3 * r.drill;
    c.fz[k] = a * (s.yz_z[k] * r.shear[0] + s.zx_z[k] * r.shear[1]) + s.closure_z[k] * closure_force;
    c.mx[k] = -a * (g.by[k] * r.moment[1] + g.bx[k] * r.moment[2]) +
              a * (s.yz_x[k] * r.shear[0] + s.zx_x[k] * r.shear[1]) + s.closure_x[k] * closure_force;
    c.my[k] = a * (g.bx[k] * r.moment[0] + g.by[k] * r.moment[2]) +
              a * (s.yz_y[k] * r.shear[0] + s.zx_y[k] * r.shear[1]) + s.closure_y[k] * closure_force;
  }
  return c;
}

double triangle_shear_bound(const ElementGeometry& g, double inertia, double closing)
{
  const Shear s = shear_of(g);
  const auto product = [&](const PerCorner& az, const PerCorner& ax, const PerCorner& ay, const PerCorner& bz,
                           const PerCorner& bx, const PerCorner& by) {
    return dot(az, bz) + (dot(ax, bx) + dot(ay, by)) / inertia;
  };
  const double yy = product(s.yz_z, s.yz_x, s.yz_y, s.yz_z, s.yz_x, s.yz_y),
               xx = product(s.zx_z, s.zx_x, s.zx_y, s.zx_z, s.zx_x, s.zx_y),
               xy = product(s.yz_z, s.yz_x, s.yz_y, s.zx_z, s.zx_x, s.zx_y);
  return 0.5 * (xx + yy + std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy)) +
         closing * product(s.closure_z, s.closure_x, s.closure_y, s.closure_z, s.closure_x, s.closure_y);
}

} // namespace birdstrike
