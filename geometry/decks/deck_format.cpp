// SPDX-License-Identifier: GPL-3.0-or-later
// Which solvers a bird can be handed to, and the systems of units that their users work in.
#include "geometry/decks/deck_format.h"

#include "core/error.h"

#include <array>

namespace birdstrike {

namespace {

struct FormatRow
{
  DeckFormat format;
  std::string_view name, extension;
};

constexpr std::array formats{FormatRow{DeckFormat::dyna, "dyna", ".k"},
                             FormatRow{DeckFormat::radioss, "radioss", ".rad"},
                             FormatRow{DeckFormat::abaqus, "abaqus", ".inp"}};

constexpr double inch = 0.0254, foot = 0.3048,
                 pound_force = 4.4482216152605; // [m, m, N], exact by definition

std::string listed(const std::vector<std::string>& names)
{
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return text;
}

} // namespace

std::vector<std::string> deck_format_names()
{
  std::vector<std::string> names;
  for (const FormatRow& row : formats)
    names.emplace_back(row.name);
  return names;
}

DeckFormat deck_format(std::string_view name)
{
  for (const FormatRow& row : formats)
    if (row.name == name)
      return row.format;
  throw InputError("no deck is known for a solver \"" + std::string(name) + "\"; known are " +
                   listed(deck_format_names()));
}

std::string deck_extension(DeckFormat format)
{
  for (const FormatRow& row : formats)
    if (row.format == format)
      return std::string(row.extension);
  return {};
}

std::vector<DeckUnits> deck_unit_systems()
{
  return {{"kg-m-s", 1, 1, 1, "Pa", "J"},
          {"t-mm-s", 1e3, 1e-3, 1, "MPa", "mJ"},
          {"kg-mm-ms", 1, 1e-3, 1e-3, "GPa", "J"},
          {"g-mm-ms", 1e-3, 1e-3, 1e-3, "MPa", "mJ"},
          {"g-cm-us", 1e-3, 1e-2, 1e-6, "100 GPa", "100 kJ"},
          {"lbf-s2/in-in-s", pound_force / inch, inch, 1, "psi", "in lbf"},
          {"slug-ft-s", pound_force / foot, foot, 1, "psf", "ft lbf"}};
}

std::vector<std::string> deck_unit_names()
{
  std::vector<std::string> names;
  for (const DeckUnits& units : deck_unit_systems())
    names.push_back(units.name);
  return names;
}

DeckUnits deck_units(std::string_view name)
{
  for (const DeckUnits& units : deck_unit_systems())
    if (units.name == name)
      return units;
  throw InputError("no system of units \"" + std::string(name) +
                   "\" is known (mass, length, time); known are " + listed(deck_unit_names()));
}

} // namespace birdstrike
