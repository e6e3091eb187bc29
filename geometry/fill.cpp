// SPDX-License-Identifier: GPL-3.0-or-later
// Solids into particles on an equal-spaced lattice.
#include "geometry/fill.h"

#include "core/error.h"
#include "geometry/inside.h"
#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <numeric>
#include <unistd.h>

namespace birdstrike {

namespace {

constexpr double bytes_per_particle = 600; // state, neighbour list and output of a run; an upper figure
constexpr double memory_share = 0.8;       // of the machine's memory that a run may take
constexpr double snap_share = 0.05;        // of the spacing: a box this near to y = 0 is taken as symmetric

template <class... Values>
std::string text(const char* format, Values... values)
{
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

double physical_memory() // [bytes]
{
  return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
}

//! Lattice points along one axis: cells of one spacing, centred on the box.
struct Axis
{
  double centre, spacing;
  long count;
  Axis(double lower, double upper, double spacing)
      : centre(0.5 * (lower + upper)),
        spacing(spacing),
        count(std::max(1l, std::lround((upper - lower) / spacing)))
  {
  }
  double at(long i) const { return centre + 0.5 * spacing * double(2 * i - (count - 1)); }
  long first_from(double x) const // smallest i with at(i) >= x, within a cell
  {
    return std::clamp(long(std::floor((x - at(0)) / spacing)), 0l, count);
  }
  long end_before(double x) const
  {
    return std::clamp(long(std::floor((x - at(0)) / spacing)) + 2, 0l, count);
  }
};

//! Volume of every object less the objects that lie wholly within it.
std::vector<double> exclusive_volumes(const SurfaceMesh& mesh, const std::vector<Inside>& insides,
                                      const std::vector<double>& volumes)
{
  std::vector<double> exclusive = volumes;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    std::size_t holder = mesh.size(); // the smallest object around object i
    for (std::size_t j = 0; j < mesh.size(); ++j) {
      if (j == i || volumes[j] <= volumes[i] || (holder < mesh.size() && volumes[j] >= volumes[holder]))
        continue;
      if (std::all_of(mesh[i].points.begin(), mesh[i].points.end(),
                      [&](const Vector3& p) { return insides[j].contains(p); }))
        holder = j;
    }
    if (holder < mesh.size())
      exclusive[holder] -= volumes[i];
  }
  return exclusive;
}

//! An object with its part, in the order in which objects may claim a point.
struct Claim
{
  std::size_t object;
  std::uint8_t part;
};

constexpr std::uint8_t nobody = 255;

//! Seeds with the same z. The first claim that contains a point gets it.
void fill_layer(const std::vector<Claim>& claims, const std::vector<Inside>& insides, const Axis& along_x,
                const Axis& along_y, double z, std::vector<Seed>& seeds)
{
  std::vector<std::uint8_t> owner(along_x.count);
  for (long j = 0; j < along_y.count; ++j) {
    const double y = along_y.at(j);
    std::fill(owner.begin(), owner.end(), nobody);
    for (const Claim& claim : claims) {
      const Inside& inside = insides[claim.object];
      const Box& box = inside.box();
      if (y < box.lower.y() || y > box.upper.y() || z < box.lower.z() || z > box.upper.z())
        continue;
      const long end = along_x.end_before(box.upper.x());
      for (long i = along_x.first_from(box.lower.x()); i < end; ++i)
        if (owner[i] == nobody && inside.contains({along_x.at(i), y, z}))
          owner[i] = claim.part;
    }
    for (long i = 0; i < along_x.count; ++i)
      if (owner[i] != nobody)
        seeds.push_back({{along_x.at(i), y, z}, owner[i]});
  }
}

//! Twice volume over area is the thickness of a plate, and 2/3 of that of a rod or a ball's 1/3: a fair
//! length.
double typical_thickness(const SurfacePart& part) { return 2 * signed_volume(part) / surface_area(part); }

} // namespace

void require_memory(double volume, double length, double spacing)
{
  const double count = volume / std::pow(spacing, 3);
  const double allowed = std::min(memory_share * physical_memory() / bytes_per_particle,
                                  double(std::numeric_limits<std::int32_t>::max()));
  if (count <= allowed)
    return;
  const double fits = 1.01 * std::cbrt(volume / allowed);
  throw InputError(
      text("a spacing of %.4g mm would make about %.3g particles, which need %.3g GB where the machine "
           "has %.3g GB; the bird is %.4g m long and holds %.4g m3 (is its unit right?); a spacing of "
           "%.4g mm or more fits",
           1e3 * spacing, count, 1e-9 * count * bytes_per_particle, 1e-9 * physical_memory(), length, volume,
           1e3 * fits));
}

Fill fill_lattice(const SurfaceMesh& mesh, const std::vector<std::string>& part_of, double spacing)
{
  require(std::isfinite(spacing) && spacing > 0,
          text("the particle spacing is %g m; it must be positive", spacing));
  require(!mesh.empty(), "the mesh holds no solid to fill");
  require(part_of.size() == mesh.size(), "every object of the mesh needs the name of its part");

  std::vector<double> volumes;
  for (const SurfacePart& object : mesh) {
    volumes.push_back(signed_volume(object));
    require(volumes.back() > 0,
            "object '" + object.name + "' encloses no volume or is inside out; flip its normals");
  }
  Box box = bounding_box(mesh);
  require_memory(std::accumulate(volumes.begin(), volumes.end(), 0.0), (box.upper - box.lower).maxCoeff(),
                 spacing);

  Fill fill;
  fill.spacing = spacing;
  std::vector<Claim> claims;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto at = std::find_if(fill.parts.begin(), fill.parts.end(),
                                 [&](const FilledPart& p) { return p.name == part_of[i]; });
    claims.push_back({i, std::uint8_t(at - fill.parts.begin())});
    if (at == fill.parts.end())
      fill.parts.push_back({part_of[i], 0, 0});
    require(fill.parts.size() < nobody,
            "the mesh has more than 254 parts; give objects of one material one part");
  }
  // An inner solid is smaller than the one around it, so that one order serves both rules.
  std::stable_sort(claims.begin(), claims.end(),
                   [&](const Claim& a, const Claim& b) { return volumes[a.object] < volumes[b.object]; });

  std::vector<Inside> insides;
  for (const SurfacePart& object : mesh)
    insides.emplace_back(object);
  const std::vector<double> exclusive = exclusive_volumes(mesh, insides, volumes);
  for (const Claim& claim : claims)
    fill.parts[claim.part].mesh_volume += exclusive[claim.object];

  Axis along_x(box.lower.x(), box.upper.x(), spacing), along_y(box.lower.y(), box.upper.y(), spacing),
      along_z(box.lower.z(), box.upper.z(), spacing);
  if (std::abs(along_y.centre) < snap_share * spacing)
    along_y.centre = 0;

  std::vector<std::vector<Seed>> layers(along_z.count);
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic)
  for (long k = 0; k < along_z.count; ++k)
    try {
      fill_layer(claims, insides, along_x, along_y, along_z.at(k), layers[k]);
    } catch (...) { // must not leave a parallel loop
#pragma omp critical
      failure = std::current_exception();
    }
  if (failure)
    std::rethrow_exception(failure);

  for (auto& layer : layers) {
    for (const Seed& seed : layer)
      ++fill.parts[seed.part].particles;
    fill.seeds.insert(fill.seeds.end(), layer.begin(), layer.end());
    layer = {};
  }
  for (std::size_t p = 0; p < fill.parts.size(); ++p) {
    if (fill.parts[p].particles > 0)
      continue;
    double thickness = std::numeric_limits<double>::infinity();
    for (const Claim& claim : claims)
      if (claim.part == p)
        thickness = std::min(thickness, typical_thickness(mesh[claim.object]));
    throw InputError(
        text("part '%s' is about %.3g mm thick and gets no particle at a spacing of %.4g mm; use a "
             "spacing of %.2g mm or less, or leave the part out of the mesh",
             fill.parts[p].name.c_str(), 1e3 * thickness, 1e3 * spacing, 1e3 * thickness / 2));
  }
  return fill;
}

} // namespace birdstrike
