// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds and test bodies: profiles turned about the x axis.
#include "geometry/shapes.h"

#include "core/error.h"
#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {

namespace {

constexpr double pi = std::numbers::pi;

struct ProfilePoint
{
  double x, radius; // [m]
};
using Profile = std::vector<ProfilePoint>; // from the rear pole to the front pole; both have radius 0

Profile spheroid_profile(const ShapeSize& size, int along)
{
  Profile profile;
  for (int i = 0; i <= along; ++i) {
    const double angle = pi * i / along;
    profile.push_back({-0.5 * size.length * std::cos(angle), 0.5 * size.diameter * std::sin(angle)});
  }
  return profile;
}

Profile cylinder_profile(const ShapeSize& size, int along)
{
  Profile profile{{-0.5 * size.length, 0}};
  for (int i = 0; i <= along; ++i)
    profile.push_back({size.length * (double(i) / along - 0.5), 0.5 * size.diameter});
  profile.push_back({0.5 * size.length, 0});
  return profile;
}

Profile capsule_profile(const ShapeSize& size, int along)
{
  const double radius = 0.5 * size.diameter,
               straight = 0.5 * size.length - radius; // half of the cylinder's length
  const int half = along / 2;
  Profile profile;
  for (int i = 0; i <= half; ++i) {
    const double angle = 0.5 * pi * i / half;
    profile.push_back({-straight - radius * std::cos(angle), radius * std::sin(angle)});
  }
  for (int i = straight > 0 ? 0 : 1; i <= half; ++i) {
    const double angle = 0.5 * pi * i / half;
    profile.push_back({straight + radius * std::sin(angle), radius * std::cos(angle)});
  }
  return profile;
}

struct Shape
{
  std::string_view name;
  double lowest_aspect, highest_aspect;
  double (*volume_over_cube)(double aspect); // V / D^3
  Profile (*profile)(const ShapeSize&, int along);
};

const Shape shapes[] = {
    {"sphere", 1, 1, [](double) { return pi / 6; }, spheroid_profile},
    {"cylinder", 0.05, 20, [](double a) { return pi * a / 4; }, cylinder_profile},
    {"capsule", 1, 20, [](double a) { return pi * (3 * a - 1) / 12; }, capsule_profile},
    {"spheroid", 0.05, 20, [](double a) { return pi * a / 6; }, spheroid_profile},
};

const Shape& find_shape(std::string_view name)
{
  std::string known;
  for (const Shape& shape : shapes) {
    if (shape.name == name)
      return shape;
    known += (known.empty() ? "" : ", ") + std::string(shape.name);
  }
  throw InputError("unknown bird shape '" + std::string(name) + "'; known are " + known);
}

void require_aspect(const Shape& shape, double aspect)
{
  constexpr double rounding = 1e-9;
  require(aspect >= shape.lowest_aspect - rounding && aspect <= shape.highest_aspect + rounding,
          "the aspect (length / diameter) of a " + std::string(shape.name) + " is " + std::to_string(aspect) +
              "; allowed is " + std::to_string(shape.lowest_aspect) + " to " +
              std::to_string(shape.highest_aspect));
}

SurfacePart revolve(const Profile& profile, int around)
{
  SurfacePart part;
  const int rings = int(profile.size()) - 2, front = 1 + rings * around;
  part.points.push_back({profile.front().x, 0, 0});
  for (int r = 1; r <= rings; ++r)
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * pi * k / around;
      part.points.push_back(
          {profile[r].x, profile[r].radius * std::cos(angle), profile[r].radius * std::sin(angle)});
    }
  part.points.push_back({profile.back().x, 0, 0});

  const auto at = [&](int ring, int k) { return 1 + ring * around + k % around; };
  for (int k = 0; k < around; ++k) {
    part.triangles.push_back({0, at(0, k + 1), at(0, k)});
    for (int r = 0; r + 1 < rings; ++r) {
      part.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k + 1)});
      part.triangles.push_back({at(r, k), at(r + 1, k + 1), at(r + 1, k)});
    }
    part.triangles.push_back({front, at(rings - 1, k), at(rings - 1, k + 1)});
  }
  return part;
}

} // namespace

std::vector<std::string_view> shape_names()
{
  std::vector<std::string_view> names;
  for (const Shape& shape : shapes)
    names.push_back(shape.name);
  return names;
}

ShapeSize shape_size(std::string_view name, double mass, double density, double aspect)
{
  const Shape& shape = find_shape(name);
  require(std::isfinite(mass) && mass > 0, "the mass of a " + std::string(name) + " must be positive");
  require(std::isfinite(density) && density > 0,
          "the density of a " + std::string(name) + " must be positive");
  require_aspect(shape, aspect);
  const double diameter = std::cbrt(mass / density / shape.volume_over_cube(aspect));
  return {diameter, aspect * diameter};
}

double squared_radius(std::string_view name, const ShapeSize& size, double x)
{
  find_shape(name);
  const double radius = 0.5 * size.diameter, half = 0.5 * size.length, away = std::abs(x);
  if (name == "cylinder")
    return away <= half * (1 + 1e-9) ? radius * radius : -1; // a layer may end in rounding
  if (name == "capsule") {
    const double beyond = std::max(0.0, away - (half - radius));
    return radius * radius - beyond * beyond;
  }
  return radius * radius * (1 - x * x / (half * half)); // sphere and spheroid
}

double shape_volume(std::string_view name, const ShapeSize& size)
{
  const Shape& shape = find_shape(name);
  return shape.volume_over_cube(size.length / size.diameter) * std::pow(size.diameter, 3);
}

SurfacePart make_shape(std::string_view name, const ShapeSize& size, const Facets& facets)
{
  const Shape& shape = find_shape(name);
  require(size.diameter > 0 && size.length > 0, "the size of a " + std::string(name) + " must be positive");
  require_aspect(shape, size.length / size.diameter);
  require(facets.around >= 8 && facets.along >= 4, "a shape needs at least 8 facets around and 4 along");
  SurfacePart part = revolve(shape.profile(size, facets.along), facets.around);
  part.name = name;
  const double grow = std::cbrt(shape_volume(name, size) / signed_volume(part));
  for (Vector3& p : part.points)
    p *= grow;
  return part;
}

SurfacePart make_box(const Vector3& size)
{
  require((size.array() > 0).all(), "the edges of a box must be positive");
  SurfacePart part;
  part.name = "box";
  for (int corner = 0; corner < 8; ++corner)
    part.points.push_back({size.x() * ((corner & 1) - 0.5), size.y() * ((corner >> 1 & 1) - 0.5),
                           size.z() * ((corner >> 2) - 0.5)});
  part.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return part;
}

} // namespace birdstrike
