// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mix_parts.h"

#include "core/error.h"
#include "geometry/fill.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>

namespace birdstrike {
namespace {

//! Rows of seeds of equal x, in the order of x and of their rows within.
std::vector<std::vector<std::size_t>> layers_of(const Fill& fill)
{
  std::vector<std::size_t> order(fill.seeds.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto x = [&](std::size_t row) { return fill.seeds[row].position.x(); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x(a) < x(b); });
  std::vector<std::vector<std::size_t>> layers;
  for (const std::size_t row : order) {
    if (layers.empty() || x(row) - x(layers.back().front()) > 1e-6 * fill.spacing)
      layers.emplace_back();
    layers.back().push_back(row);
  }
  for (auto& layer : layers) // equal but for rounding: in the order of the fill
    std::sort(layer.begin(), layer.end());
  return layers;
}

//! Whole counts with the sum \p count nearest to wanted = share count + carried, largest remainders first.
//! \param carried  what earlier layers lack; updated
std::vector<std::size_t> counts_of_layer(const std::vector<PartShare>& shares, std::size_t count,
                                         std::vector<double>& carried)
{
  std::vector<std::size_t> counts(shares.size());
  std::vector<double> left(shares.size());
  std::size_t given = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const double wanted = shares[k].share * double(count) + carried[k];
    counts[k] = wanted > 0 ? std::min(std::size_t(wanted), count - given) : 0;
    left[k] = wanted - double(counts[k]);
    given += counts[k];
  }
  for (; given < count; ++given) {
    const std::size_t k = std::size_t(std::max_element(left.begin(), left.end()) - left.begin());
    ++counts[k];
    --left[k];
  }
  carried = left;
  return counts;
}

//! 0 ... n - 1, each as likely; std::uniform_int_distribution differs from one library to the next.
std::uint32_t below(std::uint32_t n, std::mt19937& engine)
{
  const std::uint64_t range = std::uint64_t(1) << 32, usable = range - range % n;
  std::uint64_t value = engine();
  while (value >= usable)
    value = engine();
  return std::uint32_t(value % n);
}

//! Fisher and Yates.
void shuffle(std::vector<std::uint8_t>& values, std::mt19937& engine)
{
  for (std::size_t i = values.size(); i > 1; --i)
    std::swap(values[i - 1], values[below(std::uint32_t(i), engine)]);
}

double filled_volume(const Fill& fill)
{
  double volume = 0;
  for (const FilledPart& part : fill.parts)
    volume += part.mesh_volume;
  return volume;
}

} // namespace

void mix_parts(Fill& fill, const std::vector<PartShare>& shares, std::uint32_t random)
{
  require(!shares.empty() && shares.size() < 255, "a mixture needs 1 to 254 parts");
  double sum = 0;
  for (const PartShare& part : shares) {
    require(part.share > 0, "the share of " + part.name + " must be above 0");
    sum += part.share;
  }
  char text[80];
  std::snprintf(text, sizeof text, "the shares of the parts sum to %.4g; they must sum to 1", sum);
  require(std::abs(sum - 1) < 1e-9, text);

  const double volume = filled_volume(fill);
  std::mt19937 engine(random);
  std::vector<double> carried(shares.size(), 0);
  for (const auto& layer : layers_of(fill)) {
    const std::vector<std::size_t> counts = counts_of_layer(shares, layer.size(), carried);
    std::vector<std::uint8_t> parts;
    for (std::size_t k = 0; k < counts.size(); ++k)
      parts.insert(parts.end(), counts[k], std::uint8_t(k));
    shuffle(parts, engine);
    for (std::size_t i = 0; i < layer.size(); ++i)
      fill.seeds[layer[i]].part = parts[i];
  }
  fill.parts.clear();
  for (const PartShare& part : shares)
    fill.parts.push_back({part.name, 0, part.share * volume});
  for (const Seed& seed : fill.seeds)
    ++fill.parts[seed.part].particles;
  for (const FilledPart& part : fill.parts)
    require(part.particles > 0, "part " + part.name + " gets none of the " +
                                    std::to_string(fill.seeds.size()) +
                                    " particles; use a finer spacing or a larger share");
}

} // namespace birdstrike
