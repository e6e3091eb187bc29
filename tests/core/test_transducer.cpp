// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/transducer.h"

#include "bird_samples.h"
#include "core/error.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace birdstrike;

TEST_CASE("the share of a footprint on a face is the overlap of two discs", "[transducer][analytic]")
{
  constexpr double pi = std::numbers::pi;
  CHECK(face_share(0, 2, 1) == 1);
  CHECK(face_share(1, 2, 1) == 1);
  CHECK(face_share(3, 2, 1) == 0);
  CHECK(face_share(0.3, 0.5, 1) == Approx(0.25)); // the face is the smaller one
  // Discs of radius 1 at a distance of 1: the lens has 2 pi/3 - sqrt(3)/2.
  CHECK(face_share(1, 1, 1) == Approx((2 * pi / 3 - 0.5 * std::sqrt(3.0)) / pi).epsilon(1e-12));
  for (const double face : {0.4, 1.0, 1.7, 3.0}) // against counting points of a fine grid
    for (const double distance : {0.2, 0.9, 1.3, 2.5}) {
      INFO("face " << face << ", distance " << distance);
      long in_both = 0, all = 0;
      for (double y = -0.9975; y < 1; y += 0.005)
        for (double z = -0.9975; z < 1; z += 0.005)
          if (y * y + z * z < 1) {
            ++all;
            in_both += (y - distance) * (y - distance) + z * z < face * face;
          }
      CHECK(face_share(distance, face, 1) == Approx(double(in_both) / double(all)).margin(1e-3));
    }
}

TEST_CASE("faces all over the plate feel the whole force", "[transducer][analytic]")
{
  // The mean over all places of a face is force over area: every part of a footprint is felt once.
  const double face = 0.7, footprint = 0.4, step = 0.01;
  double sum = 0;
  for (double y = -1.5; y < 1.5; y += step)
    for (double z = -1.5; z < 1.5; z += step)
      sum += face_share(std::hypot(y - 0.013, z + 0.021), face, footprint) * step * step;
  CHECK(sum == Approx(std::numbers::pi * face * face).epsilon(1e-3));
}

TEST_CASE("an undisturbed lattice presses evenly wherever the face lies", "[transducer][analytic]")
{
  const double face = 1.5, footprint = footprint_radius(1);
  for (const double y : {0.0, 0.2, 0.5})
    for (const double z : {0.0, 0.35, 0.5}) {
      double force = 0;
      for (int j = -5; j <= 5; ++j)
        for (int k = -5; k <= 5; ++k)
          force += face_share(std::hypot(j - y, k - z), face, footprint); // 1 N in every cell of 1 m2
      CHECK(force / (std::numbers::pi * face * face) == Approx(1).epsilon(0.01));
    }
}

TEST_CASE("the low pass has its rise time and is exact for steps of any size", "[transducer][analytic]")
{
  const double rise = 5e-6, tau = rise / std::log(9.0);
  CHECK(low_pass(0.3, 2, 7, 1e-6, 0) == 7); // no filter
  // A jump to 1: 10 and 90 % are one rise time apart.
  const double t10 = -tau * std::log(0.9), t90 = -tau * std::log(0.1);
  CHECK(t90 - t10 == Approx(rise));
  CHECK(low_pass(0, 1, 1, t10, rise) == Approx(0.1));
  CHECK(low_pass(0, 1, 1, t90, rise) == Approx(0.9));
  // A ramp p = t follows as t - tau (1 - exp(-t/tau)), in one step or in uneven ones.
  const double end = 3 * tau, exact = end - tau * (1 - std::exp(-3.0));
  CHECK(low_pass(0, 0, end, end, rise) == Approx(exact).epsilon(1e-12));
  double state = 0, time = 0;
  for (const double share : {0.1, 0.003, 0.4, 1e-6, 0.496999}) {
    state = low_pass(state, time, time + share * end, share * end, rise);
    time += share * end;
  }
  CHECK(state == Approx(exact).epsilon(1e-10));
}

TEST_CASE("a face that covers the bird's footprint measures the force of the run", "[transducer][simulation]")
{
  Settings settings;
  settings.end_time = 3e-5;
  settings.frames = 2;
  settings.threads = 1;
  const double diameter = 0.06;
  Simulation run(samples::block(8, 6, 6, 1.5e-3, 0.1, {150, 0, 0}), make_rigid_plate(0.1, 0.1, 0.005, 4, 4),
                 settings, {{"all", 0, 0, diameter, 0}, {"part", 1e-3, 0, 3e-3, 2e-6}});
  Observer nobody;
  run.run(nobody);
  const History &h = run.history(), &t = run.transducer_history();
  REQUIRE(t.rows() == h.rows());
  REQUIRE(t.columns.size() == 5);
  CHECK(t.columns[4].name == "part_filtered");
  CHECK(t.columns[4].unit == "Pa");
  const std::size_t force = h.find("contact_force_x");
  double most = 0, filtered = 0, raw = 0;
  for (std::size_t row = 0; row < h.rows(); ++row) {
    CHECK(t.at(row, 0) == h.at(row, 0));
    CHECK(t.at(row, 1) * std::numbers::pi * diameter * diameter / 4 == Approx(h.at(row, force)).margin(1e-9));
    most = std::max(most, h.at(row, force));
    raw = std::max(raw, t.at(row, 3));
    filtered = std::max(filtered, t.at(row, 4));
  }
  CHECK(most > 1000);
  CHECK(filtered > 0.2 * raw);
  CHECK(filtered < raw);
}

TEST_CASE("a face without size is refused", "[transducer][errors]")
{
  CHECK_THROWS_WITH(TransducerGauges({{"axis", 0, 0, 0, 0}}, 1e-3),
                    Catch::Contains("transducers.axis.diameter"));
  CHECK_THROWS_WITH(TransducerGauges({{"axis", 0, 0, 1, -1}}, 1e-3),
                    Catch::Contains("transducers.axis.rise_time"));
}

TEST_CASE("means over time are those of straight lines between rows", "[history][analytic]")
{
  History h{{{"time", "s"}, {"a", "Pa"}}, {0, 0, 1, 2, 3, 2}};
  CHECK(time_mean(h, 1, 0, 1) == Approx(1));
  CHECK(time_mean(h, 1, 0.5, 2) == Approx((0.75 + 2) / 1.5));
  CHECK(time_mean(h, 1, 0, 3) == Approx(5.0 / 3));
  CHECK(std::isnan(time_mean(h, 1, 2, 3.5)));
  CHECK(std::isnan(time_mean(h, 1, 2, 1)));
}
