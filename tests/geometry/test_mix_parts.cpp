// SPDX-License-Identifier: GPL-3.0-or-later
// Mixtures: shares of layers and totals, disorder, and the same bird for the same seed.
#include "geometry/fill_shape.h"
#include "geometry/mix_parts.h"
#include "temporary_folder.h"

#include <cmath>
#include <map>

using namespace birdstrike;
using Catch::Contains;

namespace {

const ShapeSize capsule{0.1, 0.2};
const std::vector<PartShare> mixture{{"light", 0.6}, {"dense", 0.4}};

Fill mixed(const std::vector<PartShare>& shares, std::uint32_t random, double spacing = 0.005)
{
  Fill fill = fill_shape("capsule", capsule, spacing, "body");
  mix_parts(fill, shares, random);
  return fill;
}

std::vector<int> parts_of(const Fill& fill)
{
  std::vector<int> parts;
  for (const Seed& seed : fill.seeds)
    parts.push_back(seed.part);
  return parts;
}

} // namespace

TEST_CASE("every cross-section of a mixture has the parts' shares, and so has the whole",
          "[geometry][mixture]")
{
  const std::vector<PartShare> three{{"a", 0.5}, {"b", 0.49}, {"c", 0.01}};
  for (const auto& shares : {mixture, three}) {
    const Fill fill = mixed(shares, 1);
    std::map<long, std::vector<double>> layers; // counts, then all
    for (const Seed& seed : fill.seeds) {
      auto& counts = layers[std::lround(2 * seed.position.x() / fill.spacing)];
      counts.resize(shares.size() + 1);
      ++counts[seed.part];
      ++counts.back();
    }
    CHECK(layers.size() == 40);
    for (const auto& [layer, counts] : layers)
      for (std::size_t part = 0; part < shares.size(); ++part)
        CHECK(std::abs(counts[part] - shares[part].share * counts.back()) < 2);
    std::size_t sum = 0;
    for (std::size_t part = 0; part < shares.size(); ++part) {
      CHECK(fill.parts[part].name == shares[part].name);
      CHECK(std::abs(double(fill.parts[part].particles) - shares[part].share * double(fill.seeds.size())) <
            1);
      CHECK(fill.parts[part].mesh_volume ==
            Approx(shares[part].share * shape_volume("capsule", capsule)).epsilon(1e-12));
      sum += fill.parts[part].particles;
    }
    CHECK(sum == fill.seeds.size());
  }
}

TEST_CASE("a seed gives the same mixture everywhere, another one another", "[geometry][mixture]")
{
  const std::vector<int> first = parts_of(mixed(mixture, 1));
  CHECK(parts_of(mixed(mixture, 1)) == first);
  const std::vector<int> other = parts_of(mixed(mixture, 2));
  std::size_t differ = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    differ += first[i] != other[i];
  // Two independent draws of 60 : 40 differ in 2 * 0.6 * 0.4 of all places.
  CHECK(double(differ) / double(first.size()) == Approx(0.48).margin(0.03));
  // Written down once: Mersenne Twister, rejection and Fisher-Yates leave nothing to the standard library.
  Fill row = fill_column({{"body", 1}}, 4, 0.01);
  mix_parts(row, {{"a", 0.5}, {"b", 0.5}}, 5489);
  std::string text;
  for (const int part : parts_of(row))
    text += part == 0 ? 'a' : 'b';
  CHECK(text == "baaaaabbbbaaabbb");
}

TEST_CASE("parts of a mixture lie without order", "[geometry][mixture]")
{
  const Fill fill = mixed(mixture, 1);
  double cross = 0, sideways = 0, rows = 0;
  int pairs = 0;
  for (std::size_t i = 0; i + 1 < fill.seeds.size(); ++i)
    if (fill.seeds[i].position.x() == fill.seeds[i + 1].position.x()) {
      cross += (fill.seeds[i].part - 0.4) * (fill.seeds[i + 1].part - 0.4);
      ++pairs;
    }
  for (const Seed& seed : fill.seeds) {
    sideways += (seed.part - 0.4) * seed.position.y();
    rows += (seed.part - 0.4) * seed.position.z();
  }
  const double n = double(fill.seeds.size());
  CHECK(std::abs(cross / pairs) < 4 * 0.24 / std::sqrt(n)); // neighbours in a row: four standard deviations
  const double spread = 4 * std::sqrt(0.24 * n) * 0.25 * capsule.diameter;
  CHECK(std::abs(sideways) < spread);
  CHECK(std::abs(rows) < spread);
}

TEST_CASE("mixtures that cannot be are refused", "[geometry][mixture][errors]")
{
  CHECK_THROWS_WITH(mixed({{"a", 0.6}, {"b", 0.3}}, 1), Contains("sum to 0.9") && Contains("sum to 1"));
  CHECK_THROWS_WITH(mixed({{"a", 1.5}, {"b", -0.5}}, 1), Contains("share of b") && Contains("above 0"));
  CHECK_THROWS_WITH(mixed({}, 1), Contains("1 to 254 parts"));
  CHECK_THROWS_WITH(mixed({{"a", 1 - 1e-7}, {"b", 1e-7}}, 1),
                    Contains("part b gets none") && Contains("finer"));
}
