// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/fill_shape.h"

#include "core/error.h"

#include <cmath>
#include <cstdio>

namespace birdstrike {

namespace {

constexpr double fewest_across = 4; // cells; fewer are no shape
constexpr double good_volume =
    0.005; // relative error; a worse one is worth a look at other places of the lattice

//! Cells of one layer whose middles lie within \p radius2 of the axis.
//! \param shift  of the layer, in spacings
void fill_disc(double x, double radius2, double shift_y, double shift_z, double spacing,
               std::vector<Seed>& seeds)
{
  if (radius2 < 0)
    return;
  const long most = static_cast<long>(std::sqrt(radius2) / spacing) + 2;
  for (long j = -most; j <= most; ++j)
    for (long k = -most; k <= most; ++k) {
      const double y = (double(j) + shift_y) * spacing, z = (double(k) + shift_z) * spacing;
      if (y * y + z * z <= radius2)
        seeds.push_back({{x, y, z}, 0});
    }
}

//! \param layers  of the lattice along x, centred
//! \param phase   shift of the whole lattice along y, in spacings
std::vector<Seed> fill_layers(std::string_view shape, const ShapeSize& size, double spacing, long layers,
                              double phase)
{
  std::vector<Seed> seeds;
  for (long i = 0; i < layers; ++i) {
    const double x = (double(i) - 0.5 * double(layers - 1)) * spacing;
    const double y = double(i) * leaning_lattice.shift_y + phase, z = double(i) * leaning_lattice.shift_z;
    fill_disc(x, squared_radius(shape, size, x), y - std::floor(y), z - std::floor(z), spacing, seeds);
  }
  return seeds;
}

} // namespace

Fill fill_shape(std::string_view shape, const ShapeSize& size, double spacing, const std::string& part)
{
  require(std::isfinite(spacing) && spacing > 0, "the particle spacing must be positive");
  const double volume = shape_volume(shape, size), cell = spacing * spacing * spacing;
  require_memory(volume, size.length, spacing);

  Fill fill;
  fill.spacing = spacing;
  fill.lattice = leaning_lattice;
  const auto error = [&](const std::vector<Seed>& seeds) {
    return std::abs(double(seeds.size()) * cell / volume - 1);
  };
  const long whole = std::max(1l, static_cast<long>(size.length / spacing));
  for (const double phase : {0.0, 0.25, 0.5, 0.75}) {
    if (!fill.seeds.empty() && error(fill.seeds) < good_volume)
      break;
    for (const long layers : {whole, whole + 1}) {
      std::vector<Seed> seeds = fill_layers(shape, size, spacing, layers, phase);
      if (fill.seeds.empty() || error(seeds) < error(fill.seeds))
        fill.seeds = std::move(seeds);
    }
  }
  if (std::min(size.diameter, size.length) < fewest_across * spacing || error(fill.seeds) > 0.25) {
    char text[300];
    std::snprintf(text, sizeof text,
                  "a %.*s of %.4g mm diameter and %.4g mm length cannot be made of cells of %.4g mm; use a "
                  "spacing of %.2g mm or less",
                  int(shape.size()), shape.data(), 1e3 * size.diameter, 1e3 * size.length, 1e3 * spacing,
                  1e3 * std::min(size.diameter, size.length) / fewest_across);
    throw InputError(text);
  }
  fill.parts.push_back({part, fill.seeds.size(), volume, cell, {}});
  return fill;
}

Fill fill_column(const std::vector<std::pair<std::string, int>>& layers, int columns, double spacing)
{
  require(std::isfinite(spacing) && spacing > 0, "the particle spacing must be positive");
  require(columns > 0 && !layers.empty() && layers.size() < 255,
          "a column needs 1 to 254 parts and at least one cell sideways");
  double total = 0;
  for (const auto& [name, count] : layers) {
    require(count > 0, "part " + name + " of the column needs at least one layer");
    total += count;
  }
  require_memory(total * columns * columns * spacing * spacing * spacing, total * spacing, spacing);

  Fill fill;
  fill.spacing = spacing;
  long layer = 0;
  for (std::size_t part = 0; part < layers.size(); ++part) {
    const std::size_t before = fill.seeds.size();
    for (int i = 0; i < layers[part].second; ++i, ++layer)
      for (int j = 0; j < columns; ++j)
        for (int k = 0; k < columns; ++k)
          fill.seeds.push_back(
              {spacing * Vector3(-0.5 - double(layer), j - 0.5 * (columns - 1), k - 0.5 * (columns - 1)),
               std::uint8_t(part)});
    const std::size_t count = fill.seeds.size() - before;
    const double cell = spacing * spacing * spacing;
    fill.parts.push_back({layers[part].first, count, double(count) * cell, cell, {}});
  }
  return fill;
}

} // namespace birdstrike
