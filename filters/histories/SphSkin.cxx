// SPDX-License-Identifier: BSD-3-Clause
// The surface on which a field of particles has a level.
#include "SphSkin.h"

#include "MarchingCase.h"
#include "ParallelFor.h"

#include <atomic>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <tuple>

namespace {

constexpr int N = 8, M = N + 1; // cubes and points along the side of a block
using Lattice = std::array<std::int32_t, 3>;

struct Visit // a particle reaches a block
{
  Lattice Block;
  std::uint32_t Particle;
};

bool operator<(const Visit& a, const Visit& b)
{
  return std::tie(a.Block, a.Particle) < std::tie(b.Block, b.Particle);
}

struct Vertex
{
  int Edge; // 3 * point of the block + axis
  Vector3d Place;
};

struct Patch // of one block
{
  std::vector<Vertex> Vertices;
  std::vector<std::array<std::int32_t, 3>> Triangles; // numbers of its vertices
};

struct Scratch
{
  std::array<double, M * M * M> Value;
  std::array<std::int32_t, 3 * M * M * M> Vertex; // on each edge, -1: none yet
};

class Marcher
{
public:
  Marcher(const SphField& field, double spacing, double level, double memory)
      : Field(field), Spacing(spacing), Level(level), Memory(memory)
  {
    this->Low = field.GetPoints().front();
    for (const Vector3d& p : field.GetPoints())
      for (std::size_t k = 0; k < 3; ++k)
        this->Low[k] = std::min(this->Low[k], p[k]);
  }

  SphSkin March(const std::function<bool(double)>& goOn)
  {
    this->FindBlocks();
    this->Patches.resize(this->Starts.size() - 1);
    const bool done = ParallelFor(
        this->Patches.size(), 16,
        [this](std::size_t begin, std::size_t end) {
          const auto scratch = std::make_unique<Scratch>();
          for (std::size_t b = begin; b < end && !this->Full; ++b) {
            this->Fill(b, *scratch);
            this->MarchBlock(b, *scratch);
          }
        },
        goOn);
    if (this->Full)
      throw SkinTooLarge("the surface has more than " + std::to_string(this->Triangles.load()) +
                         " triangles");
    return done ? this->Join() : SphSkin();
  }

private:
  Lattice BlockAt(const Vector3d& p, double shift) const
  {
    Lattice block;
    for (std::size_t k = 0; k < 3; ++k) {
      const double b = std::floor((p[k] + shift - this->Low[k]) / (N * this->Spacing));
      if (!(std::abs(b) < 0.9 * std::numeric_limits<std::int32_t>::max() / N))
        throw SkinTooLarge("a particle lies " + std::to_string(b * N) + " grid spacings away from another");
      block[k] = static_cast<std::int32_t>(b);
    }
    return block;
  }

  // All blocks with the particles that reach them, in their order.
  void FindBlocks()
  {
    const auto& points = this->Field.GetPoints();
    const auto& h = this->Field.GetSmoothing();
    const auto range = [&](std::size_t i) {
      const double reach = SphField::Support * h[i];
      return std::make_pair(this->BlockAt(points[i], -reach), this->BlockAt(points[i], reach));
    };
    double visits = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [low, high] = range(i);
      visits += (high[0] - low[0] + 1.0) * (high[1] - low[1] + 1.0) * (high[2] - low[2] + 1.0);
    }
    if (visits * sizeof(Visit) > this->Memory)
      throw SkinTooLarge("the grid needs " +
                         std::to_string(static_cast<long long>(visits * sizeof(Visit) / 1e6)) + " MB");
    this->Visits.reserve(static_cast<std::size_t>(visits));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [low, high] = range(i);
      for (std::int32_t x = low[0]; x <= high[0]; ++x)
        for (std::int32_t y = low[1]; y <= high[1]; ++y)
          for (std::int32_t z = low[2]; z <= high[2]; ++z)
            this->Visits.push_back({{x, y, z}, static_cast<std::uint32_t>(i)});
    }
    std::sort(this->Visits.begin(), this->Visits.end());
    for (std::size_t n = 0; n < this->Visits.size(); ++n)
      if (n == 0 || this->Visits[n].Block != this->Visits[n - 1].Block)
        this->Starts.push_back(n);
    this->Starts.push_back(this->Visits.size());
  }

  double Coordinate(std::size_t axis, std::int32_t block, int k) const
  {
    return this->Low[axis] + this->Spacing * static_cast<double>(std::int64_t(block) * N + k);
  }

  // The field at the points of a block. Neighbours find the same bits at the points that they share.
  void Fill(std::size_t b, Scratch& scratch) const
  {
    scratch.Value.fill(0);
    const Lattice& block = this->Visits[this->Starts[b]].Block;
    std::array<std::array<double, M>, 3> at;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int k = 0; k < M; ++k)
        at[axis][static_cast<std::size_t>(k)] = this->Coordinate(axis, block[axis], k);
    for (std::size_t n = this->Starts[b]; n < this->Starts[b + 1]; ++n) {
      const std::size_t i = this->Visits[n].Particle;
      const Vector3d& p = this->Field.GetPoints()[i];
      const double reach = SphField::Support * this->Field.GetSmoothing()[i], squared = reach * reach;
      std::array<int, 3> first, last;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        first[axis] = 0;
        last[axis] = M - 1;
        while (first[axis] < M && at[axis][static_cast<std::size_t>(first[axis])] <= p[axis] - reach)
          ++first[axis];
        while (last[axis] >= 0 && at[axis][static_cast<std::size_t>(last[axis])] >= p[axis] + reach)
          --last[axis];
      }
      for (int z = first[2]; z <= last[2]; ++z) {
        const double dz = at[2][static_cast<std::size_t>(z)] - p[2];
        for (int y = first[1]; y <= last[1]; ++y) {
          const double dy = at[1][static_cast<std::size_t>(y)] - p[1], yz = dy * dy + dz * dz;
          if (yz >= squared)
            continue;
          double* const row = scratch.Value.data() + (z * M + y) * M;
          for (int x = first[0]; x <= last[0]; ++x) {
            const double dx = at[0][static_cast<std::size_t>(x)] - p[0];
            row[x] += this->Field.Share(i, dx * dx + yz); // 0 beyond the support
          }
        }
      }
    }
  }

  void MarchBlock(std::size_t b, Scratch& scratch)
  {
    Patch& patch = this->Patches[b];
    scratch.Vertex.fill(-1);
    for (int z = 0; z < N; ++z)
      for (int y = 0; y < N; ++y)
        for (int x = 0; x < N; ++x) {
          int inside = 0;
          for (int c = 0; c < 8; ++c)
            inside |= (this->IsInside(scratch, PointOf(x, y, z, c)) ? 1 : 0) << c;
          if (inside == 0 || inside == 255)
            continue;
          for (const std::array<int, 3>& triangle : MarchingCase(inside)) {
            std::array<std::int32_t, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) {
              const CubeEdge& edge = CubeEdges()[static_cast<std::size_t>(triangle[k])];
              corners[k] = this->VertexOn(b, PointOf(x, y, z, edge.Corner), edge.Axis, scratch);
            }
            patch.Triangles.push_back(corners);
          }
        }
    const auto triangles = static_cast<std::int64_t>(patch.Triangles.size());
    const std::int64_t all = this->Triangles.fetch_add(triangles) + triangles;
    // Some 36 bytes of a triangle and half a vertex here, the same again in the joined surface.
    if (static_cast<double>(all) * 100 + static_cast<double>(this->Visits.size() * sizeof(Visit)) >
        this->Memory)
      this->Full = true;
  }

  static int PointOf(int x, int y, int z, int corner)
  {
    return ((z + (corner >> 2 & 1)) * M + y + (corner >> 1 & 1)) * M + x + (corner & 1);
  }

  bool IsInside(const Scratch& scratch, int point) const
  {
    return scratch.Value[static_cast<std::size_t>(point)] >= this->Level;
  }

  std::int32_t VertexOn(std::size_t b, int point, int axis, Scratch& scratch)
  {
    const int edge = 3 * point + axis;
    std::int32_t& known = scratch.Vertex[static_cast<std::size_t>(edge)];
    if (known >= 0)
      return known;
    static constexpr int step[3] = {1, M, M * M};
    const double a = scratch.Value[static_cast<std::size_t>(point)],
                 c = scratch.Value[static_cast<std::size_t>(point + step[axis])];
    const Lattice& block = this->Visits[this->Starts[b]].Block;
    Vector3d place{this->Coordinate(0, block[0], point % M), this->Coordinate(1, block[1], point / M % M),
                   this->Coordinate(2, block[2], point / (M * M))};
    place[static_cast<std::size_t>(axis)] += (this->Level - a) / (c - a) * this->Spacing;
    known = static_cast<std::int32_t>(this->Patches[b].Vertices.size());
    this->Patches[b].Vertices.push_back({edge, place});
    return known;
  }

  // One surface of all patches; vertices on the sides of blocks are shared.
  SphSkin Join()
  {
    using Key = std::array<std::int32_t, 4>; // point of the whole lattice, axis
    std::map<Key, std::int64_t> shared;
    SphSkin skin;
    skin.Triangles.reserve(static_cast<std::size_t>(this->Triangles.load()));
    std::vector<std::int64_t> numbers;
    for (std::size_t b = 0; b < this->Patches.size(); ++b) {
      const Lattice& block = this->Visits[this->Starts[b]].Block;
      numbers.clear();
      for (const Vertex& vertex : this->Patches[b].Vertices) {
        const int axis = vertex.Edge % 3, point = vertex.Edge / 3;
        const std::array<int, 3> local{point % M, point / M % M, point / (M * M)};
        bool side = false;
        Key key{0, 0, 0, axis};
        for (std::size_t k = 0; k < 3; ++k) {
          side = side || (static_cast<int>(k) != axis && local[k] % N == 0);
          key[k] = block[k] * N + local[k];
        }
        const auto next = static_cast<std::int64_t>(skin.Points.size());
        const std::int64_t number = side ? shared.emplace(key, next).first->second : next;
        if (number == next)
          skin.Points.push_back(vertex.Place);
        numbers.push_back(number);
      }
      for (const auto& t : this->Patches[b].Triangles)
        skin.Triangles.push_back({numbers[static_cast<std::size_t>(t[0])],
                                  numbers[static_cast<std::size_t>(t[1])],
                                  numbers[static_cast<std::size_t>(t[2])]});
      this->Patches[b] = {};
    }
    return skin;
  }

  const SphField& Field;
  const double Spacing, Level, Memory;
  Vector3d Low;
  std::vector<Visit> Visits;
  std::vector<std::size_t> Starts; // of each block in Visits; one more at the end
  std::vector<Patch> Patches;
  std::atomic<std::int64_t> Triangles{0};
  std::atomic<bool> Full{false};
};

} // namespace

SphSkin MakeSphSkin(const SphField& field, double spacing, double level, double memory,
                    const std::function<bool(double)>& goOn)
{
  if (field.GetPoints().empty())
    return {};
  return Marcher(field, spacing, level, memory).March(goOn);
}
