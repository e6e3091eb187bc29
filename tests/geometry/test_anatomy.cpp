// SPDX-License-Identifier: GPL-3.0-or-later
// The goose: sound solids, weight, size, anatomy; and the committed file against its numbers.
#include "geometry/anatomy.h"
#include "geometry/check.h"
#include "geometry/fill.h"
#include "geometry/import/read_mesh.h"
#include "geometry/inside.h"
#include "geometry/part_of_object.h"
#include "temporary_folder.h"

#include <algorithm>
#include <map>

using namespace birdstrike;

namespace {

const std::filesystem::path file = std::filesystem::path(BIRDSTRIKE_SOURCE_DIR) / "share/meshes/goose.glb";

const SurfaceMesh& committed()
{
  static const SurfaceMesh mesh = read_mesh(file);
  return mesh;
}
const SurfacePart& part(const std::string& name)
{
  return *std::find_if(committed().begin(), committed().end(), [&](const auto& p) { return p.name == name; });
}
std::vector<std::string> part_names()
{
  std::vector<std::string> names;
  for (const SurfacePart& p : committed())
    names.push_back(part_of_object(p.name));
  return names;
}

} // namespace

TEST_CASE("every part of the goose is a solid with a name of its own", "[geometry][goose]")
{
  const char* const names[] = {"head", "neck", "torso", "wing_left", "wing_right", "bones", "lungs"};
  REQUIRE(committed().size() == 7);
  const auto reports = require_solids(committed(), file);
  for (int i = 0; i < 7; ++i) {
    CHECK(reports[i].name == names[i]);
    CHECK(reports[i].components == (reports[i].name == "lungs" ? 2u : 1u));
  }
  CHECK(std::filesystem::file_size(file) < 2u << 20);
}

TEST_CASE("the goose has the size and the weight of a Canada goose", "[geometry][goose]")
{
  const Box box = bounding_box(committed());
  const Vector3 size = box.upper - box.lower;
  CHECK(size.x() > 0.75);
  CHECK(size.x() < 1.10);
  CHECK(size.y() > 1.27);
  CHECK(size.y() < 1.85);
  const Fill fill = fill_lattice(committed(), part_names(), 0.006);
  double mass = 0;
  for (const FilledPart& p : fill.parts) {
    mass += p.mesh_volume * nominal_density(p.name);
    CAPTURE(p.name);
    CHECK(double(p.particles) * std::pow(0.006, 3) == Approx(p.mesh_volume).epsilon(0.06));
  }
  CHECK(mass == Approx(4.0).epsilon(0.02));
  CHECK(fill.seeds.size() > 20000);
}

TEST_CASE("head leads, tail trails, wings mirror each other, bones and lungs lie inside the torso",
          "[geometry][goose]")
{
  CHECK(bounding_box(part("head")).upper.x() == bounding_box(committed()).upper.x());
  CHECK(bounding_box(part("torso")).lower.x() == bounding_box(committed()).lower.x());
  CHECK(signed_volume(part("wing_left")) == Approx(signed_volume(part("wing_right"))).epsilon(1e-6));
  CHECK(volume_centre(part("wing_left")).y() == Approx(-volume_centre(part("wing_right")).y()).epsilon(1e-6));
  CHECK(volume_centre(part("wing_left")).y() > 0.2);
  const Inside torso(part("torso")), bones(part("bones"));
  for (const Vector3& p : part("bones").points)
    REQUIRE(torso.contains(p));
  const GooseBodies bodies = make_goose_bodies({});
  for (const Vector3& p : part("lungs").points) {
    REQUIRE(torso.contains(p));
    REQUIRE(bodies.bones(p) > 0.001); // lungs keep clear of bones
  }
}

TEST_CASE("neighbouring parts reach into each other, so that the fill leaves no gap", "[geometry][goose]")
{
  const auto touches = [](const std::string& a, const std::string& b) {
    const Inside inside(part(b));
    return std::any_of(part(a).points.begin(), part(a).points.end(),
                       [&](const Vector3& p) { return inside.contains(p); });
  };
  CHECK(touches("neck", "torso"));
  CHECK(touches("neck", "head"));
  CHECK(touches("wing_left", "torso"));
  CHECK(touches("wing_right", "torso"));
}

TEST_CASE("the committed goose is the one that the numbers make", "[geometry][goose]")
{
  const SurfaceMesh made = make_goose();
  REQUIRE(made.size() == committed().size());
  for (std::size_t i = 0; i < made.size(); ++i) {
    CAPTURE(made[i].name);
    CHECK(made[i].name == committed()[i].name);
    CHECK(signed_volume(made[i]) == Approx(signed_volume(committed()[i])).epsilon(1e-4));
    CHECK((volume_centre(made[i]) - volume_centre(committed()[i])).norm() < 1e-5);
  }
}

TEST_CASE("nominal densities follow the porosities of the dissertation", "[geometry][goose]")
{
  CHECK(nominal_density("torso") == Approx(400));
  CHECK(nominal_density("bones") == Approx(800));
  CHECK_THAT(test::input_error([] { nominal_density("tail"); }), Catch::Contains("'tail'"));
}
