// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/initial_gap.h"

#include "contact_samples.h"
#include "core/contact/closest_point.h"
#include "core/error.h"

#include <catch2/catch.hpp>

#include <random>

using namespace birdstrike;
using namespace birdstrike::samples;

TEST_CASE("the smallest gap is that of all pairs", "[contact][gap]")
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 10; ++round) {
    Target target(fold(4, 0.1, 0.3 * round), 0.002);
    for (std::size_t e = 0; e < target.thickness.size(); ++e)
      target.thickness[e] *= 1 + 0.1 * static_cast<double>(e % 7);
    std::vector<Vector3> places;
    for (int i = 0; i < 200; ++i)
      places.push_back({-0.25 + 0.1 * number(random), 0.1 * number(random), 0.05 * number(random)});
    const Particles p = drops(places, 0.004);
    double least = 1e300;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t e = 0; e < target.mesh.elements.size(); ++e)
        least = std::min(least, distance_to_element(places[i], {target.mesh.elements[e], target.position}) -
                                    0.5 * (0.004 + target.thickness[e]));
    const InitialGap found = require_initial_gap(p, target.view());
    CHECK(found.gap == Approx(least).epsilon(1e-12));
    const auto e = static_cast<std::size_t>(found.element);
    CHECK(distance_to_element(p.position(found.row), {target.mesh.elements[e], target.position}) -
              0.5 * (0.004 + target.thickness[e]) ==
          Approx(least).epsilon(1e-12));
    CHECK(found.too_near == 0);
  }
}

TEST_CASE("a bird that starts in the target is told which particle, where and what to do",
          "[contact][gap][errors]")
{
  const Target plate(square(4, 0.04), 0.002);
  const Particles p =
      drops({{-0.1, 0, 0}, {-0.0029, 0.001, 0.002}, {-0.0012, 0.012, 0.012}, {-0.003, 0, 0}}, 0.004);
  const InitialGap found = find_initial_gap(p, plate.view());
  CHECK(found.too_near == 2);
  CHECK(found.particle == 2);
  CHECK(found.element == 15);
  CHECK(found.gap == Approx(-0.0018));
  CHECK_THROWS_WITH(require_initial_gap(p, plate.view()),
                    Catch::Contains("particle 2 (part torso) at x = -0.0012, y = 0.012, z = 0.012") &&
                        Catch::Contains("1.2 mm from the middle of element 15 (part skin)") &&
                        Catch::Contains("need 3 mm") && Catch::Contains("2 of 4 particles") &&
                        Catch::Contains("increase bird.gap by 1.8 mm"));
  Target nothing(square(1, 0.04), 0.002);
  nothing.gone[0] = 1;
  CHECK_THROWS_AS(find_initial_gap(p, nothing.view()), InputError);
}
