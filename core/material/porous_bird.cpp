// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/porous_bird.h"

#include "core/error.h"
#include "core/material/impact_event.h"
#include "core/material/porous_water.h"

#include <array>

namespace birdstrike {

namespace {

struct NamedLaw
{
  std::string_view name;
  EquationOfState (*make)(double porosity, double density);
};

constexpr std::array laws{
    NamedLaw{"impact-event",
             [](double z, double rho) -> EquationOfState { return impact_event_cubic(z, rho).law; }},
    NamedLaw{"impact-event-table",
             [](double z, double rho) -> EquationOfState { return impact_event_table(z, rho); }},
    NamedLaw{"shock", [](double z, double rho) -> EquationOfState { return shock_law(z, rho); }},
    NamedLaw{"isentropic", [](double z, double rho) -> EquationOfState { return isentropic_law(z, rho); }},
};

} // namespace

std::vector<std::string_view> porous_law_names()
{
  std::vector<std::string_view> names;
  for (const NamedLaw& law : laws)
    names.push_back(law.name);
  return names;
}

EquationOfState make_porous_law(const std::string& name, double porosity, double density)
{
  require(porosity >= 0 && porosity <= 0.9, "porosity " + std::to_string(porosity) + " is outside 0 ... 0.9");
  require(density > 0, "the reference density of '" + name + "' must be positive");
  std::string known;
  for (const NamedLaw& law : laws) {
    if (law.name == name)
      return law.make(porosity, density);
    known += (known.empty() ? "" : ", ") + std::string(law.name);
  }
  throw InputError("unknown equation of state '" + name + "'; known are " + known);
}

double porous_density(double porosity)
{
  return (1 - porosity) * porous_water::water_density + porosity * porous_water::air_density;
}

double porosity_of(double density)
{
  return (porous_water::water_density - density) / (porous_water::water_density - porous_water::air_density);
}

} // namespace birdstrike
