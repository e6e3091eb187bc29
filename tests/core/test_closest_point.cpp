// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/closest_point.h"
#include "core/contact/passage.h"

#include <catch2/catch.hpp>

#include <random>

using namespace birdstrike;

namespace {

std::mt19937 random_numbers(7);

Vector3 anywhere(double size = 1)
{
  std::uniform_real_distribution<double> number(-size, size);
  return {number(random_numbers), number(random_numbers), number(random_numbers)};
}

} // namespace

TEST_CASE("no sampled point of a triangle is nearer than the closest one", "[contact][closest]")
{
  for (int k = 0; k < 2000; ++k) {
    const Vector3 a = anywhere(), b = anywhere(), c = k % 10 ? anywhere() : Vector3(a + 0.3 * (b - a)),
                  p = anywhere(3);
    const TrianglePoint found = closest_on_triangle(p, a, b, c);
    const Vector3 again = found.weight[0] * a + found.weight[1] * b + found.weight[2] * c;
    REQUIRE((again - found.point).norm() < 1e-13);
    REQUIRE(found.weight[0] + found.weight[1] + found.weight[2] == Approx(1).epsilon(1e-14));
    REQUIRE(*std::min_element(found.weight.begin(), found.weight.end()) >= -1e-15);
    REQUIRE(found.distance2 == Approx((p - found.point).squaredNorm()));
    double least = 1e300;
    constexpr int n = 60;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        least = std::min(least, (p - (a + (b - a) * i / n + (c - a) * j / n)).norm());
    const double distance = std::sqrt(found.distance2);
    REQUIRE(distance <= least + 1e-12);
    REQUIRE(distance > least - 4.0 / n); // a sample is never farther than that from any point
  }
}

TEST_CASE("the nearest point of a quadrilateral does not depend on the corner that is named first",
          "[contact][closest]")
{
  const std::vector<Vector3> x{{0, 0, 0}, {0, 1, 0.1}, {0.2, 1.1, 1}, {-0.1, 0, 0.9}}; // warped
  for (int k = 0; k < 200; ++k) {
    const Vector3 p = anywhere(2);
    const double distance = distance_to_element(p, {{0, 1, 2, 3}, x});
    CHECK(distance == Approx(distance_to_element(p, {{2, 3, 0, 1}, x})).epsilon(1e-13));
    CHECK(distance == Approx(distance_to_element(p, {{3, 2, 1, 0}, x})).epsilon(1e-13));
  }
}

TEST_CASE("weights of the nodes make the nearest point", "[contact][closest]")
{
  const std::vector<Vector3> x{{0, 0, 0}, {0, 1, 0.1}, {0.2, 1.1, 1}, {-0.1, 0, 0.9}};
  for (const ShellElement& element : {ShellElement{0, 1, 2, 3}, ShellElement{0, 1, 2, 2}}) {
    const ElementPieces pieces(element, x);
    CHECK(pieces.count == (is_triangle(element) ? 1 : 4));
    for (int k = 0; k < pieces.count; ++k) {
      const auto [a, b, c] = pieces.piece(k);
      const TrianglePoint found = closest_on_triangle(anywhere(2), a, b, c);
      const auto weight = pieces.node_weights(k, found.weight);
      Vector3 sum = Vector3::Zero();
      for (std::size_t n = 0; n < 4; ++n)
        sum += weight[n] * x[static_cast<std::size_t>(element[n])];
      CHECK((sum - found.point).norm() < 1e-14);
    }
  }
}

TEST_CASE("passing is going through a triangle, not around it", "[contact][passage]")
{
  const std::array<Vector3, 3> t{Vector3(0, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)};
  CHECK(passes({-0.1, 0.2, 0.2}, t, {0.1, 0.3, 0.3}, t));
  CHECK(passes({0.1, 0.2, 0.2}, t, {-0.1, 0.3, 0.3}, t));
  CHECK_FALSE(passes({-0.1, 0.2, 0.2}, t, {-0.01, 0.3, 0.3}, t));
  CHECK_FALSE(passes({-0.1, 0.7, 0.7}, t, {0.1, 0.7, 0.7}, t));
  CHECK(passes({-0.1, 0.5, 0.5}, t, {0.1, 0.5, 0.5}, t)); // just on the border
  auto moved = t;
  for (Vector3& corner : moved)
    corner += Vector3(-0.2, 0, 0);
  CHECK(passes({-0.1, 0.2, 0.2}, t, {-0.1, 0.2, 0.2}, moved)); // the triangle moves
  moved = t;
  for (Vector3& corner : moved)
    corner += Vector3(0.5, 0, 0);
  CHECK_FALSE(passes({-0.1, 0.2, 0.2}, t, {0.4, 0.2, 0.2}, moved)); // both do
}
