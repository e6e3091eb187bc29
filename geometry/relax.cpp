// SPDX-License-Identifier: GPL-3.0-or-later
// Particles that settle: shifts against the gradient of what they count too much.
#include "geometry/relax.h"

#include "core/error.h"
#include "core/format_text.h"
#include "core/parallel.h"
#include "core/particles/kernel.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace birdstrike {

namespace {

// On a cubic lattice the most even state comes after some thirty rounds; then, slowly, particles pair up, because the
// cubic spline hardly tells two near particles from one of twice the volume. The close-packed lattice stays. So the
// best state is kept, and patience is short.
constexpr int rounds = 200;           // of shifts, at most
constexpr int patience = 12;          // rounds without a better state
constexpr double better = 0.995;      // times the best deviation so far
constexpr double mobility = 0.5;      // shift = -mobility h^2 grad C, near the largest that does not ring
constexpr double longest_shift = 0.1; // spacings
constexpr int lines_a_cell = 4;       // each way, to cut a cell of the bird's own space
constexpr double apart = 2.0;         // spacings between particles that are added or removed together
constexpr int rounds_of_numbers = 100;

//! The bird's own space as cells of one spacing, cut by the surface: volume and middle of what lies inside.
struct Space
{
  std::vector<Vector3> middle;
  std::vector<double> volume;
};

Space space_of(const Solids& solids, double spacing)
{
  const Box& box = solids.box();
  const auto count = [&](int k) { return long((box.upper[k] - box.lower[k]) / spacing) + 1; };
  const long nx = count(0), ny = count(1), nz = count(2);
  const double line = spacing / lines_a_cell;
  std::vector<Space> layers(nx);
#pragma omp parallel for schedule(dynamic)
  for (long i = 0; i < nx; ++i) {
    std::vector<Vector3> first(ny);
    std::vector<double> volume(ny);
    std::vector<Span> spans;
    for (long k = 0; k < nz; ++k) {
      std::fill(first.begin(), first.end(), Vector3::Zero());
      std::fill(volume.begin(), volume.end(), 0.0);
      for (int a = 0; a < lines_a_cell; ++a)
        for (int b = 0; b < lines_a_cell; ++b) {
          const double x = box.lower.x() + double(i) * spacing + (a + 0.5) * line,
                       z = box.lower.z() + double(k) * spacing + (b + 0.5) * line;
          solids.spans(z, x, spans);
          for (const Span& span : spans) {
            const long to = std::clamp(long((span.to - box.lower.y()) / spacing), 0l, ny - 1);
            for (long j = std::clamp(long((span.from - box.lower.y()) / spacing), 0l, ny - 1); j <= to; ++j) {
              const double low = std::max(span.from, box.lower.y() + double(j) * spacing),
                           high = std::min(span.to, box.lower.y() + double(j + 1) * spacing);
              if (high <= low)
                continue;
              const double piece = (high - low) * line * line;
              volume[j] += piece;
              first[j] += piece * Vector3(x, 0.5 * (low + high), z);
            }
          }
        }
      for (long j = 0; j < ny; ++j)
        if (volume[j] > 0) {
          layers[i].middle.push_back(first[j] / volume[j]);
          layers[i].volume.push_back(volume[j]);
        }
    }
  }
  Space space;
  for (const Space& layer : layers) {
    space.middle.insert(space.middle.end(), layer.middle.begin(), layer.middle.end());
    space.volume.insert(space.volume.end(), layer.volume.begin(), layer.volume.end());
  }
  return space;
}

//! What particles count too much at a place, and its gradient.
struct Excess
{
  double value = 0;
  Vector3 gradient = Vector3::Zero();
};

class Settling
{
public:
  Settling(Fill& fill, const Solids& solids, const std::vector<std::uint8_t>& part_of, double smoothing)
      : fill_(fill),
        solids_(solids),
        part_of_(part_of),
        h_(smoothing * fill.spacing),
        space_(space_of(solids, fill.spacing)),
        cells_(space_.middle, 2 * h_)
  {
    for (const FilledPart& part : fill.parts)
      wanted_.push_back(std::max(1l, std::lround(part.mesh_volume / std::pow(fill.spacing, 3))));
    for (std::size_t p = 0; p < fill.parts.size(); ++p)
      fill.parts[p].particle_volume = fill.parts[p].mesh_volume / double(wanted_[p]);
    for (const Seed& seed : fill.seeds) {
      at_.push_back(seed.position);
      part_.push_back(seed.part);
    }
  }

  void run()
  {
    match_numbers();
    double best = INFINITY;
    std::vector<Vector3> most_even;
    for (int round = 0, since = 0; round < rounds && since < patience; ++round, ++since) {
      const std::vector<Vector3> before = at_;
      if (const double deviation = shift(); deviation < better * best) {
        best = deviation;
        most_even = before;
        since = 0;
      }
    }
    at_ = std::move(most_even);
    finish();
  }

private:
  double volume(std::size_t i) const { return fill_.parts[part_[i]].particle_volume; }

  Excess excess(const Vector3& at, const PointGrid& grid) const
  {
    Excess e;
    grid.visit(at, 2 * h_, [&](std::uint32_t j, const Vector3& offset, double squared) {
      const double r = std::sqrt(squared);
      e.value += volume(j) * kernel(r, h_);
      e.gradient += volume(j) * kernel_slope(r, h_) * offset;
    });
    const Excess own = body(at);
    e.value -= own.value;
    e.gradient -= own.gradient;
    return e;
  }

  Excess body(const Vector3& at) const
  {
    Excess e;
    cells_.visit(at, 2 * h_, [&](std::uint32_t j, const Vector3& offset, double squared) {
      const double r = std::sqrt(squared);
      e.value += space_.volume[j] * kernel(r, h_);
      e.gradient += space_.volume[j] * kernel_slope(r, h_) * offset;
    });
    return e;
  }

  bool belongs(const Vector3& at, std::uint8_t part) const
  {
    const int owner = solids_.owner(at);
    return owner >= 0 && part_of_[owner] == part;
  }

  // Particles are added in the widest holes and taken from the densest places of each part, a few at a time.
  void match_numbers()
  {
    std::vector<long> have(fill_.parts.size());
    for (std::uint8_t part : part_)
      ++have[part];
    for (int round = 0; round < rounds_of_numbers; ++round) {
      long missing = 0;
      for (std::size_t p = 0; p < have.size(); ++p)
        missing += std::abs(wanted_[p] - have[p]);
      if (missing == 0)
        return;
      const PointGrid grid(at_, 2 * h_);
      const std::vector<long> before = have;
      remove(grid, have);
      add(have);
      if (have == before)
        break;
    }
    for (std::size_t p = 0; p < have.size(); ++p)
      require(have[p] == wanted_[p],
              format_text(
                  "part '%s' is too thin to be relaxed at a spacing of %.4g mm: it has room for %ld of %ld "
                  "particles; use a finer spacing, or no relaxation",
                  fill_.parts[p].name.c_str(), 1e3 * fill_.spacing, have[p], wanted_[p]));
  }

  void remove(const PointGrid& grid, std::vector<long>& have)
  {
    std::vector<std::pair<double, std::uint32_t>> dense;
    for (std::size_t i = 0; i < at_.size(); ++i)
      if (have[part_[i]] > wanted_[part_[i]])
        dense.emplace_back(0, std::uint32_t(i));
    for_each_row(dense.size(),
                 [&](std::size_t k) { dense[k].first = -excess(at_[dense[k].second], grid).value; });
    std::sort(dense.begin(), dense.end());
    std::vector<char> gone(at_.size()), shy(at_.size());
    for (const auto& [value, i] : dense) {
      if (shy[i] || have[part_[i]] == wanted_[part_[i]])
        continue;
      gone[i] = 1;
      --have[part_[i]];
      grid.visit(at_[i], apart * fill_.spacing, [&](std::uint32_t j, const Vector3&, double) { shy[j] = 1; });
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < at_.size(); ++i)
      if (!gone[i]) {
        at_[kept] = at_[i];
        part_[kept++] = part_[i];
      }
    at_.resize(kept);
    part_.resize(kept);
  }

  void add(std::vector<long>& have)
  {
    // Places half a spacing around the particles there are, and the middles of the cells of the body.
    const PointGrid grid(at_, 2 * h_);
    std::vector<Vector3> places;
    std::vector<std::uint8_t> part;
    const auto offer = [&](const Vector3& at) {
      const int owner = solids_.owner(at);
      if (owner < 0 || have[part_of_[owner]] >= wanted_[part_of_[owner]])
        return;
      places.push_back(at);
      part.push_back(part_of_[owner]);
    };
    if (std::none_of(have.begin(), have.end(), [&, p = 0](long n) mutable { return n < wanted_[p++]; }))
      return;
    for (const Vector3& middle : space_.middle)
      for (int corner = 0; corner < 8; ++corner)
        offer(middle +
              0.25 * fill_.spacing * Vector3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    std::vector<std::pair<double, std::uint32_t>> holes(places.size());
    for_each_row(places.size(), [&](std::size_t k) {
      double nearest = 4 * h_ * h_;
      grid.visit(places[k], 2 * h_, [&](std::uint32_t, const Vector3&, double squared) {
        nearest = std::min(nearest, squared);
      });
      holes[k] = {excess(places[k], grid).value - nearest / (fill_.spacing * fill_.spacing),
                  std::uint32_t(k)};
    });
    std::sort(holes.begin(), holes.end());
    const PointGrid offered(places, apart * fill_.spacing);
    std::vector<char> shy(places.size());
    for (const auto& [value, k] : holes) {
      if (shy[k] || have[part[k]] == wanted_[part[k]])
        continue;
      at_.push_back(places[k]);
      part_.push_back(part[k]);
      ++have[part[k]];
      offered.visit(places[k], apart * fill_.spacing,
                    [&](std::uint32_t j, const Vector3&, double) { shy[j] = 1; });
    }
  }

  // One shift of all particles; returns the root mean square of what they counted too much before it.
  double shift()
  {
    const PointGrid grid(at_, 2 * h_);
    std::vector<Vector3> to(at_.size());
    std::vector<double> value(at_.size());
    for_each_row(at_.size(), [&](std::size_t i) {
      const Excess e = excess(at_[i], grid);
      value[i] = e.value;
      Vector3 step = -mobility * h_ * h_ * e.gradient;
      const double length = step.norm(), most = longest_shift * fill_.spacing;
      if (length > most)
        step *= most / length;
      to[i] = at_[i];
      for (int half = 0; half < 3; ++half, step *= 0.5) // at a surface: as far as the part reaches
        if (belongs(at_[i] + step, part_[i])) {
          to[i] = at_[i] + step;
          break;
        }
    });
    measure(value);
    at_.swap(to);
    return fill_.density_deviation;
  }

  void measure(const std::vector<double>& value)
  {
    fill_.density_deviation = std::sqrt(
        ordered_sum(value.size(), [&](std::size_t i) { return value[i] * value[i]; }) / double(value.size()));
    fill_.density_worst = 0;
    for (double v : value)
      fill_.density_worst = std::max(fill_.density_worst, std::abs(v));
  }

  void finish()
  {
    const PointGrid grid(at_, 2 * h_);
    std::vector<double> value(at_.size()), deep(at_.size());
    for_each_row(at_.size(), [&](std::size_t i) {
      value[i] = excess(at_[i], grid).value;
      deep[i] = body(at_[i]).value > 0.999 ? 1 : 0;
    });
    measure(value);
    const double inner = std::accumulate(deep.begin(), deep.end(), 0.0);
    double counted = 0;
    for (std::size_t i = 0; i < at_.size(); ++i)
      counted += deep[i] * value[i];
    fill_.lattice.counted = inner > 0 ? 1 + counted / inner : 1;
    fill_.seeds.clear();
    for (std::size_t i = 0; i < at_.size(); ++i)
      fill_.seeds.push_back({at_[i], part_[i]});
  }

  Fill& fill_;
  const Solids& solids_;
  const std::vector<std::uint8_t>& part_of_;
  double h_;
  Space space_;
  PointGrid cells_;
  std::vector<long> wanted_;
  std::vector<Vector3> at_;
  std::vector<std::uint8_t> part_;
};

} // namespace

void relax(Fill& fill, const Solids& solids, const std::vector<std::uint8_t>& part_of, double smoothing)
{
  Settling(fill, solids, part_of, smoothing).run();
}

} // namespace birdstrike
