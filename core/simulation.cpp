// SPDX-License-Identifier: BSD-3-Clause
// The explicit cycle of section 5.3 and figure 3.2. Velocities and energy are taken to the middle of the step with the
// rates at its start, positions to its end with the velocities in the middle (5.13, 5.14), and the rest of the way with
// the rates at the end, which are found once a step from velocities and densities carried there.
#include "core/simulation.h"

#include "core/contact/mirror_contact.h"
#include "core/error.h"
#include "core/gauges/bird_history.h"
#include "core/gauges/target_history.h"
#include "core/parallel.h"
#include "core/particles/smoothing_length.h"

#include <algorithm>
#include <chrono>
#include <functional>

#include <omp.h>

namespace birdstrike {

namespace {

constexpr double skin_over_h = 0.16; // mean skin of a particle at first: a fifth of a spacing

double wall_clock()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

//! Adds the time it lives to one of the shares.
struct Stopwatch
{
  double& share;
  double start = wall_clock();
  ~Stopwatch() { share += wall_clock() - start; }
};

//! When states are handed out after the first one [s].
std::vector<double> frame_times(const Settings& s)
{
  std::vector<double> times = s.frame_times;
  for (int frame = 1; s.frame_times.empty() && frame <= s.frames; ++frame)
    times.push_back(s.end_time * frame / s.frames);
  return times;
}

//! Speed of the bird [m/s].
double speed_of(const Particles& p)
{
  const double mass = total_mass(p);
  return mass > 0 ? total_momentum(p).norm() / mass : 0;
}

//! Largest speed of a node of the target [m/s].
double fastest_node(const MeshTarget& target)
{
  double fastest = 0;
  if (target.shells())
    for (const Vector3& velocity : target.shells()->velocity)
      fastest = std::max(fastest, velocity.norm());
  return fastest;
}

void check(const Settings& s, const Particles& p, const RigidPlate* plate)
{
  for (const double value : {s.end_time, s.courant, s.viscosity.linear, s.viscosity.quadratic,
                             s.tension_cutoff, s.smoothing_shrink, s.smoothing_growth})
    require(std::isfinite(value), "every setting of the run must be a finite number");
  require(s.end_time > 0, "run.end must be positive");
  require(s.frames > 0, "run.frames must be at least 1");
  require(std::is_sorted(s.frame_times.begin(), s.frame_times.end(), std::less_equal<>()) &&
              (s.frame_times.empty() || (s.frame_times.front() > 0 && s.frame_times.back() == s.end_time)),
          "the times of frames must lie above 0, rise, and end with run.end");
  require(s.courant > 0 && s.courant <= 1, "run.courant must lie above 0 and not above 1");
  require(s.viscosity.linear >= 0 && s.viscosity.quadratic >= 0,
          "viscosity coefficients must not be negative");
  require(s.tension_cutoff <= 0, "run.tension_cutoff is the lowest pressure and must not be positive");
  require(s.smoothing_shrink > 0 && s.smoothing_shrink <= 1 && s.smoothing_growth >= 1,
          "smoothing bounds must enclose 1");
  const double widest = 2 * s.smoothing_growth * p.initial_smoothing;
  require(widest <= 0.4 * widest_pair * p.spacing,
          "with run.smoothing_growth = " + std::to_string(s.smoothing_growth) +
              " a particle may act as far as " + std::to_string(widest / p.spacing) +
              " spacings; lower it, or bird.smoothing, until that is at most " +
              std::to_string(0.4 * widest_pair));
  if (s.periodic) {
    const double least = 4 * p.initial_smoothing * s.smoothing_growth * (1 + skin_over_h);
    require(s.periodic->size_y >= least && s.periodic->size_z >= least,
            "the periodic box must be at least " + std::to_string(least) +
                " m wide, twice the reach of a particle");
  }
  if (!plate)
    return;
  for (std::size_t i = 0; i < p.size(); ++i)
    require(p.x[i] < 0, "particle " + std::to_string(p.id[i]) + " (part " + p.parts[p.part[i]].name +
                            ") starts at x = " + std::to_string(p.x[i]) +
                            " m, behind the plate's face at x = 0; increase bird.gap");
}

} // namespace

struct Simulation::State
{
  Settings settings;
  Particles particles;
  std::optional<RigidPlate> plate;
  std::optional<MeshTarget> mesh;
  std::optional<InitialGap> initial_gap;  // with mesh and bird
  std::optional<ParticleContact> contact; // the same
  std::optional<MirrorSearch> mirror;     // where contact mirrors
  MirrorPlanes walls;
  std::vector<SurfaceForce> image_forces;
  std::vector<double> fx, fy, fz;     // of contact on the particles [N]
  std::vector<Vector3> node_force;    // of contact on the nodes of mesh [N]
  std::vector<Vector3> node_velocity; // of the nodes at the end of a step, to first order [m/s]
  std::vector<DeflectionGauge> deflections;

  Rates rates;
  SphRates sph;
  Neighbours neighbours;
  std::vector<double> trial_vx, trial_vy, trial_vz, trial_density, trial_energy;
  std::vector<double> rest_density; // of each part [kg/m3]
  BirdPass pass;

  History history;
  TransducerGauges transducers;
  PermanentSet permanent_set;
  Ledger ledger;
  Shares shares;
  double time = 0;
  TimeStep stable, step; // the second is shortened where a frame asks for it
  long steps = 0;
  std::optional<double> first_contact;

  State(Particles p, Target target, const Settings& s, std::vector<Transducer> faces,
        std::vector<DeflectionGauge> points)
      : settings(s),
        particles(std::move(p)),
        plate(std::move(target.plate)),
        mesh(std::move(target.mesh)),
        deflections(std::move(points)),
        sph(s, plate ? &*plate : nullptr),
        neighbours(skin_over_h * particles.initial_smoothing,
                   s.periodic ? Period{s.periodic->size_y, s.periodic->size_z} : Period{}),
        transducers(std::move(faces), particles.spacing),
        permanent_set(s.end_time)
  {
    if (!mesh)
      return;
    node_force.resize(mesh->mesh().points.size());
    for (auto* array : {&fx, &fy, &fz})
      array->resize(particles.size());
    if (particles.size() > 0) {
      ContactSettings of_contact = target.contact;
      if (of_contact.impact_speed <= 0)
        of_contact.impact_speed = speed_of(particles) + fastest_node(*mesh);
      initial_gap = require_initial_gap(particles, mesh->surface());
      contact.emplace(particles, mesh->surface(), of_contact);
      if (of_contact.mirror)
        mirror.emplace(2 * s.smoothing_growth * particles.initial_smoothing, particles.spacing);
    }
  }

  RigidPlate* target_plate() { return plate ? &*plate : nullptr; }
  Shells* shells() { return mesh ? mesh->shells() : nullptr; }

  void start();
  void advance(double dt);
  void kick_target(double dt);
  bool move(double dt);
  void finish_kick(double dt);
  void refresh_neighbours();
  void evaluate_rates(double dt);
  void evaluate_contact(double dt);
  void collect_image_forces();
  TimeStep find_step();
  void book_target();
  void book();
};

void Simulation::State::start()
{
  rates.resize(particles.size());
  for (auto* array : {&trial_vx, &trial_vy, &trial_vz, &trial_density, &trial_energy})
    array->resize(particles.size());
  ledger.mass = total_mass(particles);
  ledger.initial_momentum = total_momentum(particles);
  history = make_bird_history(particles);
  if (mesh)
    add_target_columns(history, deflections);
  require_finite(particles, rates, time);
  for (const Part& part : particles.parts)
    rest_density.push_back(reference_density(part.eos));
  move(0);
  refresh_neighbours();
  evaluate_rates(0); // finds the density,
  move(0);
  evaluate_rates(0); // and with it the forces
  finish_kick(0);
  book_target();
  ledger.initial_energy = pass.sums().kinetic + pass.sums().internal + ledger.target.total();
  book();
}

void Simulation::State::advance(double dt)
{
  kick_target(0.5 * dt);
  ledger.viscous += 0.5 * dt * pass.sums().viscous_power;
  const bool anyone_past_plate = move(dt);
  if (anyone_past_plate) {
    const Stopwatch watch{shares.contact};
    ledger.impulse += throw_back(particles, *plate, dt, settings.periodic.has_value());
    for_each_row(particles.size(),
                 [&](std::size_t i) { trial_vx[i] = particles.vx[i] + 0.5 * dt * rates.ax[i]; });
  }
  if (Shells* structure = shells()) {
    const Stopwatch watch{shares.shells};
    structure->drift(dt);
  }
  refresh_neighbours();
  evaluate_rates(dt);
  kick_target(0.5 * dt);
  finish_kick(0.5 * dt);
  ledger.viscous += 0.5 * dt * pass.sums().viscous_power;
}

//! The target's velocities and impulses by the present forces.
void Simulation::State::kick_target(double dt)
{
  if (Shells* structure = shells()) {
    const Stopwatch watch{shares.shells};
    structure->kick(dt);
  }
  ledger.impulse += ledger.contact_force * dt;
  if (plate)
    book_impulse(*plate, dt);
}

//! The second half of the particles' kick, and all that is to be known of them after it.
void Simulation::State::finish_kick(double dt)
{
  const Stopwatch watch{shares.particles};
  pass.kick(particles, rates, settings.viscosity, dt);
  if (!pass.sums().finite)
    require_finite(particles, rates, time);
}

//! Velocities and energies through the first half of a step of length \p dt, places to its end; then velocity, density,
//! energy and h as they will be there, to first order: what the rates there need.
//! \return whether a particle is behind the plate's plane
bool Simulation::State::move(double dt)
{
  const Stopwatch watch{shares.particles};
  constexpr double least =
      0.1; // of the density before; the compression limit of the time step keeps far from it
  Particles& p = particles;
  const double half = 0.5 * dt;
  const double foremost = ordered_reduce(
      p.size(), -1e300,
      [&](double& x, std::size_t i) {
        const double ax = rates.ax[i] * half, ay = rates.ay[i] * half, az = rates.az[i] * half;
        p.vx[i] += ax, p.vy[i] += ay, p.vz[i] += az;
        p.energy[i] += rates.energy[i] * half;
        p.x[i] += p.vx[i] * dt, p.y[i] += p.vy[i] * dt, p.z[i] += p.vz[i] * dt;
        trial_vx[i] = p.vx[i] + ax, trial_vy[i] = p.vy[i] + ay, trial_vz[i] = p.vz[i] + az;
        trial_density[i] = std::max(p.density[i] + dt * rates.density[i], least * p.density[i]);
        trial_energy[i] = p.energy[i] + half * rates.viscous[i]; // less the work of the pressure at the end
        p.smoothing_length[i] =
            smoothing_length(p.initial_smoothing, rest_density[p.part[i]], trial_density[i],
                             settings.smoothing_shrink, settings.smoothing_growth);
        x = std::max(x, p.x[i]);
      },
      [](double& a, double b) { a = std::max(a, b); });
  return plate && foremost >= 0;
}

void Simulation::State::refresh_neighbours()
{
  const Stopwatch watch{shares.particles};
  if (particles.size() == 0)
    return;
  if (!neighbours.is_stale(particles))
    return;
  if (settings.periodic) // back into the box
    for_each_row(particles.size(), [&](std::size_t i) {
      particles.y[i] -= settings.periodic->size_y * std::round(particles.y[i] / settings.periodic->size_y);
      particles.z[i] -= settings.periodic->size_z * std::round(particles.z[i] / settings.periodic->size_z);
    });
  const std::vector<std::int32_t>& order = neighbours.sort(particles);
  reorder(particles, order);
  rates.reorder(order);
  if (contact)
    contact->reorder(order);
  std::vector<double> scratch;
  for (auto* array : {&trial_vx, &trial_vy, &trial_vz, &trial_density, &trial_energy})
    reorder(*array, order, scratch);
  neighbours.build(particles);
}

//! Forces at the end of a step of length \p dt.
void Simulation::State::evaluate_rates(double dt)
{
  if (contact && mesh->shells())
    mesh->shells()->carried_velocity(dt, node_velocity);
  if (particles.size() > 0) {
    if (mirror) {
      const Stopwatch watch{shares.contact};
      mirror->find(particles, mesh->surface(&node_velocity), walls);
    }
    const Stopwatch watch{shares.particles};
    sph.evaluate(particles, trial_vx, trial_vy, trial_vz, trial_density, trial_energy, neighbours, rates,
                 mirror ? &walls : nullptr);
    particles.density = rates.summed_density;
    if (contact) // looks at places and velocities
      require_finite(particles, rates, time);
  }
  if (plate) {
    const Stopwatch watch{shares.contact};
    ledger.contact_force = collect_contact_force(particles, rates, *plate);
    if (!first_contact && ledger.contact_force[0] > 0)
      first_contact = time;
  }
  if (Shells* structure = shells()) {
    const Stopwatch watch{shares.shells};
    structure->evaluate(dt, time);
  }
  if (contact)
    evaluate_contact(dt);
}

void Simulation::State::evaluate_contact(double dt)
{
  const Stopwatch watch{shares.contact};
  std::fill(node_force.begin(), node_force.end(), Vector3::Zero());
  collect_image_forces();
  contact->evaluate(particles, trial_vx, trial_vy, trial_vz, mesh->surface(&node_velocity), dt, fx, fy, fz,
                    node_force, mesh->loads, image_forces);
  for_each_row(particles.size(), [&](std::size_t i) {
    rates.ax[i] += fx[i] / particles.mass[i];
    rates.ay[i] += fy[i] / particles.mass[i];
    rates.az[i] += fz[i] / particles.mass[i];
    rates.wall_force[i] += fx[i]; // which holds the images' share
  });
  if (Shells* structure = mesh->shells())
    structure->add_contact(node_force);
  ledger.contact_force = contact->force_on_target();
  if (!first_contact && (contact->touching() > 0 || ledger.contact_force[0] > 0))
    first_contact = time;
}

//! What the images do to the particles, to be taken from the target.
void Simulation::State::collect_image_forces()
{
  image_forces.clear();
  for (std::size_t i = 0; i < rates.image_force.size(); ++i) {
    const Vector3& force = rates.image_force[i];
    if (walls.element[i] < 0 || force.isZero())
      continue;
    const Vector3 normal(walls.normal_x[i], walls.normal_y[i], walls.normal_z[i]);
    // Half a cell of matter between the particle and the wall, as for the springs.
    const double stiffness =
        2 * particles.density[i] * particles.sound_speed[i] * particles.sound_speed[i] * particles.spacing;
    const double damping = particles.density[i] * particles.spacing * particles.spacing *
                           (settings.viscosity.linear * particles.sound_speed[i] +
                            settings.viscosity.quadratic * rates.approach[i]);
    image_forces.push_back({walls.element[i], walls.weight[i], force, force.dot(normal), stiffness, damping});
  }
}

//! The smallest limit of particles, shells and contact.
TimeStep Simulation::State::find_step()
{
  std::vector<TimeStep> others;
  if (const Shells* structure = shells())
    others.push_back({structure->stable_step(), "shells"});
  if (contact)
    others.push_back({settings.courant * contact->stable_step(), "contact"});
  return stable_time_step(pass.sums().limits, settings, others, stable, time);
}

void Simulation::State::book_target()
{
  if (contact) {
    ledger.contact = contact->energy().stored;
    ledger.contact_released = contact->energy().released;
    ledger.friction = contact->energy().friction;
  }
  if (const Shells* structure = shells()) {
    ledger.target = structure->energy();
    ledger.target_momentum = structure->momentum();
    ledger.support_impulse = structure->support_impulse();
  }
}

void Simulation::State::book()
{
  const Stopwatch watch{shares.gauges};
  ledger.momentum = pass.sums().momentum;
  ledger.kinetic = pass.sums().kinetic;
  ledger.internal = pass.sums().internal;
  book_target();
  double highest = 0;
  if (mesh)
    for (const double pressure : mesh->loads.pressure)
      highest = std::max(highest, pressure);
  if (plate)
    for (const Vector3& force : plate->force)
      highest = std::max(highest, force[0] / plate->element_area());
  record(history, pass.peaks(), ledger, time, step.size, highest);
  if (mesh) {
    record_target(history, *mesh, deflections, ledger, contact ? contact->leaked() : 0, time);
    permanent_set.record(*mesh, time);
  }
  transducers.record(particles, rates, time);
}

Simulation::Simulation(Particles particles, Target target, const Settings& settings,
                       std::vector<Transducer> transducers, std::vector<DeflectionGauge> deflections)
{
  check(settings, particles, target.plate ? &*target.plate : nullptr);
  require(particles.size() > 0 || target.mesh, "there is neither a bird nor a target that could move");
  state_ = std::make_unique<State>(std::move(particles), std::move(target), settings, std::move(transducers),
                                   std::move(deflections));
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;

void Simulation::run(Observer& observer)
{
  State& s = *state_;
  const Stopwatch watch{s.shares.total};
  const int threads = s.settings.threads > 0 ? s.settings.threads : omp_get_max_threads();
  omp_set_num_threads(threads);
  const auto hand_out_frame = [&] {
    const Stopwatch writing{s.shares.writing};
    observer.on_frame(*this);
  };

  s.start();
  hand_out_frame();
  for (const double frame_time : frame_times(s.settings)) {
    while (s.time < frame_time) {
      s.stable = s.find_step();
      const double left = frame_time - s.time;
      s.step = {fit_to_frame(s.stable.size, left), s.stable.limit};
      s.time = s.step.size >= left ? frame_time : s.time + s.step.size;
      s.advance(s.step.size);
      ++s.steps;
      s.book();
      observer.on_step(*this);
    }
    hand_out_frame();
  }
}

const Settings& Simulation::settings() const { return state_->settings; }
const Particles& Simulation::particles() const { return state_->particles; }
const RigidPlate* Simulation::plate() const { return state_->target_plate(); }
const MeshTarget* Simulation::mesh_target() const { return state_->mesh ? &*state_->mesh : nullptr; }
const ParticleContact* Simulation::contact() const { return state_->contact ? &*state_->contact : nullptr; }
const History& Simulation::history() const { return state_->history; }
const History& Simulation::transducer_history() const { return state_->transducers.history(); }
PermanentSet::Largest Simulation::permanent_set() const
{
  return state_->mesh ? state_->permanent_set.largest(*state_->mesh) : PermanentSet::Largest();
}
const Ledger& Simulation::ledger() const { return state_->ledger; }
const Shares& Simulation::shares() const { return state_->shares; }
const std::optional<InitialGap>& Simulation::initial_gap() const { return state_->initial_gap; }
double Simulation::time() const { return state_->time; }
const TimeStep& Simulation::time_step() const { return state_->step; }
long Simulation::steps() const { return state_->steps; }
long Simulation::list_rebuilds() const { return state_->neighbours.rebuilds(); }
double Simulation::mean_neighbours() const { return state_->neighbours.mean_neighbours(); }
std::optional<double> Simulation::first_contact() const { return state_->first_contact; }

} // namespace birdstrike
