// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces written and read back: names, volumes, places; and what cannot be written.
#include "geometry/birds/slab.h"
#include "geometry/import/import_mesh.h"
#include "geometry/import/read_mesh.h"
#include "geometry/measure.h"
#include "geometry/write_surface.h"
#include "temporary_folder.h"

#include <nlohmann/json.hpp>

#include <cstring>

using namespace birdstrike;

namespace {

SurfacePart box(const std::string& name, const Vector3& corner, const Vector3& size)
{
  PointGrid top{2, 2, {}}, bottom{2, 2, {}};
  for (double y : {0.0, 1.0})
    for (double x : {1.0, 0.0}) {
      bottom.points.push_back(corner + size.cwiseProduct(Vector3(x, y, 0)));
      top.points.push_back(corner + size.cwiseProduct(Vector3(x, y, 1)));
    }
  return close_slab(name, top, bottom);
}

SurfaceMesh two_boxes()
{
  return {box("torso", {0, 0, 0}, {0.3, 0.2, 0.1}), box("wing_left", {0.1, 0.3, -0.05}, {0.1, 0.5, 0.01})};
}

std::size_t files_in(const std::filesystem::path& folder)
{
  return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {}));
}

} // namespace

TEST_CASE("names, volumes and places of parts come back from GLB and OBJ", "[geometry][write]")
{
  const test::TemporaryFolder folder;
  const SurfaceMesh mesh = two_boxes();
  for (const char* name : {"bird.glb", "bird.obj", "BIRD2.OBJ"}) {
    CAPTURE(name);
    write_surface(mesh, folder / name);
    const SurfaceMesh back = read_mesh(folder / name);
    REQUIRE(back.size() == 2);
    for (int i = 0; i < 2; ++i) {
      CHECK(back[i].name == mesh[i].name);
      CHECK(back[i].points.size() == mesh[i].points.size());
      CHECK(signed_volume(back[i]) == Approx(signed_volume(mesh[i])).epsilon(1e-6));
      CHECK((volume_centre(back[i]) - volume_centre(mesh[i])).norm() < 1e-7);
    }
  }
  CHECK(files_in(folder / "") == 3);
}

TEST_CASE("a GLB stands upright in viewers, whose up is +y", "[geometry][write]")
{
  const test::TemporaryFolder folder;
  write_surface(two_boxes(), folder / "bird.glb");
  std::ifstream stream(folder / "bird.glb", std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, 4);
  const auto json = nlohmann::json::parse(bytes.substr(20, length));
  REQUIRE(json["scenes"][0]["nodes"].size() == 1);
  const auto& root = json["nodes"][json["scenes"][0]["nodes"][0].get<int>()];
  CHECK(root["children"].size() == 2);
  const auto column = [&](int c) {
    return Vector3(root["matrix"][4 * c], root["matrix"][4 * c + 1], root["matrix"][4 * c + 2]);
  };
  CHECK(column(0) == Vector3(1, 0, 0));  // the nose stays
  CHECK(column(1) == Vector3(0, 0, -1)); // the left wing
  CHECK(column(2) == Vector3(0, 1, 0));  // up
}

TEST_CASE("what we write is read back as it is: no guess of unit or axes", "[geometry][write][import]")
{
  const test::TemporaryFolder folder;
  const SurfaceMesh mesh = two_boxes(); // whose nose nobody could find
  for (const char* name : {"bird.glb", "bird.obj", "bird.ply", "bird.stl"}) {
    CAPTURE(name);
    write_surface(mesh, folder / name);
    const ImportedMesh back = import_mesh({folder / name}, {});
    CHECK(back.unit == 1);
    CHECK_FALSE(back.unit_guessed);
    CHECK(back.warnings.empty());
    const Box bounds = bounding_box(back.parts);
    CHECK((bounds.lower - Vector3(0, 0, -0.05)).norm() < 1e-7);
    CHECK((bounds.upper - Vector3(0.3, 0.8, 0.1)).norm() < 1e-7);
  }
}

TEST_CASE("PLY, STL and OFF hold all parts as one", "[geometry][write]")
{
  const test::TemporaryFolder folder;
  const SurfaceMesh mesh = two_boxes();
  for (const char* name : {"bird.ply", "bird.stl", "bird.off"}) {
    CAPTURE(name);
    write_surface(mesh, folder / name);
    const SurfaceMesh back = read_mesh(folder / name);
    REQUIRE(back.size() == 1);
    CHECK(back[0].triangles.size() == 24);
    CHECK(back[0].points.size() == 16);
    CHECK(signed_volume(back[0]) == Approx(0.3 * 0.2 * 0.1 + 0.1 * 0.5 * 0.01).epsilon(1e-6));
    const Box bounds = bounding_box(back[0]);
    CHECK((bounds.lower - Vector3(0, 0, -0.05)).norm() < 1e-7);
    CHECK((bounds.upper - Vector3(0.3, 0.8, 0.1)).norm() < 1e-7);
  }
  CHECK(std::filesystem::file_size(folder / "bird.stl") == 84 + 24 * 50);
}

TEST_CASE("a blank in a part's name does not end it", "[geometry][write]")
{
  const test::TemporaryFolder folder;
  write_surface({box("left wing", {0, 0, 0}, {1, 1, 1})}, folder / "wing.obj");
  CHECK(read_mesh(folder / "wing.obj").at(0).name == "left_wing");
}

TEST_CASE("what cannot be written says so and leaves nothing behind", "[geometry][write]")
{
  const test::TemporaryFolder folder;
  const SurfaceMesh mesh = two_boxes();
  CHECK_THAT(test::input_error([&] { write_surface(mesh, folder / "bird.step"); }),
             Catch::Contains("bird.step") && Catch::Contains(".glb, .obj, .ply, .stl or .off"));
  CHECK_THAT(test::input_error([&] { write_surface({}, folder / "bird.obj"); }),
             Catch::Contains("no triangle"));
  for (const char* name : {"none/bird.glb", "none/bird.obj", "none/bird.stl"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(write_surface(mesh, folder / name), OutputError);
  }
  std::filesystem::create_directories(folder / "taken.ply" / std::filesystem::path("x"));
  CHECK_THROWS_AS(write_surface(mesh, folder / "taken.ply"), OutputError);
  CHECK(files_in(folder / "") == 1);
}
