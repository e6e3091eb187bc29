// SPDX-License-Identifier: BSD-3-Clause
#include "core/shells/belytschko_tsay.h"

#include <cmath>

namespace birdstrike {

namespace {

double dot(const PerCorner& a, const PerCorner& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

//! Change of bx and by with height over the middle surface of a warped element, and what the tilt of its corners'
//! normals against axis 3 adds when it spins about that axis.
//!
//! A corner at (xi, eta) of z = warp xi eta has the normal (-z,x, -z,y, 1); the surface at height h runs through
//! x + h n. Its gradients to first order in h are bx + h cx, by + h cy.
struct WarpTerms
{
  PerCorner cx, cy;                 //!< [1/m2]
  double spin_xx, spin_yy, spin_xy; //!< curvature rate over spin [1/m]
};

WarpTerms warp_terms(const ElementGeometry& g)
{
  const double c = 2 * g.warp / (g.area * g.area);
  const double x02 = g.x[0] - g.x[2], x31 = g.x[3] - g.x[1], y02 = g.y[0] - g.y[2], y31 = g.y[3] - g.y[1];
  WarpTerms w;
  w.cx = {c * x02, c * x31, -c * x02, -c * x31};
  w.cy = {c * y02, c * y31, -c * y02, -c * y31};
  // Slopes of z at corners: z,xi = warp eta, z,eta = warp xi, turned into x and y by the Jacobian of the middle, whose
  // determinant is area / 4. With a = d x / d xi and so on.
  const double a = 0.25 * (-g.x[0] + g.x[1] + g.x[2] - g.x[3]),
               b = 0.25 * (-g.y[0] + g.y[1] + g.y[2] - g.y[3]);
  const double d = 0.25 * (-g.x[0] - g.x[1] + g.x[2] + g.x[3]),
               e = 0.25 * (-g.y[0] - g.y[1] + g.y[2] + g.y[3]);
  constexpr PerCorner xi{-1, 1, 1, -1}, eta{-1, -1, 1, 1};
  PerCorner nx, ny;
  for (int k = 0; k < 4; ++k) {
    const double slope = 4 * g.warp / g.area;
    nx[k] = -slope * (eta[k] * e - xi[k] * b);
    ny[k] = -slope * (xi[k] * a - eta[k] * d);
  }
  w.spin_xx = -dot(g.bx, ny);
  w.spin_yy = dot(g.by, nx);
  w.spin_xy = dot(g.bx, nx) - dot(g.by, ny);
  return w;
}

} // namespace

ElementGeometry quad_geometry(const std::array<Vector3, 4>& corners)
{
  ElementGeometry g;
  const Vector3 middle = 0.25 * ((corners[0] + corners[1]) + (corners[2] + corners[3]));
  const Vector3 across = (corners[2] - corners[0]).cross(corners[3] - corners[1]); // twice the area long
  const double twice = std::sqrt(across.squaredNorm());
  const Vector3 normal = across * (1 / twice), side = corners[1] - corners[0];
  const double rise = side.dot(normal);
  const Vector3 flat = side - rise * normal, first = flat * (1 / std::sqrt(flat.squaredNorm()));
  g.axes.col(0) = first;
  g.axes.col(1) = normal.cross(first);
  g.axes.col(2) = normal;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector3 from = corners[k] - middle;
    g.x[k] = from.dot(first);
    g.y[k] = from.dot(g.axes.col(1));
  }
  // The normal is across both diagonals: their ends are at one height, +-warp, in turn.
  g.warp = -0.5 * rise;
  g.z = {g.warp, -g.warp, g.warp, -g.warp};
  g.area = 0.5 * twice;
  const double f = 1 / twice;
  const double x20 = f * (g.x[2] - g.x[0]), y20 = f * (g.y[2] - g.y[0]), x31 = f * (g.x[3] - g.x[1]),
               y31 = f * (g.y[3] - g.y[1]);
  g.bx = {-y31, y20, y31, -y20};
  g.by = {x31, -x20, -x31, x20};
  return g;
}

StrainRates quad_strain_rates(const ElementGeometry& g, const CornerMotion& m, bool warping)
{
  const double vx_y = dot(g.by, m.vx), vy_x = dot(g.bx, m.vy);
  StrainRates r;
  r.membrane[0] = dot(g.bx, m.vx);
  r.membrane[1] = dot(g.by, m.vy);
  r.membrane[2] = vx_y + vy_x;
  r.curvature[0] = dot(g.bx, m.wy);
  r.curvature[1] = -dot(g.by, m.wx);
  r.curvature[2] = dot(g.by, m.wy) - dot(g.bx, m.wx);
  r.shear[0] = dot(g.by, m.vz) - 0.25 * (m.wx[0] + m.wx[1] + m.wx[2] + m.wx[3]);
  r.shear[1] = dot(g.bx, m.vz) + 0.25 * (m.wy[0] + m.wy[1] + m.wy[2] + m.wy[3]);
  const double spin = 0.5 * (vy_x - vx_y);
  r.drill = 0.25 * (m.wz[0] + m.wz[1] + m.wz[2] + m.wz[3]) - spin;
  // The axes turn with the projection of their side, from which a tilt of the normal takes the side's rise.
  r.spin = spin - (m.vy[1] - m.vy[0] + (g.z[1] - g.z[0]) * dot(g.by, m.vz)) / (g.x[1] - g.x[0]);
  if (warping) {
    const WarpTerms w = warp_terms(g);
    r.curvature[0] += dot(w.cx, m.vx) + spin * w.spin_xx;
    r.curvature[1] += dot(w.cy, m.vy) + spin * w.spin_yy;
    r.curvature[2] += dot(w.cx, m.vy) + dot(w.cy, m.vx) + spin * w.spin_xy;
  }
  return r;
}

CornerForces quad_forces(const ElementGeometry& g, const Resultants& s, bool warping)
{
  const double a = g.area;
  CornerForces c;
  for (int k = 0; k < 4; ++k) {
    c.fx[k] = a * (g.bx[k] * s.force[0] + g.by[k] * (s.force[2] + 0.5 * s.drill));
    c.fy[k] = a * (g.by[k] * s.force[1] + g.bx[k] * (s.force[2] - 0.5 * s.drill));
    c.fz[k] = a * (g.by[k] * s.shear[0] + g.bx[k] * s.shear[1]);
    c.mx[k] = -a * (g.by[k] * s.moment[1] + g.bx[k] * s.moment[2] + 0.25 * s.shear[0]);
    c.my[k] = a * (g.bx[k] * s.moment[0] + g.by[k] * s.moment[2] + 0.25 * s.shear[1]);
    c.mz[k] = 0.25 * a * s.drill;
  }
  if (warping) {
    const WarpTerms w = warp_terms(g);
    const double twist = w.spin_xx * s.moment[0] + w.spin_yy * s.moment[1] + w.spin_xy * s.moment[2];
    for (int k = 0; k < 4; ++k) {
      c.fx[k] += a * (w.cx[k] * s.moment[0] + w.cy[k] * s.moment[2] - 0.5 * g.by[k] * twist);
      c.fy[k] += a * (w.cy[k] * s.moment[1] + w.cx[k] * s.moment[2] + 0.5 * g.bx[k] * twist);
    }
  }
  return c;
}

} // namespace birdstrike
