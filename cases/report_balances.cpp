// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a run kept what it has to keep.
#include "cases/report_balances.h"

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {
namespace {

enum class Verdict
{
  good,
  fair,
  bad,
  open
};

Json row(const std::string& name, Json value, Verdict verdict, const std::string& why)
{
  static constexpr std::array names{"good", "fair", "bad", "open"};
  static constexpr std::array marks{"fine", "look at it", "not fine", "no judgement"};
  const auto k = static_cast<std::size_t>(verdict);
  return {
      {"name", name}, {"value", std::move(value)}, {"verdict", names[k]}, {"mark", marks[k]}, {"why", why}};
}

//! good up to the first bound, fair up to the second one
Verdict by_size(double value, double fine, double tolerable)
{
  return std::abs(value) <= fine        ? Verdict::good
         : std::abs(value) <= tolerable ? Verdict::fair
                                        : Verdict::bad;
}

std::string entry(const ReportFolder& run, const std::string& key)
{
  for (const Entry& one : run.case_entries)
    if (join(one.path) == key && one.values.size() == 1 && std::holds_alternative<std::string>(one.values[0]))
      return std::get<std::string>(one.values[0]);
  return {};
}

bool is_rigid(const ReportFolder& run)
{
  for (const Entry& one : run.case_entries)
    if (join(one.path) == "target.rigid" && one.values.size() == 1 &&
        std::holds_alternative<bool>(one.values[0]))
      return std::get<bool>(one.values[0]);
  return true;
}

void add_mass(Json& rows, const ReportFolder& run)
{
  const auto mass = number_at(run.summary, {"bird", "mass"});
  if (!mass)
    return;
  const auto factor = number_at(run.summary, {"density_factor"});
  const double off = factor ? *factor - 1 : 0;
  std::string why = "Every particle keeps its mass, so that the bird's is constant by construction.";
  if (const std::string asked = entry(run, "bird.mass"); !asked.empty())
    why += fmt::format(" The case asks for {}.", asked);
  if (factor)
    why += fmt::format(" The densities of the parts are {} times those of their materials, to meet it{}",
                       short_number(*factor),
                       std::abs(off) <= 0.02 ? "."
                                             : ": more than 2 % off; the mass and the volume of the bird "
                                               "do not go together.");
  rows.push_back(row("Mass of the bird", quantity(mass, 1, "kg"), by_size(off, 0.02, 0.1), why));
}

void add_momentum(Json& rows, const Json& summary)
{
  if (const auto error = number_at(summary, {"impulse_error"}))
    rows.push_back(
        row("Momentum", quantity(error, 100, "%"), by_size(*error, 1e-6, 1e-3),
            "Impulse on the target against the momentum that the bird has lost, over its momentum. Forces "
            "between particles are pairs, so that only rounding may be left."));
}

void add_energy(Json& rows, const ReportFolder& run)
{
  if (const auto error = number_at(run.summary, {"energy", "balance_error"})) {
    const Verdict verdict = by_size(*error, 0.01, 0.05);
    rows.push_back(row("Energy, equation 5.59", quantity(error, 100, "%"), verdict,
                       std::string("Kinetic and internal energy at the end against those at the start. ") +
                           (verdict == Verdict::good
                                ? "Up to 1 % the time step and the viscosity are right."
                                : "Above 1 %: a smaller run.courant, another run.viscosity or a smaller "
                                  "bird.spacing may keep it.")));
    return;
  }
  const std::size_t column = run.history.find("energy_balance_error");
  if (run.history.rows() > 0 && column < run.history.columns.size()) {
    const double last = run.history.at(run.history.rows() - 1, column);
    rows.push_back(row("Energy, equation 5.59", quantity(last, 100, "%"), by_size(last, 0.01, 0.05),
                       "At the last step that histories.csv has: the run is not complete."));
  }
}

void add_impulse(Json& rows, const ReportFolder& run)
{
  const auto share = number_at(run.summary, {"impulse_over_normal_momentum"});
  if (!share)
    return;
  const auto eroded = number_at(run.summary, {"target", "eroded_elements"});
  const auto momentum = number_at(run.summary, {"bird", "momentum"});
  const auto left = number_at(run.summary, {"bird", "final_momentum"});
  const bool flies_on = momentum && left && *left > 0.05 * *momentum;
  Verdict verdict = Verdict::open;
  std::string why = "What the target received along its normal over the bird's momentum across it. ";
  if (!is_rigid(run))
    why += eroded && *eroded > 0 ? "The target broke, and what flies through it keeps its momentum."
                                 : "The target gives way, which the ratio of a rigid one does not tell of.";
  else if (*share < 0.95 && flies_on)
    why += fmt::format("The bird still has {:.0f} % of its momentum: the impact is not over at the end of "
                       "the run, or part of "
                       "the bird misses the target. A later run.end shows the whole of it.",
                       100 * *left / *momentum);
  else {
    verdict = *share >= 0.95 && *share <= 1.1   ? Verdict::good
              : *share >= 0.85 && *share <= 1.2 ? Verdict::fair
                                                : Verdict::bad;
    why += "1 if the bird comes to rest across a rigid target, up to 1.1 as flesh springs back a little.";
  }
  rows.push_back(row("Impulse ratio", quantity(share, 1, ""), verdict, why));
}

void add_target(Json& rows, const Json& summary)
{
  if (const auto share = number_at(summary, {"target", "hourglass_over_internal"}))
    rows.push_back(row(
        "Hourglass energy", quantity(share, 100, "%"), by_size(*share, 0.05, 0.1),
        "Over the internal energy of the target. Up to 5 % its elements bend as the material does and not in "
        "patterns of the mesh."));
  if (const auto leaked = number_at(summary, {"target", "leaked_particles"}))
    rows.push_back(row("Leaked particles", quantity(leaked, 1, ""),
                       *leaked == 0 ? Verdict::good : Verdict::bad,
                       *leaked == 0 ? "None has passed the target other than through a hole or beside it."
                                    : "They have passed the unbroken target, and its load lacks theirs."));
}

} // namespace

Json report_balances(const ReportFolder& run)
{
  Json rows = Json::array();
  add_mass(rows, run);
  add_momentum(rows, run.summary);
  add_impulse(rows, run);
  add_energy(rows, run);
  add_target(rows, run.summary);
  return rows;
}

} // namespace birdstrike
