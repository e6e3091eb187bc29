// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/permanent_set.h"

#include "shell_samples.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace birdstrike;

TEST_CASE("the permanent set is what a node swings about, sampled at uneven steps", "[permanent_set]")
{
  MeshTarget target = samples::strip();
  const std::size_t dent = samples::node_at(target.mesh(), {0, 0.2, 0.1});
  const Vector3 start = target.position(dent), set(0.003, 0, -0.004), swing(0.001, 0, 0);
  PermanentSet gauge(1);
  const auto at = [&](double time) {
    // Ten whole swings in the window; what comes before it does not count.
    const double phase = 2 * std::numbers::pi * 50 * (time - 0.8);
    const Vector3 now = set + std::cos(phase) * swing;
    target.shells()->position[dent] = start + (time < 0.8 ? Vector3(1, 2, 3) : now);
    gauge.record(target, time);
  };
  at(0.1);
  CHECK(gauge.largest(target).set == 0);
  constexpr int steps = 4000;
  for (int k = 0; k <= steps; ++k) {
    const double x = static_cast<double>(k) / steps;
    at(0.7999 + 0.2001 * (x + 0.1 * x * (1 - x))); // the steps grow shorter
  }
  CHECK(gauge.largest(target).set == Approx(0.005).epsilon(1e-4));
  CHECK(gauge.largest(target).amplitude == Approx(0.001).epsilon(1e-3));
}

TEST_CASE("what no element holds any more leaves no set", "[permanent_set]")
{
  MeshTarget target = samples::strip();
  const std::size_t end = samples::node_at(target.mesh(), {0, 0.4, 0});
  target.shells()->position[end] += Vector3(5, 0, 0); // torn off with the last element
  target.shells()->position[0] += Vector3(0.001, 0, 0);
  PermanentSet gauge(1);
  gauge.record(target, 1);
  CHECK(gauge.largest(target).set == Approx(5));
  target.shells()->gone[3] = 1;
  CHECK(gauge.largest(target).set == Approx(0.001));
  CHECK(gauge.largest(target).amplitude == 0);
}

TEST_CASE("a rigid target keeps no set", "[permanent_set]")
{
  ShellMesh mesh = samples::patch(2, 2, [](double u, double v) { return Vector3(0, u, v); });
  mesh.parts.front().thickness = 0.01;
  const MeshTarget rigid{std::move(mesh)};
  PermanentSet gauge(1);
  gauge.record(rigid, 1);
  CHECK(gauge.largest(rigid).set == 0);
}
