// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/shape_parts_case.h"

#include "core/error.h"
#include "geometry/fill.h"
#include "geometry/mix_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace birdstrike {
namespace {

constexpr std::array<std::pair<const char*, Place>, 3> places{
    {{"rest", Place::rest}, {"ribs", Place::ribs}, {"core", Place::core}}};

bool has_share(const PartCase& part) { return !std::isnan(part.share); }
bool is_placed(const PartCase& part) { return !part.place.empty(); }

std::vector<PlacedPart> placed_parts(const Case& parsed)
{
  std::vector<PlacedPart> parts;
  for (const PartCase& part : parsed.bird.parts)
    for (const auto& [name, place] : places)
      if (part.place == name)
        parts.push_back({part.name, place});
  return parts;
}

//! Shares do not hang on the size of the shape, so that this one does as well as any.
ShapeSize unit_size(const Case& parsed) { return {1, parsed.bird.length_over_diameter}; }

double share_of(const Case& parsed, const PlacedPart& part)
{
  const BirdCase& bird = parsed.bird;
  return share_of_place(bird.shape, unit_size(parsed), placed_parts(parsed), part.place, bird.ribs,
                        bird.core);
}

void check_shares(const std::vector<PartCase>& parts, const std::string& file)
{
  double sum = 0;
  std::vector<std::string> shares;
  for (const PartCase& part : parts) {
    if (is_placed(part))
      throw InputError(fmt::format(
          "{}: bird.parts.{}: a part has a share, of a mixture, or a place, and this one has both; "
          "leave one of them out",
          file, part.name));
    if (!has_share(part))
      throw InputError(fmt::format("{}: bird.parts.{}.share is missing: other parts have one, and the shares "
                                   "of all parts have to sum to 1",
                                   file, part.name));
    sum += part.share;
    shares.push_back(fmt::format("{} {:g}", part.name, part.share));
  }
  if (std::abs(sum - 1) >= 1e-9)
    throw InputError(fmt::format("{}: bird.parts: the shares of the parts have to sum to 1; {} sum to {:g}",
                                 file, fmt::join(shares, ", "), sum));
}

void check_places(const Case& parsed, const std::string& file)
{
  for (const PartCase& part : parsed.bird.parts)
    if (!is_placed(part))
      throw InputError(
          fmt::format("{}: bird.parts.{}.place is missing: other parts have one; one of \"{}\" is needed",
                      file, part.name, fmt::join(place_names(), "\", \"")));
  try {
    mean_density(parsed);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: bird.parts.*.place, bird.ribs or bird.core: {}", file, error.what()));
  }
}

} // namespace

std::vector<std::string> place_names()
{
  std::vector<std::string> names;
  for (const auto& [name, place] : places)
    names.emplace_back(name);
  return names;
}

bool is_mixture(const Case& parsed)
{
  return !parsed.bird.shape.empty() && !is_column(parsed) &&
         std::any_of(parsed.bird.parts.begin(), parsed.bird.parts.end(), has_share);
}

bool has_place(const Case& parsed, Place place)
{
  if (parsed.bird.shape.empty() || is_column(parsed))
    return false;
  const std::vector<PlacedPart> parts = placed_parts(parsed);
  return std::any_of(parts.begin(), parts.end(),
                     [place](const PlacedPart& part) { return part.place == place; });
}

void check_shape_parts(const Case& parsed)
{
  const std::vector<PartCase>& parts = parsed.bird.parts;
  const std::string file = parsed.file.string();
  if (is_mixture(parsed))
    check_shares(parts, file);
  else if (std::any_of(parts.begin(), parts.end(), is_placed))
    check_places(parsed, file);
  else if (parts.size() > 1)
    throw InputError(fmt::format(
        "{}: bird.parts.{}: a {} has one part, and here are {}; leave the others out, or give each its share "
        "of a mixture (share = 0.4) or its place (place = \"rest\", \"ribs\" or \"core\"), or use a "
        "bird.mesh",
        file, parts[1].name, parsed.bird.shape, parts.size()));
}

double mean_density(const Case& parsed)
{
  const auto density = [&](const PartCase& part) { return reference_density(natural_law(parsed, part)); };
  const std::vector<PartCase>& parts = parsed.bird.parts;
  const std::vector<PlacedPart> placed = placed_parts(parsed);
  if (!is_mixture(parsed) && placed.empty())
    return density(parts.at(0));
  double sum = 0;
  for (std::size_t row = 0; row < parts.size(); ++row)
    sum += density(parts[row]) * (placed.empty() ? parts[row].share : share_of(parsed, placed.at(row)));
  return sum;
}

void give_parts(const Case& parsed, const ShapeSize& size, Fill& fill)
{
  const BirdCase& bird = parsed.bird;
  if (is_mixture(parsed)) {
    std::vector<PartShare> shares;
    for (const PartCase& part : bird.parts)
      shares.push_back({part.name, part.share});
    mix_parts(fill, shares, std::uint32_t(bird.seed));
  } else if (const std::vector<PlacedPart> parts = placed_parts(parsed); !parts.empty()) {
    place_parts(fill, bird.shape, size, parts, bird.ribs, bird.core);
  }
}

} // namespace birdstrike
