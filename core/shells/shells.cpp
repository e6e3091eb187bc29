// SPDX-License-Identifier: BSD-3-Clause
#include "core/shells/shells.h"

#include "core/error.h"
#include "core/parallel.h"
#include "core/shells/belytschko_tsay.h"
#include "core/shells/c0_triangle.h"
#include "core/shells/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace birdstrike {

namespace {

constexpr double folded_share = 0.02; // of its first stable step: an element with less is no element any more

int corners_of(const ShellElement& element) { return is_triangle(element) ? 3 : 4; }

//! Work of a stress over a strain, transverse shear corrected [J/m3].
double work(const ShellPoint& before, const ShellPoint& after, const ShellStrain& e)
{
  return 0.5 *
         ((before.xx + after.xx) * e.xx + (before.yy + after.yy) * e.yy + (before.xy + after.xy) * e.xy +
          shear_correction * ((before.yz + after.yz) * e.yz + (before.zx + after.zx) * e.zx));
}

//! A turn about axis 3, of stresses (5.40, as a rotation so that their invariants stay) and of strains.
struct Turn
{
  double cos, sin;

  explicit Turn(double angle)
  {
    const double q = 0.5 * angle, f = 1 / (1 + q * q);
    cos = (1 - q * q) * f;
    sin = 2 * q * f;
  }
  void stress(ShellPoint& p) const
  {
    const double xx = p.xx, yz = p.yz, change = sin * (sin * (p.yy - xx) - 2 * cos * p.xy);
    p.xy += sin * (cos * (xx - p.yy) - 2 * sin * p.xy);
    p.xx += change;
    p.yy -= change;
    p.yz = sin * p.zx + cos * yz;
    p.zx = cos * p.zx - sin * yz;
  }
  //! \param e  xx, yy, gamma xy
  void plane_strain(double (&e)[3]) const
  {
    const double xx = e[0], change = sin * (sin * (e[1] - xx) - cos * e[2]);
    e[2] += 2 * sin * (cos * (xx - e[1]) - sin * e[2]);
    e[0] += change;
    e[1] -= change;
  }
  //! \param e  gamma yz, gamma zx
  void shear(double (&e)[2]) const
  {
    const double yz = e[0];
    e[0] = sin * e[1] + cos * yz;
    e[1] = cos * e[1] - sin * yz;
  }
};

//! Bound of the highest frequency of one element [1/s], squared: of its membrane with drilling, and of bending with shear.
//! Rows sums of modulus times B M^-1 B^T for the first and for bending, its exact largest root for shear.
//! \param inertia  of rotation over mass [m2]
double highest_frequency2(const ElementGeometry& g, const ShellMaterial& m, double thickness, double inertia,
                          int corners, const ShellSettings& settings)
{
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    xx += g.bx[k] * g.bx[k];
    yy += g.by[k] * g.by[k];
    xy += g.bx[k] * g.by[k];
  }
  xy = std::abs(xy);
  const double nu = m.poisson, plane = m.plane_modulus(), shear = m.shear_modulus();
  const double tie = settings.drilling * shear, skew = 0.5 * std::abs(xx - yy);
  const double bending_x = plane * (xx + nu * yy + (1 + nu) * xy),
               bending_y = plane * (yy + nu * xx + (1 + nu) * xy), twist = shear * (2 * xy + xx + yy);
  const double tied = tie > 0 ? 0.5 * (1 - nu) * plane * xy : 0;
  const double membrane = std::max({bending_x + tied, bending_y + tied, twist + (tie > 0 ? shear * skew : 0),
                                    tie * (xy + skew + 0.25 * (xx + yy) + 1 / (corners * inertia))});
  const double bending = std::max({bending_x, bending_y, twist}) * thickness * thickness / 12 / inertia;
  double sheared;
  if (corners == 3) {
    const double closing = settings.hourglass * thickness * thickness / (12 * g.area * g.area);
    sheared = triangle_shear_bound(g, inertia, closing);
  } else {
    sheared = 0.5 * (xx + yy + std::sqrt(4 * skew * skew + 4 * xy * xy)) + 0.25 / inertia;
  }
  return corners / m.density * std::max(membrane, bending + shear_correction * shear * sheared);
}

//! Integral of the shape functions over an element, a share of its area each (5.17).
PerCorner corner_shares(const ElementGeometry& g, int corners)
{
  if (corners == 3)
    return {1.0 / 3, 1.0 / 3, 1.0 / 3, 0};
  PerCorner share{};
  double sum = 0;
  const double at = 1 / std::sqrt(3.0);
  constexpr PerCorner xi{-1, 1, 1, -1}, eta{-1, -1, 1, 1};
  for (int i = 0; i < 4; ++i) { // two by two points
    const double r = at * xi[i], s = at * eta[i];
    double xr = 0, xs = 0, yr = 0, ys = 0;
    for (int k = 0; k < 4; ++k) {
      const double nr = 0.25 * xi[k] * (1 + eta[k] * s), ns = 0.25 * eta[k] * (1 + xi[k] * r);
      xr += nr * g.x[k];
      yr += nr * g.y[k];
      xs += ns * g.x[k];
      ys += ns * g.y[k];
    }
    const double area = xr * ys - xs * yr;
    for (int k = 0; k < 4; ++k)
      share[k] += 0.25 * (1 + xi[k] * r) * (1 + eta[k] * s) * area;
    sum += area;
  }
  for (double& value : share)
    value /= sum;
  return share;
}

//! Resultants of the stress in proportion to its rate (stiff_damping).
struct Viscous
{
  Resultants resultants{};

  //! \return work on the strain [J/m3]
  double add(double beta, const ShellPoint& before, const ShellPoint& now, const ShellStrain& e, double dz,
             double z)
  {
    const double xx = beta * (now.xx - before.xx), yy = beta * (now.yy - before.yy),
                 xy = beta * (now.xy - before.xy), yz = shear_correction * beta * (now.yz - before.yz),
                 zx = shear_correction * beta * (now.zx - before.zx);
    resultants.force[0] += dz * xx;
    resultants.force[1] += dz * yy;
    resultants.force[2] += dz * xy;
    resultants.moment[0] += dz * z * xx;
    resultants.moment[1] += dz * z * yy;
    resultants.moment[2] += dz * z * xy;
    resultants.shear[0] += dz * yz;
    resultants.shear[1] += dz * zx;
    return xx * e.xx + yy * e.yy + xy * e.xy + yz * e.yz + zx * e.zx;
  }
};

//! Motion of the corners in the axes of the element; velocities against that of the first.
CornerMotion motion_in(const ElementGeometry& g, const std::array<Vector3, 4>& v,
                       const std::array<Vector3, 4>& w, int n)
{
  CornerMotion m;
  if (n == 3)
    m.vx[3] = m.vy[3] = m.vz[3] = m.wx[3] = m.wy[3] = m.wz[3] = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
    const Vector3 local_v = g.axes.transpose() * (v[k] - v[0]), local_w = g.axes.transpose() * w[k];
    m.vx[k] = local_v[0];
    m.vy[k] = local_v[1];
    m.vz[k] = local_v[2];
    m.wx[k] = local_w[0];
    m.wy[k] = local_w[1];
    m.wz[k] = local_w[2];
  }
  return m;
}

std::string place_text(const Vector3& p)
{
  char text[100];
  std::snprintf(text, sizeof text, "(%.4g, %.4g, %.4g) m", p[0], p[1], p[2]);
  return text;
}

} // namespace

Shells::Shells(ShellMesh mesh, std::vector<ShellSection> sections, std::vector<Support> supports,
               ShellLoads loads, const ShellSettings& settings)
    : position(mesh.points),
      mesh_(std::move(mesh)),
      sections_(std::move(sections)),
      loads_(std::move(loads)),
      settings_(settings)
{
  check();
  const std::size_t nodes = mesh_.points.size(), count = mesh_.elements.size();
  velocity.assign(nodes, Vector3::Zero());
  spin = force_ = moment_ = external_ = velocity;
  thickness.resize(count);
  gone.assign(count, 0);
  elements_.resize(count);
  corners_.assign(4 * count, {Vector3::Zero(), Vector3::Zero()});
  element_step_.assign(count, 0);
  for (const ShellSection& section : sections_) {
    heights_.emplace_back();
    weights_.emplace_back();
    for (const GaussPoint& point : gauss_legendre(section.points)) {
      heights_.back().push_back(0.5 * point.place);
      weights_.back().push_back(0.5 * point.weight);
    }
  }
  std::size_t rows = 0;
  for (std::size_t e = 0; e < count; ++e) {
    first_point_.push_back(rows);
    rows += static_cast<std::size_t>(section_of(e).points);
    thickness[e] = section_of(e).thickness;
  }
  points.resize(rows);
  lump_masses();
  join_corners();
  gather_support(supports);
  if (settings_.spin)
    for (std::size_t n = 0; n < nodes; ++n) {
      velocity[n] = steady_velocity(position[n]);
      spin[n] = settings_.spin->velocity;
    }
  evaluate(0, 0);
  for (std::size_t e = 0; e < count; ++e)
    elements_[e].step0 = element_step_[e];
}

void Shells::check() const
{
  require(!mesh_.elements.empty(), "the target's mesh has no shell element");
  require(sections_.size() == mesh_.parts.size(),
          "the target's mesh has " + std::to_string(mesh_.parts.size()) + " parts, and there are " +
              std::to_string(sections_.size()) + " sections for them");
  for (std::size_t k = 0; k < sections_.size(); ++k) {
    const ShellSection& s = sections_[k];
    const std::string part = "part " + mesh_.parts[k].name + " of the target: ";
    require(s.thickness > 0 && std::isfinite(s.thickness), part + "the thickness must be positive");
    require(s.points >= 2 && s.points <= 10,
            part + "2 to 10 points through the thickness are possible, not " + std::to_string(s.points));
    try {
      s.material.check();
    } catch (const InputError& error) {
      throw InputError(part + error.what());
    }
  }
  const auto nodes = static_cast<std::int32_t>(mesh_.points.size());
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    const ShellElement& element = mesh_.elements[e];
    for (const std::int32_t node : element)
      require(node >= 0 && node < nodes, "element " + std::to_string(e) + " of the target names node " +
                                             std::to_string(node) + ", which is not there");
    require(mesh_.part_of(e) < mesh_.parts.size(),
            "element " + std::to_string(e) + " of the target is of no part");
    std::array<Vector3, 4> corners;
    for (int k = 0; k < 4; ++k)
      corners[static_cast<std::size_t>(k)] =
          mesh_.points[static_cast<std::size_t>(element[static_cast<std::size_t>(k)])];
    const ElementGeometry g = is_triangle(element) ? triangle_geometry(corners) : quad_geometry(corners);
    require(std::isfinite(g.area) && g.area > 0 && std::isfinite(g.bx[0]),
            "element " + std::to_string(e) + " of the target near " + place_text(corners[0]) +
                " has no area or is turned over itself; mend the mesh");
  }
  require(settings_.hourglass >= 0 && settings_.drilling >= 0 && settings_.courant > 0 &&
              settings_.courant <= 1 && settings_.damping >= 0 && settings_.stiff_damping >= 0 &&
              settings_.failed_share > 0 && settings_.failed_share <= 1,
          "a setting of the target's shells is out of range");
}

void Shells::lump_masses()
{
  mass_.assign(position.size(), 0);
  inertia_.assign(position.size(), 0);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const ShellElement& element = mesh_.elements[e];
    const int n = corners_of(element);
    std::array<Vector3, 4> corners;
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = position[static_cast<std::size_t>(element[k])];
    const ElementGeometry g = n == 3 ? triangle_geometry(corners) : quad_geometry(corners);
    const ShellSection& section = section_of(e);
    const PerCorner share = corner_shares(g, n);
    const double all = section.material.density * section.thickness * g.area;
    elements_[e].area0 = g.area;
    double least = 1;
    for (int k = 0; k < n; ++k) {
      const auto node = static_cast<std::size_t>(element[static_cast<std::size_t>(k)]);
      mass_[node] += share[static_cast<std::size_t>(k)] * all;
      // The physical t^2 / 12 of a plate, raised so that turning does not ask for smaller steps than stretching
      // (T. J. R. Hughes, M. Cohen, M. Haroun, Nucl. Eng. Des. 46 (1978) 203).
      inertia_[node] +=
          share[static_cast<std::size_t>(k)] * all * (section.thickness * section.thickness + g.area) / 12;
      least = std::min(least, share[static_cast<std::size_t>(k)]);
    }
    require(least > 0, "element " + std::to_string(e) + " of the target near " + place_text(corners[0]) +
                           " is concave; mend the mesh");
    elements_[e].mass_ratio = 1 / (n * least);
  }
  for (std::size_t n = 0; n < mass_.size(); ++n)
    require(mass_[n] > 0, "node " + std::to_string(n) + " of the target at " + place_text(position[n]) +
                              " belongs to no element; remove it");
}

void Shells::join_corners()
{
  corner_begin_.assign(position.size() + 1, 0);
  for (const ShellElement& element : mesh_.elements)
    for (int k = 0; k < corners_of(element); ++k)
      ++corner_begin_[static_cast<std::size_t>(element[static_cast<std::size_t>(k)]) + 1];
  for (std::size_t n = 0; n < position.size(); ++n)
    corner_begin_[n + 1] += corner_begin_[n];
  corner_of_.resize(static_cast<std::size_t>(corner_begin_.back()));
  std::vector<std::int32_t> next(corner_begin_.begin(), corner_begin_.end() - 1);
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
    for (int k = 0; k < corners_of(mesh_.elements[e]); ++k) {
      const auto node = static_cast<std::size_t>(mesh_.elements[e][static_cast<std::size_t>(k)]);
      corner_of_[static_cast<std::size_t>(next[node]++)] = static_cast<std::int32_t>(4 * e) + k;
    }
}

void Shells::gather_support(const std::vector<Support>& supports)
{
  std::vector<std::int32_t> row(position.size(), -1);
  for (const Support& support : supports) {
    require(!support.nodes.empty(), "a support of the target holds no node");
    for (const std::int32_t node : support.nodes) {
      require(node >= 0 && node < static_cast<std::int32_t>(position.size()),
              "a support names node " + std::to_string(node) + " of the target, which is not there");
      std::int32_t& r = row[static_cast<std::size_t>(node)];
      if (r < 0) {
        r = static_cast<std::int32_t>(held_.size());
        held_.push_back({node, {}, {}});
      }
      Held& held = held_[static_cast<std::size_t>(r)];
      for (std::size_t k = 0; k < 3; ++k) {
        held.moves[k] = held.moves[k] || support.moves[k];
        held.turns[k] = held.turns[k] || support.turns[k];
      }
    }
  }
}

Vector3 Shells::steady_velocity(const Vector3& place) const
{
  if (!settings_.spin || rotating_frame_)
    return Vector3::Zero();
  return settings_.spin->velocity.cross(place - settings_.spin->centre);
}

//! Held components follow the steady motion.
void Shells::hold_velocities()
{
  const Vector3 steady_spin =
      settings_.spin && !rotating_frame_ ? settings_.spin->velocity : Vector3(Vector3::Zero());
  for (const Held& held : held_) {
    const auto n = static_cast<std::size_t>(held.node);
    const Vector3 steady = steady_velocity(position[n]);
    for (int k = 0; k < 3; ++k) {
      if (held.moves[static_cast<std::size_t>(k)])
        velocity[n][k] = steady[k];
      if (held.turns[static_cast<std::size_t>(k)])
        spin[n][k] = steady_spin[k];
    }
  }
}

void Shells::kick(double dt)
{
  for (const Held& held : held_) {
    const auto n = static_cast<std::size_t>(held.node);
    // Along the circle at the moment of the force: the chord of the step leans outwards and would do work of its own.
    const Vector3 steady = steady_velocity(position[n]);
    for (int k = 0; k < 3; ++k) {
      if (held.moves[static_cast<std::size_t>(k)]) {
        support_impulse_[k] -= force_[n][k] * dt;
        external_work_ -= force_[n][k] * steady[k] * dt;
      }
      if (held.turns[static_cast<std::size_t>(k)])
        external_work_ -= moment_[n][k] * spin[n][k] * dt;
    }
  }
  for (const Vector3& load : external_)
    external_impulse_ += load * dt;
  for_each_row(position.size(), [&](std::size_t n) {
    velocity[n] += force_[n] * (dt / mass_[n]);
    spin[n] += moment_[n] * (dt / inertia_[n]);
  });
  hold_velocities();
  if (settings_.damping > 0) {
    const double before = kinetic_energy(), factor = std::exp(-settings_.damping * dt);
    const Vector3 turning =
        settings_.spin && !rotating_frame_ ? settings_.spin->velocity : Vector3(Vector3::Zero());
    for_each_row(position.size(), [&](std::size_t n) { // towards the steady motion
      const Vector3 steady = steady_velocity(position[n]);
      velocity[n] = steady + factor * (velocity[n] - steady);
      spin[n] = turning + factor * (spin[n] - turning);
    });
    hold_velocities();
    damped_ += before - kinetic_energy();
  }
}

void Shells::drift(double dt)
{
  if (settings_.spin && !rotating_frame_) { // along the chord, so that held nodes stay on their circles
    const double rate = settings_.spin->velocity.norm();
    if (rate > 0) {
      const Eigen::AngleAxisd turn(rate * dt, settings_.spin->velocity / rate);
      for (const Held& held : held_) {
        const auto n = static_cast<std::size_t>(held.node);
        const Vector3 arm = position[n] - settings_.spin->centre, chord = (turn * arm - arm) / dt;
        for (int k = 0; k < 3; ++k)
          if (held.moves[static_cast<std::size_t>(k)])
            velocity[n][k] = chord[k];
      }
    }
  }
  for_each_row(position.size(), [&](std::size_t n) { position[n] += velocity[n] * dt; });
}

void Shells::carried_velocity(double dt, std::vector<Vector3>& result) const
{
  result.resize(position.size());
  for_each_row(position.size(),
               [&](std::size_t n) { result[n] = velocity[n] + 0.5 * dt / mass_[n] * force_[n]; });
  for (const Held& held : held_) {
    const auto n = static_cast<std::size_t>(held.node);
    for (int k = 0; k < 3; ++k)
      if (held.moves[static_cast<std::size_t>(k)])
        result[n][k] = velocity[n][k];
  }
}

void Shells::evaluate_element(std::size_t e, double dt)
{
  Element& state = elements_[e];
  const ShellElement& element = mesh_.elements[e];
  const bool triangle = is_triangle(element);
  const int n = triangle ? 3 : 4;
  const std::size_t part = mesh_.part_of(e);
  const ShellSection& section = sections_[part];
  const ShellMaterial& material = section.material;
  std::array<Vector3, 4> end, middle, v, w;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto node = static_cast<std::size_t>(element[k]);
    end[k] = position[node];
    v[k] = velocity[node];
    w[k] = spin[node];
    middle[k] = end[k] - 0.5 * dt * v[k];
  }
  ShellPoint* const p = points.data() + first_point_[e];
  const auto point_count = static_cast<std::size_t>(section.points);
  const double *const height = heights_[part].data(), *const weight = weights_[part].data();
  double t = thickness[e];
  Viscous viscous;

  if (dt > 0) {
    // Strains from the motion in the middle of the step, where a rigid turn strains nothing (5.24, 5.25).
    const ElementGeometry g = triangle ? triangle_geometry(middle) : quad_geometry(middle);
    const CornerMotion m = motion_in(g, v, w, n);
    StrainRates r;
    if (triangle) {
      const TriangleRates rates = triangle_strain_rates(g, m);
      r = rates.rates;
      const double modulus =
          settings_.hourglass * shear_correction * material.shear_modulus() * t * t * t / (12 * g.area);
      const double before = state.closure;
      state.closure += modulus * rates.closure * dt;
      state.hourglass_work += 0.5 * (before + state.closure) * rates.closure * dt;
    } else {
      r = quad_strain_rates(g, m, settings_.warping);
      state.hourglass_work +=
          advance(state.hourglass,
                  hourglass_moduli(g, material.young, material.shear_modulus(), t, settings_.hourglass), g, m,
                  r.spin * dt, dt);
    }
    const double drill_before = state.drill;
    state.drill += settings_.drilling * material.shear_modulus() * t * r.drill * dt;
    state.hourglass_work += 0.5 * (drill_before + state.drill) * r.drill * dt * g.area;

    // Stresses in axes that have turned with the material to the end of the step, strains from its middle.
    const Turn turn(r.spin * dt), half(0.5 * r.spin * dt);
    half.plane_strain(r.membrane);
    half.plane_strain(r.curvature);
    half.shear(r.shear);
    const double beta = settings_.stiff_damping / dt;
    double thinning = 0, energy = 0, plastic = 0, damped = 0;
    for (std::size_t k = 0; k < point_count; ++k) {
      if (has_failed(p[k]))
        continue;
      const double z = height[k] * t;
      const ShellStrain strain{dt * (r.membrane[0] + z * r.curvature[0]),
                               dt * (r.membrane[1] + z * r.curvature[1]),
                               dt * (r.membrane[2] + z * r.curvature[2]), dt * r.shear[0], dt * r.shear[1]};
      turn.stress(p[k]);
      ShellPoint before = p[k];
      thinning += weight[k] * update(material, strain, dt, p[k]);
      plastic += weight[k] * (p[k].plastic_work - before.plastic_work);
      if (has_failed(p[k]))
        p[k].xx = p[k].yy = p[k].xy = p[k].yz = p[k].zx = 0;
      energy += weight[k] * work(before, p[k], strain);
      if (beta > 0)
        damped += weight[k] * viscous.add(beta, before, p[k], strain, weight[k] * t, z);
    }
    state.internal += energy * g.area * t;
    state.plastic += plastic * g.area * t;
    state.damped += damped * g.area * t;
    t *= std::exp(thinning);
    thickness[e] = t;
  }

  // Forces where the nodes are now.
  const ElementGeometry g = triangle ? triangle_geometry(end) : quad_geometry(end);
  Resultants s = viscous.resultants;
  std::size_t failed = 0;
  for (std::size_t k = 0; k < point_count; ++k) {
    failed += has_failed(p[k]);
    const double dz = weight[k] * t, z = height[k] * t;
    s.force[0] += dz * p[k].xx;
    s.force[1] += dz * p[k].yy;
    s.force[2] += dz * p[k].xy;
    s.moment[0] += dz * z * p[k].xx;
    s.moment[1] += dz * z * p[k].yy;
    s.moment[2] += dz * z * p[k].xy;
    s.shear[0] += shear_correction * dz * p[k].yz;
    s.shear[1] += shear_correction * dz * p[k].zx;
  }
  s.drill = state.drill;
  CornerForces forces;
  if (triangle) {
    forces = triangle_forces(g, s, state.closure);
  } else {
    forces = quad_forces(g, s, settings_.warping);
    add_forces(state.hourglass, g, forces);
  }
  for (int k = 0; k < n; ++k) {
    const auto c = static_cast<std::size_t>(k);
    corners_[4 * e + c] = {g.axes * Vector3(forces.fx[c], forces.fy[c], forces.fz[c]),
                           g.axes * Vector3(forces.mx[c], forces.my[c], forces.mz[c])};
  }

  const double inertia = (section.thickness * section.thickness + state.area0) / 12;
  const double frequency = std::sqrt(state.mass_ratio * g.area * t / (state.area0 * section.thickness) *
                                     highest_frequency2(g, material, t, inertia, n, settings_));
  const double share = 0.5 * settings_.stiff_damping * frequency; // of critical damping at that frequency
  element_step_[e] = settings_.courant * 2 / frequency * (std::sqrt(1 + share * share) - share);

  // What is not a number is no fold: evaluate() stops at it.
  const bool folded = dt > 0 && element_step_[e] <= folded_share * state.step0 && element_step_[e] > 0;
  if (static_cast<double>(failed) >= settings_.failed_share * static_cast<double>(point_count) ||
      (folded && can_fail(material)))
  {
    gone[e] = 1;
    element_step_[e] = 1e300;
    for (int k = 0; k < n; ++k)
      corners_[4 * e + static_cast<std::size_t>(k)] = {Vector3::Zero(), Vector3::Zero()};
  }
}

void Shells::evaluate(double dt, double time)
{
  // Plastic elements cost more than others and lie close together: small portions, whoever is free takes the next.
#pragma omp parallel for schedule(dynamic, 64) if (elements_.size() > 500)
  for (std::ptrdiff_t e = 0; e < static_cast<std::ptrdiff_t>(elements_.size()); ++e)
    if (!gone[static_cast<std::size_t>(e)])
      evaluate_element(static_cast<std::size_t>(e), dt);
  stable_step_ = 1e300;
  eroded_ = 0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    eroded_ += gone[e];
    if (!(element_step_[e] > 0) ||
        (!gone[e] && dt > 0 && element_step_[e] < folded_share * elements_[e].step0))
      report_broken(e, time);
    stable_step_ = std::min(stable_step_, element_step_[e]);
  }
  const double motion = ordered_sum(
      position.size(), [&](std::size_t n) { return velocity[n].squaredNorm() + spin[n].squaredNorm(); });
  if (!std::isfinite(motion))
    report_lost_node(time);
  const bool loaded =
      !loads_.surfaces.empty() || !loads_.nodes.empty() || (rotating_frame_ && settings_.spin);
  if (loaded) { // by the mean of the loads at both ends of the step
    const auto half_work = [&] {
      return 0.5 * dt *
             ordered_sum(position.size(), [&](std::size_t n) { return external_[n].dot(velocity[n]); });
    };
    external_work_ += half_work();
    apply_loads(time);
    external_work_ += half_work();
  }
  for_each_row(position.size(), [&](std::size_t n) {
    Vector3 force = external_[n], moment = Vector3::Zero();
    for (std::int32_t k = corner_begin_[n]; k < corner_begin_[n + 1]; ++k) {
      const Corner& corner = corners_[static_cast<std::size_t>(corner_of_[static_cast<std::size_t>(k)])];
      force -= corner.force;
      moment -= corner.moment;
    }
    force_[n] = force;
    moment_[n] = moment;
  });
}

void Shells::apply_loads(double time)
{
  std::fill(external_.begin(), external_.end(), Vector3::Zero());
  for (const SurfaceLoad& load : loads_.surfaces) {
    const double factor = load.history(time);
    if (factor == 0)
      continue;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      if (gone[e])
        continue;
      const ShellElement& element = mesh_.elements[e];
      const int n = corners_of(element);
      const auto at = [&](std::size_t k) -> const Vector3& {
        return position[static_cast<std::size_t>(element[k])];
      };
      // Half the cross product of the diagonals is area times normal.
      const Vector3 area = n == 3 ? Vector3(0.5 * (at(1) - at(0)).cross(at(2) - at(0)))
                                  : Vector3(0.5 * (at(2) - at(0)).cross(at(3) - at(1)));
      const Vector3 force = factor / n * (elements_[e].area0 * load.traction - load.pressure * area);
      for (int k = 0; k < n; ++k)
        external_[static_cast<std::size_t>(element[static_cast<std::size_t>(k)])] += force;
    }
  }
  for (const NodeLoad& load : loads_.nodes)
    external_[static_cast<std::size_t>(load.node)] += load.history(time) * load.force;
  if (rotating_frame_ && settings_.spin)
    for (std::size_t n = 0; n < position.size(); ++n) {
      const Vector3& w = settings_.spin->velocity;
      external_[n] -= mass_[n] * w.cross(w.cross(position[n] - settings_.spin->centre));
    }
}

void Shells::add_contact(const std::vector<Vector3>& force)
{
  for_each_row(position.size(), [&](std::size_t n) { force_[n] += force[n]; });
}

void Shells::launch(const Vector3& by)
{
  for (Vector3& v : velocity)
    v += by;
  hold_velocities();
}

void Shells::report_broken(std::size_t e, double time) const
{
  const auto node = static_cast<std::size_t>(mesh_.elements[e][0]);
  char text[400];
  std::snprintf(
      text, sizeof text,
      "element %zu of the target (part %s) broke down at t = %.6g s near %s: thickness %.4g m, stable step "
      "%.3g s; a smaller run.courant, a finer mesh or a material that fails may help",
      e, mesh_.parts[mesh_.part_of(e)].name.c_str(), time, place_text(position[node]).c_str(), thickness[e],
      element_step_[e]);
  throw RunError(text);
}

void Shells::report_lost_node(double time) const
{
  std::size_t n = 0;
  while (n + 1 < position.size() && velocity[n].allFinite() && spin[n].allFinite())
    ++n;
  char text[300];
  std::snprintf(
      text, sizeof text,
      "node %zu of the target at %s before the load is lost: its velocity is no longer a finite number at "
      "t = %.6g s; try a smaller run.courant or target.courant",
      n, place_text(mesh_.points[n]).c_str(), time);
  throw RunError(text);
}

double Shells::total_mass() const
{
  double sum = 0;
  for (const double m : mass_)
    sum += m;
  return sum;
}

Vector3 Shells::momentum() const
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t n = 0; n < mass_.size(); ++n)
    sum += mass_[n] * velocity[n];
  return sum;
}

double Shells::kinetic_energy() const
{
  return ordered_sum(mass_.size(), [&](std::size_t n) {
    return 0.5 * (mass_[n] * velocity[n].squaredNorm() + inertia_[n] * spin[n].squaredNorm());
  });
}

ShellEnergy Shells::energy() const
{
  ShellEnergy sum;
  sum.kinetic = kinetic_energy();
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& state = elements_[e];
    sum.damped += state.damped;
    sum.plastic += state.plastic;
    if (gone[e]) {
      sum.eroded += state.internal + state.hourglass_work;
      continue;
    }
    sum.internal += state.internal;
    sum.hourglass += state.hourglass_work;
  }
  sum.damped += damped_;
  sum.external = external_work_;
  return sum;
}

} // namespace birdstrike
