// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of decks collect, in the deck's own units and numbers, and how it becomes a bird.
#include "geometry/decks/deck_builder.h"

#include "core/error.h"
#include "core/format_text.h"

#include <algorithm>

namespace birdstrike {

DeckBuilder::DeckBuilder(const std::filesystem::path& file, const TextLines& lines, DeckFormat format,
                         const std::string& units)
    : name_(file.string()), lines_(lines), format_(format), given_units_(units)
{
}

void DeckBuilder::fail(std::size_t line, const std::string& problem) const
{
  throw InputError("deck file '" + name_ + "'" + (line > 0 ? " line " + std::to_string(line) : "") + ": " +
                   problem);
}

double DeckBuilder::real(std::string_view text, std::size_t line, const char* what) const
{
  const std::optional<double> value = to_real(text);
  if (!value)
    fail(line, std::string(what) + " is " + shown(text) + " and should be a number");
  return *value;
}

double DeckBuilder::real_or_zero(std::string_view text, std::size_t line, const char* what) const
{
  return trimmed(text).empty() ? 0 : real(text, line, what);
}

std::int64_t DeckBuilder::integer(std::string_view text, std::size_t line, const char* what) const
{
  const std::optional<std::int64_t> value = to_integer(text);
  if (!value)
    fail(line, std::string(what) + " is " + shown(text) + " and should be a whole number");
  return *value;
}

void DeckBuilder::add_node(std::int64_t id, const Vector3& position, std::size_t line)
{
  check(nodes_.emplace(id, position).second, line, "node " + std::to_string(id) + " comes a second time");
}

void DeckBuilder::add_particle(std::int64_t id, std::int64_t part, double mass, std::size_t line)
{
  check(mass >= 0, line, "the mass of particle " + std::to_string(id) + " is negative");
  particles_.push_back({id, part, mass, line});
}

DeckUnits DeckBuilder::the_units() const
{
  if (own_units)
    return *own_units;
  constexpr std::string_view mark = "unit system:";
  for (std::size_t k = 0; k < std::min<std::size_t>(lines_.size(), 100); ++k)
    if (const std::size_t at = lines_[k].find(mark); at != std::string::npos) {
      const std::string name(trimmed(std::string_view(lines_[k]).substr(at + mark.size())));
      const std::vector<std::string> known = deck_unit_names();
      if (std::find(known.begin(), known.end(), name) != known.end())
        return deck_units(name);
    }
  if (!given_units_.empty())
    return deck_units(given_units_);
  std::string names;
  for (const std::string& name : deck_unit_names())
    names += (names.empty() ? "" : ", ") + name;
  fail(0, "the deck does not say its units; give them, one of " + names);
}

DeckBird DeckBuilder::finish()
{
  check(!particles_.empty(), 0,
        "there are no SPH particles in this deck (*ELEMENT_SPH of LS-DYNA, /SPHCEL of Radioss or PC3D of "
        "Abaqus)");
  const DeckUnits units = the_units();
  std::stable_sort(particles_.begin(), particles_.end(),
                   [](const Particle& a, const Particle& b) { return a.id < b.id; });

  DeckBird bird;
  bird.format = format_;
  bird.units = units.name;
  std::map<std::int64_t, int> row_of_part;
  for (const Particle& particle : particles_)
    row_of_part[particle.part] = 0;
  for (auto& [id, row] : row_of_part) {
    row = static_cast<int>(bird.part_names.size());
    const Part& part = parts[id];
    bird.part_names.push_back(part.name.empty() ? "part " + std::to_string(id) : part.name);
    bird.part_density.push_back(part.density * units.density());
  }
  for (const Particle& particle : particles_) {
    const std::string number = std::to_string(particle.id);
    check(bird.id.empty() || bird.id.back() != particle.id, particle.line,
          "particle " + number + " comes a second time");
    const auto node = nodes_.find(particle.id);
    check(node != nodes_.end(), particle.line, "particle " + number + " has no node");
    const double mass = particle.mass > 0 ? particle.mass : parts[particle.part].mass;
    check(mass > 0, particle.line, "particle " + number + " has no mass, and its part gives none");
    Vector3 speed = velocity.value_or(Vector3::Zero());
    if (const auto by_node = node_velocity.find(particle.id); by_node != node_velocity.end())
      speed = by_node->second;
    else if (const auto by_part = part_velocity.find(particle.part); by_part != part_velocity.end())
      speed = by_part->second;
    bird.id.push_back(particle.id);
    bird.position.push_back(node->second * units.length);
    bird.velocity.push_back(speed * units.velocity());
    bird.mass.push_back(mass * units.mass);
    bird.part.push_back(row_of_part[particle.part]);
  }
  return bird;
}

} // namespace birdstrike
