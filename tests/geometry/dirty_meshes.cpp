// SPDX-License-Identifier: GPL-3.0-or-later
// Small surfaces, each spoilt in one named way. Longer than others: it is a list.
#include "dirty_meshes.h"

#include "geometry/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <numbers>

namespace birdstrike::test {

namespace {

constexpr double pi = std::numbers::pi, radius = 0.1;
const double ball_volume = 4 * pi / 3 * std::pow(radius, 3);
using Triangle = std::array<int, 3>;

// Random numbers that are the same with every library.
struct Random
{
  std::uint64_t state = 88172645463325252u;
  double operator()()
  {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return double(state >> 11) / 9007199254740992.0;
  }
};

SurfacePart named(SurfacePart part)
{
  part.name = "torso";
  return part;
}

SurfacePart ball(double r = radius, const Vector3& centre = Vector3::Zero())
{
  SurfacePart part = named(make_shape("sphere", {2 * r, 2 * r}, {24, 12}));
  for (Vector3& p : part.points)
    p += centre;
  return part;
}

SurfacePart box(const Vector3& size, const Vector3& centre = Vector3::Zero())
{
  SurfacePart part = named(make_box(size));
  for (Vector3& p : part.points)
    p += centre;
  return part;
}

void add(SurfacePart& part, const SurfacePart& other)
{
  const int first = int(part.points.size());
  part.points.insert(part.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
    part.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

SurfacePart together(SurfacePart part, const SurfacePart& other)
{
  add(part, other);
  return part;
}

SurfacePart flipped(SurfacePart part)
{
  for (auto& t : part.triangles)
    std::swap(t[1], t[2]);
  return part;
}

SurfacePart some_flipped(SurfacePart part, double share)
{
  Random random;
  for (auto& t : part.triangles)
    if (random() < share)
      std::swap(t[1], t[2]);
  return part;
}

Vector3 middle(const SurfacePart& part, const Triangle& t)
{
  return (part.points[t[0]] + part.points[t[1]] + part.points[t[2]]) / 3;
}

template <class Test>
SurfacePart without(SurfacePart part, Test test)
{
  std::erase_if(part.triangles, [&](const Triangle& t) { return test(middle(part, t)); });
  return part;
}

SurfacePart some_dropped(SurfacePart part, double share)
{
  Random random;
  return without(std::move(part), [&](const Vector3&) { return random() < share; });
}

// Every triangle with its own three points.
SurfacePart soup(const SurfacePart& part)
{
  SurfacePart result{part.name, {}, {}};
  for (const auto& t : part.triangles) {
    const int first = int(result.points.size());
    for (int corner : t)
      result.points.push_back(part.points[corner]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

// Points at one place, to many digits, become one.
SurfacePart joined(const SurfacePart& part)
{
  SurfacePart result{part.name, {}, part.triangles};
  std::map<std::array<std::int64_t, 3>, int> rows;
  std::vector<int> row;
  for (const Vector3& p : part.points) {
    const auto [at, is_new] =
        rows.try_emplace({std::llround(p.x() * 1e12), std::llround(p.y() * 1e12), std::llround(p.z() * 1e12)},
                         int(result.points.size()));
    if (is_new)
      result.points.push_back(p);
    row.push_back(at->second);
  }
  for (auto& t : result.triangles)
    for (int& corner : t)
      corner = row[corner];
  return result;
}

SurfacePart moved(SurfacePart part, const Vector3& by)
{
  for (Vector3& p : part.points)
    p += by;
  return part;
}

// Parallelogram of m x n cells, looking towards u x v.
SurfacePart grid(const Vector3& corner, const Vector3& u, const Vector3& v, int m, int n)
{
  SurfacePart part{"torso", {}, {}};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i)
      part.points.push_back(corner + u * (double(i) / m) + v * (double(j) / n));
  const auto at = [&](int i, int j) { return j * (m + 1) + i; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      part.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      part.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return part;
}

// The six faces of a box, each with a grid of its own, `gap` away from where they belong.
SurfacePart panels(const Vector3& size, const std::array<int, 6>& cells, double gap = 0)
{
  SurfacePart part{"torso", {}, {}};
  for (int axis = 0; axis < 3; ++axis)
    for (int end = 0; end < 2; ++end) {
      Vector3 u = Vector3::Zero(), v = Vector3::Zero(), out = Vector3::Zero();
      u[(axis + 1) % 3] = size[(axis + 1) % 3];
      v[(axis + 2) % 3] = size[(axis + 2) % 3];
      out[axis] = end ? 1 : -1;
      Vector3 corner = -size / 2;
      if (end)
        corner[axis] = size[axis] / 2;
      else
        std::swap(u, v);
      const int n = cells[2 * axis + end];
      add(part, grid(corner + gap * out, u, v, n, n));
    }
  return joined(part);
}

// Surface over two periodic or open parameters in 0 ... 1.
template <class Place>
SurfacePart sheet(int m, int n, Place place)
{
  SurfacePart part = grid({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, m, n);
  for (Vector3& p : part.points)
    p = place(p.x(), p.y());
  return joined(part);
}

SurfacePart tube(double r, double length, int around = 24, int along = 8)
{
  return sheet(along, around, [&](double s, double t) {
    return Vector3((s - 0.5) * length, r * std::cos(2 * pi * t), -r * std::sin(2 * pi * t));
  });
}

SurfacePart moebius()
{
  return sheet(48, 4, [](double s, double t) -> Vector3 {
    const double a = 2 * pi * s, w = (t - 0.5) * 0.06;
    const double r = 0.1 + w * std::cos(a / 2);
    return {r * std::cos(a), r * std::sin(a), w * std::sin(a / 2)};
  });
}

SurfacePart klein_bottle()
{
  return sheet(48, 16, [](double s, double t) -> Vector3 {
    // Figure-of-eight immersion: closed, one-sided, cuts itself along a circle.
    const double u = 2 * pi * s, v = 2 * pi * (t + 0.5 / 16); // no corner on the circle
    const double r = 0.1 + 0.04 * (std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v));
    return {r * std::cos(u), r * std::sin(u),
            0.04 * (std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v))};
  });
}

// A tube of square section along a path that crosses itself.
SurfacePart crossing_tube()
{
  const std::vector<Vector3> path{{-0.15, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}, {0, -0.1, 0.004}};
  SurfacePart part{"torso", {}, {}};
  const double half = 0.015;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vector3 before =
        i > 0 ? (path[i] - path[i - 1]).normalized() : Vector3(path[1] - path[0]).normalized();
    const Vector3 after = i + 1 < path.size() ? (path[i + 1] - path[i]).normalized() : before;
    const Vector3 up = Vector3::UnitZ(), side_before = up.cross(before), side_after = up.cross(after);
    const Vector3 side = -(side_before + side_after) / (1 + side_before.dot(side_after)); // mitre
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      part.points.push_back(path[i] + half * (a * side + b * up));
  }
  const int last = 4 * int(path.size() - 1);
  part.triangles = {{0, 1, 2}, {0, 2, 3}, {last, last + 2, last + 1}, {last, last + 3, last + 2}};
  for (int i = 0; i < last; i += 4)
    for (int k = 0; k < 4; ++k) {
      const int a = i + k, b = i + (k + 1) % 4;
      part.triangles.push_back({a, a + 4, b + 4});
      part.triangles.push_back({a, b + 4, b});
    }
  return part;
}

// A box whose far end is turned by half a turn: it goes through one line in the middle, and half of it is inside out.
SurfacePart twisted_box()
{
  SurfacePart part = panels({0.2, 0.06, 0.04}, {4, 4, 4, 4, 4, 4});
  for (Vector3& p : part.points)
    if (p.x() > 0.07)
      p.y() = -p.y();
    else if (p.x() > 0.02)
      p.y() *= -0.5;
  return part;
}

SurfacePart divided_box()
{
  // x = -0.1 ... 0.1 with a membrane in x = 0.02
  SurfacePart part = box({0.12, 0.08, 0.06}, {-0.04, 0, 0});
  add(part, box({0.08, 0.08, 0.06}, {0.06, 0, 0}));
  return joined(part);
}

bool in_wall(const Vector3& m) { return std::abs(m.x() - 0.02) < 1e-9; }

SurfacePart wing() { return grid({-0.05, 0, 0}, {0.1, 0, 0}, {0, 0.3, 0}, 4, 12); }

const std::vector<Vector3> ball_in{{0, 0, 0}, {0.06, 0, 0}, {0, -0.07, 0.03}, {-0.04, 0.04, -0.04}};
const std::vector<Vector3> ball_out{
    {0.11, 0, 0}, {0, 0.12, 0}, {0.08, 0.08, 0}, {-0.3, 0.01, 0.02}, {1, 2, 3}};
const std::vector<Vector3> box_in{{-0.09, 0.03, 0.02}, {0.015, 0, 0}, {0.025, 0, 0}, {0.09, -0.03, -0.02}};
const std::vector<Vector3> box_out{{-0.11, 0, 0}, {0, 0.05, 0}, {0, 0, -0.04}, {0.12, 0.1, 0.1}};
const double box_volume = 0.2 * 0.08 * 0.06;

void holes(std::vector<DirtyMesh>& list)
{
  SurfacePart part = ball();
  part.triangles.erase(part.triangles.begin() + 100);
  list.push_back({"hole-small",
                  "One triangle is missing.",
                  part,
                  {"filled 1 hole (", "mm across)"},
                  "3 edges have only one face",
                  ball_volume,
                  1e-9,
                  ball_in,
                  ball_out});

  part = without(ball(), [](const Vector3& p) { return p.x() > 0.06; });
  double edge = 0; // where the cut really is: the rim of the facets
  for (const auto& t : part.triangles)
    for (int c : t)
      edge = std::max(edge, part.points[c].x());
  list.push_back({"hole-large",
                  "A third of a ball's height is missing.",
                  part,
                  {"filled 1 hole (", "mm across)"},
                  "the surface is open",
                  ball_volume - pi * std::pow(radius - edge, 2) * (2 * radius + edge) / 3,
                  0.01,
                  {{0, 0, 0}, {-0.06, 0, 0}, {edge - 0.01, 0, 0}},
                  {{edge + 0.01, 0, 0}, {0, 0.12, 0}, {-0.3, 0, 0}}});

  part = without(ball(), [](const Vector3& p) { return p.z() > 0.04; });
  edge = -1;
  for (const auto& t : part.triangles)
    for (int c : t)
      edge = std::max(edge, part.points[c].z());
  for (Vector3& p : part.points)
    p = Vector3(p.x(), p.y() / 3, p.z() / 3);
  list.push_back({"open-along-its-back",
                  "A body three times as long as wide whose back is missing.",
                  part,
                  {"filled 1 hole (", "mm across)"},
                  "the surface is open",
                  (ball_volume - pi * std::pow(radius - edge, 2) * (2 * radius + edge) / 3) / 9,
                  0.05, // the rim lies on no plane
                  {{0, 0, 0}, {-0.06, 0, 0}, {0.05, 0, 0.005}},
                  {{0, 0, 0.03}, {0, 0.05, 0}, {-0.15, 0, 0}}});

  list.push_back({"tenth-of-the-faces-missing",
                  "A tenth of the faces is missing, at random.",
                  some_dropped(ball(), 0.1),
                  {"filled", "holes (largest"},
                  "the surface is open",
                  ball_volume,
                  0.02,
                  ball_in,
                  ball_out});

  list.push_back({"open-tube",
                  "A neck without its ends.",
                  tube(0.04, 0.2),
                  {"filled 2 holes (largest"},
                  "the surface is open",
                  pi * 0.04 * 0.04 * 0.2,
                  0.015,
                  {{0, 0, 0}, {0.09, 0, 0}, {-0.09, 0.02, 0}},
                  {{0.11, 0, 0}, {-0.11, 0, 0}, {0, 0.05, 0}}});

  part = sheet(24, 12, [](double s, double t) {
    const double a = 2 * pi * s; // flat ellipse, shrinking to a line at the tip
    return Vector3(0.06 * std::cos(a), 0.3 * t, 0.012 * std::sin(a) * (1 - t));
  });
  list.push_back({"wing-open-at-the-root",
                  "A thin wing of two skins, open where the body was.",
                  part,
                  {"filled 1 hole ("},
                  "the surface is open",
                  pi * 0.06 * 0.012 * 0.3 / 2,
                  0.03,
                  {{0, 0.02, 0}, {0.02, 0.1, 0}},
                  {{0, -0.02, 0}, {0.07, 0.1, 0}, {0, 0.1, 0.015}}});
}

void windings(std::vector<DirtyMesh>& list)
{
  list.push_back({"all-flipped",
                  "Every face looks inwards.",
                  flipped(ball()),
                  {"flipped all 528 triangles"},
                  "normals point inwards",
                  ball_volume,
                  1e-9,
                  ball_in,
                  ball_out});
  list.push_back({"some-flipped",
                  "A tenth of the faces looks inwards.",
                  some_flipped(ball(), 0.1),
                  {"flipped", "of 528 triangles"},
                  "look opposite ways",
                  ball_volume,
                  1e-9,
                  ball_in,
                  ball_out});
  list.push_back({"random-winding",
                  "A soup whose triangles look either way.",
                  soup(some_flipped(ball(), 0.5)),
                  {"double points", "flipped", "of 528 triangles"},
                  "points are there twice",
                  ball_volume,
                  1e-9,
                  ball_in,
                  ball_out});
  list.push_back({"moebius-strip",
                  "A strip with one side only.",
                  moebius(),
                  {"one-sided", "thickened 1 sheet to 10 mm"},
                  "the surface is open",
                  2 * pi * 0.1 * 0.06 * 0.01,
                  0.15,
                  {{-0.1, 0, 0.015}, {0.11, 0, 0}},
                  {{0, 0, 0}, {0.1, 0, 0.02}, {-0.12, 0, 0}, {0, 0, 0.1}}});
  list.push_back({"klein-bottle",
                  "Closed, but with one side only.",
                  klein_bottle(),
                  {"one-sided", "wrapped 1 piece as one body"},
                  "look opposite ways",
                  0,
                  1,
                  {{-0.1, 0.002, 0.028}, {-0.1, 0.002, -0.028}},
                  {{0, 0, 0}, {0, 0, 0.1}, {0.2, 0, 0}}});
}

void doubles(std::vector<DirtyMesh>& list)
{
  SurfacePart part = ball();
  for (int i = 0; i < 10; ++i)
    part.triangles.push_back(part.triangles[20 * i]);
  list.push_back({"doubled-faces",
                  "Ten faces are there twice.",
                  part,
                  {"dropped 10 doubled triangles"},
                  "10 faces are there twice",
                  ball_volume,
                  1e-9,
                  ball_in,
                  ball_out});

  list.push_back({"doubled-membrane",
                  "Two cells share a wall that is there from both sides.",
                  divided_box(),
                  {"dropped 2 doubled triangles", "dropped 1 inner wall"},
                  "2 faces are there twice",
                  box_volume,
                  1e-9,
                  box_in,
                  box_out});

  part = divided_box();
  int wall = 0;
  std::erase_if(part.triangles, [&](const Triangle& t) { return in_wall(middle(part, t)) && ++wall > 2; });
  list.push_back({"inner-wall",
                  "A membrane divides a box.",
                  part,
                  {"dropped 1 inner wall"},
                  "4 edges have more than two faces",
                  box_volume,
                  1e-9,
                  box_in,
                  box_out});

  list.push_back({"double-points",
                  "Every triangle has points of its own.",
                  soup(ball()),
                  {"double points"},
                  "points are there twice",
                  ball_volume,
                  1e-9,
                  ball_in,
                  ball_out});

  part = box({0.2, 0.08, 0.06});
  add(part, grid({-0.05, -0.02, 0.03}, {0.1, 0, 0}, {0, 0.04, 0}, 2, 2));
  list.push_back({"coplanar-overlap",
                  "A loose panel lies on a face.",
                  part,
                  {"dropped 1 piece that lies on the surface"},
                  "the surface is open",
                  box_volume,
                  1e-9,
                  box_in,
                  box_out});

  part = wing();
  const auto front = part.triangles;
  for (const auto& t : front)
    part.triangles.push_back({t[0], t[2], t[1]});
  list.push_back({"two-sided-sheet",
                  "A wing without thickness, once from above and once from below.",
                  part,
                  {"dropped 96 doubled triangles", "thickened 1 sheet to 10 mm"},
                  "96 faces are there twice",
                  0.1 * 0.3 * 0.01,
                  0.02,
                  {{0, 0.15, 0.003}, {0.04, 0.29, -0.003}},
                  {{0, 0.15, 0.008}, {0.06, 0.15, 0}, {0, -0.02, 0}}});
}

void seams(std::vector<DirtyMesh>& list)
{
  // One edge of the box gets a corner in its middle on one side only.
  SurfacePart part = box({0.2, 0.08, 0.06});
  const Triangle t = part.triangles[0];
  const int m = int(part.points.size());
  part.points.push_back((part.points[t[0]] + part.points[t[1]]) / 2);
  part.triangles[0] = {t[0], m, t[2]};
  part.triangles.push_back({m, t[1], t[2]});
  list.push_back({"t-junction",
                  "A corner sits on the side of a face.",
                  part,
                  {"split sides at 1 T-junction"},
                  "1 corner lies",
                  box_volume,
                  1e-9,
                  box_in,
                  box_out});

  list.push_back({"t-junction-seam",
                  "The faces of a box are divided differently.",
                  panels({0.2, 0.08, 0.06}, {2, 3, 4, 5, 3, 7}),
                  {"split sides at", "T-junctions"},
                  "corners lie on the side of a face",
                  box_volume,
                  1e-6,
                  box_in,
                  box_out});

  list.push_back({"crack-narrow",
                  "Cracks narrower than rounding.",
                  panels({0.2, 0.08, 0.06}, {3, 3, 3, 3, 3, 3}, 1e-8),
                  {"joined", "border points"},
                  "edges have only one face",
                  box_volume,
                  1e-5,
                  box_in,
                  box_out});

  part = without(ball(), [](const Vector3& p) { return p.x() > 0; });
  add(part, moved(without(ball(), [](const Vector3& p) { return p.x() < 0; }), {0.001, 0, 0}));
  list.push_back({"crack-wide",
                  "Two halves stand 1 mm apart.",
                  part,
                  {"joined 24 border points (gaps of up to 1 mm)"},
                  "the surface is open",
                  ball_volume,
                  0.02,
                  ball_in,
                  ball_out});

  list.push_back({"panels-apart",
                  "Six panels stand around a box without touching.",
                  panels({0.2, 0.08, 0.06}, {4, 4, 4, 4, 4, 4}, 0.006),
                  {"wrapped 6 pieces as one body"},
                  "the surface is open",
                  0.212 * 0.092 * 0.072,
                  0.15,
                  box_in,
                  {{-0.13, 0, 0}, {0, 0.07, 0}, {0, 0, -0.06}, {0.12, 0.1, 0.1}}});
}

void pieces(std::vector<DirtyMesh>& list)
{
  list.push_back({"self-crossing",
                  "A tube runs through itself.",
                  crossing_tube(),
                  {},
                  "intersects itself",
                  0,
                  1,
                  {{0, 0, 0}, {0.09, 0, 0}, {0.05, 0.1, 0}, {0, 0.05, 0.002}},
                  {{0.05, 0.05, 0}, {0, 0, 0.04}, {-0.05, 0.05, 0}}});
  list.push_back({"twisted",
                  "A box turned through itself: half of it is inside out.",
                  twisted_box(),
                  {"wrapped ("},
                  "intersects itself",
                  0,
                  1,
                  {{-0.08, 0, 0}, {-0.08, 0.02, 0.01}, {0.09, 0, 0}},
                  {{0, 0.05, 0}, {0, 0, 0.04}, {0.12, 0, 0}}});
  list.push_back({"overlapping",
                  "Two balls overlap.",
                  together(ball(), ball(0.06, {0.1, 0.003, 0.002})),
                  {"pieces overlap: they are taken as one body"},
                  "intersects itself",
                  ball_volume + 4 * pi / 3 * std::pow(0.06, 3),
                  1e-9,
                  {{0, 0, 0}, {0.08, 0, 0}, {0.14, 0, 0}, {0.1, 0.02, 0}},
                  {{0.17, 0, 0}, {0.09, 0.09, 0}, {-0.11, 0, 0}}});
  list.push_back({"overlapping-one-flipped",
                  "Two balls overlap, the smaller inside out.",
                  together(ball(), flipped(ball(0.06, {0.1, 0.003, 0.002}))),
                  {"flipped 528 of 1056 triangles", "overlap"},
                  "intersects itself",
                  ball_volume + 4 * pi / 3 * std::pow(0.06, 3),
                  1e-9,
                  {{0, 0, 0}, {0.08, 0, 0}, {0.14, 0, 0}, {0.1, 0.02, 0}},
                  {{0.17, 0, 0}, {0.09, 0.09, 0}, {-0.11, 0, 0}}});
  list.push_back({"nested-outward",
                  "A ball within a ball, both outwards.",
                  together(ball(), ball(0.05)),
                  {"1 piece lies inside another and looks outwards"},
                  "flat or inside out",
                  ball_volume * 1.125,
                  1e-9,
                  ball_in,
                  ball_out});
  list.push_back({"nested-cavity",
                  "A ball with a cavity, as it should be.",
                  together(ball(), flipped(ball(0.05))),
                  {},
                  "",
                  ball_volume * 0.875,
                  1e-9,
                  {{0.06, 0, 0}, {0, -0.07, 0.03}},
                  {{0, 0, 0}, {0.03, 0, 0}, {0.11, 0, 0}}});
  list.push_back({"nested-all-flipped",
                  "A ball with a cavity, everything inside out.",
                  together(flipped(ball()), ball(0.05)),
                  {"flipped all 1056 triangles", "wall of a cavity"},
                  "normals point inwards",
                  ball_volume * 0.875,
                  1e-9,
                  {{0.06, 0, 0}, {0, -0.07, 0.03}},
                  {{0, 0, 0}, {0.03, 0, 0}, {0.11, 0, 0}}});
  list.push_back({"shared-edge",
                  "Two boxes touch along an edge.",
                  joined(together(box({0.1, 0.1, 0.1}), box({0.1, 0.1, 0.1}, {0.1, 0.1, 0}))),
                  {},
                  "1 edge has more than two faces",
                  2e-3,
                  1e-9,
                  {{0, 0, 0}, {0.1, 0.1, 0}, {0.04, 0.04, 0}},
                  {{0.1, 0, 0}, {0, 0.1, 0}, {0.06, 0.04, 0}}});
  list.push_back({"shared-corner",
                  "Two boxes touch in a corner.",
                  joined(together(box({0.1, 0.1, 0.1}), box({0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}))),
                  {},
                  "",
                  2e-3,
                  1e-9,
                  {{0, 0, 0}, {0.1, 0.1, 0.1}},
                  {{0.1, 0, 0}, {0, 0.1, 0}, {0.1, 0.1, 0}}});
  SurfacePart part = ball();
  add(part, {"", {{0.2, 0, 0}, {0.21, 0, 0}, {0.2, 0.01, 0}}, {{0, 1, 2}}});
  list.push_back({"stray-triangle",
                  "A loose triangle floats beside the body.",
                  part,
                  {"dropped 1 stray piece (1 triangle)"},
                  "3 edges have only one face",
                  ball_volume,
                  1e-9,
                  ball_in,
                  {{0.2, 0, 0}, {0.203, 0.003, 0}, {0.11, 0, 0}}});
  part = ball();
  add(part, {"", {{1000, 0, 0}, {1000.01, 0, 0}, {1000, 0.01, 0}}, {{0, 1, 2}}});
  list.push_back({"stray-far-away",
                  "A loose triangle a kilometre away.",
                  part,
                  {"dropped 1 stray piece (1 triangle)"},
                  "3 edges have only one face",
                  ball_volume,
                  1e-9,
                  ball_in,
                  {{1000.003, 0.003, 0}, {500, 0, 0}, {0.11, 0, 0}}});
}

void sheets(std::vector<DirtyMesh>& list)
{
  list.push_back({"sheet",
                  "A wing without thickness.",
                  wing(),
                  {"thickened 1 sheet to 10 mm"},
                  "the surface is open",
                  0.1 * 0.3 * 0.01,
                  0.02,
                  {{0, 0.15, 0.003}, {0.04, 0.29, -0.003}},
                  {{0, 0.15, 0.008}, {0.06, 0.15, 0}, {0, -0.02, 0}}});
  const double c = 0.1 * std::cos(pi / 4);
  SurfacePart part = joined(together(grid({-0.05, 0, 0}, {0.1, 0, 0}, {0, c, c}, 3, 3),
                                     grid({-0.05, -c, c}, {0.1, 0, 0}, {0, c, -c}, 3, 3)));
  list.push_back({"folded-sheet",
                  "A half folded wing without thickness.",
                  part,
                  {"thickened 1 sheet to 10 mm"},
                  "the surface is open",
                  2 * 0.1 * 0.1 * 0.01,
                  0.05,
                  {{0, 0.03, 0.03}, {0, -0.05, 0.05}, {0, 0, 0.001}},
                  {{0, 0, 0.03}, {0, 0.06, 0.02}, {0, 0, -0.02}}});
  part = box({0.2, 0.08, 0.06});
  // The fin stands on the edge between two faces: that edge has three.
  int a = -1, b = -1;
  for (int i = 0; i < int(part.points.size()); ++i)
    if (part.points[i].y() > 0 && part.points[i].z() > 0)
      (part.points[i].x() < 0 ? a : b) = i;
  const int first = int(part.points.size());
  part.points.push_back({-0.1, 0.2, 0.03});
  part.points.push_back({0.1, 0.2, 0.03});
  part.triangles.push_back({a, b, first + 1});
  part.triangles.push_back({a, first + 1, first});
  list.push_back({"sheet-on-a-body",
                  "A wing without thickness grows out of an edge of the body.",
                  part,
                  {"thickened 1 sheet to 10 mm"},
                  "1 edge has more than two faces",
                  box_volume + 0.2 * 0.16 * 0.01,
                  0.02,
                  {{0, 0, 0}, {0, 0.1, 0.03}, {0.09, 0.19, 0.027}},
                  {{0, 0.1, 0.04}, {0, 0.22, 0.03}, {0, 0.06, 0}}});
}

void numbers(std::vector<DirtyMesh>& list)
{
  // Split the side of one triangle; the gap towards its neighbour is closed by a triangle without area.
  SurfacePart part = box({0.2, 0.08, 0.06});
  const Triangle t = part.triangles[0];
  const int m = int(part.points.size());
  part.points.push_back((part.points[t[0]] + part.points[t[1]]) / 2);
  part.triangles[0] = {t[0], m, t[2]};
  part.triangles.push_back({m, t[1], t[2]});
  part.triangles.push_back({t[0], t[1], m});
  list.push_back({"zero-area",
                  "A face without area closes a T-junction.",
                  part,
                  {"dropped 1 triangle without area", "split sides at 1 T-junction"},
                  "1 face has no area",
                  box_volume,
                  1e-9,
                  box_in,
                  box_out});

  part = ball();
  const Triangle s = part.triangles[200];
  const int n = int(part.points.size());
  part.points.push_back(part.points[s[0]] + 1e-4 * (middle(part, s) - part.points[s[0]]));
  part.triangles[200] = {s[0], s[1], n};
  part.triangles.push_back({s[1], s[2], n});
  part.triangles.push_back({s[2], s[0], n});
  list.push_back({"needles",
                  "Triangles ten thousand times as long as they are wide.",
                  part,
                  {},
                  "",
                  ball_volume,
                  1e-4,
                  ball_in,
                  ball_out});

  part = ball();
  for (int i = 0; i < 50; ++i)
    part.points.push_back({0.3, 0.001 * i, 0});
  list.push_back({"unused-points",
                  "Points that no face uses.",
                  part,
                  {},
                  "",
                  ball_volume,
                  1e-9,
                  ball_in,
                  {{0.3, 0.02, 0}, {0.11, 0, 0}}});

  list.push_back({"thinner-than-the-spacing",
                  "A plate of 0.1 mm.",
                  box({0.2, 0.1, 1e-4}),
                  {},
                  "",
                  0.2 * 0.1 * 1e-4,
                  1e-9,
                  {{0, 0, 0}},
                  {{0, 0, 1e-3}, {0.11, 0, 0}}});

  const Vector3 far(1e6, -2e6, 3e6);
  part = some_flipped(moved(ball(), far), 0.1);
  part.triangles.erase(part.triangles.begin() + 100);
  DirtyMesh& distant =
      list.emplace_back(DirtyMesh{"far-from-the-origin",
                                  "A flipped ball with a hole, thousands of kilometres away.",
                                  part,
                                  {"flipped", "filled 1 hole ("},
                                  "only one face",
                                  ball_volume,
                                  1e-6,
                                  ball_in,
                                  ball_out});
  for (auto* points : {&distant.inside, &distant.outside})
    for (Vector3& p : *points)
      p += far;

  Random random;
  part = ball();
  for (Vector3& p : part.points) { // one by one: compilers differ in the order of arguments
    const double z = random() - 0.5, y = random() - 0.5, x = random() - 0.5;
    p += 0.03 * Vector3(x, y, z);
  }
  list.push_back({"spiky-noise",
                  "A scan with noise as large as its faces.",
                  part,
                  {},
                  "intersects itself",
                  ball_volume,
                  0.06,
                  {{0, 0, 0}, {0.06, 0, 0}},
                  {{0.14, 0, 0}, {0, 0.15, 0}}});
}

void worst(std::vector<DirtyMesh>& list)
{
  SurfacePart part = soup(some_flipped(some_dropped(ball(), 0.1), 0.5));
  for (int i = 0; i < 20; ++i) {
    part.triangles.push_back(part.triangles[7 * i]);
    part.triangles.push_back({part.triangles[9 * i][0], part.triangles[9 * i][2], part.triangles[9 * i][1]});
  }
  add(part, {"", {{0.2, 0, 0}, {0.21, 0, 0}, {0.2, 0.01, 0}}, {{0, 1, 2}}});
  list.push_back({"worst-soup",
                  "A soup of either winding with a tenth missing, doubles and a stray.",
                  part,
                  {"double points", "dropped 40 doubled triangles", "filled", "flipped", "1 stray piece"},
                  "faces are there twice",
                  ball_volume,
                  0.02,
                  ball_in,
                  {{0.11, 0, 0}, {0, 0.12, 0}, {0.203, 0.003, 0}}});

  part = ball();
  part.triangles.erase(part.triangles.begin() + 100);
  SurfacePart small = flipped(ball(0.06, {0.1, 0.003, 0.002}));
  small.triangles.erase(small.triangles.begin() + 30);
  add(part, small);
  add(part, {"", {{1000, 0, 0}, {1000.01, 0, 0}, {1000, 0.01, 0}}, {{0, 1, 2}}});
  list.push_back({"worst-overlap",
                  "Two balls with holes overlap, one inside out, and a stray is far away.",
                  part,
                  {"filled 2 holes", "flipped 527 of 1054 triangles", "overlap", "1 stray piece"},
                  "only one face",
                  ball_volume + 4 * pi / 3 * std::pow(0.06, 3),
                  1e-9,
                  {{0, 0, 0}, {0.08, 0, 0}, {0.14, 0, 0}},
                  {{0.17, 0, 0}, {0.09, 0.09, 0}, {1000.003, 0.003, 0}}});

  part = some_flipped(divided_box(), 0.5);
  int wall = 0;
  std::erase_if(part.triangles, [&](const Triangle& t) { return in_wall(middle(part, t)) && ++wall > 2; });
  part = together(soup(part), moved(wing(), {0, 0.06, 0}));
  list.push_back({"worst-body-and-wing",
                  "A divided body of either winding as soup, with a wing without thickness beside it.",
                  part,
                  {"double points", "dropped 1 inner wall", "thickened 1 sheet to 10 mm"},
                  "",
                  box_volume + 0.1 * 0.3 * 0.01,
                  0.02,
                  {{-0.09, 0.03, 0.02}, {0.015, 0, 0}, {0.025, 0, 0}, {0, 0.2, 0.003}},
                  {{-0.11, 0, 0}, {0, 0.2, 0.008}, {0, 0.05, 0}}});
  list.back().strict = "only one face";

  part = panels({0.2, 0.08, 0.06}, {2, 3, 4, 5, 3, 7});
  part = some_flipped(std::move(part), 0.5);
  part = without(part, [](const Vector3& p) { return p.z() > 0.029 && p.x() > 0.06; });
  list.push_back({"worst-seams",
                  "Faces divided differently and wound either way, with a hole.",
                  part,
                  {"T-junctions", "filled 1 hole", "flipped"},
                  "corners lie on the side of a face",
                  box_volume,
                  0.01,
                  box_in,
                  box_out});
}

} // namespace

double depth_in_ball(const Vector3& point) { return radius - point.norm(); }

double depth_in_box(const Vector3& point) { return (Vector3(0.1, 0.04, 0.03) - point.cwiseAbs()).minCoeff(); }

// Nothing else in the list has these volumes.
bool is_ball(const DirtyMesh& mesh) { return mesh.volume == ball_volume && mesh.inside == ball_in; }
bool is_box(const DirtyMesh& mesh) { return mesh.volume == box_volume && mesh.inside == box_in; }

std::vector<DirtyMesh> dirty_meshes()
{
  std::vector<DirtyMesh> list;
  holes(list);
  windings(list);
  doubles(list);
  seams(list);
  pieces(list);
  sheets(list);
  numbers(list);
  worst(list);
  return list;
}

std::vector<DirtyMesh> hopeless_meshes()
{
  std::vector<DirtyMesh> list;
  list.push_back({"empty", "No triangles.", {"torso", {{0, 0, 0}}, {}}, {}, "it has no triangles"});
  list.push_back({"line",
                  "All faces lie on one line.",
                  {"torso", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {1, 2, 3}}},
                  {},
                  "none of its triangles has an area"});
  list.push_back({"point",
                  "All corners at one place.",
                  {"torso", {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}},
                  {},
                  "none of its triangles has an area"});
  list.push_back({"missing-point",
                  "A face refers to a point that is not there.",
                  {"torso", {{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}},
                  {},
                  "not there"});
  list.push_back({"not-a-number",
                  "A coordinate is not a number.",
                  {"torso", {{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}}, {{0, 1, 2}}},
                  {},
                  "finite"});
  return list;
}

void write_obj(const SurfacePart& part, const std::filesystem::path& file)
{
  std::ofstream out(file);
  out.precision(17);
  out << "o " << part.name << '\n';
  for (const Vector3& p : part.points)
    out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& t : part.triangles)
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
}

} // namespace birdstrike::test
