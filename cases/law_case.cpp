// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/law_case.h"

#include "cases/case.h"

#include "cases/law_table.h"
#include "core/error.h"
#include "core/material/porous_bird.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace birdstrike {
namespace {

struct Parameter
{
  std::string_view name;
  double LawCase::*value;
};
constexpr std::array parameters{
    Parameter{"density", &LawCase::density},
    Parameter{"bulk_modulus", &LawCase::bulk_modulus},
    Parameter{"B", &LawCase::B},
    Parameter{"gamma", &LawCase::gamma},
    Parameter{"C1", &LawCase::C1},
    Parameter{"C2", &LawCase::C2},
    Parameter{"C3", &LawCase::C3},
    Parameter{"mu_max", &LawCase::mu_max},
    Parameter{"c0", &LawCase::c0},
    Parameter{"slope", &LawCase::slope},
    Parameter{"slope_2", &LawCase::slope_2},
    Parameter{"slope_3", &LawCase::slope_3},
    Parameter{"gruneisen", &LawCase::gruneisen},
    Parameter{"gruneisen_slope", &LawCase::gruneisen_slope},
};

double or_else(double value, double otherwise) { return std::isnan(value) ? otherwise : value; }

template <class Law>
EquationOfState checked(const Law& law)
{
  law.check();
  return law;
}

struct Kind
{
  std::string_view name;
  std::vector<std::string_view> needed, optional; // "file" among them is LawCase::file
  EquationOfState (*make)(const LawCase& given, const std::filesystem::path& folder);
};

const std::vector<Kind>& kinds()
{
  using Path = std::filesystem::path;
  static const std::vector<Kind> all{
      {"linear",
       {"density", "bulk_modulus"},
       {},
       [](const LawCase& g, const Path&) {
         return checked(Linear{g.density, g.bulk_modulus});
       }},
      {"murnaghan",
       {"density", "B", "gamma"},
       {},
       [](const LawCase& g, const Path&) {
         return checked(Murnaghan{g.density, g.B, g.gamma});
       }},
      {"polynomial",
       {"density", "C1"},
       {"C2", "C3", "mu_max"},
       [](const LawCase& g, const Path&) {
         return checked(
             CubicPolynomial{g.density, g.C1, or_else(g.C2, 0), or_else(g.C3, 0), or_else(g.mu_max, 1)});
       }},
      {"hugoniot",
       {"density", "c0", "slope"},
       {},
       [](const LawCase& g, const Path&) {
         return EquationOfState(cubic_from_hugoniot(g.density, g.c0, g.slope));
       }},
      {"mie-gruneisen",
       {"density", "c0", "slope", "gruneisen"},
       {"slope_2", "slope_3", "gruneisen_slope"},
       [](const LawCase& g, const Path&) {
         return EquationOfState(
             MieGrueneisen(g.density, {g.c0, g.slope, or_else(g.slope_2, 0), or_else(g.slope_3, 0),
                                       g.gruneisen, or_else(g.gruneisen_slope, 0)}));
       }},
      {"table",
       {"file"},
       {},
       [](const LawCase& g, const Path& folder) {
         const LawTable table = read_law_table(folder / g.file);
         return EquationOfState(Tabulated(table.density, table.pressure, Path(g.file).filename().string()));
       }},
  };
  return all;
}

bool holds(const std::vector<std::string_view>& names, std::string_view name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

//! What the law needs and what it has not.
void check_parameters(const LawCase& given, const Kind& kind)
{
  const auto check = [&](std::string_view name, bool is_there) {
    const std::string needed = fmt::format(
        "law = \"{}\" needs {}{}", kind.name, fmt::join(kind.needed, ", "),
        kind.optional.empty() ? "" : fmt::format(" and may have {}", fmt::join(kind.optional, ", ")));
    if (holds(kind.needed, name) && !is_there)
      throw InputError(fmt::format("{}: eos.{}.{} is missing: {}", given.place, given.name, name, needed));
    if (is_there && !holds(kind.needed, name) && !holds(kind.optional, name))
      throw InputError(
          fmt::format("{}: eos.{}.{} has no meaning here: {}", given.place, given.name, name, needed));
  };
  for (const Parameter& parameter : parameters)
    check(parameter.name, !std::isnan(given.*parameter.value));
  check("file", !given.file.empty());
}

} // namespace

std::vector<std::string> law_kinds()
{
  std::vector<std::string> names;
  for (const Kind& kind : kinds())
    names.emplace_back(kind.name);
  return names;
}

EquationOfState make_law(const LawCase& given, const std::filesystem::path& folder)
{
  for (const Kind& kind : kinds()) {
    if (kind.name != given.law)
      continue;
    check_parameters(given, kind);
    try {
      return kind.make(given, folder);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: eos.{}: {}", given.place, given.name, error.what()));
    }
  }
  throw InputError(fmt::format("{}: eos.{}.law = \"{}\": one of \"{}\" is needed", given.place, given.name,
                               given.law, fmt::join(law_kinds(), "\", \"")));
}

EquationOfState natural_law(const std::string& name, double porosity, const std::vector<LawCase>& laws,
                            const std::filesystem::path& folder)
{
  for (const LawCase& law : laws)
    if (law.name == name)
      return make_law(law, folder);
  const auto known = porous_law_names();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    std::string own;
    for (const LawCase& law : laws)
      own += ", " + law.name;
    throw InputError(
        fmt::format("unknown equation of state '{}'; known are {}{}", name, fmt::join(known, ", "), own));
  }
  return make_porous_law(name, porosity, porous_density(porosity));
}

namespace {

bool has_own_law(const Case& parsed, const PartCase& part)
{
  return std::any_of(parsed.laws.begin(), parsed.laws.end(),
                     [&](const LawCase& law) { return law.name == part.eos; });
}

} // namespace

double porosity_of(const Case& parsed, const PartCase& part)
{
  return std::isnan(part.density) || has_own_law(parsed, part) ? part.porosity : porosity_of(part.density);
}

EquationOfState natural_law(const Case& parsed, const PartCase& part)
{
  if (std::isnan(part.density) || has_own_law(parsed, part)) {
    const EquationOfState law = natural_law(part.eos, part.porosity, parsed.laws, parsed.file.parent_path());
    return std::isnan(part.density) ? law : rescaled(law, part.density);
  }
  return make_porous_law(part.eos, porosity_of(part.density), part.density);
}

} // namespace birdstrike
