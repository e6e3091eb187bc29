// SPDX-License-Identifier: GPL-3.0-or-later
// What all decks of a bird have in common, worked out once: order, parts, velocities, header.
#include "geometry/decks/deck_contents.h"

#include "core/error.h"
#include "core/format_text.h"
#include "core/theory/impact_pressures.h"
#include "geometry/decks/deck_file.h"
#include "geometry/decks/deck_number.h"
#include "geometry/decks/deck_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace birdstrike {

namespace {

constexpr double same_mass = 1e-9;     // relative
constexpr double usual_speed = 250;    // of a table for a bird at rest [m/s]
constexpr double smallest_cutoff = -1; // in place of 0 [Pa]

//! A line that no solver takes for a comment or a keyword.
std::string as_title(std::string_view text, std::size_t longest, const std::string& otherwise)
{
  std::string line = printable(text.substr(0, longest));
  while (!line.empty() && line.back() == ' ')
    line.pop_back();
  line.erase(0, line.find_first_not_of(' '));
  if (line.empty())
    return otherwise;
  return (std::string_view("*$#/").find(line[0]) == std::string_view::npos ? "" : "_") + line;
}

std::vector<std::int32_t> rows_by_id(const Particles& bird)
{
  const std::size_t count = bird.size();
  require(count > 0, "the bird has no particles; there is nothing to write");
  std::vector<std::int32_t> row(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto id = static_cast<std::size_t>(bird.id[i]);
    require(id < count && row[id] < 0, "the ids of the particles are not 0 to " + std::to_string(count - 1));
    require(bird.part[i] < bird.parts.size() && bird.mass[i] > 0 && bird.position(i).allFinite() &&
                bird.velocity(i).allFinite() && std::isfinite(bird.mass[i]),
            "particle " + std::to_string(id) +
                " has no part, no positive mass, or no finite position and velocity");
    row[id] = static_cast<std::int32_t>(i);
  }
  return row;
}

std::vector<DeckGroup> by_mass(const DeckContents& deck, const std::vector<std::int32_t>& members)
{
  const auto mass = [&](std::int32_t id) { return deck.bird->mass[deck.row_of(id)]; };
  std::vector<std::int32_t> sorted = members;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](std::int32_t a, std::int32_t b) { return mass(a) < mass(b); });
  std::vector<DeckGroup> groups;
  for (std::size_t first = 0; first < sorted.size();) {
    std::size_t end = first;
    double sum = 0;
    for (; end < sorted.size() && mass(sorted[end]) <= mass(sorted[first]) * (1 + same_mass); ++end)
      sum += mass(sorted[end]);
    groups.push_back(
        {sum / static_cast<double>(end - first), {sorted.begin() + first, sorted.begin() + end}});
    std::sort(groups.back().members.begin(), groups.back().members.end());
    first = end;
  }
  return groups;
}

void add_parts(DeckContents& deck, double speed)
{
  const Particles& bird = *deck.bird;
  std::vector<std::vector<std::int32_t>> members(bird.parts.size());
  for (std::size_t id = 0; id < deck.particles(); ++id)
    members[bird.part[deck.row_of(static_cast<std::int32_t>(id))]].push_back(static_cast<std::int32_t>(id));
  for (std::size_t k = 0; k < bird.parts.size(); ++k) {
    if (members[k].empty())
      continue;
    const Part& part = bird.parts[k];
    DeckPart entry{as_title(part.name, 64, "part " + std::to_string(k + 1)),
                   &part,
                   deck.options.first_part + static_cast<int>(k),
                   reference_density(part.eos),
                   0,
                   0,
                   std::move(members[k]),
                   {}};
    entry.groups = by_mass(deck, entry.members);
    for (const DeckGroup& group : entry.groups)
      entry.mass += group.mass * static_cast<double>(group.members.size());
    naming(entry, [&] { deck.hugoniot = std::max(deck.hugoniot, hugoniot(part.eos, speed).pressure); });
    deck.parts.push_back(std::move(entry));
  }
  // Soft parts feel the pressure of stiff ones beside them.
  for (DeckPart& part : deck.parts)
    part.range = 2 * deck.hugoniot;
}

void add_header(DeckContents& deck, double speed, const Vector3& velocity, double largest_speed)
{
  const DeckUnits& u = deck.units;
  const auto add = [&](const std::string& text) {
    for (std::string& line : wrapped(text))
      deck.header.push_back(std::move(line));
  };
  add("Bird of SPH particles, written by BirdStrike");
  if (!deck.options.title.empty())
    add("title: " + deck.options.title);
  if (!deck.options.source.empty())
    add("source: " + deck.options.source);
  add("unit system: " + u.name);
  add(format_text("  one unit of mass is %.12g kg, of length %.12g m, of time %.12g s;", u.mass, u.length,
                  u.time));
  add(format_text("  so pressure is in %s, energy in %s", u.pressure_name.c_str(), u.energy_name.c_str()));
  double mass = 0;
  Vector3 moment = Vector3::Zero();
  for (const DeckPart& part : deck.parts)
    mass += part.mass;
  for (std::size_t i = 0; i < deck.particles(); ++i)
    moment += deck.bird->mass[i] * deck.bird->position(i);
  const Vector3 centre = moment / (mass * u.length);
  add(format_text("%zu particles, mass %.9g, centre of mass %.6g %.6g %.6g", deck.particles(), mass / u.mass,
                  centre[0], centre[1], centre[2]));
  if (deck.one_velocity)
    add(format_text("velocity %.9g %.9g %.9g", velocity[0] / u.velocity(), velocity[1] / u.velocity(),
                    velocity[2] / u.velocity()));
  else
    add(format_text("velocities differ, up to %.6g", largest_speed / u.velocity()));
  add(format_text("tables reach to %.6g %s, twice the Hugoniot pressure of the stiffest part at %.6g m/s",
                  2 * deck.hugoniot / u.pressure(), u.pressure_name.c_str(), speed));
  add("  part      particles        mass      density  name");
  for (const DeckPart& part : deck.parts)
    add(format_text("  %-6d %12zu %11.6g %12.6g  ", part.id, part.members.size(), part.mass / u.mass,
                    part.density / u.density()) +
        part.name);
  add("There is no target and no contact in this deck: add them. Shear stress and viscosity are not "
      "modelled.");
}

} // namespace

std::vector<std::string> wrapped(const std::string& text, std::size_t width)
{
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > width) {
    std::size_t at = rest.rfind(' ', width);
    if (at == std::string::npos || at < width / 2)
      at = width;
    lines.push_back(rest.substr(0, at));
    rest = "  " + rest.substr(rest.find_first_not_of(' ', at));
  }
  lines.push_back(rest);
  return lines;
}

std::string table_remark(const DeckTable& table, const DeckPart& part, const DeckUnits& units, double error)
{
  const double range = part.range / units.pressure();
  return format_text(
      "table of %zu points; off from the law by at most %.2f %% of the pressure from %.6g to %.6g %s, "
      "and of %.6g below; above, one straight line to twice the range",
      table.rows.size(), 100 * error, 0.01 * range, range, units.pressure_name.c_str(), 0.01 * range);
}

CubicTerms cubic_terms(const DeckPart& part)
{
  if (const auto* linear = std::get_if<Linear>(&part.part->eos))
    return {true, linear->K, 0, 0};
  const auto* cubic = std::get_if<CubicPolynomial>(&part.part->eos);
  if (!cubic)
    return {false, 0, 0, 0};
  const double end = ratio_at(*cubic, part.range) - 1;
  bool fits = true;
  constexpr int samples = 100;
  for (int k = 1; k <= samples; ++k) { // beyond mu_max the law may leave its curve
    const double mu = end * k / samples, p = mu * (cubic->C1 + mu * (cubic->C2 + mu * cubic->C3));
    fits = fits && std::abs(p - cubic->at(cubic->rho0 * (1 + mu)).pressure) <= 1e-9 * part.range;
  }
  return {fits, cubic->C1, cubic->C2, cubic->C3};
}

DeckContents deck_contents(const Particles& bird, const DeckOptions& options)
{
  DeckContents deck{&bird, options, deck_units(options.units), rows_by_id(bird), {}, {}, {}, 0, 0, 0, true,
                    0,     0};
  require(options.first_id > 0 && options.first_part > 0,
          "numbers of nodes and parts in a deck start at 1 or above");
  require(options.tension_cutoff <= 0, "the tension cut-off must be 0 or negative");
  require(options.end_time >= 0 && options.table_speed >= 0,
          "the end time and the speed of the tables must not be negative");

  const Vector3 velocity = bird.velocity(deck.row_of(0));
  Vector3 lower = bird.position(0), upper = lower;
  double largest_speed = 0;
  for (std::size_t i = 0; i < deck.particles(); ++i) {
    deck.one_velocity = deck.one_velocity && bird.velocity(i) == velocity;
    largest_speed = std::max(largest_speed, bird.velocity(i).norm());
    lower = lower.cwiseMin(bird.position(i));
    upper = upper.cwiseMax(bird.position(i));
  }
  constexpr double slow = 1; // [m/s]; a bird that is set off by hand afterwards
  const double speed = options.table_speed > 0 ? options.table_speed
                       : largest_speed > slow  ? largest_speed
                                               : usual_speed;
  const double length = std::max((upper - lower).norm(), bird.spacing);
  const double passing =
      (largest_speed > slow && deck.one_velocity
           ? (upper - lower).cwiseAbs().dot(velocity.cwiseAbs()) / (largest_speed * largest_speed)
           : length / speed);
  constexpr int digits = 3, frames = 60;
  deck.end_time =
      options.end_time > 0 ? options.end_time : rounded(3 * std::max(passing, 0.1 * length / speed), digits);
  deck.frame_time = rounded(deck.end_time / frames, digits);
  deck.smoothing =
      bird.spacing > 0 && bird.initial_smoothing > 0 ? bird.initial_smoothing / bird.spacing : 1.2;
  deck.cutoff = std::min(options.tension_cutoff, smallest_cutoff);
  deck.title = as_title(options.title, 72, "BirdStrike: bird of SPH particles");
  add_parts(deck, speed);
  add_header(deck, speed, velocity, largest_speed);
  return deck;
}

} // namespace birdstrike
