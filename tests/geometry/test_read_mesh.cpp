// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files that are sound, and many that are not.
#include "geometry/check.h"
#include "geometry/import/read_mesh.h"
#include "geometry/import/weld.h"
#include "geometry/measure.h"
#include "geometry/shapes.h"
#include "geometry/write_glb.h"
#include "temporary_folder.h"

#include <cstring>
#include <sstream>

using namespace birdstrike;
using Catch::Contains;
using test::input_error;
using test::TemporaryFolder;

namespace {

// Every triangle with corners of its own, as STL has them.
std::string stl_solid(const SurfacePart& part, const std::string& name)
{
  std::ostringstream text;
  text.precision(9);
  text << "solid " << name << "\n";
  for (const auto& t : part.triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (int corner : t)
      text << "vertex " << part.points[corner].transpose() << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid " << name << "\n";
  return text.str();
}

std::string obj_group(const SurfacePart& part, const std::string& name, int first = 1)
{
  std::ostringstream text;
  text.precision(9);
  text << "g " << name << "\n";
  for (const Vector3& p : part.points)
    text << "v " << p.transpose() << "\n";
  for (const auto& t : part.triangles)
    text << "f " << t[0] + first << " " << t[1] + first << " " << t[2] + first << "\n";
  return text.str();
}

std::string content(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

TEST_CASE("corners of an STL are welded into a closed solid", "[geometry][import]")
{
  const TemporaryFolder folder;
  const SurfacePart sphere = make_shape("sphere", {0.1, 0.1}, {24, 12});
  const SurfaceMesh mesh = read_mesh(folder.write("bird.stl", stl_solid(sphere, "torso")));
  REQUIRE(mesh.size() == 1);
  CHECK(mesh[0].name == "torso");
  CHECK(mesh[0].points.size() == sphere.points.size());
  CHECK(mesh[0].triangles.size() == sphere.triangles.size());
  CHECK(require_solids(mesh, "bird.stl")[0].volume == Approx(signed_volume(sphere)).epsilon(1e-5));
}

TEST_CASE("groups of an OBJ become parts in the order of the file, in metres", "[geometry][import]")
{
  const TemporaryFolder folder;
  const SurfacePart box = make_box({100, 50, 30});
  const auto file =
      folder.write("bird.obj", obj_group(box, "torso") + obj_group(make_box({10, 10, 10}), "head", 9));
  const SurfaceMesh mesh = read_mesh(file, 1e-3);
  REQUIRE(mesh.size() == 2);
  CHECK(mesh[0].name == "torso");
  CHECK(mesh[1].name == "head");
  CHECK(signed_volume(mesh[0]) == Approx(1.5e-4).epsilon(1e-5));
  CHECK_THROWS_AS(read_mesh(file, 0), InputError);
}

TEST_CASE("files without names give the part the file's name", "[geometry][import]")
{
  const TemporaryFolder folder;
  const SurfacePart box = make_box({1, 1, 1});
  std::ostringstream off;
  off << "OFF\n8 12 0\n";
  for (const Vector3& p : box.points)
    off << p.transpose() << "\n";
  for (const auto& t : box.triangles)
    off << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  const SurfaceMesh mesh = read_mesh(folder.write("torso.off", off.str()));
  REQUIRE(mesh.size() == 1);
  CHECK(mesh[0].name == "torso");
  CHECK(signed_volume(mesh[0]) == Approx(1));
}

TEST_CASE("a GLB keeps names, points and volumes", "[geometry][import][glb]")
{
  const TemporaryFolder folder;
  SurfaceMesh mesh{make_shape("capsule", {0.1, 0.2}), make_box({0.1, 0.2, 0.3})};
  mesh[0].name = "torso";
  mesh[1].name = "wing_left";
  write_glb(mesh, folder / "bird.glb");
  const SurfaceMesh read = read_mesh(folder / "bird.glb");
  REQUIRE(read.size() == 2);
  for (int i = 0; i < 2; ++i) {
    CHECK(read[i].name == mesh[i].name);
    CHECK(read[i].points.size() == mesh[i].points.size());
    CHECK(read[i].triangles.size() == mesh[i].triangles.size());
    CHECK(signed_volume(read[i]) == Approx(signed_volume(mesh[i])).epsilon(1e-5));
  }
  CHECK_FALSE(std::filesystem::exists(folder / "bird.glb.part"));
  CHECK_THROWS_AS(write_glb(mesh, folder / "no such folder/bird.glb"), OutputError);
}

TEST_CASE("node transforms are applied and mirrored nodes stay outward", "[geometry][import]")
{
  const TemporaryFolder folder;
  write_glb({make_box({0.1, 0.2, 0.3})}, folder / "box.glb");
  std::string text = content(folder / "box.glb");
  // Two nodes with one mesh: one shifted, one mirrored in y. The JSON chunk is rewritten with its new length.
  std::uint32_t length = 0;
  std::memcpy(&length, text.data() + 12, 4);
  std::string json = text.substr(20, length);
  const std::string node = R"({"name":"box","mesh":0})";
  REQUIRE(json.find(node) != std::string::npos);
  json.replace(json.find(node), node.size(),
               R"({"name":"wing_left","mesh":0,"translation":[0,1,0]},)"
               R"({"name":"wing_right","mesh":0,"translation":[0,-1,0],"scale":[1,-1,1]})");
  const std::string children = R"("children":[1])";
  REQUIRE(json.find(children) != std::string::npos);
  json.replace(json.find(children), children.size(), R"("children":[1,2])");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::uint32_t new_length = std::uint32_t(json.size()),
                      total = std::uint32_t(text.size()) + new_length - length;
  text.replace(20, length, json);
  std::memcpy(text.data() + 12, &new_length, 4);
  std::memcpy(text.data() + 8, &total, 4);

  const SurfaceMesh mesh = read_mesh(folder.write("wings.glb", text));
  REQUIRE(mesh.size() == 2);
  CHECK(mesh[0].name == "wing_left");
  CHECK(mesh[1].name == "wing_right");
  CHECK(bounding_box(mesh[0]).centre().y() == Approx(1));
  CHECK(bounding_box(mesh[1]).centre().y() == Approx(-1));
  CHECK_NOTHROW(require_solids(mesh, "wings.glb"));
}

TEST_CASE("the weld joins what is near, drops what collapses, and keeps the rest apart", "[geometry][import]")
{
  SurfacePart part{"p", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 + 1e-9, 0, 0}, {1, 1, 0}, {0, 1e-9, 0}}, {}};
  part.triangles = {{0, 1, 2}, {3, 4, 2}, {0, 5, 1}}; // the last has two corners at one place
  weld(part, 1e-6);
  CHECK(part.points.size() == 4);
  CHECK(part.triangles.size() == 2);
  CHECK(part.points[1] == Vector3(1, 0, 0)); // the first of a cluster stays in place
}

TEST_CASE("files that cannot be bird meshes are refused by name", "[geometry][import][broken]")
{
  const TemporaryFolder folder;
  CHECK_THAT(input_error([&] { read_mesh(folder / "none.stl"); }),
             Contains("none.stl") && Contains("does not exist"));
  CHECK_THAT(input_error([&] { read_mesh(folder / ""); }), Contains("not a file"));
  CHECK_THAT(input_error([&] { read_mesh(folder.write("empty.obj", "")); }), Contains("empty"));
  CHECK_THAT(input_error([&] { read_mesh(folder.write("bird.xyzzy", "1 2 3")); }),
             Contains("'.xyzzy'") && Contains("glTF"));
  CHECK_THAT(input_error([&] { read_mesh(folder.write("bird", "1 2 3")); }), Contains("unknown format"));
  for (const char* cad : {"bird.CATPart", "bird.sldprt"})
    CHECK_THAT(input_error([&] { read_mesh(folder.write(cad, "V5_CFV2")); }),
               Contains("one CAD program") && Contains("STL, OBJ or glTF"));
  CHECK_THAT(input_error([&] { read_mesh(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")); }),
             Contains("points.obj"));
  CHECK_THAT(
      input_error([&] { read_mesh(folder.write("flat.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n")); }),
      Contains("flat.obj") && Contains("triangles"));
  CHECK_THROWS_AS(read_mesh(folder.write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), InputError);
  CHECK_THROWS_AS(read_mesh(folder.write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")), InputError);
}

TEST_CASE("garbage with any mesh extension is refused by name", "[geometry][import][broken]")
{
  const TemporaryFolder folder;
  std::string noise;
  for (unsigned i = 0, state = 12345; i < 4000; ++i) {
    state = state * 1664525u + 1013904223u;
    noise += char(state >> 24);
  }
  for (const char* extension : {"obj", "stl", "ply", "off", "gltf", "glb", "dae", "3mf", "fbx", "x3d", "3ds"})
    for (const std::string& bytes : {noise, std::string("hello world\n")}) {
      const std::string name = std::string("noise.") + extension;
      CAPTURE(name);
      CHECK_THAT(input_error([&] { read_mesh(folder.write(name, bytes)); }), Contains(name));
    }
}

TEST_CASE("a GLB cut anywhere is refused", "[geometry][import][broken]")
{
  const TemporaryFolder folder;
  write_glb({make_shape("sphere", {0.1, 0.1}, {16, 8})}, folder / "whole.glb");
  const std::string whole = content(folder / "whole.glb");
  for (const double share : {0.001, 0.01, 0.1, 0.3, 0.5, 0.9, 0.999}) {
    CAPTURE(share);
    const auto file = folder.write("cut.glb", whole.substr(0, std::size_t(share * double(whole.size()))));
    CHECK_THAT(input_error([&] { read_mesh(file); }), Contains("cut.glb"));
  }
}
