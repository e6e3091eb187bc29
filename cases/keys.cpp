// SPDX-License-Identifier: GPL-3.0-or-later
// The table of keys, and what is looked up in it.
#include "cases/keys.h"

#include "core/material/porous_bird.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike {
namespace {

using enum Dimension;

Range above(double low) { return {low, {}, true}; }
Range at_least(double low) { return {low, {}, false}; }
Range at_most(double high) { return {{}, high, false}; }
Range within(double low, double high) { return {low, high, false}; }
Range above_within(double low, double high) { return {low, high, true}; }

std::vector<std::string> law_names()
{
  const auto names = porous_law_names();
  return {names.begin(), names.end()};
}
std::vector<std::string> viscosity_names() { return {"pairwise", "dissertation"}; }

// clang-format off
#define SLOT(member) [](Case& c, std::size_t) -> Slot { return &c.member; }
#define LAW_SLOT(member) [](Case& c, std::size_t row) -> Slot { return &c.laws[row].member; }
#define PART_SLOT(member) [](Case& c, std::size_t part) -> Slot { return &c.bird.parts[part].member; }
const std::vector<Key>& table()
{
  static const std::vector<Key> rows{
    {"title", number, "", true, {}, "what the case shows, in one line", SLOT(title)},
    {"source", number, "", false, {}, "where the case comes from", SLOT(source)},

    {"bird.mesh", number, "", true, {}, "mesh file with named parts: a path beside the case, or a file of share/meshes", SLOT(bird.mesh)},
    {"bird.mesh_unit", length, "m", false, above(0), "length of one unit of the mesh file", SLOT(bird.mesh_unit)},
    {"bird.mass", mass, "kg", true, above(0), "mass of the whole bird, met exactly", SLOT(bird.mass)},
    {"bird.spacing", length, "mm", true, above(0), "distance between particles", SLOT(bird.spacing)},
    {"bird.velocity", velocity, "m/s", true, above(0), "speed towards the target, along +x", SLOT(bird.velocity)},
    {"bird.gap", length, "mm", false, at_least(0), "distance between bird and target at the start", SLOT(bird.gap)},
    {"bird.smoothing", number, "", false, within(0.8, 3), "smoothing length over spacing", SLOT(bird.smoothing)},
    {"bird.yaw", angle, "deg", false, {}, "turns the nose to the bird's left, about the vertical axis", SLOT(bird.yaw)},
    {"bird.pitch", angle, "deg", false, {}, "turns the nose up", SLOT(bird.pitch)},
    {"bird.roll", angle, "deg", false, {}, "turns the left wing up, about the flight axis", SLOT(bird.roll)},
    {"bird.parts.*.porosity", number, "", false, within(0, 0.9), "volume share of air in the part's material; required with a law of porous flesh", PART_SLOT(porosity)},
    {"bird.parts.*.eos", number, "", false, {}, "equation of state of the part", PART_SLOT(eos), law_names, true},

    {"eos.*.law", number, "", true, {}, "kind of the law; it needs: linear density, bulk_modulus; murnaghan density, B, gamma; polynomial density, C1 [C2, C3, mu_max]; hugoniot density, c0, slope; mie-gruneisen density, c0, slope, gruneisen [slope_2, slope_3, gruneisen_slope]; table file", LAW_SLOT(law), law_kinds},
    {"eos.*.density", density, "kg/m3", false, above(0), "density at rest; a part scaled to meet the bird's mass keeps the pressure as a function of density / density at rest", LAW_SLOT(density)},
    {"eos.*.bulk_modulus", pressure, "MPa", false, above(0), "K of p = K (rho/rho0 - 1)", LAW_SLOT(bulk_modulus)},
    {"eos.*.B", pressure, "MPa", false, above(0), "of p = B [(rho/rho0)^gamma - 1]: bulk modulus over gamma", LAW_SLOT(B)},
    {"eos.*.gamma", number, "", false, at_least(1), "exponent of Murnaghan's law", LAW_SLOT(gamma)},
    {"eos.*.C1", pressure, "MPa", false, above(0), "of p = C1 mu + C2 mu^2 + C3 mu^3, mu = rho/rho0 - 1", LAW_SLOT(C1)},
    {"eos.*.C2", pressure, "MPa", false, {}, "of the polynomial; 0 if not given", LAW_SLOT(C2)},
    {"eos.*.C3", pressure, "MPa", false, {}, "of the polynomial; 0 if not given", LAW_SLOT(C3)},
    {"eos.*.mu_max", number, "", false, above(0), "compression up to which the polynomial has to rise; 1 if not given", LAW_SLOT(mu_max)},
    {"eos.*.c0", velocity, "m/s", false, above(0), "sound speed at rest, of the shock curve us = c0 + slope u", LAW_SLOT(c0)},
    {"eos.*.slope", number, "", false, at_least(0), "slope of the shock curve", LAW_SLOT(slope)},
    {"eos.*.slope_2", number, "", false, {}, "S2 of us = c0 + (slope + S2 u/us + S3 (u/us)^2) u; 0 if not given", LAW_SLOT(slope_2)},
    {"eos.*.slope_3", number, "", false, {}, "S3 of the same; 0 if not given", LAW_SLOT(slope_3)},
    {"eos.*.gruneisen", number, "", false, at_least(0), "Grueneisen's Gamma at rest", LAW_SLOT(gruneisen)},
    {"eos.*.gruneisen_slope", number, "", false, {}, "a of rho Gamma = rho0 (gruneisen + a mu); 0 if not given", LAW_SLOT(gruneisen_slope)},
    {"eos.*.file", number, "", false, {}, "table with the columns density [kg/m3] and pressure [Pa], a path beside the case", LAW_SLOT(file)},

    {"target.plate.size", length, "m", true, above(0), "edge lengths of the plate, sideways and upwards", SLOT(target.size)},
    {"target.plate.thickness", length, "mm", true, above(0), "thickness of the plate", SLOT(target.thickness)},
    {"target.plate.elements", number, "", true, within(1, 2000), "number of elements, sideways and upwards", SLOT(target.elements)},
    {"target.rigid", number, "", false, {}, "the plate does not move; deformable plates are not available yet", SLOT(target.rigid)},

    {"run.end", time, "ms", true, above(0), "simulated time", SLOT(run.end_time)},
    {"run.frames", number, "", false, within(1, 100000), "states written after the one at the start, evenly spaced", SLOT(run.frames)},
    {"run.courant", number, "", false, above_within(0, 1), "share of the largest stable time step", SLOT(run.courant)},
    {"run.viscosity", number, "", false, {}, "artificial viscosity: between pairs, or the bulk term of equation 5.58", SLOT(run.viscosity.kind), viscosity_names},
    {"run.viscosity_linear", number, "", false, at_least(0), "coefficient of the term linear in the rate of compression; 0.06 with viscosity = \"dissertation\"", SLOT(run.viscosity.linear)},
    {"run.viscosity_quadratic", number, "", false, at_least(0), "coefficient of the quadratic term; 1.5 with viscosity = \"dissertation\"", SLOT(run.viscosity.quadratic)},
    {"run.shear_switch", number, "", false, {}, "pairwise viscosity fades where the flow shears or turns", SLOT(run.viscosity.shear_switch)},
    {"run.tension_cutoff", pressure, "MPa", false, at_most(0), "lowest pressure that a particle can carry", SLOT(run.tension_cutoff)},
    {"run.smoothing_shrink", number, "", false, above_within(0, 1), "smallest smoothing length over its first value", SLOT(run.smoothing_shrink)},
    {"run.smoothing_growth", number, "", false, at_least(1), "largest smoothing length over its first value", SLOT(run.smoothing_growth)},
  };
  return rows;
}
#undef SLOT
#undef LAW_SLOT
#undef PART_SLOT
// clang-format on

//! A Case with one part, to look defaults up in.
Case& defaults()
{
  static Case values = [] {
    Case c;
    c.bird.parts.emplace_back();
    c.laws.emplace_back();
    return c;
  }();
  return values;
}

std::vector<std::string> split(std::string_view path)
{
  std::vector<std::string> segments;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find('.', from), path.size());
    segments.emplace_back(path.substr(from, to - from));
    from = to + 1;
  }
  return segments;
}

//! The key's path with '*' replaced by what stands there in \p path.
std::string named(const Key& key, const std::vector<std::string>& path)
{
  std::vector<std::string> segments = split(key.path);
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i] == "*")
      segments[i] = i < path.size() ? path[i] : segments.front() == "eos" ? "<name>" : "<part>";
  return fmt::format("{}", fmt::join(segments, "."));
}

//! Levenshtein's distance.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above_left = diagonal;
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, above_left + (a[i - 1] != b[j - 1])});
    }
  }
  return row[b.size()];
}

template <class... F>
struct Overload : F...
{
  using F::operator()...;
};

} // namespace

std::span<const Key> case_keys() { return table(); }

const Key* find_key(const std::vector<std::string>& path)
{
  for (const Key& key : table()) {
    const std::vector<std::string> segments = split(key.path);
    if (std::equal(segments.begin(), segments.end(), path.begin(), path.end(),
                   [](const std::string& a, const std::string& b) { return a == "*" ? !b.empty() : a == b; }))
      return &key;
  }
  return nullptr;
}

std::string nearest_key(const std::vector<std::string>& path)
{
  const std::string given = fmt::format("{}", fmt::join(path, "."));
  std::string best;
  std::size_t smallest = std::max<std::size_t>(3, given.size() / 4) + 1;
  for (const Key& key : table()) {
    const std::string known = named(key, path);
    if (known.ends_with("." + given)) // the right key in the wrong table
      return known;
    const std::size_t distance = edit_distance(given, known);
    if (distance < smallest) {
      smallest = distance;
      best = known;
    }
  }
  return best;
}

std::string kind_of(const Key& key)
{
  const std::string quantity =
      fmt::format("a{} {}", key.dimension == angle ? "n" : "", dimension_name(key.dimension));
  return std::visit(Overload{
                        [&](double*) { return quantity; },
                        [&](std::array<double, 2>*) {
                          return fmt::format("a list of two {}s with units", dimension_name(key.dimension));
                        },
                        [](int*) { return std::string("an integer"); },
                        [](std::array<int, 2>*) { return std::string("a list of two integers"); },
                        [](bool*) { return std::string("true or false"); },
                        [&](auto*) {
                          return key.choices
                                     ? fmt::format("one of \"{}\"{}", fmt::join(key.choices(), "\", \""),
                                                   key.or_law ? " or the name of an [eos.NAME]" : "")
                                     : std::string("a text in quotes");
                        },
                    },
                    key.slot(defaults(), 0));
}

std::string describe(const Range& range, Dimension dimension)
{
  const std::string unit = dimension == number ? "" : fmt::format(" {}", si_unit(dimension));
  if (range.low && range.high)
    return fmt::format("{}{} ... {}{}", range.low_open ? "above " : "", *range.low, *range.high, unit);
  if (range.low)
    return fmt::format("{} {}{}", range.low_open ? "above" : "at least", *range.low, unit);
  if (range.high)
    return fmt::format("at most {}{}", *range.high, unit);
  return "";
}

std::string toml_string(std::string_view text)
{
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      result += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      result += c;
  }
  return result + '"';
}

bool is_empty(const Slot& slot)
{
  if (double* const* number = std::get_if<double*>(&slot))
    return std::isnan(**number);
  if (std::string* const* text = std::get_if<std::string*>(&slot))
    return (*text)->empty();
  return false;
}

std::string to_toml(const Slot& slot, const Key& key)
{
  const auto quantity = [&](double value) {
    if (key.dimension != number)
      return toml_string(format_quantity(value, key.dimension, key.unit));
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  };
  return std::visit(
      Overload{
          [&](double* value) { return quantity(*value); },
          [&](std::array<double, 2>* value) {
            return fmt::format("[{}, {}]", quantity((*value)[0]), quantity((*value)[1]));
          },
          [](int* value) { return fmt::format("{}", *value); },
          [](std::array<int, 2>* value) { return fmt::format("[{}, {}]", (*value)[0], (*value)[1]); },
          [](bool* value) { return std::string(*value ? "true" : "false"); },
          [](std::string* value) { return toml_string(*value); },
          [](ViscosityKind* value) {
            return toml_string(*value == ViscosityKind::pairwise ? "pairwise" : "dissertation");
          },
      },
      slot);
}

std::string keys_manual()
{
  std::string text;
  for (const Key& key : table()) {
    const std::string range = describe(key.range, key.dimension);
    const Slot slot = key.slot(defaults(), 0);
    text += fmt::format("{}\n    {}\n    {}{}; {}\n", named(key, {}), key.text, kind_of(key),
                        range.empty() ? "" : ", " + range,
                        key.required     ? "required"
                        : is_empty(slot) ? "optional"
                                         : "default " + to_toml(slot, key));
  }
  return text;
}

} // namespace birdstrike
