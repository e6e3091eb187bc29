// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/build_shape.h"

#include "cases/shape_parts_case.h"
#include "core/error.h"

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {

std::vector<std::string> bird_shape_names()
{
  const auto shapes = shape_names();
  std::vector<std::string> names(shapes.begin(), shapes.end());
  names.emplace_back("column");
  return names;
}

ShapeSize size_of_shape(const Case& parsed)
{
  const BirdCase& bird = parsed.bird;
  const double density = mean_density(parsed);
  try {
    return shape_size(bird.shape, bird.mass, density, bird.length_over_diameter);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: bird.length_over_diameter: {}", parsed.file.string(), error.what()));
  }
}

Fill fill_of_shape(const Case& parsed)
{
  const BirdCase& bird = parsed.bird;
  if (!is_column(parsed)) {
    const ShapeSize size = size_of_shape(parsed);
    try {
      const double spacing =
          bird.particles > 0 ? std::cbrt(shape_volume(bird.shape, size) / bird.particles) : bird.spacing;
      Fill fill = fill_shape(bird.shape, size, spacing, bird.parts.at(0).name);
      give_parts(parsed, size, fill);
      return fill;
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: bird.spacing: {}", parsed.file.string(), error.what()));
    }
  }
  std::vector<std::pair<std::string, int>> layers;
  for (const PartCase& part : bird.parts)
    layers.emplace_back(part.name, part.layers);
  try {
    return fill_column(layers, bird.columns, bird.spacing);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: bird.parts: {}", parsed.file.string(), error.what()));
  }
}

} // namespace birdstrike
