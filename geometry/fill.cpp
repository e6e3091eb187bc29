// SPDX-License-Identifier: GPL-3.0-or-later
// Solids into particles: rows of a lattice, cut by the surfaces.
#include "geometry/fill.h"

#include "core/error.h"
#include "core/format_text.h"
#include "geometry/measure.h"
#include "geometry/relax.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <numeric>
#include <unistd.h>

namespace birdstrike {

namespace {

constexpr double bytes_per_particle = 600; // state, neighbour list and output of a run; an upper figure
constexpr double memory_share = 0.8;       // of the machine's memory that a run may take
constexpr double snap_share = 0.05;        // of the spacing: a box this near to y = 0 is taken as symmetric
constexpr double widest_gap = 1.5;         // spacings between parts that were meant to touch
constexpr double fewest_lines = 400,
                 most_lines = 1500;   // across the longest side, to measure what the parts have
constexpr double good_volume = 0.005; // error of the whole bird's volume; a worse one is worth other places
constexpr int places = 8; // of a lattice that stay symmetric: half a cell off or not, along x, y and z
constexpr int tries_for_count = 8;       // spacings tried to meet a number of particles
constexpr double step_for_count = 0.004; // between them
constexpr std::size_t most_parts = 255;  // parts are bytes
constexpr int along = 1;                 // rows of the lattice run along y, within layers across x

struct Named
{
  std::string_view name;
  Lattice lattice;
};
constexpr std::array lattices{Named{"cubic", cubic_lattice}, Named{"fcc", fcc_lattice},
                              Named{"leaning", leaning_lattice}};

double physical_memory() // [bytes]
{
  return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
}

//! Points low + (i + shift) step along one axis; for a shift of zero they lie evenly about the middle of the box.
struct Axis
{
  double step, centre;
  long count;
  //! \param aside  half a cell off
  Axis(double lower, double upper, double step, bool aside, bool may_snap = false)
      : step(step), centre(0.5 * (lower + upper))
  {
    if (may_snap && std::abs(centre) < snap_share * step)
      centre = 0;
    count = std::max(1l, std::lround((upper - lower) / step)) + aside;
  }
  double at(long i, double shift) const // exactly symmetric without a shift
  {
    return centre + 0.5 * step * (double(2 * i - (count - 1)) + 2 * shift);
  }
  long first_from(double x, double shift) const
  {
    long i = long(std::ceil((x - centre) / step + 0.5 * double(count - 1) - shift));
    i -= at(i - 1, shift) >= x;
    return i + (at(i, shift) < x);
  }
};

class LatticeFill
{
public:
  LatticeFill(const Solids& solids, const std::vector<std::uint8_t>& part_of, const Lattice& lattice,
              double spacing, int place)
      : solids_(solids),
        part_of_(part_of),
        lattice_(lattice),
        x_(solids.box().lower.x(), solids.box().upper.x(), spacing * lattice.layer, place & 1),
        y_(solids.box().lower.y(), solids.box().upper.y(), spacing * lattice.side, place & 2, true),
        z_(solids.box().lower.z(), solids.box().upper.z(), spacing * lattice.side, place & 4)
  {
  }

  std::vector<Seed> seeds() const
  {
    std::vector<std::vector<Seed>> layers(x_.count);
    over_layers([&](long layer) {
      rows(layer, [&](const Vector3& at, std::uint8_t part) { layers[layer].push_back({at, part}); });
    });
    std::vector<Seed> all;
    all.reserve(std::accumulate(layers.begin(), layers.end(), std::size_t(0),
                                [](std::size_t sum, const auto& layer) { return sum + layer.size(); }));
    for (auto& layer : layers) {
      all.insert(all.end(), layer.begin(), layer.end());
      layer = {};
    }
    return all;
  }

  //! All particles, or none where a part has none.
  std::size_t count() const
  {
    std::vector<std::array<std::size_t, most_parts>> layers(x_.count);
    over_layers([&](long layer) {
      layers[layer].fill(0);
      rows(layer, [&](const Vector3&, std::uint8_t part) { ++layers[layer][part]; });
    });
    std::array<std::size_t, most_parts> of_part{};
    for (const auto& layer : layers)
      for (std::size_t p = 0; p < most_parts; ++p)
        of_part[p] += layer[p];
    std::size_t sum = 0;
    for (std::uint8_t part : part_of_)
      if (of_part[part] == 0)
        return 0;
    for (std::size_t n : of_part)
      sum += n;
    return sum;
  }

private:
  template <class Use>
  void over_layers(Use&& use) const
  {
    std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic)
    for (long layer = 0; layer < x_.count; ++layer)
      try {
        use(layer);
      } catch (...) { // must not leave a parallel loop
#pragma omp critical
        failure = std::current_exception();
      }
    if (failure)
      std::rethrow_exception(failure);
  }

  template <class Use>
  void rows(long layer, Use&& use) const
  {
    const double x = x_.at(layer, 0);
    const auto shift = [&](double per_layer) {
      const double s = double(layer) * per_layer;
      return s - std::floor(s);
    };
    const double shift_y = shift(lattice_.shift_y), shift_z = shift(lattice_.shift_z);
    std::vector<Span> spans;
    for (long k = -1; k <= z_.count; ++k) {
      const double z = z_.at(k, shift_z);
      solids_.spans(z, x, spans);
      for (const Span& span : spans)
        for (long j = y_.first_from(span.from, shift_y); y_.at(j, shift_y) < span.to; ++j)
          use(Vector3(x, y_.at(j, shift_y), z), part_of_[span.object]);
    }
  }

  const Solids& solids_;
  const std::vector<std::uint8_t>& part_of_;
  Lattice lattice_;
  Axis x_, y_, z_;
};

//! A spacing and a place of the lattice.
struct Layout
{
  double spacing;
  int place;
  double off; //!< share by which the number of particles misses the wish
};

//! The place of the lattice at which the number of particles comes nearest to the wish.
Layout best_place(double spacing, double wanted, const std::function<std::size_t(double, int)>& count)
{
  Layout best{spacing, 0, std::numeric_limits<double>::infinity()};
  for (int place = 0; place < places && best.off > good_volume; ++place) {
    const auto found = double(count(spacing, place));
    const double off = found > 0 ? std::abs(found / wanted - 1) : std::numeric_limits<double>::max();
    if (off < best.off)
      best = {spacing, place, off};
  }
  return best;
}

//! The layout that gives the number of particles wanted as nearly as whole cells can.
Layout layout_for(std::size_t wanted, double volume, const std::function<std::size_t(double, int)>& count)
{
  const double exact = std::cbrt(volume / double(wanted));
  Layout best = best_place(exact, double(wanted), count);
  for (int i = 1; i <= tries_for_count && best.off > good_volume; ++i) {
    const double spacing = exact * (1 + (i % 2 ? 1 : -1) * ((i + 1) / 2) * step_for_count);
    if (const Layout next = best_place(spacing, double(wanted), count); next.off < best.off)
      best = next;
  }
  return best;
}

//! Adds gaps seen along another axis: of each two objects the widest stays.
void add_gaps(std::vector<Meeting>& gaps, const std::vector<Meeting>& more)
{
  for (const Meeting& one : more) {
    const auto same = std::find_if(gaps.begin(), gaps.end(),
                                   [&](const Meeting& g) { return g.a == one.a && g.b == one.b; });
    if (same == gaps.end())
      gaps.push_back(one);
    else if (one.volume > same->volume)
      *same = one;
  }
}

//! Twice volume over area is the thickness of a plate, and 2/3 of that of a rod or a ball's 1/3: a fair length.
double typical_thickness(const SurfacePart& part) { return 2 * signed_volume(part) / surface_area(part); }

void require_all_filled(const Fill& fill, const SurfaceMesh& mesh, const std::vector<std::uint8_t>& part_of,
                        double spacing)
{
  for (std::size_t p = 0; p < fill.parts.size(); ++p) {
    if (fill.parts[p].particles > 0)
      continue;
    double thickness = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mesh.size(); ++i)
      if (part_of[i] == p)
        thickness = std::min(thickness, typical_thickness(mesh[i]));
    throw InputError(
        format_text("part '%s' is about %.3g mm thick and gets no particle at a spacing of %.4g mm; use a "
                    "spacing of %.2g mm or less, or leave the part out of the mesh",
                    fill.parts[p].name.c_str(), 1e3 * thickness, 1e3 * spacing, 1e3 * thickness / 2));
  }
}

} // namespace

std::vector<std::string> lattice_names()
{
  std::vector<std::string> names;
  for (const Named& named : lattices)
    names.emplace_back(named.name);
  return names;
}

Lattice lattice_named(std::string_view name)
{
  for (const Named& named : lattices)
    if (named.name == name)
      return named.lattice;
  throw InputError("there is no lattice '" + std::string(name) + "'; known are cubic, fcc and leaning");
}

void require_memory(double volume, double length, double spacing)
{
  const double count = volume / std::pow(spacing, 3);
  const double allowed = std::min(memory_share * physical_memory() / bytes_per_particle,
                                  double(std::numeric_limits<std::int32_t>::max()));
  if (count <= allowed)
    return;
  const double fits = 1.01 * std::cbrt(volume / allowed);
  throw InputError(format_text(
      "a spacing of %.4g mm would make about %.3g particles, which need %.3g GB where the machine "
      "has %.3g GB; the bird is %.4g m long and holds %.4g m3 (is its unit right?); a spacing of "
      "%.4g mm or more fits",
      1e3 * spacing, count, 1e-9 * count * bytes_per_particle, 1e-9 * physical_memory(), length, volume,
      1e3 * fits));
}

Fill fill_mesh(const SurfaceMesh& mesh, const std::vector<std::string>& part_of, const FillOptions& options)
{
  const bool by_count = options.particles > 0;
  require(by_count || (std::isfinite(options.spacing) && options.spacing > 0),
          format_text("the particle spacing is %g m; it must be positive", options.spacing));
  require(part_of.size() == mesh.size(), "every object of the mesh needs the name of its part");

  Fill fill;
  fill.lattice = lattice_named(options.lattice);
  std::vector<std::uint8_t> part_row;
  for (const std::string& name : part_of) {
    const auto at = std::find_if(fill.parts.begin(), fill.parts.end(),
                                 [&](const FilledPart& p) { return p.name == name; });
    part_row.push_back(std::uint8_t(at - fill.parts.begin()));
    if (at == fill.parts.end())
      fill.parts.push_back({.name = name});
    require(fill.parts.size() < most_parts,
            "the mesh has more than 254 parts; give objects of one material one part");
  }

  const Solids solids(mesh, along);
  double whole = 0;
  for (const SurfacePart& object : mesh)
    whole += signed_volume(object);
  const double length = (solids.box().upper - solids.box().lower).maxCoeff();
  const double first_spacing = by_count ? std::cbrt(whole / double(options.particles)) : options.spacing;
  require_memory(whole, length, first_spacing);

  const double step = std::max(std::min(0.5 * first_spacing, length / fewest_lines), length / most_lines);
  const Solids::Shares shares = solids.shares(part_of, step, widest_gap * first_spacing);
  fill.overlaps = shares.overlaps;
  fill.gaps = shares.gaps;
  for (const int axis : {0, 2}) // a gap is seen by lines that cross it; one part has none
    if (fill.parts.size() > 1)
      add_gaps(fill.gaps, Solids(mesh, axis).shares(part_of, 2 * step, widest_gap * first_spacing).gaps);
  double volume = 0;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    fill.parts[part_row[i]].body += shares.of[i];
    volume += shares.of[i].amount;
  }
  for (FilledPart& part : fill.parts)
    part.mesh_volume = part.body.amount;

  const auto lattice = [&](double spacing, int place) {
    return LatticeFill(solids, part_row, fill.lattice, spacing, place);
  };
  const auto count = [&](double spacing, int place) { return lattice(spacing, place).count(); };
  const auto choose = [&]() -> Layout {
    if (by_count)
      return options.relax ? Layout{std::cbrt(volume / double(options.particles)), 0, 0}
                           : layout_for(options.particles, volume, count);
    return options.best_place ? best_place(options.spacing, volume / std::pow(options.spacing, 3), count)
                              : Layout{options.spacing, 0, 0};
  };
  const Layout layout = choose();
  fill.spacing = layout.spacing;
  fill.seeds = lattice(layout.spacing, layout.place).seeds();
  for (FilledPart& part : fill.parts)
    part.particle_volume = std::pow(fill.spacing, 3);
  if (options.relax)
    relax(fill, solids, part_row, options.smoothing);
  for (FilledPart& part : fill.parts)
    part.particles = 0;
  for (const Seed& seed : fill.seeds)
    ++fill.parts[seed.part].particles;
  require_all_filled(fill, mesh, part_row, fill.spacing);
  return fill;
}

Fill fill_lattice(const SurfaceMesh& mesh, const std::vector<std::string>& part_of, double spacing)
{
  return fill_mesh(mesh, part_of, {.spacing = spacing});
}

} // namespace birdstrike
