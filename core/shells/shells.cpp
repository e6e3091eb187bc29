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

//! Turn a stress in its plane (5.40, as a rotation so that its invariants stay).
void turn_by(double angle, ShellPoint& p)
{
  const double q = 0.5 * angle, c = (1 - q * q) / (1 + q * q), s = 2 * q / (1 + q * q);
  const double xx = p.xx, yy = p.yy, xy = p.xy, yz = p.yz, zx = p.zx;
  p.xx = c * c * xx + s * s * yy - 2 * s * c * xy;
  p.yy = s * s * xx + c * c * yy + 2 * s * c * xy;
  p.xy = s * c * (xx - yy) + (c * c - s * s) * xy;
  p.zx = c * zx - s * yz;
  p.yz = s * zx + c * yz;
}

//! Bound of the highest frequency of one element [1/s], squared: strain modes of membrane, and of bending with shear.
//! \param inertia  of rotation over mass [m2]
double highest_frequency2(const ElementGeometry& g, const ShellMaterial& m, double thickness, double inertia,
                          int corners)
{
  double xx = 0, yy = 0, xy = 0;
  for (int k = 0; k < corners; ++k) {
    xx += g.bx[k] * g.bx[k];
    yy += g.by[k] * g.by[k];
    xy += g.bx[k] * g.by[k];
  }
  xy = std::abs(xy);
  const double nu = m.poisson;
  // Row sums of modulus times B B^T over E / (1 - nu^2).
  const double rows = std::max(
      {xx + nu * yy + (1 + nu) * xy, yy + nu * xx + (1 + nu) * xy, 0.5 * (1 - nu) * (2 * xy + xx + yy)});
  const double membrane = corners * m.plane_modulus() / m.density * rows;
  const double bending = membrane * thickness * thickness / 12 / inertia;
  const double side_shear =
      corners == 3 ? 1.5 : 1; // the sides of a triangle see rotations that the mean does not
  const double shear = side_shear * shear_correction * m.shear_modulus() / m.density *
                       (corners * (std::max(xx, yy) + xy) + 1 / inertia);
  return std::max(membrane, bending + shear);
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
    require(
        s.material.density > 0 && s.material.young > 0 && s.material.poisson >= 0 && s.material.poisson < 0.5,
        part + "the material needs a positive density and Young's modulus, and Poisson's ratio in 0 ... 0.5");
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
  for (const Support& support : supports)
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
    for (int k = 0; k < 3; ++k) {
      if (held.moves[static_cast<std::size_t>(k)]) {
        support_impulse_[k] -= force_[n][k] * dt;
        external_work_ -= force_[n][k] * velocity[n][k] * dt;
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
    for_each_row(position.size(), [&](std::size_t n) {
      velocity[n] *= factor;
      spin[n] *= factor;
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
  const std::vector<double>&height = heights_[part], &weight = weights_[part];
  double t = thickness[e], damping_force[8] = {};

  if (dt > 0) {
    // Strains from the motion in the middle of the step, where a rigid turn strains nothing (5.24, 5.25).
    const ElementGeometry g = triangle ? triangle_geometry(middle) : quad_geometry(middle);
    CornerMotion m{};
    for (int k = 0; k < n; ++k) {
      const auto c = static_cast<std::size_t>(k);
      const Vector3 local_v = g.axes.transpose() * (v[c] - v[0]), local_w = g.axes.transpose() * w[c];
      m.vx[c] = local_v[0];
      m.vy[c] = local_v[1];
      m.vz[c] = local_v[2];
      m.wx[c] = local_w[0];
      m.wy[c] = local_w[1];
      m.wz[c] = local_w[2];
    }
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
                  hourglass_moduli(g, material.young, material.shear_modulus(), t, settings_.hourglass),
                  hourglass_pattern(g), m, r.spin * dt, dt);
    }
    const double drill_before = state.drill;
    state.drill += settings_.drilling * material.shear_modulus() * t * r.drill * dt;
    state.hourglass_work += 0.5 * (drill_before + state.drill) * r.drill * dt * g.area;
    double thinning = 0, energy = 0, damped = 0;
    const double viscous = settings_.stiff_damping / dt;
    for (std::size_t k = 0; k < point_count; ++k) {
      if (has_failed(p[k]))
        continue;
      const double z = height[k] * t;
      const ShellStrain strain{dt * (r.membrane[0] + z * r.curvature[0]),
                               dt * (r.membrane[1] + z * r.curvature[1]),
                               dt * (r.membrane[2] + z * r.curvature[2]), dt * r.shear[0], dt * r.shear[1]};
      turn_by(r.spin * dt, p[k]);
      const ShellPoint before = p[k];
      thinning += weight[k] * update(material, strain, dt, p[k]);
      energy += weight[k] * work(before, p[k], strain);
      if (viscous > 0) {
        const double xx = viscous * (p[k].xx - before.xx), yy = viscous * (p[k].yy - before.yy),
                     xy = viscous * (p[k].xy - before.xy), yz = viscous * (p[k].yz - before.yz),
                     zx = viscous * (p[k].zx - before.zx);
        const double dz = weight[k] * t, values[3] = {xx, yy, xy};
        for (int c = 0; c < 3; ++c) {
          damping_force[c] += dz * values[c];
          damping_force[3 + c] += dz * z * values[c];
        }
        damping_force[6] += shear_correction * dz * yz;
        damping_force[7] += shear_correction * dz * zx;
        damped += weight[k] * (xx * strain.xx + yy * strain.yy + xy * strain.xy +
                               shear_correction * (yz * strain.yz + zx * strain.zx));
      }
    }
    state.internal += energy * g.area * t;
    state.damped += damped * g.area * t;
    t *= std::exp(thinning);
    thickness[e] = t;
  }

  // Forces where the nodes are now.
  const ElementGeometry g = triangle ? triangle_geometry(end) : quad_geometry(end);
  Resultants s{};
  std::size_t failed = 0;
  for (std::size_t k = 0; k < point_count; ++k) {
    if (has_failed(p[k])) {
      ++failed;
      p[k].xx = p[k].yy = p[k].xy = p[k].yz = p[k].zx = 0;
      continue;
    }
    const double dz = weight[k] * t, z = height[k] * t;
    s.force[0] += dz * p[k].xx;
    s.force[1] += dz * p[k].yy;
    s.force[2] += dz * p[k].xy;
    s.moment[0] += dz * z * p[k].xx;
    s.moment[1] += dz * z * p[k].yy;
    s.moment[2] += dz * z * p[k].xy;
    s.shear[0] += dz * p[k].yz;
    s.shear[1] += dz * p[k].zx;
  }
  for (int c = 0; c < 3; ++c) {
    s.force[c] += damping_force[c];
    s.moment[c] += damping_force[3 + c];
  }
  s.shear[0] = shear_correction * s.shear[0] + damping_force[6];
  s.shear[1] = shear_correction * s.shear[1] + damping_force[7];
  s.drill = state.drill;
  CornerForces forces;
  if (triangle) {
    forces = triangle_forces(g, s, state.closure);
  } else {
    forces = quad_forces(g, s, settings_.warping);
    add_forces(state.hourglass, hourglass_pattern(g), forces);
  }
  for (int k = 0; k < n; ++k) {
    const auto c = static_cast<std::size_t>(k);
    corners_[4 * e + c] = {g.axes * Vector3(forces.fx[c], forces.fy[c], forces.fz[c]),
                           g.axes * Vector3(forces.mx[c], forces.my[c], forces.mz[c])};
  }

  const double inertia = (section.thickness * section.thickness + state.area0) / 12;
  const double frequency = std::sqrt(state.mass_ratio * g.area * t / (state.area0 * section.thickness) *
                                     highest_frequency2(g, material, t, inertia, n));
  const double share = 0.5 * settings_.stiff_damping * frequency; // of critical damping at that frequency
  element_step_[e] = settings_.courant * 2 / frequency * (std::sqrt(1 + share * share) - share);

  const bool folded = dt > 0 && !(element_step_[e] > folded_share * state.step0);
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
  for_each_row(elements_.size(), [&](std::size_t e) {
    if (!gone[e])
      evaluate_element(e, dt);
  });
  stable_step_ = 1e300;
  eroded_ = 0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    eroded_ += gone[e];
    if (!(element_step_[e] > 0) ||
        (!gone[e] && dt > 0 && element_step_[e] < folded_share * elements_[e].step0))
      report_broken(e, time);
    stable_step_ = std::min(stable_step_, element_step_[e]);
  }
  for (std::size_t n = 0; n < position.size(); ++n)
    external_work_ += 0.5 * dt * external_[n].dot(velocity[n]);
  apply_loads(time);
  for (std::size_t n = 0; n < position.size(); ++n)
    external_work_ += 0.5 * dt * external_[n].dot(velocity[n]);
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
