// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/sph_rates.h"

#include "core/material/energy_step.h"
#include "core/parallel.h"
#include "core/particles/artificial_viscosity.h"
#include "core/particles/kernel.h"

#include <atomic>
#include <numbers>

namespace birdstrike {

namespace {

// Sums in single precision tell a density to a few parts in 1e7 (up to h of 2 spacings; to 1.4e-6 at 3). What is nearer to
// that of the undisturbed lattice counts as undisturbed, and all else is shifted by as much, so that matter at rest feels
// exactly nothing.
constexpr double same_density = 1e-6;

double compression(double number)
{
  const double change = number - 1;
  return 1 + (change > same_density    ? change - same_density
              : change < -same_density ? change + same_density
                                       : 0);
}

} // namespace

void Rates::resize(std::size_t count)
{
  for (auto* array :
       {&ax, &ay, &az, &density, &summed_density, &energy, &viscous, &wall_force, &divergence, &approach})
    array->assign(count, 0.0);
  limiter.assign(count, 1.0);
  for (auto& array : strain_rate)
    array.assign(count, 0.0f);
}

void Rates::reorder(const std::vector<std::int32_t>& order)
{
  std::vector<double> scratch;
  for (auto* array : {&ax, &ay, &az, &density, &summed_density, &energy, &viscous, &wall_force, &divergence,
                      &approach, &limiter})
    birdstrike::reorder(*array, order, scratch);
  std::vector<float> single;
  for (auto& array : strain_rate)
    birdstrike::reorder(array, order, single);
}

SphRates::SphRates(const Settings& settings, const RigidPlate* plate, const PairKernels& kernels)
    : kernels_(kernels), settings_(settings)
{
  pair_settings_.limited = settings.viscosity.kind == ViscosityKind::limited;
  if (settings.viscosity.kind == ViscosityKind::bulk)
    settings_.viscosity.linear = settings_.viscosity.quadratic = 0;
  bulk_ = settings.viscosity;
  pair_settings_.beta = settings_.viscosity.quadratic;
  if (plate)
    pair_settings_.plate = {true, settings.periodic.has_value(), 0.5 * plate->size_y, 0.5 * plate->size_z};
}

//! What holds for a whole run.
void SphRates::read_parts(const Particles& p)
{
  lattice_sum_ = lattice_sum(p.initial_smoothing / p.spacing, p.lattice);
  for (const Part& part : p.parts) {
    const double rho0 = reference_density(part.eos), lattice_cell = p.spacing * p.spacing * p.spacing;
    const double cell = part.particle_volume > 0 ? part.particle_volume : lattice_cell;
    parts_.push_back({rho0, 1 / rho0, cell,
                      static_cast<float>(8 / std::numbers::pi * (cell / lattice_cell) / lattice_sum_),
                      depends_on_energy(part.eos)});
  }
  if (p.size() > 0)
    flight_ = p.velocity(0).cast<float>();
  pair_settings_.plate.half_y /= p.spacing;
  pair_settings_.plate.half_z /= p.spacing;
  pair_settings_.plate.reach = 2 * p.initial_smoothing * settings_.smoothing_growth / p.spacing * (1 + 1e-6);
}

void SphRates::prepare(Particles& p, const Trial& trial, const Quad& list, std::size_t quad,
                       const Rates& rates)
{
  const double per_spacing = 1 / p.spacing, half_alpha = 0.5 * settings_.viscosity.linear;
  const PairUnits& unit = pair_settings_.unit;
  const WholePlace whole_x(unit.x, p.spacing), whole_y(unit.y, p.spacing), whole_z(unit.z, p.spacing);
  const auto single = [](double value) { return static_cast<float>(value); };
  QuadState& state = states_[quad];
  sums_[quad] = {};
  bool undisturbed = true;
  double gap = 1e30;
  for (std::size_t l = 0; l < quad_size; ++l) {
    const bool used = l < static_cast<std::size_t>(list.count);
    const std::size_t i = static_cast<std::size_t>(list.begin) + (used ? l : 0);
    const PartConstants& part = parts_[p.part[i]];
    if (used) {
      const EquationOfState& eos = p.parts[p.part[i]].eos;
      // Pressure and energy need each other: 5.54 or 5.55, with the work of the old pressure done already.
      const double e = part.with_energy ? energy_step(eos, {.energy = trial.energy[i],
                                                            .pressure = 0,
                                                            .old_volume = 1 / p.density[i],
                                                            .new_volume = 1 / trial.density[i],
                                                            .lowest_pressure = settings_.tension_cutoff})
                                              .energy
                                        : 0;
      const LawPoint point = birdstrike::evaluate(eos, trial.density[i], e);
      p.pressure[i] = std::max(point.pressure, settings_.tension_cutoff);
      p.sound_speed[i] = point.sound_speed;
      undisturbed = undisturbed && p.pressure[i] == 0 && single(trial.vx[i]) == (*flight_)[0] &&
                    single(trial.vy[i]) == (*flight_)[1] && single(trial.vz[i]) == (*flight_)[2];
      if (p.x[i] < 0)
        gap = std::min(gap, -p.x[i] * per_spacing);
    }
    const double x = trial.density[i] * part.per_density, per_x2 = 1 / (x * x);
    double q = 0; // 5.58 uses the rate of compression at the end of the step before
    if (!shock_stress_.empty()) {
      q = bulk_viscosity(trial.density[i], p.sound_speed[i], rates.divergence[i], std::cbrt(part.cell / x),
                         bulk_.linear, bulk_.quadratic);
      shock_stress_[i] = q * per_x2;
      undisturbed = undisturbed && q == 0;
    }
    state.x[l] = whole_x(p.x[i]), state.y[l] = whole_y(p.y[i]), state.z[l] = whole_z(p.z[i]);
    if (pair_settings_.plate.present && p.x[i] < 0 && state.x[l] == 0)
      state.x[l] = -1; // in front of the plate, however little
    state.vx[l] = single(trial.vx[i]), state.vy[l] = single(trial.vy[i]), state.vz[l] = single(trial.vz[i]);
    state.support[l] = single(p.smoothing_length[i] * per_spacing);
    state.weight[l] = used ? part.weight : 0.0f;
    state.pressure[l] = single(p.pressure[i]);
    state.stress[l] = single((p.pressure[i] + q) * per_x2);
    state.sound_speed[l] = single(half_alpha * p.sound_speed[i]);
    state.lightness[l] = single(x * part.per_density);
    state.smooth[l] = single(1 - rates.limiter[i]);
    for (std::size_t c = 0; c < 6; ++c)
      state.strain_rate[c][l] = single(rates.strain_rate[c][i] * p.spacing);
    state.rest_density[l] = single(part.rest_density);
    if (pair_settings_.plate.present) {
      absolute_y_[quad * quad_size + l] = single(p.y[i] * per_spacing);
      absolute_z_[quad * quad_size + l] = single(p.z[i] * per_spacing);
    }
  }
  undisturbed_[quad] = undisturbed;
  gap_[quad] = single(gap);
}

void SphRates::prepare_walls(const Particles& p, const MirrorPlanes& walls, const Quad& list,
                             std::size_t quad)
{
  QuadWalls& wall = walls_[quad];
  wall = {};
  for (std::size_t l = 0; l < static_cast<std::size_t>(list.count); ++l) {
    const std::size_t i = static_cast<std::size_t>(list.begin) + l;
    if (walls.open[i] <= 0)
      continue;
    const Vector3 normal(walls.normal_x[i], walls.normal_y[i], walls.normal_z[i]);
    wall.x[l] = static_cast<float>(normal[0]);
    wall.y[l] = static_cast<float>(normal[1]);
    wall.z[l] = static_cast<float>(normal[2]);
    wall.height[l] = static_cast<float>((normal.dot(p.position(i)) - walls.offset[i]) / p.spacing);
    wall.speed[l] = static_cast<float>(walls.speed[i]);
    wall.open[l] = static_cast<float>(walls.open[i]);
    undisturbed_[quad] = 0;
  }
}

//! Has anything reached a quad or one that it meets? Where not, no pressure and velocities that are equal in the precision
//! of the pairs make rates of exactly zero, and a density that stays what it was to that precision.
void SphRates::find_active(const Neighbours& neighbours)
{
  const std::vector<Quad>& quads = neighbours.quads();
  for_each_row(quads.size(), [&](std::size_t q) {
    active_[q] = !undisturbed_[q] || (pair_settings_.plate.present && gap_[q] < pair_settings_.plate.reach);
  });
  // Lists have each pair once, so both are marked; by several threads at a time, but all write the same.
  const auto mark = [&](std::size_t q) {
    std::atomic_ref<std::uint8_t>(active_[q]).store(1, std::memory_order_relaxed);
  };
  for_each_row(quads.size(), [&](std::size_t q) {
    const std::int32_t* const partners = neighbours.partners().data() + quads[q].first;
    for (std::int32_t n = 0; n < quads[q].partners; ++n) {
      const auto partner = static_cast<std::size_t>(partners[n]);
      if (undisturbed_[q] == undisturbed_[partner])
        continue;
      mark(q);
      mark(partner);
    }
  });
}

void SphRates::finish(Particles& p, const Quad& list, const QuadState& state, const QuadSums& sums,
                      Rates& r) const
{
  const ViscosityKind kind = settings_.viscosity.kind;
  const double per_spacing = 1 / p.spacing;
  using S = QuadSums;
  for (std::size_t l = 0; l < static_cast<std::size_t>(list.count); ++l) {
    const std::size_t i = static_cast<std::size_t>(list.begin) + l;
    // The mass may differ from volume times density (dissertation 8.3.3): that is inertia and nothing else.
    const PartConstants& part = parts_[p.part[i]];
    const double cell = part.cell, per_density = cell / p.mass[i], rest_density = part.rest_density;
    const double x = rest_density * static_cast<double>(state.lightness[l]);
    const double per_weight = 1.0 / state.weight[l], per_length = per_spacing * per_weight;
    const double per_time = S::gradient_factor * per_length / x;
    std::array<double, 9> g; // grad v
    for (std::size_t c = 0; c < 9; ++c)
      g[c] = sums.at(S::gradient + static_cast<int>(c), l) * per_time;
    const double compression_rate = -x * (g[0] + g[4] + g[8]); // D
    const double work = compression_rate + S::work_factor * sums.at(S::extra_work, l) * per_length;
    const double shock = shock_stress_.empty() ? 0 : shock_stress_[i];
    p.mean_pressure[i] = sums.at(S::pressure, l) / sums.at(S::number, l);
    const double pull = S::force_factor * per_length, force = pull * per_density, wall_force = pull * cell;
    r.ax[i] = sums.at(S::fx, l) * force;
    r.ay[i] = sums.at(S::fy, l) * force;
    r.az[i] = sums.at(S::fz, l) * force;
    r.wall_force[i] = sums.at(S::wall, l) * wall_force;
    if (!walls_.empty())
      r.image_force[i] =
          wall_force * Vector3(sums.at(S::wall, l), sums.at(S::wall_y, l), sums.at(S::wall_z, l));
    r.divergence[i] = g[0] + g[4] + g[8];
    r.density[i] = rest_density * compression_rate;
    r.summed_density[i] = rest_density * compression(sums.at(S::number, l) * per_weight);
    r.viscous[i] = (S::heating_factor * sums.at(S::heating, l) * per_length + shock * work) * per_density;
    r.energy[i] = r.viscous[i] + (state.stress[l] - shock) * work * per_density;
    r.approach[i] = kind == ViscosityKind::bulk ? std::cbrt(cell / x) * std::abs(r.divergence[i])
                                                : static_cast<double>(sums.at(S::mu, l));
    r.limiter[i] = kind == ViscosityKind::limited    ? plane_compression(g)
                   : kind == ViscosityKind::switched ? shear_switch(g)
                                                     : 1;
    const double strain_rate[6] = {g[0], g[4], g[8], g[1] + g[3], g[2] + g[6], g[5] + g[7]};
    for (int c = 0; c < 6; ++c)
      r.strain_rate[c][i] = static_cast<float>(strain_rate[c]);
  }
}

void SphRates::evaluate(Particles& p, const std::vector<double>& vx, const std::vector<double>& vy,
                        const std::vector<double>& vz, const std::vector<double>& density,
                        const std::vector<double>& energy, const Neighbours& neighbours, Rates& rates,
                        const MirrorPlanes* walls)
{
  const bool first_time = lattice_sum_ == 0;
  if (first_time)
    read_parts(p);
  pair_settings_.unit = neighbours.units(p.spacing);
  const std::vector<Quad>& quads = neighbours.quads();
  const std::size_t count = quads.size();
  states_.resize(count);
  sums_.resize(count);
  active_.resize(count);
  undisturbed_.resize(count);
  gap_.resize(count);
  walls_.resize(walls ? count : 0);
  rates.image_force.resize(walls ? p.size() : 0);
  if (settings_.viscosity.kind == ViscosityKind::bulk)
    shock_stress_.resize(p.size());
  if (pair_settings_.plate.present) {
    absolute_y_.resize(count * quad_size);
    absolute_z_.resize(count * quad_size);
  }

  const Trial trial{vx, vy, vz, density, energy};
  for_each_row(count, [&](std::size_t q) {
    prepare(p, trial, quads[q], q, rates);
    if (walls)
      prepare_walls(p, *walls, quads[q], q);
  });

  const PairInput in{states_.data(), walls ? walls_.data() : nullptr, gap_.data(), absolute_y_.data(),
                     absolute_z_.data()};
  // Where h follows the density, that of a free surface goes on changing in flight.
  const bool held = settings_.smoothing_shrink == 1 && settings_.smoothing_growth == 1;
  const bool skips = settings_.skip_undisturbed && held && !first_time;
  if (skips)
    find_active(neighbours);
  const auto is_active = [&](std::size_t q) { return !skips || active_[q]; };
  neighbours.schedule().run([&](std::size_t q) {
    const std::int32_t* const partners = neighbours.partners().data();
    const auto meets_active = [&] {
      for (std::int32_t n = 0; n < quads[q].partners; ++n)
        if (active_[static_cast<std::size_t>(partners[quads[q].first + n])])
          return true;
      return false;
    };
    if (is_active(q) || meets_active())
      kernels_.rates(quads.data(), static_cast<std::int32_t>(q), partners, in, pair_settings_, sums_.data());
  });
  skipped_ = skips ? std::count(active_.begin(), active_.end(), 0) : 0;
  for_each_row(count, [&](std::size_t q) {
    if (is_active(q))
      finish(p, quads[q], states_[q], sums_[q], rates);
    else
      leave_alone(p, quads[q], rates);
  });
}

//! The rates of what nothing has reached.
void SphRates::leave_alone(Particles& p, const Quad& list, Rates& r) const
{
  for (std::size_t i = static_cast<std::size_t>(list.begin);
       i < static_cast<std::size_t>(list.begin + list.count); ++i)
  {
    p.mean_pressure[i] = 0;
    for (auto* array :
         {&r.ax, &r.ay, &r.az, &r.wall_force, &r.divergence, &r.density, &r.viscous, &r.energy, &r.approach})
      (*array)[i] = 0;
    if (!r.image_force.empty())
      r.image_force[i].setZero();
    r.limiter[i] = 1;
    for (auto& array : r.strain_rate)
      array[i] = 0;
  }
}

} // namespace birdstrike
