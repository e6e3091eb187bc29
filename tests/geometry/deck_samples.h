// SPDX-License-Identifier: GPL-3.0-or-later
// Small birds for the tests of decks.
#pragma once

#include "core/particles/particles.h"
#include "geometry/decks/write_deck.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace birdstrike::test::decks {

//! Water of Steinberg, UCRL-MA-106439.
inline const MieGrueneisenConstants water{1480, 2.56, -1.986, 0.2286, 0.4934, 1.3937};

//! A part for each kind of law, its constants given and not fitted: what is written depends on no library.
inline std::vector<Part> sample_parts()
{
  const std::vector<double> density{600, 640, 700, 780, 840, 880, 1000}, // a soft, locking foam
      pressure{0, 1e6, 3e6, 9e6, 25e6, 80e6, 600e6};
  return {{"torso", cubic_from_hugoniot(938, 1482.9, 2), 0, 0},
          {"wings_left", Tabulated(density, pressure, "foam.csv"), 0, 0},
          {"head", MieGrueneisen(1000, water), 0, 0},
          {"bones", Murnaghan{1100, 320e6, 7.15}, 0, 0}};
}

//! \p side^3 particles on a lattice, parts in layers along y; rows are not in the order of ids.
inline Particles sample_bird(int side = 3, double spacing = 0.0061,
                             const Vector3& velocity = {-116.5, 3.25, 0})
{
  std::vector<Seed> seeds;
  const std::vector<Part> parts = sample_parts();
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k)
        seeds.push_back({Vector3(i - 0.4, j - side / 3.0, k + 0.1) * spacing,
                         static_cast<std::uint8_t>(std::min<int>(j * 4 / side, 3))});
  std::vector<bool> used(parts.size());
  for (const Seed& seed : seeds)
    used[seed.part] = true;
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (!used[k])
      seeds[k].part = static_cast<std::uint8_t>(k);
  Particles bird = make_particles(parts, seeds, spacing, velocity, 1.2);
  const auto count = static_cast<std::int32_t>(bird.size());
  for (std::int32_t i = 0; i < count; ++i)
    bird.id[static_cast<std::size_t>(i)] = (i + 5) % count;
  return bird;
}

inline Vector3 centre_of_mass(const std::vector<Vector3>& position, const std::vector<double>& mass)
{
  Vector3 sum = Vector3::Zero();
  double total = 0;
  for (std::size_t i = 0; i < mass.size(); ++i)
    sum += mass[i] * position[i], total += mass[i];
  return sum / total;
}

inline std::string text_of(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::vector<std::string> lines_of(const std::filesystem::path& file)
{
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

//! Lines behind each line that is \p keyword up to the next keyword, without comments: one block for each.
inline std::vector<std::vector<std::string>> blocks(const std::vector<std::string>& lines,
                                                    const std::string& keyword)
{
  std::vector<std::vector<std::string>> found;
  const char sign = keyword[0];
  bool inside = false;
  for (const std::string& line : lines) {
    const bool comment = line[0] == '$' || line[0] == '#' || line.starts_with("**");
    if (comment)
      continue;
    if (line[0] == sign) {
      inside = line == keyword;
      if (inside)
        found.emplace_back();
    } else if (inside) {
      found.back().push_back(line);
    }
  }
  return found;
}

//! Number in columns first to first + width, counted from 1 as manuals do.
inline double field(const std::string& line, std::size_t first, std::size_t width)
{
  return std::stod(line.substr(first - 1, width));
}

} // namespace birdstrike::test::decks
