// SPDX-License-Identifier: GPL-3.0-or-later
// The length unit of a mesh that does not say it.
#include "geometry/import/guess_unit.h"

#include "core/error.h"
#include "geometry/import/number_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace birdstrike {

namespace {

struct Unit
{
  const char *name, *plural;
  double length; // [m]
  bool rare;
};
constexpr Unit units[] = {{"m", "metres", 1, false},
                          {"cm", "centimetres", 1e-2, false},
                          {"mm", "millimetres", 1e-3, false},
                          {"inch", "inches", 0.0254, false},
                          {"foot", "feet", 0.3048, true}};

struct Candidate
{
  Unit unit;
  double span, density; // density 0: unknown
  bool span_fits() const { return span >= smallest_span && span <= largest_span; }
  bool density_fits() const { return density >= lightest_bird && density <= heaviest_bird; }
  //! How many times the density lies off a bird's.
  double density_off() const
  {
    return density <= 0 ? 1 : std::max({1.0, lightest_bird / density, density / heaviest_bird});
  }
  std::string text() const
  {
    return std::string(unit.name) + " (" + number_text(span) + " m wide" +
           (density > 0 ? ", " + number_text(density) + " kg/m3" : "") + ")";
  }
};

std::string list(const std::vector<Candidate>& candidates)
{
  std::string text;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    text += (i == 0 ? "" : i + 1 == candidates.size() ? " or " : ", ") + candidates[i].text();
  return text;
}

// With a mass, densities of two units differ at least by 2.54^3 = 16. One that is off the range of birds by less than
// this still tells them apart: dirty meshes enclose more or less than they should, and cases scale masses.
constexpr double density_slack = 3;

} // namespace

std::string unit_name(double unit)
{
  for (const Unit& one : units)
    if (std::abs(unit - one.length) < 1e-9 * one.length)
      return one.name;
  return number_text(unit) + " m";
}

UnitGuess guess_unit(const std::string& subject, double extent, double volume, double mass)
{
  std::vector<Candidate> all, fitting;
  for (const Unit& unit : units)
    all.push_back({unit, extent * unit.length,
                   mass > 0 && volume > 0 ? mass / (volume * std::pow(unit.length, 3)) : 0});
  const std::string remedy = "; give the unit of the mesh";
  for (const Candidate& one : all)
    if (one.span_fits() && one.density_off() <= density_slack)
      fitting.push_back(one);
  if (fitting.empty()) {
    const bool spans = std::any_of(all.begin(), all.end(), [](const auto& one) { return one.span_fits(); });
    throw InputError(subject + ": no length unit gives a bird of 0.2 m to 3.6 m wingspan" +
                     (spans ? " and 300 to 1200 kg/m3" : "") + "; one file unit would be " + list(all) +
                     remedy);
  }
  const bool by_mass = fitting.front().density > 0;
  if (!by_mass && std::any_of(fitting.begin(), fitting.end(), [](const auto& one) { return !one.unit.rare; }))
    std::erase_if(fitting, [](const Candidate& one) { return one.unit.rare; });
  require(fitting.size() == 1, subject + ": its length unit cannot be told: " + list(fitting) +
                                   " fit equally" + remedy + (by_mass ? "" : ", or the mass of the bird"));
  const Candidate& best = fitting.front();
  UnitGuess guess{best.unit.length,
                  std::string("taken as ") + best.unit.plural + ": that makes it " + number_text(best.span) +
                      " m wide",
                  !best.density_fits() && best.density > 0};
  if (by_mass)
    guess.reason += " and " + number_text(best.density) + " kg/m3 heavy on average";
  return guess;
}

} // namespace birdstrike
