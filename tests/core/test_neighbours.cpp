// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/neighbours.h"

#include "bird_samples.h"

#include <catch2/catch.hpp>

#include <set>

using namespace birdstrike;

namespace {

double image(double d, double length) { return length > 0 ? d - length * std::round(d / length) : d; }

//! Pairs (lane, partner) that the list must hold, by looking at all of them.
std::set<std::pair<int, int>> close_pairs(const Particles& p, double skin, Period period)
{
  std::set<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < p.size(); ++j) {
      const double dx = p.x[i] - p.x[j], dy = image(p.y[i] - p.y[j], period.y),
                   dz = image(p.z[i] - p.z[j], period.z);
      const double reach = p.smoothing_length[i] + p.smoothing_length[j] + skin;
      if (dx * dx + dy * dy + dz * dz < reach * reach)
        pairs.insert({p.id[i], p.id[j]});
    }
  return pairs;
}

//! Pairs from both sides; a quad is its own first partner, and two others are listed once.
std::set<std::pair<int, int>> listed_pairs(const Particles& p, const Neighbours& list)
{
  std::set<std::pair<int, int>> pairs;
  bool twice = false;
  for (std::size_t q = 0; q < list.quads().size(); ++q) {
    const Quad& c = list.quads()[q];
    CHECK(list.partners()[c.first] == static_cast<int>(q));
    for (int i = c.begin; i < c.begin + c.count; ++i)
      for (int n = 0; n < c.partners; ++n) {
        const Quad& partner = list.quads()[list.partners()[c.first + n]];
        for (int j = partner.begin; j < partner.begin + partner.count; ++j) {
          twice |= !pairs.insert({p.id[i], p.id[j]}).second;
          if (n > 0)
            twice |= !pairs.insert({p.id[j], p.id[i]}).second;
        }
      }
  }
  CHECK_FALSE(twice);
  return pairs;
}

void check_against_all_pairs(Particles p, Period period)
{
  const double skin = 0.3 * p.initial_smoothing;
  Neighbours list(skin, period);
  reorder(p, std::vector<std::int32_t>(list.sort(p)));
  list.build(p);
  const auto needed = close_pairs(p, 0.5 * skin, period), listed = listed_pairs(p, list);
  CHECK(std::includes(listed.begin(), listed.end(), needed.begin(), needed.end()));
  std::size_t rows = 0;
  for (const Quad& c : list.quads()) {
    CHECK(c.count >= 1);
    rows += c.count;
  }
  CHECK(rows == p.size());
  const auto interacting = close_pairs(p, 0, period);
  CHECK(list.mean_neighbours() == Approx(static_cast<double>(interacting.size()) / p.size() - 1));
}

} // namespace

TEST_CASE("the lists hold every pair within reach", "[neighbours]")
{
  SECTION("a lattice") { check_against_all_pairs(samples::block(9, 7, 8, 1e-3), {}); }
  SECTION("a disordered block") { check_against_all_pairs(samples::shaken_block(9, 1e-3, 1), {}); }
  SECTION("unequal smoothing lengths")
  {
    Particles p = samples::shaken_block(8, 1e-3, 2);
    for (std::size_t i = 0; i < p.size(); ++i)
      p.smoothing_length[i] *= 0.6 + 0.1 * (p.id[i] % 9);
    check_against_all_pairs(p, {});
  }
  SECTION("debris far away")
  {
    Particles p = samples::shaken_block(6, 1e-3, 3);
    p.y[0] = 500, p.z[1] = -300, p.x[2] = 1e4;
    check_against_all_pairs(p, {});
  }
  SECTION("debris so far away that pencils are wide")
  {
    Particles p = samples::shaken_block(6, 1e-3, 3);
    p.y[0] = 500; // pencils of 250 spacings
    p.y[1] = p.y[2] + 64e-3, p.x[1] = p.x[2],
    p.z[1] = p.z[2]; // not a neighbour of 2, though 64 spacings count as none
    check_against_all_pairs(p, {});
  }
  SECTION("a box that repeats") { check_against_all_pairs(samples::block(12, 6, 6, 1e-3), {6e-3, 6e-3}); }
}

TEST_CASE("a bulk particle of the lattice has 80 neighbours at h = 1.25 spacings", "[neighbours][analytic]")
{
  // Lattice points closer than 2.5 spacings, the centre left out.
  int expected = 0;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k)
        expected += i * i + j * j + k * k < 6.25 && i * i + j * j + k * k > 0;
  REQUIRE(expected == 80);
  Particles p = samples::block(30, 6, 6, 1e-3);
  Neighbours list(1e-4, {6e-3, 6e-3});
  reorder(p, std::vector<std::int32_t>(list.sort(p)));
  list.build(p);
  // In x the block has ends: the two outermost layers miss partners.
  CHECK(list.mean_neighbours() > 76);
  CHECK(list.mean_neighbours() < 80);
}

TEST_CASE("free flight keeps the lists, motion against the others beyond five skins does not", "[neighbours]")
{
  Particles p = samples::shaken_block(6, 1e-3, 4);
  const double skin = 4e-4;
  Neighbours list(skin, {});
  CHECK(list.is_stale(p));
  reorder(p, std::vector<std::int32_t>(list.sort(p)));
  list.build(p);
  for (double& x : p.x)
    x += 10;
  CHECK_FALSE(list.is_stale(p));
  p.y[17] += 5.1 * skin;
  CHECK(list.is_stale(p));
}

TEST_CASE("skins follow how long lists last, within bounds, but not in a box that repeats", "[neighbours]")
{
  const double skin = 2e-4;
  //! Pairs of quads listed after many lists that lasted so many steps each.
  const auto listed_after = [](double first_skin, int steps, Period period) {
    Particles p = samples::shaken_block(12, 1e-3, 7);
    for (auto* array : {&p.vx, &p.vy, &p.vz})
      array->assign(p.size(), 0.0);
    Neighbours list(first_skin, period);
    for (int build = 0; build < 40; ++build) {
      reorder(p, std::vector<std::int32_t>(list.sort(p)));
      list.build(p);
      for (int step = 0; step < steps; ++step)
        list.is_stale(p);
    }
    return list.partners().size();
  };
  const std::size_t usual = listed_after(skin, 0, {});
  CHECK(listed_after(skin, 15, {}) == usual);
  CHECK(listed_after(skin, 3, {}) == listed_after(3 * skin, 0, {}));
  CHECK(listed_after(skin, 30, {}) == listed_after(0.75 * skin, 0, {}));
  CHECK(listed_after(3 * skin, 0, {}) > 1.5 * static_cast<double>(usual));
  CHECK(listed_after(0.75 * skin, 0, {}) < usual);
  const Period period{14e-3, 14e-3};
  CHECK(listed_after(skin, 3, period) == listed_after(skin, 0, period));
}

TEST_CASE("reordering moves whole particles", "[particles]")
{
  Particles p = samples::shaken_block(5, 1e-3, 5);
  const Particles before = p;
  Neighbours list(1e-4, {});
  reorder(p, std::vector<std::int32_t>(list.sort(p)));
  const auto row = p.row_of_id();
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto k = static_cast<std::size_t>(row[i]);
    CHECK(p.x[k] == before.x[i]);
    CHECK(p.vz[k] == before.vz[i]);
    CHECK(p.density[k] == before.density[i]);
  }
}

TEST_CASE("a position that is not finite is named", "[neighbours][errors]")
{
  Particles p = samples::shaken_block(4, 1e-3, 6);
  p.x[7] = std::nan("");
  Neighbours list(1e-4, {});
  CHECK_THROWS_WITH(list.sort(p), Catch::Contains("particle 7"));
}
