// SPDX-License-Identifier: GPL-3.0-or-later
// Scalars of a finished run.
#include "cases/summary.h"

#include "core/particles/pair_kernels.h"
#include "core/simulation.h"
#include "core/theory/impact_pressures.h"
#include "core/theory/water_hammer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace birdstrike {
namespace {

struct Peak
{
  std::string name; //!< "all" or a part
  double value = 0, time = 0;
};

//! Largest value of every column max_pressure_<name>, and when.
//! \param prefix  of the columns, before the name of the part
std::vector<Peak> peaks(const History& history, std::string_view prefix = "max_pressure_")
{
  std::vector<Peak> result;
  for (std::size_t column = 0; column < history.columns.size(); ++column) {
    if (!history.columns[column].name.starts_with(prefix))
      continue;
    Peak peak{history.columns[column].name.substr(prefix.size()), -INFINITY, 0};
    for (std::size_t row = 0; row < history.rows(); ++row)
      if (history.at(row, column) > peak.value) {
        peak.value = history.at(row, column);
        peak.time = history.at(row, 0);
      }
    result.push_back(peak);
  }
  return result;
}

double largest(const History& history, const std::string& name)
{
  double value = 0;
  if (const std::size_t column = history.find(name); column < history.columns.size())
    for (std::size_t row = 0; row < history.rows(); ++row)
      value = std::max(value, history.at(row, column));
  return value;
}

//! Particles that contact has lost: behind a plate's face within its outline, or through an unbroken mesh.
std::size_t leaked_particles(const Simulation& run)
{
  if (run.contact())
    return static_cast<std::size_t>(run.contact()->leaked());
  std::size_t count = 0;
  const Particles& p = run.particles();
  for (std::size_t i = 0; run.plate() && i < p.size(); ++i)
    count += p.x[i] > 0 && run.plate()->element_at(p.y[i], p.z[i]) >= 0;
  return count;
}

//! Largest length of a displacement of the target, and when; zero without the column.
Peak largest_deflection(const History& history)
{
  Peak peak;
  if (const std::size_t column = history.find("max_deflection"); column < history.columns.size())
    for (std::size_t row = 0; row < history.rows(); ++row)
      if (history.at(row, column) > peak.value)
        peak = {"", history.at(row, column), history.at(row, 0)};
  return peak;
}

//! The value farthest from zero, with its sign, and when.
Peak largest_magnitude(const History& history, std::size_t column)
{
  Peak peak;
  for (std::size_t row = 0; row < history.rows(); ++row)
    if (std::abs(history.at(row, column)) > std::abs(peak.value))
      peak = {"", history.at(row, column), history.at(row, 0)};
  return peak;
}

//! Hourglass energy over internal energy, elements that are gone left out.
double hourglass_share(const ShellEnergy& energy)
{
  return energy.internal > 0 ? energy.hourglass / energy.internal : 0;
}

double updates_per_second(const Simulation& run)
{
  const double seconds = run.shares().total - run.shares().writing;
  return seconds > 0
             ? static_cast<double>(run.particles().size()) * static_cast<double>(run.steps()) / seconds
             : 0;
}

//! Exact pressures of a part at the bird's first speed: the shock's at its component into the plate, those of the
//! stagnation point at the whole of it, as its streamline is slowed down to rest whatever the angle (section 7.3).
struct Theory
{
  std::string part;
  double hugoniot, bernoulli, standing_shock; //!< [Pa]
  double
      compliant; //!< 2.4, on a target that gives way before waves come back through its thickness; NaN if rigid [Pa]
};

//! rho c of a wave across the thickness of the target's first part; NaN for a target that does not move [kg/m2/s].
double target_impedance(const Simulation& run)
{
  const Shells* shells = run.mesh_target() ? run.mesh_target()->shells() : nullptr;
  return shells ? std::sqrt(shells->section_of(0).material.density * run.mesh_target()->surface().modulus[0])
                : NAN;
}

//! 2.4 with the shock speed that 2.4 wants, at the impact speed.
double compliant_pressure(const EquationOfState& eos, double speed, double impedance)
{
  if (std::isnan(impedance))
    return NAN;
  return compliant_target_pressure(reference_density(eos) * hugoniot(eos, speed).shock_speed, impedance,
                                   speed);
}

std::vector<Theory> theory_of(const Simulation& run)
{
  std::vector<Theory> rows;
  const Ledger& ledger = run.ledger();
  const double speed = ledger.mass > 0 ? ledger.initial_momentum[0] / ledger.mass : 0;
  const double whole = ledger.mass > 0 ? ledger.initial_momentum.norm() / ledger.mass : 0;
  for (const Part& part : run.particles().parts)
    if (speed > 0)
      rows.push_back({part.name, hugoniot(part.eos, speed).pressure, stagnation_bernoulli(part.eos, whole),
                      stagnation_standing_shock(part.eos, whole),
                      compliant_pressure(part.eos, speed, target_impedance(run))});
  return rows;
}

} // namespace

std::string summary_json(const Simulation& run, const RunFacts& facts)
{
  const Ledger& ledger = run.ledger();
  const double momentum = ledger.initial_momentum.norm();
  const Vector3 along = momentum > 0 ? Vector3(ledger.initial_momentum / momentum) : Vector3::UnitX();
  const double impulse = ledger.impulse.dot(along);
  const Vector3 lost = ledger.initial_momentum - ledger.momentum;

  nlohmann::ordered_json json;
  json["version"] = BIRDSTRIKE_VERSION; // of the program
  json["instruction_set"] = pair_kernels().name;
  json["threads"] = run.settings().threads > 0 ? run.settings().threads : omp_get_max_threads();
  json["particles"] = run.particles().size();
  json["steps"] = run.steps();
  json["wall_seconds"] = facts.wall_seconds;
  json["updates_per_second"] = updates_per_second(run);
  json["bird"] = {
      {"mass", ledger.mass}, {"momentum", momentum}, {"final_momentum", ledger.momentum.dot(along)}};
  if (!facts.bird.empty()) {
    const auto bird = nlohmann::ordered_json::parse(facts.bird);
    for (const auto& [key, value] : bird.items())
      if (!json["bird"].contains(key))
        json["bird"][key] = value;
  }
  json["density_factor"] = facts.density_factor;
  json["impulse"] = impulse;
  json["impulse_over_momentum"] = momentum > 0 ? impulse / momentum : 0;
  const double normal_momentum = ledger.initial_momentum[0];
  json["impulse_over_normal_momentum"] = normal_momentum > 0 ? ledger.impulse[0] / normal_momentum : 0;
  json["impulse_error"] = momentum > 0 ? (lost - ledger.impulse).norm() / momentum : 0;
  json["contact_time"] = nullptr;
  json["first_force_time"] = nullptr;
  if (run.first_contact()) {
    json["contact_time"] = facts.contact_time;
    json["first_force_time"] = *run.first_contact();
  }
  json["energy"] = {{"initial", ledger.initial_energy},
                    {"final", ledger.total_energy()},
                    {"balance_error", ledger.balance_error()}};
  for (const Peak& peak : peaks(run.history()))
    json["peak_pressure"][peak.name] = {{"value", peak.value}, {"time", peak.time}};
  for (const Peak& peak : peaks(run.history(), "max_mean_pressure_"))
    json["peak_mean_pressure"][peak.name] = {{"value", peak.value}, {"time", peak.time}};
  json["peak_contact_force"] = largest(run.history(), "contact_force_x");
  const Peak deflection = largest_deflection(run.history());
  const Shells* shells = run.mesh_target() ? run.mesh_target()->shells() : nullptr;
  json["target"] = {{"max_deflection", deflection.value},
                    {"max_deflection_time", deflection.time},
                    {"permanent_set", run.permanent_set().set},
                    {"residual_amplitude", run.permanent_set().amplitude},
                    {"eroded_elements", shells ? shells->eroded() : 0},
                    {"leaked_particles", leaked_particles(run)}};
  if (run.initial_gap())
    json["target"]["initial_gap"] = run.initial_gap()->gap;
  if (shells) {
    const ShellEnergy& e = ledger.target;
    json["target"]["mass"] = shells->total_mass();
    json["target"]["energy"] = {{"kinetic", e.kinetic},     {"internal", e.internal}, {"plastic", e.plastic},
                                {"hourglass", e.hourglass}, {"eroded", e.eroded},     {"damped", e.damped},
                                {"external", e.external}};
    json["target"]["hourglass_over_internal"] = hourglass_share(e);
    json["target"]["support_impulse"] = {ledger.support_impulse[0], ledger.support_impulse[1],
                                         ledger.support_impulse[2]};
    for (std::size_t c = 0; c < run.history().columns.size(); ++c)
      if (const std::string& name = run.history().columns[c].name; name.starts_with("deflection_")) {
        const Peak peak = largest_magnitude(run.history(), c);
        json["target"]["deflections"][name.substr(11)] = {{"value", peak.value}, {"time", peak.time}};
      }
  }
  if (run.contact())
    json["energy"]["contact"] = {
        {"stored", ledger.contact}, {"released", ledger.contact_released}, {"friction", ledger.friction}};
  // The bird's own three are those of the part with the highest Hugoniot pressure.
  const std::vector<Theory> theory = theory_of(run);
  const auto values = [](const Theory& t) {
    nlohmann::ordered_json row{{"hugoniot_pressure", t.hugoniot},
                               {"stagnation_bernoulli", t.bernoulli},
                               {"stagnation_standing_shock", t.standing_shock}};
    if (!std::isnan(t.compliant))
      row["compliant_target_pressure"] = t.compliant;
    return row;
  };
  if (!theory.empty()) {
    json["theory"] =
        values(*std::max_element(theory.begin(), theory.end(),
                                 [](const Theory& a, const Theory& b) { return a.hugoniot < b.hugoniot; }));
    for (const Theory& row : theory)
      json["theory"][row.part] = values(row);
  }
  if (!facts.transducers.empty())
    json["transducers"] = to_json(facts.transducers);
  if (!theory.empty())
    for (const TransducerReport& one : facts.transducers) {
      const auto ratio = [&](double pressure, const char* exact) {
        const double value = pressure / json["theory"][exact].get<double>();
        return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
      };
      json["transducers"][one.name]["pulse_over_hugoniot"] = ratio(one.pulse_mean, "hugoniot_pressure");
      json["transducers"][one.name]["steady_over_stagnation"] =
          ratio(one.steady_mean, "stagnation_standing_shock");
    }
  if (facts.planar)
    json["verification"] = to_json(*facts.planar);
  const Shares& shares = run.shares();
  json["shares"] = {{"particles", shares.particles}, {"shells", shares.shells},
                    {"contact", shares.contact},     {"gauges", shares.gauges},
                    {"writing", shares.writing},     {"figures", facts.figure_seconds}};
  json["series_bytes"] = facts.series_bytes;
  json["peak_pressure_on_frames"] = facts.peak_on_frames;
  return json.dump(2) + "\n";
}

std::string summary_table(const Simulation& run, const RunFacts& facts)
{
  const Ledger& ledger = run.ledger();
  const double momentum = ledger.initial_momentum.norm();
  std::string text = fmt::format("{:<22} {}\n", "particles, steps",
                                 fmt::format("{}, {}", run.particles().size(), run.steps()));
  const auto row = [&](const std::string& name, const std::string& value) {
    text += fmt::format("{:<22} {}\n", name, value);
  };
  row("wall time", fmt::format("{:.1f} s, {:.2f} million particle updates per second", facts.wall_seconds,
                               1e-6 * updates_per_second(run)));
  row("first contact", run.first_contact() ? fmt::format("{:.4f} ms", 1e3 * facts.contact_time) : "none");
  row("impulse", fmt::format("{:.2f} N s, {:.4f} of the bird's momentum", ledger.impulse.norm(),
                             momentum > 0 ? ledger.impulse.norm() / momentum : 0));
  row("largest force", fmt::format("{:.1f} kN", 1e-3 * largest(run.history(), "contact_force_x")));
  if (const Shells* shells = run.mesh_target() ? run.mesh_target()->shells() : nullptr) {
    const Peak deflection = largest_deflection(run.history());
    const PermanentSet::Largest rest = run.permanent_set();
    row("target",
        fmt::format("largest deflection {:.2f} mm at {:.3f} ms, permanent set {:.2f} mm, about which it "
                    "still swings by {:.2f} mm",
                    1e3 * deflection.value, 1e3 * deflection.time, 1e3 * rest.set, 1e3 * rest.amplitude));
    row("", fmt::format(
                "{} of {} elements eroded, plastic energy {:.4g} J, hourglass {:.2f} % of internal energy",
                shells->eroded(), shells->mesh().elements.size(), ledger.target.plastic,
                100 * hourglass_share(ledger.target)));
  }
  if (run.contact() && leaked_particles(run) > 0)
    row("leaked particles", fmt::format("{}: they have passed the unbroken target", leaked_particles(run)));
  row("energy balance error", fmt::format("{:.4f} %", 100 * ledger.balance_error()));
  const std::vector<Theory> theory = theory_of(run);
  for (const Peak& peak : peaks(run.history())) {
    std::string exact;
    for (const Theory& t : theory)
      if (t.part == peak.name)
        exact = fmt::format("; plane shock {:.2f} MPa", 1e-6 * t.hugoniot);
    row("peak pressure " + peak.name,
        fmt::format("{:.2f} MPa at {:.3f} ms{}", 1e-6 * peak.value, 1e3 * peak.time, exact));
  }
  for (const TransducerReport& t : facts.transducers)
    row("transducer " + t.name,
        fmt::format("peak {:.2f} MPa at {:.3f} ms{}{}", 1e-6 * t.peak, 1e3 * t.peak_time,
                    std::isfinite(t.pulse_mean) ? fmt::format(", pulse {:.2f} MPa", 1e-6 * t.pulse_mean) : "",
                    std::isfinite(t.steady_mean) ? fmt::format(", steady {:.2f} MPa", 1e-6 * t.steady_mean)
                                                 : ""));
  if (facts.planar)
    row("plane wave",
        fmt::format("plateau {:.4g} MPa, Hugoniot {:.4g} MPa, ripple {:.2f} %, overshoot {:.2f}",
                    1e-6 * facts.planar->plateau_mean, 1e-6 * facts.planar->hugoniot_pressure,
                    100 * facts.planar->plateau_ripple, facts.planar->overshoot));
  row("series", fmt::format("{:.1f} MB", 1e-6 * static_cast<double>(facts.series_bytes)));
  text.pop_back();
  return text;
}

} // namespace birdstrike
