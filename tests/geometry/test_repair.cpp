// SPDX-License-Identifier: GPL-3.0-or-later
// Every dirty mesh becomes the body that was meant, and says what was done; strict mode refuses with the right words.
#include "dirty_meshes.h"
#include "geometry/measure.h"
#include "geometry/repair/repair.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

#include <Eigen/Geometry>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>
#include <numbers>
#include <random>

using namespace birdstrike;
using Catch::Contains;
using namespace birdstrike::test;

namespace {

// Solid angles by the formula for spherical triangles (l'Huilier's half-angle form), not the one that the sources use.
double winding(const SurfacePart& part, const Vector3& point)
{
  double sum = 0;
  for (const auto& t : part.triangles) {
    const Vector3 a = (part.points[t[0]] - point).normalized(), b = (part.points[t[1]] - point).normalized(),
                  c = (part.points[t[2]] - point).normalized();
    const auto angle = [](const Vector3& p, const Vector3& q) {
      return std::atan2(p.cross(q).norm(), p.dot(q));
    };
    const double ab = angle(a, b), bc = angle(b, c), ca = angle(c, a), s = (ab + bc + ca) / 2;
    const double excess =
        4 * std::atan(std::sqrt(std::max(0.0, std::tan(s / 2) * std::tan((s - ab) / 2) *
                                                  std::tan((s - bc) / 2) * std::tan((s - ca) / 2))));
    sum += a.dot(b.cross(c)) < 0 ? -excess : excess;
  }
  return sum / (4 * std::numbers::pi);
}

std::string all(const PartRepair& report)
{
  std::string text;
  for (const auto* list : {&report.actions, &report.notes})
    for (const std::string& line : *list)
      text += line + "\n";
  return text;
}

RepairedMesh repaired(const SurfacePart& part, bool strict = false)
{
  return repair({part}, {strict, dirty_spacing, 0}, "bird.obj");
}

bool balanced(const SurfacePart& part)
{
  std::map<std::pair<int, int>, int> net;
  for (const auto& t : part.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      net[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  return std::all_of(net.begin(), net.end(), [](const auto& edge) { return edge.second == 0; });
}

} // namespace

TEST_CASE("dirty meshes become bodies", "[geometry][repair][dirty]")
{
  const auto meshes = dirty_meshes();
  CHECK(meshes.size() >= 25);
  for (const DirtyMesh& mesh : meshes) {
    INFO(mesh.name);
    const RepairedMesh result = repaired(mesh.part);
    const SurfacePart& part = result.parts.front();
    const PartRepair& report = result.reports.front();
    if (std::getenv("DIRTY_SHOW"))
      std::cout << "== " << mesh.name << "\n" << describe(report);
    INFO(describe(report));
    for (const std::string& text : mesh.outcome)
      CHECK_THAT(all(report), Contains(text));
    if (mesh.outcome.empty()) {
      CHECK(report.actions.empty());
      CHECK(report.largest_move == 0);
    }
    CHECK(balanced(part));
    CHECK(report.after.balanced);
    CHECK(report.after.volume > 0);
    if (mesh.volume > 0)
      CHECK(report.after.volume == Approx(mesh.volume).epsilon(mesh.tolerance));
    for (const Vector3& p : mesh.inside) {
      INFO("inside " << p.transpose());
      CHECK(std::abs(std::round(winding(part, p))) >= 1);
    }
    for (const Vector3& p : mesh.outside) {
      INFO("outside " << p.transpose());
      CHECK(std::abs(winding(part, p)) < 0.01);
    }
  }
}

TEST_CASE("repaired balls and boxes hold every point that they should, and no other",
          "[geometry][repair][dirty]")
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.15, 0.15);
  int balls = 0, boxes = 0;
  for (const DirtyMesh& mesh : dirty_meshes()) {
    if (!is_ball(mesh) && !is_box(mesh))
      continue;
    INFO(mesh.name);
    const SurfacePart part = repaired(mesh.part).parts.front();
    ++(is_ball(mesh) ? balls : boxes);
    // A cap over a hole of two or three facets lies up to 8 mm under the ball, and its facets 1 mm above and below.
    const double deep = is_ball(mesh) ? 0.009 : 1e-3, off = is_ball(mesh) ? 0.002 : 1e-3;
    int stray = 0, hole = 0, tried = 0;
    while (tried < 150) {
      const Vector3 p(place(random), place(random), place(random));
      const double depth = is_ball(mesh) ? depth_in_ball(p) : depth_in_box(p);
      if (depth < deep && depth > -off)
        continue;
      ++tried;
      const bool inside = std::abs(winding(part, p)) > 0.5;
      stray += inside && depth < 0;
      hole += !inside && depth > 0;
    }
    CHECK(stray == 0);
    CHECK(hole == 0);
  }
  CHECK(balls >= 12);
  CHECK(boxes >= 7);
}

TEST_CASE("a sound part comes back bit for bit", "[geometry][repair]")
{
  SurfaceMesh mesh{make_shape("capsule", {0.114, 0.228}), make_box({0.2, 0.1, 0.1})};
  const RepairedMesh result = repair(mesh, {}, "bird.obj");
  REQUIRE(result.parts.size() == 2);
  for (int i = 0; i < 2; ++i) {
    CHECK(result.parts[i].points == mesh[i].points);
    CHECK(result.parts[i].triangles == mesh[i].triangles);
    CHECK(result.reports[i].actions.empty());
    CHECK_THAT(describe(result.reports[i]), Contains("sound"));
  }
}

TEST_CASE("the report of a repair says what was wrong, what was done and how far the surface moved",
          "[geometry][repair]")
{
  SurfacePart part = make_shape("sphere", {0.2, 0.2}, {24, 12});
  const std::size_t all = part.triangles.size();
  part.triangles.erase(part.triangles.begin() + 100);
  std::swap(part.triangles[5][0], part.triangles[5][1]);
  const PartRepair report = repair({part}, {}, "bird.obj").reports.front();
  CHECK(report.before.open_edges == 3);
  CHECK(report.before.mixed_edges == 3);
  CHECK(report.after.triangles == all);
  CHECK(report.after.oriented);
  // The cap is the triangle that was missing: its middle is about one third of its height from the hole's rim.
  CHECK(report.largest_move > 0.002);
  CHECK(report.largest_move < 0.01);
  CHECK(report.mean_move < 1e-4);
  CHECK_THAT(describe(report), Contains("3 open edges") && Contains("filled 1 hole") &&
                                   Contains("flipped 1 of 527") && Contains("volume 4.19e+03 cm3") &&
                                   Contains("moved by at most"));
}

TEST_CASE("thickness and spacing of the repair are obeyed", "[geometry][repair]")
{
  const SurfacePart sheet{
      "wing", {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.3, 0}, {0, 0.3, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const auto height = [](const RepairedMesh& mesh) {
    return mesh.reports[0].after.upper.z() - mesh.reports[0].after.lower.z();
  };
  CHECK(height(repair({sheet}, {false, 5e-3, 0}, "w.obj")) == Approx(0.01));
  CHECK(height(repair({sheet}, {false, 5e-3, 3e-3}, "w.obj")) == Approx(0.003));
}

TEST_CASE("fifty thousand clean triangles are checked in no time", "[geometry][repair]")
{
  const SurfacePart part = make_shape("sphere", {0.3, 0.3}, {224, 113});
  const std::clock_t start = std::clock();
  CHECK(repair({part}, {}, "bird.obj").reports[0].actions.empty());
  CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 1.5);
}

// With DIRTY_MESHES=folder they stay there, to look at or to feed to other programs.
TEST_CASE("the dirty meshes can be had as OBJ files", "[geometry][write-dirty]")
{
  const TemporaryFolder temporary;
  const char* wanted = std::getenv("DIRTY_MESHES");
  const std::filesystem::path folder = wanted ? std::filesystem::path(wanted) : temporary / "dirty-meshes";
  std::filesystem::create_directories(folder);
  for (const DirtyMesh& mesh : dirty_meshes()) {
    const std::filesystem::path file = folder / (mesh.name + ".obj");
    write_obj(mesh.part, file);
    std::ifstream in(file);
    std::size_t faces = 0;
    for (std::string line; std::getline(in, line);)
      faces += line.starts_with("f ");
    CHECK(faces == mesh.part.triangles.size());
  }
}

TEST_CASE("strict mode refuses dirty meshes and says what would be done", "[geometry][repair][dirty]")
{
  for (const DirtyMesh& mesh : dirty_meshes()) {
    INFO(mesh.name);
    if (mesh.strict.empty()) {
      CHECK(repaired(mesh.part, true).parts.front().triangles == mesh.part.triangles);
      continue;
    }
    const std::string text = input_error([&] { repaired(mesh.part, true); });
    if (std::getenv("DIRTY_SHOW"))
      std::cout << mesh.name << ": " << text << "\n";
    CHECK_THAT(text,
               Contains("'bird.obj', part 'torso'") && Contains(mesh.strict) && Contains("without --strict"));
  }
}

TEST_CASE("what no repair can help is an error", "[geometry][repair][dirty]")
{
  for (const DirtyMesh& mesh : hopeless_meshes()) {
    INFO(mesh.name);
    CHECK_THAT(input_error([&] { repaired(mesh.part); }), Contains("torso") && Contains(mesh.strict));
  }
  CHECK_THAT(input_error([] { repair({}, {}, "bird.obj"); }), Contains("holds no part"));
  CHECK_THAT(input_error([] {
               repair({make_box({1, 1, 1})}, {false, -1, 0}, "bird.obj");
             }),
             Contains("negative"));
}
