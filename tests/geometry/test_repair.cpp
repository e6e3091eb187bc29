// SPDX-License-Identifier: GPL-3.0-or-later
// Every dirty mesh becomes the body that was meant, and says what was done; strict mode refuses with the right words.
#include "dirty_meshes.h"
#include "geometry/measure.h"
#include "geometry/repair/repair.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

#include <Eigen/Geometry>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numbers>

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
    const auto start = std::chrono::steady_clock::now();
    RepairedMesh result;
    try {
      result = repaired(mesh.part);
    } catch (const InputError& e) {
      FAIL_CHECK(e.what());
      continue;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const SurfacePart& part = result.parts.front();
    const PartRepair& report = result.reports.front();
    if (std::getenv("DIRTY_SHOW"))
      std::cout << "== " << mesh.name << " (" << seconds << " s)\n" << describe(report);
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
