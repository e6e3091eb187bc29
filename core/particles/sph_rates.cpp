// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/sph_rates.h"

#include "core/material/energy_step.h"
#include "core/parallel.h"
#include "core/particles/artificial_viscosity.h"
#include "core/particles/kernel.h"

namespace birdstrike {

namespace {
constexpr std::size_t padding = cluster_size; // lanes of a cluster that may reach past the last row
constexpr int clusters_at_once = 16;          // for one thread: enough to hide the cost of handing out work
} // namespace

void Rates::resize(std::size_t count)
{
  for (auto* array :
       {&ax, &ay, &az, &density, &summed_density, &energy, &viscous, &wall_force, &divergence, &approach})
    array->assign(count, 0.0);
  limiter.assign(count, 1.0);
  for (auto& array : strain_rate)
    array.assign(count, 0.0);
}

void Rates::reorder(const std::vector<std::int32_t>& order)
{
  std::vector<double> scratch;
  for (auto* array : {&ax, &ay, &az, &density, &summed_density, &energy, &viscous, &wall_force, &divergence,
                      &approach, &limiter})
    birdstrike::reorder(*array, order, scratch);
  for (auto& array : strain_rate)
    birdstrike::reorder(array, order, scratch);
}

SphRates::SphRates(const Settings& settings, const RigidPlate* plate, const PairKernels& kernels)
    : kernels_(kernels), settings_(settings)
{
  pair_settings_.limited = settings.viscosity.kind == ViscosityKind::limited;
  if (settings.viscosity.kind != ViscosityKind::bulk) {
    pair_settings_.alpha = settings.viscosity.linear;
    pair_settings_.beta = settings.viscosity.quadratic;
  }
  if (settings.periodic)
    pair_settings_.period = {settings.periodic->size_y, settings.periodic->size_z};
  if (plate)
    pair_settings_.plate = {0.5 * plate->size_y, 0.5 * plate->size_z, 0, true};
}

void SphRates::prepare(Particles& p, const std::vector<double>& vx, const std::vector<double>& vy,
                       const std::vector<double>& vz, const std::vector<double>& density,
                       const std::vector<double>& energy, const Rates& rates)
{
  const std::size_t n = p.size(), size = n + padding;
  if (x_.size() != size) {
    for (auto* array : {&pressure_, &pressure_sum_, &work_,        &rest_density_, &x_,       &y_,
                        &z_,        &vx_,           &vy_,          &vz_,           &h_,       &weight_,
                        &stress_,   &shock_stress_, &sound_speed_, &inertia_,      &limiter_, &fx_,
                        &fy_,       &fz_,           &number_,      &heating_,      &mu_,      &wall_})
      array->assign(size, 0.0);
    for (auto& array : gradient_)
      array.assign(size, 0.0);
    for (auto& array : strain_rate_)
      array.assign(size, 0.0);
    std::fill(h_.begin(), h_.end(), 1.0);
  }
  const Viscosity& viscosity = settings_.viscosity;
  const bool bulk = viscosity.kind == ViscosityKind::bulk;
  const double lattice = lattice_sum(p.initial_smoothing / p.spacing, p.lattice);
  for_each_row(n, [&](std::size_t i) {
    const EquationOfState& eos = p.parts[p.part[i]].eos;
    // Pressure and energy need each other: 5.54 or 5.55, with the work of the old pressure done already.
    const double e = depends_on_energy(eos) ? energy_step(eos, {.energy = energy[i],
                                                                .pressure = 0,
                                                                .old_volume = 1 / p.density[i],
                                                                .new_volume = 1 / density[i],
                                                                .lowest_pressure = settings_.tension_cutoff})
                                                  .energy
                                            : 0;
    const LawPoint point = birdstrike::evaluate(eos, density[i], e);
    const double rho0 = reference_density(eos), x = density[i] / rho0;
    p.pressure[i] = std::max(point.pressure, settings_.tension_cutoff);
    p.sound_speed[i] = point.sound_speed;
    pressure_[i] = p.pressure[i];
    x_[i] = p.x[i], y_[i] = p.y[i], z_[i] = p.z[i];
    vx_[i] = vx[i], vy_[i] = vy[i], vz_[i] = vz[i];
    h_[i] = p.smoothing_length[i];
    sound_speed_[i] = point.sound_speed;
    weight_[i] = p.volume(i) / lattice;
    inertia_[i] = rho0 / x;
    rest_density_[i] = rho0;
    // q of 5.58 uses the rate of compression at the end of the step before.
    const double q = bulk ? bulk_viscosity(density[i], point.sound_speed, rates.divergence[i],
                                           std::cbrt(p.volume(i) / x), viscosity.linear, viscosity.quadratic)
                          : 0;
    shock_stress_[i] = q / (x * x);
    stress_[i] = p.pressure[i] / (x * x) + shock_stress_[i];
    limiter_[i] = rates.limiter[i];
    for (int c = 0; c < 6; ++c)
      strain_rate_[c][i] = rates.strain_rate[c][i];
  });
  pair_settings_.plate.reach =
      2 * ordered_reduce(
              n, 0.0, [&](double& most, std::size_t i) { most = std::max(most, h_[i]); },
              [](double& a, double b) { a = std::max(a, b); });
}

//! Into padded arrays, as the pair loops want them.
void SphRates::copy_walls(const MirrorPlanes& walls)
{
  const std::size_t n = walls.open.size();
  const auto copy = [n](const std::vector<double>& from, std::vector<double>& to) {
    to.resize(n + padding, 0.0);
    std::copy(from.begin(), from.end(), to.begin());
  };
  copy(walls.normal_x, wall_x_);
  copy(walls.normal_y, wall_y_);
  copy(walls.normal_z, wall_z_);
  copy(walls.offset, wall_at_);
  copy(walls.speed, wall_speed_);
  copy(walls.open, wall_open_);
  wall_fy_.resize(n + padding, 0.0);
  wall_fz_.resize(n + padding, 0.0);
}

void SphRates::finish(Particles& p, Rates& r, bool walls)
{
  r.image_force.resize(walls ? p.size() : 0);
  const ViscosityKind kind = settings_.viscosity.kind;
  const bool bulk = kind == ViscosityKind::bulk;
  for_each_row(p.size(), [&](std::size_t i) {
    // The mass may differ from volume times density (dissertation 8.3.3): that is inertia and nothing else.
    const double cell = p.volume(i), rho0 = p.mass[i] / cell, x = rest_density_[i] / inertia_[i];
    std::array<double, 9> g; // grad v
    for (std::size_t c = 0; c < 9; ++c)
      g[c] = gradient_[c][i] / x;
    const double compression_rate = -x * (g[0] + g[4] + g[8]); // D
    p.mean_pressure[i] = pressure_sum_[i] / number_[i];
    r.ax[i] = fx_[i] / rho0;
    r.ay[i] = fy_[i] / rho0;
    r.az[i] = fz_[i] / rho0;
    r.wall_force[i] = wall_[i] * cell;
    if (walls)
      r.image_force[i] = cell * Vector3(wall_[i], wall_fy_[i], wall_fz_[i]);
    r.divergence[i] = -compression_rate / x;
    r.density[i] = rest_density_[i] * compression_rate;
    r.summed_density[i] = rest_density_[i] * number_[i];
    r.viscous[i] = (heating_[i] + shock_stress_[i] * work_[i]) / rho0;
    r.energy[i] = r.viscous[i] + (stress_[i] - shock_stress_[i]) * work_[i] / rho0;
    r.approach[i] = bulk ? std::cbrt(cell / x) * std::abs(r.divergence[i]) : mu_[i];
    r.limiter[i] = kind == ViscosityKind::limited    ? plane_compression(g)
                   : kind == ViscosityKind::switched ? shear_switch(g)
                                                     : 1;
    const double strain_rate[6] = {g[0], g[4], g[8], g[1] + g[3], g[2] + g[6], g[5] + g[7]};
    for (int c = 0; c < 6; ++c)
      r.strain_rate[c][i] = strain_rate[c];
  });
}

void SphRates::evaluate(Particles& p, const std::vector<double>& vx, const std::vector<double>& vy,
                        const std::vector<double>& vz, const std::vector<double>& density,
                        const std::vector<double>& energy, const Neighbours& neighbours, Rates& rates,
                        const MirrorPlanes* walls)
{
  prepare(p, vx, vy, vz, density, energy, rates);
  if (walls)
    copy_walls(*walls);
  const auto of_walls = [walls](const std::vector<double>& array) { return walls ? array.data() : nullptr; };

  const PairInput in{x_.data(),
                     y_.data(),
                     z_.data(),
                     vx_.data(),
                     vy_.data(),
                     vz_.data(),
                     h_.data(),
                     weight_.data(),
                     pressure_.data(),
                     stress_.data(),
                     sound_speed_.data(),
                     inertia_.data(),
                     rest_density_.data(),
                     limiter_.data(),
                     of_walls(wall_x_),
                     of_walls(wall_y_),
                     of_walls(wall_z_),
                     of_walls(wall_at_),
                     of_walls(wall_speed_),
                     of_walls(wall_open_),
                     {strain_rate_[0].data(), strain_rate_[1].data(), strain_rate_[2].data(),
                      strain_rate_[3].data(), strain_rate_[4].data(), strain_rate_[5].data()}};
  PairOutput out{fx_.data(),     fy_.data(),           fz_.data(),      {},
                 number_.data(), pressure_sum_.data(), work_.data(),    heating_.data(),
                 mu_.data(),     wall_.data(),         wall_fy_.data(), wall_fz_.data()};
  for (std::size_t c = 0; c < 9; ++c)
    out.gradient[c] = gradient_[c].data();
  const Cluster* clusters = neighbours.clusters().data();
  const std::int32_t* partners = neighbours.partners().data();
  const int count = static_cast<int>(neighbours.clusters().size());
#pragma omp parallel for schedule(dynamic, 1)
  for (int first = 0; first < count; first += clusters_at_once)
    kernels_.rates(clusters, first, std::min(count, first + clusters_at_once), partners, in, pair_settings_,
                   out);

  finish(p, rates, walls != nullptr);
}

} // namespace birdstrike
