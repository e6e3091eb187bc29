// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/particle_contact.h"

#include "core/contact/closest_point.h"
#include "core/contact/passage.h"
#include "core/error.h"
#include "core/particles/neighbours.h"

#include <limits>

namespace birdstrike {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double near = 0.25; // of a spacing beyond the contact distance: who comes there is looked at
constexpr double skin = 0.4;  // of a spacing: motion of nodes until the bins are made again
constexpr double deepest_entry = 0.25;  // of the contact distance, in the step in which a particle gets there
constexpr std::size_t run_length = 256; // particles that one thread looks at before the next run
constexpr double least_share = 1e-9;    // of a force

//! Does the foot on piece k lie on a border with the piece before or after it, which is nearer? Then that one has the foot.
bool is_shadowed(const std::array<TrianglePoint, 4>& points, int pieces, int k)
{
  if (pieces == 1)
    return false;
  const auto here = static_cast<std::size_t>(k), after = (here + 1) % 4, before = (here + 3) % 4;
  const auto nearer = [&](std::size_t other) {
    return points[other].distance2 < points[here].distance2 ||
           (points[other].distance2 == points[here].distance2 && other < here);
  };
  return (points[here].weight[0] == 0 && nearer(after)) || (points[here].weight[1] == 0 && nearer(before));
}

Vector3 at_foot(const std::array<double, 4>& weight, const ShellElement& element,
                std::span<const Vector3> of_node)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    sum += weight[k] * of_node[static_cast<std::size_t>(element[k])];
  return sum;
}

double area_of(const ShellElement& element, std::span<const Vector3> x)
{
  const auto at = [&](std::size_t k) -> const Vector3& { return x[static_cast<std::size_t>(element[k])]; };
  return 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).norm(); // for a triangle too, as at(3) is at(2)
}

//! Keep the nearest ones once there are too many.
void add(std::array<Touch, most_touches>& touches, std::size_t& count, const Touch& touch)
{
  if (count < most_touches) {
    touches[count++] = touch;
    return;
  }
  auto farthest = std::max_element(touches.begin(), touches.end(),
                                   [](const Touch& a, const Touch& b) { return a.distance < b.distance; });
  if (touch.distance < farthest->distance)
    *farthest = touch;
}

} // namespace

struct ParticleContact::Moment
{
  const Particles& particles;
  const std::vector<double>&vx, &vy, &vz;
  const ContactSurface& surface;
  double duration;
  std::vector<double>&fx, &fy, &fz;

  Vector3 velocity(std::size_t row) const { return {vx[row], vy[row], vz[row]}; }
  double stiffness(const ParticleContact& contact, std::size_t row, std::size_t element) const
  {
    return contact.settings_.stiffness_scale * contact_stiffness(contact.modulus_[particles.part[row]],
                                                                 contact.spacing_, surface.modulus[element],
                                                                 surface.thickness[element]);
  }
};

ParticleContact::ParticleContact(const Particles& p, const ContactSurface& surface,
                                 const ContactSettings& settings)
    : settings_(settings),
      spacing_(p.spacing),
      bins_((0.5 + near) * p.spacing, skin * p.spacing),
      footprint_(surface.mesh, p.spacing),
      last_position_(p.size()),
      last_element_(p.size(), -1),
      passed_(p.size(), -1),
      last_energy_(p.size(), 0),
      node_stiffness_(surface.position.size()),
      node_damping_(surface.position.size()),
      found_((p.size() + run_length - 1) / run_length),
      stable_step_(infinity)
{
  require(!surface.mesh.elements.empty(), "contact: the target has no element");
  require(settings.friction >= 0 && std::isfinite(settings.friction),
          "contact: the coefficient of friction is " + std::to_string(settings.friction) +
              "; give 0 or more");
  require(settings.friction_speed > 0, "contact: the speed at which friction sets in must be positive");
  require(settings.stiffness_scale > 0 && std::isfinite(settings.stiffness_scale),
          "contact: the stiffness scale is " + std::to_string(settings.stiffness_scale) +
              "; it must be positive, and 1 is what is derived");
  require(settings.impact_speed >= 0 && std::isfinite(settings.impact_speed),
          "contact: the impact speed must be a finite number and not negative");
  for (const Part& part : p.parts)
    modulus_.push_back(contact_modulus(part.eos, settings.impact_speed));
}

void ParticleContact::reorder(const std::vector<std::int32_t>& order)
{
  std::vector<Vector3> places;
  std::vector<std::int32_t> rows;
  std::vector<double> values;
  birdstrike::reorder(last_position_, order, places);
  birdstrike::reorder(last_element_, order, rows);
  birdstrike::reorder(passed_, order, rows);
  birdstrike::reorder(last_energy_, order, values);
}

long ParticleContact::leaked() const
{
  return leaked_ + std::count_if(passed_.begin(), passed_.end(), [](std::int32_t e) { return e >= 0; });
}

double ParticleContact::reach(double thickness) const
{
  constexpr double of_mirror =
      0.5; // of the half spacing at which undisturbed particles stand before a mirror
  return contact_distance((settings_.mirror ? of_mirror : 1) * spacing_, thickness);
}

void ParticleContact::follow_nodes(const ContactSurface& surface)
{
  bins_.update(surface);
  thickest_ = *std::max_element(surface.thickness.begin(), surface.thickness.end());
  node_moved_ = node_speed_ = 0;
  for (std::size_t n = 0; n < surface.position.size(); ++n) {
    if (!bins_.is_used(n)) // what has been torn off may fly as it likes
      continue;
    node_speed_ = std::max(node_speed_, surface.velocity[n].squaredNorm());
    if (begun_)
      node_moved_ = std::max(node_moved_, (surface.position[n] - last_node_[n]).squaredNorm());
  }
  node_speed_ = std::sqrt(node_speed_);
  node_moved_ = std::sqrt(node_moved_);
}

void ParticleContact::evaluate(const Particles& particles, const std::vector<double>& vx,
                               const std::vector<double>& vy, const std::vector<double>& vz,
                               const ContactSurface& surface, double duration, std::vector<double>& fx,
                               std::vector<double>& fy, std::vector<double>& fz,
                               std::vector<Vector3>& node_force, ElementLoads& loads,
                               std::span<const SurfaceForce> others)
{
  const Moment now{particles, vx, vy, vz, surface, duration, fx, fy, fz};
  const std::size_t count = particles.size();
  for (auto* force : {&fx, &fy, &fz})
    force->resize(count);
  follow_nodes(surface);
#pragma omp parallel for schedule(dynamic, 1) if (found_.size() > 1)
  for (std::ptrdiff_t r = 0; r < static_cast<std::ptrdiff_t>(found_.size()); ++r) {
    Found& found = found_[static_cast<std::size_t>(r)];
    found.contacts.clear();
    found.stored = found.released = found.slip_power = found.per_mass = 0;
    found.step = infinity;
    found.touching = found.leaked = found.tests = 0;
    const std::size_t first = static_cast<std::size_t>(r) * run_length;
    for (std::size_t i = first; i < std::min(count, first + run_length); ++i)
      look_at(i, now, found);
  }
  add_up(now, duration, node_force, loads, others);
  last_node_.assign(surface.position.begin(), surface.position.end());
  begun_ = true;
}

//! Of the elements at hand the one whose box is nearest, if it is nearer than \p range; -1 otherwise.
std::int32_t ParticleContact::nearest_box(const Vector3& p, double range, const ContactSurface& surface) const
{
  std::int32_t nearest = -1;
  for (const std::int32_t element : bins_.at(p)) {
    const auto e = static_cast<std::size_t>(element);
    if (surface.gone[e] || !bins_.may_reach(element, p, range))
      continue;
    const ShellElement& nodes = surface.mesh.elements[e];
    const auto at = [&](std::size_t k) -> const Vector3& {
      return surface.position[static_cast<std::size_t>(nodes[k])];
    };
    const Vector3 low = at(0).cwiseMin(at(1)).cwiseMin(at(2).cwiseMin(at(3)));
    const Vector3 high = at(0).cwiseMax(at(1)).cwiseMax(at(2).cwiseMax(at(3)));
    const double distance = (low - p).cwiseMax(p - high).cwiseMax(0.0).norm();
    if (distance < range) {
      range = distance;
      nearest = element;
    }
  }
  return nearest;
}

//! Find what a particle touches.
void ParticleContact::look_at(std::size_t row, const Moment& now, Found& found)
{
  const ContactSurface& surface = now.surface;
  const Vector3 p = now.particles.position(row);
  const Vector3 p_before = begun_ ? last_position_[row] : p;
  last_position_[row] = p;
  now.fx[row] = now.fy[row] = now.fz[row] = 0;

  // It may have passed whatever is nearer than it and the surface have moved.
  const double moved = begun_ ? (p - p_before).norm() + node_moved_ : 0;
  std::array<Touch, most_touches> touches;
  std::size_t count = 0;
  Touch nearest{}, first{};
  double gap = near * spacing_; // all that are nearer are listed
  std::int32_t crossed = -1;
  const auto look_at_element = [&](std::int32_t element) {
    const auto e = static_cast<std::size_t>(element);
    const double reach = this->reach(surface.thickness[e]);
    if (!bins_.may_reach(element, p, std::max(reach + std::max(gap, 0.0), moved)))
      return;
    const ElementPieces pieces(surface.mesh.elements[e], surface.position);
    // Most lie in the plane of the first or behind it: no need to know where their feet are.
    if (first.reach > 0 && first.distance > moved && (first.distance < first.reach || reach <= first.reach) &&
        std::all_of(pieces.corner.begin(), pieces.corner.end(), [&](const Vector3& x) {
          return first.normal.dot(x - first.foot) <= least_height * first.reach;
        }))
      return;

    std::array<TrianglePoint, 4> points;
    for (int k = 0; k < pieces.count; ++k) {
      const auto [a, b, c] = pieces.piece(k);
      points[static_cast<std::size_t>(k)] = closest_on_triangle(p, a, b, c);
    }
    for (int k = 0; k < pieces.count; ++k) {
      const TrianglePoint& point = points[static_cast<std::size_t>(k)];
      const double distance = std::sqrt(point.distance2);
      if (distance <= moved &&
          passes(p_before, ElementPieces(surface.mesh.elements[e], last_node_).piece(k), p, pieces.piece(k)))
        crossed = element;
      if (distance - reach >= gap && distance >= reach)
        continue;
      if (is_shadowed(points, pieces.count, k))
        continue;
      const auto [a, b, c] = pieces.piece(k);
      Touch touch{element,
                  pieces.node_weights(k, point.weight),
                  point.point,
                  {},
                  (b - a).cross(c - a).normalized(),
                  distance,
                  reach,
                  {},
                  1,
                  0};
      if (distance > 1e-9 * reach)
        touch.normal = (p - point.point) / distance;
      else // on the midsurface: back to where it came from
        touch.normal = touch.face.dot(p_before - point.point) < 0 ? Vector3(-touch.face) : touch.face;
      if (distance - reach < gap) {
        gap = distance - reach;
        nearest = touch;
      }
      if (distance < reach)
        add(touches, count, touch);
    }
  };
  const std::int32_t nearest_element =
      nearest_box(p, std::max((0.5 + near) * spacing_ + 0.5 * thickest_, moved), surface);
  if (nearest_element >= 0) {
    look_at_element(nearest_element);
    first = nearest;
    for (const std::int32_t element : bins_.at(p))
      if (!surface.gone[static_cast<std::size_t>(element)]) {
        ++found.tests;
        if (element != nearest_element)
          look_at_element(element);
      }
  }

  if (crossed >= 0)
    passed_[row] = passed_[row] >= 0 ? -1 : crossed;
  if (passed_[row] >= 0) {
    if (surface.gone[static_cast<std::size_t>(passed_[row])]) // there is a hole now
      passed_[row] = -1;
    else if (count == 0) { // beyond all help
      passed_[row] = -1;
      ++found.leaked;
    } else if (std::abs(nearest.normal.dot(nearest.face)) < 0.3) // beside a free edge
      passed_[row] = -1;
    else {
      passed_[row] = nearest.element;
      nearest.normal = -nearest.normal;
      nearest.distance = -nearest.distance;
      touches[0] = nearest;
      count = 1;
    }
  }

  const double energy_before = last_energy_[row];
  const std::int32_t element_before = last_element_[row];
  last_energy_[row] = 0;
  last_element_[row] = -1;
  if (count > 0)
    push(row, now, leave_standing({touches.data(), count}), found);
  if (element_before >= 0 && surface.gone[static_cast<std::size_t>(element_before)])
    found.released += energy_before - last_energy_[row];

  if (gap < near * spacing_)
    look_ahead(row, now, nearest, found);
  else if (const double speed = now.velocity(row).norm() + node_speed_; speed > 0)
    found.step = std::min(found.step, (bins_.distance_to_box(p) + near * spacing_) / speed);
}

//! Push a particle away from what it touches.
void ParticleContact::push(std::size_t row, const Moment& now, std::span<Touch> touches, Found& found)
{
  const auto stiffness_of = [&](const Touch& touch) {
    return now.stiffness(*this, row, static_cast<std::size_t>(touch.element));
  };
  for (Touch& touch : touches)
    touch.spring = contact_spring(stiffness_of(touch), touch.reach, touch.distance);
  share_out(touches);
  const Vector3 velocity = now.velocity(row);
  const double mass = now.particles.mass[row];
  Vector3 total = Vector3::Zero();
  double stiffness = 0, strongest = 0;
  for (const Touch& touch : touches) {
    if (touch.share < least_share && std::abs(touch.force) < least_share * touch.spring.force)
      continue;
    const ShellElement& element = now.surface.mesh.elements[static_cast<std::size_t>(touch.element)];
    Vector3 force = touch.force * touch.normal;
    last_energy_[row] += touch.share * touch.spring.energy;

    const Vector3 relative = velocity - at_foot(touch.weight, element, now.surface.velocity);
    const double approach = -relative.dot(touch.normal);
    if (settings_.friction > 0) {
      const Vector3 slip = relative + approach * touch.normal;
      double inverse_mass = 1 / mass;
      for (std::size_t n = 0; n < 4; ++n)
        inverse_mass +=
            touch.weight[n] * touch.weight[n] / now.surface.mass[static_cast<std::size_t>(element[n])];
      // The spring's own force, not that which holds the energy over slight folds: that may be many times the whole.
      double viscous = settings_.friction * touch.share * touch.spring.force /
                       std::sqrt(slip.squaredNorm() + settings_.friction_speed * settings_.friction_speed);
      // A step must not turn the slip round; the first is not known yet, but no longer than the spring allows.
      const double step =
          now.duration > 0 ? now.duration : 2 / std::sqrt(touch.spring.stiffness * inverse_mass);
      viscous = std::min(viscous, 0.25 / (inverse_mass * step));
      force -= viscous * slip;
      found.slip_power += viscous * slip.squaredNorm();
    }
    total += force;

    // The stiffness at the place where the particle will stop, or at half the distance.
    const double ahead =
        touch.distance - std::min(std::max(approach, 0.0) * std::sqrt(mass / touch.spring.stiffness),
                                  0.5 * std::abs(touch.distance));
    const double hardest = touch.share * contact_spring(stiffness_of(touch), touch.reach, ahead).stiffness;
    stiffness += hardest;
    // Of feet over a slight fold one may pull as hard as the other pushes too much: each with its sign.
    found.contacts.push_back(
        {touch.element, touch.weight, force, std::copysign(force.dot(touch.face), touch.force), hardest});
    if (touch.force > strongest) {
      strongest = touch.force;
      last_element_[row] = touch.element;
    }
  }
  now.fx[row] = total[0];
  now.fy[row] = total[1];
  now.fz[row] = total[2];
  found.stored += last_energy_[row];
  found.per_mass = std::max(found.per_mass, stiffness / mass);
  ++found.touching;
}

//! What a particle that comes nearer asks of the step.
void ParticleContact::look_ahead(std::size_t row, const Moment& now, const Touch& nearest, Found& found)
{
  const auto e = static_cast<std::size_t>(nearest.element);
  const Vector3 relative =
      now.velocity(row) - at_foot(nearest.weight, now.surface.mesh.elements[e], now.surface.velocity);
  const double approach = -relative.dot(nearest.normal);
  if (approach <= 0)
    return;
  const double gap = std::max(nearest.distance - nearest.reach, 0.0);
  found.step = std::min(found.step, (gap + deepest_entry * nearest.reach) / approach);
  if (gap == 0)
    return;
  const double k = now.stiffness(*this, row, e), mass = now.particles.mass[row];
  if (gap > 4 * std::sqrt(mass / k) * approach) { // not in the next step, if that is no longer than this
    found.step = std::min(found.step, gap / approach);
    return;
  }
  found.per_mass = std::max(found.per_mass, k / mass);
  found.contacts.push_back({nearest.element, nearest.weight, Vector3::Zero(), 0, k});
}

//! Sums in one order for any number of threads.
void ParticleContact::add_up(const Moment& now, double duration, std::vector<Vector3>& node_force,
                             ElementLoads& loads, std::span<const SurfaceForce> others)
{
  const ContactSurface& surface = now.surface;
  const std::size_t elements = surface.mesh.elements.size();
  if (loads.force.size() != elements) {
    loads.force.assign(elements, Vector3::Zero());
    loads.impulse.assign(elements, Vector3::Zero());
    loads.pressure.assign(elements, 0);
    loads.peak_pressure.assign(elements, 0);
  }
  for (std::size_t e = 0; e < elements; ++e) {
    loads.impulse[e] += 0.5 * duration * loads.force[e];
    loads.force[e].setZero();
    loads.pressure[e] = 0;
  }
  std::fill(node_stiffness_.begin(), node_stiffness_.end(), 0.0);
  std::fill(node_damping_.begin(), node_damping_.end(), 0.0);

  energy_.stored = 0;
  force_on_target_.setZero();
  touching_ = tests_ = 0;
  double slip_power = 0, per_mass = 0, per_node_mass = 0, damping_rate = 0;
  stable_step_ = infinity;
  const auto take = [&](const SurfaceForce& contact) {
    const auto e = static_cast<std::size_t>(contact.element);
    if (!contact.force.isZero()) {
      const Footprint::Shares shares =
          footprint_.of(surface.mesh, contact.element, contact.weight, surface.position, surface.gone);
      for (int k = 0; k < shares.count; ++k) {
        const auto [element, part] = shares.share[static_cast<std::size_t>(k)];
        loads.force[static_cast<std::size_t>(element)] -= part * contact.force;
        loads.pressure[static_cast<std::size_t>(element)] += part * contact.pressing;
      }
    }
    force_on_target_ -= contact.force;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto n = static_cast<std::size_t>(surface.mesh.elements[e][k]);
      node_force[n] -= contact.weight[k] * contact.force;
      node_stiffness_[n] += contact.weight[k] * contact.stiffness;
      node_damping_[n] += contact.weight[k] * contact.damping;
      per_node_mass = std::max(per_node_mass, node_stiffness_[n] / surface.mass[n]);
      damping_rate = std::max(damping_rate, node_damping_[n] / surface.mass[n]);
    }
  };
  for (const SurfaceForce& other : others)
    take(other);
  for (const Found& found : found_) {
    energy_.stored += found.stored;
    energy_.released += found.released;
    slip_power += found.slip_power;
    per_mass = std::max(per_mass, found.per_mass);
    stable_step_ = std::min(stable_step_, found.step);
    touching_ += found.touching;
    leaked_ += found.leaked;
    tests_ += found.tests;
    for (const SurfaceForce& contact : found.contacts)
      take(contact);
  }
  energy_.friction += 0.5 * duration * (slip_power_ + slip_power);
  slip_power_ = slip_power;
  if (per_mass + per_node_mass > 0) {
    const double omega = std::sqrt(per_mass + per_node_mass),
                 share = 0.5 * damping_rate / omega; // of critical damping
    stable_step_ = std::min(stable_step_, 2 / omega * (std::sqrt(1 + share * share) - share));
  }
  for (std::size_t e = 0; e < elements; ++e) {
    if (loads.pressure[e] != 0)
      loads.pressure[e] /= area_of(surface.mesh.elements[e], surface.position);
    loads.impulse[e] += 0.5 * duration * loads.force[e];
    loads.peak_pressure[e] = std::max(loads.peak_pressure[e], loads.pressure[e]);
  }
}

} // namespace birdstrike
