// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/search.h"

#include "contact_samples.h"
#include "core/contact/closest_point.h"

#include <catch2/catch.hpp>

#include <random>
#include <set>

using namespace birdstrike;
using namespace birdstrike::samples;

TEST_CASE("every element within reach is listed, once, while nodes move within the skin", "[contact][search]")
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  Target target(patch(9, 7,
                      [](double u, double v) {
                        return Vector3(0.1 * std::sin(3 * u), 0.2 * u * u, 0.1 * v * v * v); // graded, curved
                      }),
                0.003);
  target.gone[20] = 1;
  ElementBins bins(0.004, 0.002);
  bins.update(target.view());
  for (int round = 0; round < 3; ++round) {
    for (Vector3& x : target.position)
      x += Vector3(number(random), number(random), number(random)).normalized() * 0.0006;
    bins.update(target.view());
    for (int i = 0; i < 2000; ++i) {
      const Vector3 p(0.05 + 0.08 * number(random), 0.1 + 0.12 * number(random),
                      0.05 + 0.07 * number(random));
      const auto listed = bins.at(p);
      const std::set<std::int32_t> once(listed.begin(), listed.end());
      REQUIRE(once.size() == listed.size());
      REQUIRE(once.count(20) == 0);
      for (std::size_t e = 0; e < target.mesh.elements.size(); ++e)
        if (!target.gone[e] &&
            distance_to_element(p, {target.mesh.elements[e], target.position}) < 0.004 + 0.0015) {
          REQUIRE(once.count(static_cast<std::int32_t>(e)) == 1);
          REQUIRE(bins.may_reach(static_cast<std::int32_t>(e), p, 0.004 + 0.0015));
        }
    }
  }
  CHECK(bins.builds() == 1);
  target.position[5] += Vector3(0, 0, 0.002);
  bins.update(target.view());
  CHECK(bins.builds() == 2);
  CHECK(bins.at({std::nan(""), 0, 0}).empty());
  CHECK(bins.at({5, 0, 0}).empty());
}

TEST_CASE("pairs that are looked at grow with the particles, not with the elements", "[contact][search]")
{
  const auto tests = [](int n) { // a bird and a plate of n times the size at one spacing
    const double spacing = 0.004;
    std::vector<Vector3> places;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 10 * n; ++i)
        for (int j = 0; j < 10 * n; ++j)
          places.push_back({-(k + 0.7) * spacing, (i - 5.0 * n) * spacing, (j - 5.0 * n) * spacing});
    const Duet duet(drops(places, spacing), Target(square(10 * n, 0.04 * n), 0.002));
    return double(duet.contact.tests()) / double(places.size());
  };
  const double few = tests(1), many = tests(8);
  CHECK(few > 0);
  CHECK(many < 1.6 * few); // the rim of the small one has fewer elements
  CHECK(many < 40);
  const Duet far(drops({{-1, 0, 0}, {1, 0, 0}}, 0.004), Target(square(30, 0.1), 0.002));
  CHECK(far.contact.tests() == 0);
}

TEST_CASE("debris that flies off does not make the bins large or new", "[contact][search]")
{
  Target target(square(4, 0.04), 0.002);
  target.gone[0] = 1; // node 0 belongs to nothing else
  ElementBins bins(0.003, 0.002);
  bins.update(target.view());
  target.position[0] = {1e6, 0, 0};
  bins.update(target.view());
  CHECK(bins.builds() == 1);
  target.position[7] += Vector3(0.01, 0, 0);
  bins.update(target.view());
  CHECK(bins.builds() == 2);
  CHECK(bins.distance_to_box({1e6, 0, 0}) > 9e5);
}
