// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/shape_parts.h"

#include "core/error.h"
#include "geometry/fill.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace birdstrike {
namespace {

std::string number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

double radius_at(std::string_view shape, const ShapeSize& size, double x)
{
  return std::sqrt(std::max(0.0, squared_radius(shape, size, x)));
}

double middle_of_ring(const RibSizes& ribs, const ShapeSize& size, int ring)
{
  return ribs.number == 1 ? 0 : size.length * ribs.span * (double(ring) / (ribs.number - 1) - 0.5);
}

//! The core's radius at \p x; 0 beyond its ends [m].
double core_radius(const CoreSizes& core, const ShapeSize& size, double x)
{
  const double along = 2 * x / (core.length * size.length);
  return 0.5 * core.diameter * size.diameter * std::sqrt(std::max(0.0, 1 - along * along));
}

constexpr int slices = 2000; // of a ring, for Simpson's rule and for what it meets

//! Calls \p what(x, Simpson's weight [m]) along each ring.
template <class F>
void along_rings(const RibSizes& ribs, const ShapeSize& size, const F& what)
{
  const double step = ribs.width * size.length / slices;
  for (int ring = 0; ring < ribs.number; ++ring)
    for (int i = 0; i <= slices; ++i) {
      const double x = middle_of_ring(ribs, size, ring) + (i - 0.5 * slices) * step;
      what(x, step / 3 * (i == 0 || i == slices ? 1 : i % 2 == 1 ? 4 : 2));
    }
}

double inner_radius(double outer, const RibSizes& ribs, const ShapeSize& size)
{
  return std::max(0.0, outer - 0.5 * ribs.depth * size.diameter);
}

double rib_volume(std::string_view shape, const ShapeSize& size, const RibSizes& ribs)
{
  double volume = 0;
  along_rings(ribs, size, [&](double x, double weight) {
    const double outer = radius_at(shape, size, x), inner = inner_radius(outer, ribs, size);
    volume += weight * std::numbers::pi * (outer * outer - inner * inner);
  });
  return ribs.lumps > 0 ? 0.5 * volume : volume;
}

double core_volume(const ShapeSize& size, const CoreSizes& core)
{
  const double diameter = core.diameter * size.diameter;
  return std::numbers::pi / 6 * core.length * size.length * diameter * diameter;
}

bool is_used(const std::vector<PlacedPart>& parts, Place place)
{
  return std::any_of(parts.begin(), parts.end(),
                     [place](const PlacedPart& part) { return part.place == place; });
}

void check_ribs(const RibSizes& ribs)
{
  require(ribs.number > 0 && ribs.lumps >= 0 && ribs.width > 0 && ribs.span >= 0 && ribs.depth > 0,
          "number, width and depth of the ribs must be positive, lumps and span not negative");
  require(ribs.depth <= 1,
          "ribs of depth " + number(ribs.depth) + " are deeper than the bird's radius; allowed is up to 1");
  const double reach = (ribs.number > 1 ? ribs.span : 0) + ribs.width;
  require(reach <= 1 + 1e-12, "span + width of the ribs is " + number(reach) +
                                  " of the bird's length: they reach beyond its ends; allowed is up to 1");
  if (ribs.number > 1)
    require(ribs.span / (ribs.number - 1) >= ribs.width,
            number(ribs.number) + " ribs of width " + number(ribs.width) +
                " run into each other within a span of " + number(ribs.span) +
                "; use fewer, narrower ones or a larger span");
}

void check_core(std::string_view shape, const ShapeSize& size, const CoreSizes& core)
{
  require(core.length > 0 && core.diameter > 0, "length and diameter of the core must be positive");
  for (int i = 0; i <= slices; ++i) {
    const double x = core.length * size.length * (double(i) / slices - 0.5);
    require(core_radius(core, size, x) <= radius_at(shape, size, x) + 1e-9 * size.diameter,
            "a core of length " + number(core.length) + " and diameter " + number(core.diameter) +
                " sticks out of the " + std::string(shape) + "; make it smaller");
  }
}

void check_places(std::string_view shape, const ShapeSize& size, const std::vector<PlacedPart>& parts,
                  const RibSizes& ribs, const CoreSizes& core)
{
  const auto count = [&](Place place) {
    return std::count_if(parts.begin(), parts.end(),
                         [place](const PlacedPart& part) { return part.place == place; });
  };
  require(count(Place::rest) == 1, "exactly one part must be the \"rest\"; here " +
                                       std::string(count(Place::rest) == 0 ? "none is" : "several are"));
  require(count(Place::ribs) <= 1, "one part can be the \"ribs\", here several are");
  require(count(Place::core) <= 1, "one part can be the \"core\", here several are");
  if (is_used(parts, Place::ribs))
    check_ribs(ribs);
  if (is_used(parts, Place::core))
    check_core(shape, size, core);
  if (is_used(parts, Place::ribs) && is_used(parts, Place::core))
    along_rings(ribs, size, [&](double x, double) {
      require(core_radius(core, size, x) <=
                  inner_radius(radius_at(shape, size, x), ribs, size) + 1e-9 * size.diameter,
              "the core reaches into the ribs; make its diameter or the depth of the ribs smaller");
    });
}

//! Is the place on one of the lumps of its ring? Gaps are turned by half a lump from one ring to the next.
bool is_on_lump(const Vector3& position, int lumps, int ring)
{
  if (lumps == 0)
    return true;
  const double around = std::atan2(position.z(), position.y()) / (2 * std::numbers::pi) * lumps + 0.5 * ring;
  return around - std::floor(around) < 0.5;
}

bool is_in_ribs(const Vector3& position, std::string_view shape, const ShapeSize& size, const RibSizes& ribs)
{
  const double radius = position.tail<2>().norm();
  for (int ring = 0; ring < ribs.number; ++ring)
    if (std::abs(position.x() - middle_of_ring(ribs, size, ring)) <= 0.5 * ribs.width * size.length)
      return radius > inner_radius(radius_at(shape, size, position.x()), ribs, size) &&
             is_on_lump(position, ribs.lumps, ring);
  return false;
}

} // namespace

double share_of_place(std::string_view shape, const ShapeSize& size, const std::vector<PlacedPart>& places,
                      Place place, const RibSizes& ribs, const CoreSizes& core)
{
  check_places(shape, size, places, ribs, core);
  const double volume = shape_volume(shape, size);
  const double in_ribs = is_used(places, Place::ribs) ? rib_volume(shape, size, ribs) / volume : 0;
  const double in_core = is_used(places, Place::core) ? core_volume(size, core) / volume : 0;
  return place == Place::ribs ? in_ribs : place == Place::core ? in_core : 1 - in_ribs - in_core;
}

void place_parts(Fill& fill, std::string_view shape, const ShapeSize& size,
                 const std::vector<PlacedPart>& parts, const RibSizes& ribs, const CoreSizes& core)
{
  const double volume = shape_volume(shape, size);
  fill.parts.clear();
  std::uint8_t row_of[3] = {};
  for (const PlacedPart& part : parts) {
    row_of[int(part.place)] = std::uint8_t(fill.parts.size());
    fill.parts.push_back({part.name, 0, volume * share_of_place(shape, size, parts, part.place, ribs, core)});
  }
  const bool with_ribs = is_used(parts, Place::ribs), with_core = is_used(parts, Place::core);
  for (Seed& seed : fill.seeds) {
    const Vector3& at = seed.position;
    const Place place = with_ribs && is_in_ribs(at, shape, size, ribs)                       ? Place::ribs
                        : with_core && at.tail<2>().norm() < core_radius(core, size, at.x()) ? Place::core
                                                                                             : Place::rest;
    seed.part = row_of[int(place)];
  }
  for (const Seed& seed : fill.seeds)
    ++fill.parts[seed.part].particles;
  for (const FilledPart& part : fill.parts)
    require(part.particles > 0, "part " + part.name + " holds no particle at a spacing of " +
                                    number(1e3 * fill.spacing) +
                                    " mm; use a finer spacing or make it larger");
}

} // namespace birdstrike
