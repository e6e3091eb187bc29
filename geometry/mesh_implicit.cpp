// SPDX-License-Identifier: GPL-3.0-or-later
// The zero surface of an implicit body as triangles.
#include "geometry/mesh_implicit.h"

#include "core/error.h"
#include "geometry/remesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace birdstrike {

namespace {

constexpr std::int64_t block = 4;    // nodes along the edge of a block that is skipped as a whole
constexpr double near_enough = 1e-4; // distance to the surface, over the edge, that is not worth a step
constexpr double blocks_apart = 2.5; // half diagonals of a block; > 1 because the distance is an estimate
constexpr double grid_share =
    0.6; // grid cell over wanted edge: finer than the result, so that remeshing decides

struct Grid
{
  Vector3 origin;
  double cell;
  std::int64_t nx, ny, nz; // nodes
  std::vector<double> value;

  std::int64_t row(std::int64_t i, std::int64_t j, std::int64_t k) const { return (k * ny + j) * nx + i; }
  Vector3 node(std::int64_t row) const
  {
    return origin + cell * Vector3(double(row % nx), double(row / nx % ny), double(row / (nx * ny)));
  }
};

Grid sample(const Implicit& body, const Box& box, double cell)
{
  const Vector3 size = box.upper - box.lower;
  const auto nodes = [&](double length) { return std::int64_t(std::ceil(length / cell)) + 1; };
  Grid grid{Vector3::Zero(), cell, nodes(size.x()), nodes(size.y()), nodes(size.z()), {}};
  grid.origin =
      box.centre() - 0.5 * cell * Vector3(double(grid.nx - 1), double(grid.ny - 1), double(grid.nz - 1));
  grid.value.resize(grid.nx * grid.ny * grid.nz);
  // Blocks of nodes that lie well off the surface take the value of their middle: most of the box does.
  const double safe = blocks_apart * 0.5 * std::sqrt(3.0) * block * cell;
  const auto blocks = [](std::int64_t nodes) { return (nodes + block - 1) / block; };
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t bk = 0; bk < blocks(grid.nz); ++bk)
    for (std::int64_t bj = 0; bj < blocks(grid.ny); ++bj)
      for (std::int64_t bi = 0; bi < blocks(grid.nx); ++bi) {
        const Vector3 corner(double(bi * block), double(bj * block), double(bk * block));
        const double middle = body(grid.origin + cell * (corner + Vector3::Constant(0.5 * (block - 1))));
        const bool far_off = std::abs(middle) > safe;
        for (auto k = bk * block; k < std::min((bk + 1) * block, grid.nz); ++k)
          for (auto j = bj * block; j < std::min((bj + 1) * block, grid.ny); ++j)
            for (auto i = bi * block; i < std::min((bi + 1) * block, grid.nx); ++i) {
              const std::int64_t row = grid.row(i, j, k);
              grid.value[row] = far_off ? middle : body(grid.node(row));
            }
      }
  return grid;
}

bool touches_faces(const Grid& grid)
{
  for (std::int64_t k = 0; k < grid.nz; ++k)
    for (std::int64_t j = 0; j < grid.ny; ++j)
      for (std::int64_t i = 0; i < grid.nx; ++i) {
        const bool face =
            i == 0 || j == 0 || k == 0 || i == grid.nx - 1 || j == grid.ny - 1 || k == grid.nz - 1;
        if (face && grid.value[grid.row(i, j, k)] < 0)
          return true;
      }
  return false;
}

class Marcher
{
public:
  explicit Marcher(const Grid& grid) : grid_(grid) {}

  SurfacePart run()
  {
    // Six tetrahedra a cube, all around the diagonal from node 0 to node 7: neighbours split their shared
    // face alike, so that the surface closes. Bits of a node: 1 is +x, 2 is +y, 4 is +z.
    static constexpr int tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                             {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    for (std::int64_t k = 0; k + 1 < grid_.nz; ++k)
      for (std::int64_t j = 0; j + 1 < grid_.ny; ++j)
        for (std::int64_t i = 0; i + 1 < grid_.nx; ++i) {
          std::int64_t row[8];
          int inside = 0;
          for (int c = 0; c < 8; ++c) {
            row[c] = grid_.row(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
            inside += grid_.value[row[c]] < 0;
          }
          if (inside != 0 && inside != 8)
            for (const auto& t : tetrahedra)
              cut({row[t[0]], row[t[1]], row[t[2]], row[t[3]]});
        }
    return std::move(part_);
  }

private:
  // All six tetrahedra are positively oriented; an even permutation of the corners keeps that.
  void cut(std::array<std::int64_t, 4> c)
  {
    std::array<int, 4> order{0, 1, 2, 3};
    const auto is_inside = [&](int i) { return grid_.value[c[i]] < 0; };
    std::stable_partition(order.begin(), order.end(), is_inside);
    const int count = int(std::count_if(order.begin(), order.end(), is_inside));
    int swaps = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b)
        swaps += order[a] > order[b];
    const bool flip = swaps % 2 != 0;
    const auto at = [&](int i, int o) { return crossing(c[order[i]], c[order[o]]); };
    if (count == 1)
      add(at(0, 1), at(0, 2), at(0, 3), flip);
    else if (count == 3)
      add(at(0, 3), at(1, 3), at(2, 3), flip);
    else if (count == 2) {
      add(at(0, 2), at(0, 3), at(1, 3), flip);
      add(at(0, 2), at(1, 3), at(1, 2), flip);
    }
  }

  void add(int a, int b, int c, bool flip)
  {
    part_.triangles.push_back(flip ? std::array{a, c, b} : std::array{a, b, c});
  }

  int crossing(std::int64_t in, std::int64_t out)
  {
    const auto low = std::uint64_t(std::min(in, out)), high = std::uint64_t(std::max(in, out));
    const auto [found, is_new] = points_.try_emplace(low << 32 | high, int(part_.points.size()));
    if (is_new) { // kept off the nodes, so that no triangle is without area
      const double fi = grid_.value[in], fo = grid_.value[out], t = std::clamp(fi / (fi - fo), 0.05, 0.95);
      part_.points.push_back((1 - t) * grid_.node(in) + t * grid_.node(out));
    }
    return found->second;
  }

  const Grid& grid_;
  SurfacePart part_;
  std::unordered_map<std::uint64_t, int> points_; // by grid edge
};

// Newton along the gradient, each step at most a quarter edge: for smooth bodies two or three are enough.
void step_onto(const Implicit& body, SurfacePart& part, double edge)
{
  const double h = 1e-3 * edge;
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < std::ptrdiff_t(part.points.size()); ++i) {
    Vector3& p = part.points[i];
    for (int pass = 0; pass < 3; ++pass) {
      const double value = body(p);
      if (std::abs(value) < near_enough * edge)
        break;
      Vector3 gradient;
      for (int k = 0; k < 3; ++k)
        gradient[k] = (body(p + h * Vector3::Unit(k)) - value) / h;
      const double steepness = gradient.squaredNorm();
      if (steepness < 1e-6)
        break;
      Vector3 step = -value * gradient / steepness;
      if (step.norm() > 0.25 * edge)
        step *= 0.25 * edge / step.norm();
      p += step;
    }
  }
}

} // namespace

SurfacePart mesh_implicit(const std::string& name, const Implicit& body, const Box& box, double edge)
{
  const Grid grid = sample(body, box, grid_share * edge);
  require(grid.value.size() < (std::size_t(1) << 32),
          "the grid of body '" + name + "' is too fine; use longer edges");
  require(!touches_faces(grid), "body '" + name + "' reaches out of its box; enlarge the box");
  SurfacePart part = Marcher(grid).run();
  require(!part.triangles.empty(), "body '" + name + "' is not inside its box, or thinner than the grid");
  step_onto(body, part, 0.2 * edge);
  part = remesh(part, edge);
  step_onto(body, part, edge);
  part.name = name;
  return part;
}

} // namespace birdstrike
