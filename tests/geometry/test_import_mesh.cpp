// SPDX-License-Identifier: GPL-3.0-or-later
// The same bird in every format, unit and attitude comes out the same.
#include "geometry/import/import_mesh.h"
#include "geometry/import/read_mesh.h"
#include "geometry/measure.h"
#include "geometry/shapes.h"
#include "geometry/topology.h"
#include "mesh_files.h"
#include "temporary_folder.h"

#include <Eigen/Geometry>
#include <functional>

using namespace birdstrike;
using Catch::Contains;
using test::input_error;
using test::small_bird;
using test::TemporaryFolder;

namespace {

SurfaceMesh changed(SurfaceMesh mesh, const std::function<Vector3(const Vector3&)>& change)
{
  for (SurfacePart& part : mesh)
    for (Vector3& p : part.points)
      p = change(p);
  return mesh;
}
SurfaceMesh scaled(const SurfaceMesh& mesh, double factor)
{
  return changed(mesh, [=](const Vector3& p) { return Vector3(factor * p); });
}

std::string all_of(const std::vector<std::string>& texts)
{
  std::string all;
  for (const std::string& text : texts)
    all += text + "\n";
  return all;
}

const SurfacePart& part(const SurfaceMesh& mesh, const std::string& name)
{
  for (const SurfacePart& one : mesh)
    if (one.name == name)
      return one;
  FAIL("no part " << name);
  return mesh.front();
}

//! Nose +x, left +y, up +z, box about the origin, and every part where small_bird has it.
void check_is_small_bird(const SurfaceMesh& mesh, double tolerance = 1e-6)
{
  SurfaceMesh wanted = small_bird();
  const Vector3 middle = bounding_box(wanted).centre();
  REQUIRE(mesh.size() == wanted.size());
  for (const SurfacePart& right : wanted) {
    CAPTURE(right.name);
    const SurfacePart& found = part(mesh, right.name);
    CHECK((bounding_box(found).lower - (bounding_box(right).lower - middle)).norm() < tolerance);
    CHECK((bounding_box(found).upper - (bounding_box(right).upper - middle)).norm() < tolerance);
    CHECK(signed_volume(found) == Approx(signed_volume(right)).epsilon(1e-5));
    CHECK(found.points.size() == right.points.size());
    CHECK(found.triangles.size() == right.triangles.size());
  }
}

} // namespace

TEST_CASE("every format gives the same parts, volumes and welded topology", "[geometry][import]")
{
  const TemporaryFolder folder;
  const SurfaceMesh bird = small_bird();
  for (const auto& [name, bytes] : test::sample_files(bird)) {
    CAPTURE(name);
    const SurfaceMesh mesh = read_mesh(folder.write(name, bytes));
    const std::string extension = name.substr(name.find('.'));
    const bool has_names = extension != ".ply" && extension != ".off" && name != "sample.stl";
    double volume = 0, right_volume = 0;
    for (const SurfacePart& one : bird)
      right_volume += signed_volume(one);
    for (const SurfacePart& one : mesh) {
      volume += signed_volume(one);
      CHECK(find_topology(one).closed());
      CHECK(find_topology(one).mixed_edges == 0);
    }
    CHECK(volume == Approx(right_volume).epsilon(1e-5));
    REQUIRE(mesh.size() == (has_names ? bird.size() : 1));
    for (std::size_t i = 0; has_names && i < bird.size(); ++i) {
      CHECK(mesh[i].name == bird[i].name);
      CHECK(mesh[i].points.size() == bird[i].points.size());
      CHECK(mesh[i].triangles.size() == bird[i].triangles.size());
      CHECK(signed_volume(mesh[i]) == Approx(signed_volume(bird[i])).epsilon(1e-5));
      CHECK((bounding_box(mesh[i]).lower - bounding_box(bird[i]).lower).norm() < 1e-6);
    }
    if (!has_names) {
      CHECK(mesh[0].name == name.substr(0, name.find('.')));
      CHECK(find_topology(mesh[0]).components == int(bird.size()));
      CHECK(mesh[0].points.size() == 8 * bird.size());
    }
  }
}

TEST_CASE("names come from groups or objects of an OBJ, never from its materials", "[geometry][import]")
{
  const TemporaryFolder folder;
  const SurfaceMesh nameless = read_mesh(folder.write("goose.obj", test::obj_bytes(small_bird(), ' ', true)));
  REQUIRE(nameless.size() == 1);
  CHECK(nameless[0].name == "goose");
  CHECK(find_topology(nameless[0]).components == 5);
  CHECK(find_topology(nameless[0]).closed());
}

TEST_CASE("names of an OBJ keep their blanks as underscores", "[geometry][import]")
{
  const TemporaryFolder folder;
  std::string text = test::obj_bytes(small_bird(), 'o');
  for (std::size_t at = text.find("_left"); at != std::string::npos; at = text.find("_left"))
    text.replace(at, 5, " L ");
  for (std::size_t at = text.find("_right"); at != std::string::npos; at = text.find("_right"))
    text.replace(at, 6, " R ");
  const SurfaceMesh mesh = read_mesh(folder.write("goose.obj", text));
  CHECK(mesh.size() == small_bird().size());
  CHECK(std::any_of(mesh.begin(), mesh.end(), [](const SurfacePart& p) { return p.name == "wing_L"; }));
}

TEST_CASE("a binary STL may begin with solid and go on after its triangles", "[geometry][import]")
{
  const TemporaryFolder folder;
  for (const std::string rest : {"", "\r\n", "COLOR=abcd"})
    for (const std::string header : {"solid bird exported by CAD", "exported", "solid"}) {
      CAPTURE(header, rest);
      const SurfaceMesh mesh =
          read_mesh(folder.write("torso.stl", test::stl_bytes({small_bird()[0]}, header) + rest));
      REQUIRE(mesh.size() == 1);
      CHECK(mesh[0].name == "torso");
      CHECK(mesh[0].points.size() == 8);
      CHECK(signed_volume(mesh[0]) == Approx(0.40 * 0.16 * 0.14).epsilon(1e-5));
    }
}

TEST_CASE("solids of an STL without names stay apart", "[geometry][import]")
{
  const TemporaryFolder folder;
  SurfaceMesh bird{small_bird()[0], small_bird()[3]};
  bird[0].name = bird[1].name = "";
  const SurfaceMesh mesh = read_mesh(folder.write("goose.stl", test::stl_text(bird)));
  REQUIRE(mesh.size() == 2);
  CHECK(mesh[0].name == "goose_1");
  CHECK(mesh[1].name == "goose_2");
}

TEST_CASE("one STL a part takes the files' names", "[geometry][import]")
{
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> binary, text;
  for (SurfacePart one : scaled(small_bird(), 1000)) {
    binary.push_back(folder.write(one.name + ".stl", test::stl_bytes({one})));
    const std::string file = one.name + ".text.stl";
    one.name = "OpenSCAD_Model"; // the same in all
    text.push_back(folder.write(file, test::stl_text({one})));
  }
  check_is_small_bird(import_mesh(binary).parts);
  const ImportedMesh second = import_mesh(text, {.unit = 1e-3, .nose = "x", .up = "z"});
  CHECK(second.parts[1].name == "head.text");
  CHECK_FALSE(second.unit_guessed);
  binary.push_back(binary.front());
  CHECK_THAT(input_error([&] { import_mesh(binary); }),
             Contains("torso") && Contains("name the files differently"));
  CHECK_THAT(input_error([&] { import_mesh({}); }), Contains("no mesh file"));
}

TEST_CASE("nested and mirrored nodes of a glTF stay outward", "[geometry][import]")
{
  const TemporaryFolder folder;
  const SurfaceMesh two{small_bird()[0], small_bird()[3]};
  // Both under a node that mirrors x; the right wing is a mirror image within it.
  const std::string nodes =
      R"({"name":"bird","scale":[-1,1,1],"children":[1,2,3]},{"name":"torso","mesh":0},)"
      R"({"name":"wing_left","mesh":1},)"
      R"({"name":"wing_right","children":[4]},)"
      R"({"mesh":1,"matrix":[1,0,0,0,0,-1,0,0,0,0,1,0,0,0,0,1]})";
  const SurfaceMesh mesh = read_mesh(folder.write("bird.gltf", test::gltf_bytes(two, "test", nodes, "0")));
  REQUIRE(mesh.size() >= 2);
  double volume = 0;
  for (const SurfacePart& one : mesh) {
    CAPTURE(one.name);
    CHECK(signed_volume(one) > 0);
    CHECK(find_topology(one).closed());
    volume += signed_volume(one);
  }
  CHECK(volume == Approx(0.40 * 0.16 * 0.14 + 2 * 0.20 * 0.68 * 0.03).epsilon(1e-5));
  CHECK(bounding_box(mesh).lower.y() == Approx(-0.75));
  CHECK(bounding_box(mesh).upper.y() == Approx(0.75));
  CHECK(part(mesh, "wing_left").points[0].x() == Approx(-two[1].points[0].x()));
}

TEST_CASE("units that files state are taken", "[geometry][import]")
{
  const TemporaryFolder folder;
  const auto unit_of = [](const ImportedMesh& mesh) {
    CHECK_FALSE(mesh.unit_guessed);
    check_is_small_bird(mesh.parts, 1e-5);
    return mesh.unit;
  };
  for (const auto& [name, unit] : {std::pair{"millimeter", 1e-3},
                                   {"inch", 0.0254},
                                   {"foot", 0.3048},
                                   {"meter", 1.0},
                                   {"micron", 1e-6},
                                   {"centimeter", 1e-2}})
  {
    CAPTURE(name);
    CHECK(unit_of(import_mesh({folder.write(
              "a.3mf", test::mf3_bytes(scaled(small_bird(), 1 / unit), name))})) == Approx(unit));
  }
  CHECK(unit_of(import_mesh({folder.write("b.3mf", test::mf3_bytes(scaled(small_bird(), 1000), ""))})) ==
        1e-3);
  const std::string millimetres = R"(<unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis>)";
  const auto dae = folder.write("c.dae", test::dae_bytes(scaled(small_bird(), 1000), millimetres));
  CHECK(unit_of(import_mesh({dae})) == Approx(1e-3).epsilon(1e-9));
  CHECK(import_mesh({dae}, {.unit = 1}).unit == 1); // given wins
  CHECK_THAT(
      input_error([&] { import_mesh({folder.write("d.3mf", test::mf3_bytes(small_bird(), "furlong"))}); }),
      Contains("d.3mf") && Contains("furlong"));
  // glTF says metres: a bird in millimetres is read as it says, with a warning that it is no bird.
  const ImportedMesh giant =
      import_mesh({folder.write("e.gltf", test::gltf_bytes(scaled(small_bird(), 1000)))});
  CHECK(giant.unit == 1);
  CHECK_THAT(all_of(giant.warnings), Contains("1.5e+03 m wide") && Contains("glTF"));
  CHECK_THROWS_AS(import_mesh({dae}, {.unit = -1}), InputError);
}

TEST_CASE("units that no file states are guessed", "[geometry][import]")
{
  const TemporaryFolder folder;
  for (const double unit : {1.0, 1e-2, 1e-3}) {
    CAPTURE(unit);
    const auto file = folder.write("bird.obj", test::obj_bytes(scaled(small_bird(), 1 / unit)));
    const ImportedMesh mesh = import_mesh({file});
    CHECK(mesh.unit_guessed);
    CHECK(mesh.unit == unit);
    CHECK_THAT(all_of(mesh.notes), Contains("bird.obj") && Contains("1.5 m wide"));
    check_is_small_bird(mesh.parts);
  }
  // 59 file units may be 1.5 m in inches or 0.59 m in centimetres: only the mass tells.
  const auto inches = folder.write("inch.obj", test::obj_bytes(scaled(small_bird(), 1 / 0.0254)));
  CHECK_THAT(input_error([&] { import_mesh({inches}); }),
             Contains("inch.obj") && Contains("cm (0.591 m wide)") && Contains("inch (1.5 m wide)"));
  const ImportedMesh told = import_mesh({inches}, {.mass = 8.0});
  CHECK(told.unit == 0.0254);
  check_is_small_bird(told.parts);
  CHECK_THAT(all_of(told.notes), Contains("kg/m3"));
  const auto feet = folder.write("foot.obj", test::obj_bytes(scaled(small_bird(), 1 / 0.3048)));
  CHECK(import_mesh({feet}).unit == 0.3048); // as metres it would span 4.9 m
  const auto speck = folder.write("speck.obj", test::obj_bytes(scaled(small_bird(), 1e-3)));
  CHECK_THAT(input_error([&] { import_mesh({speck}); }),
             Contains("speck.obj") && Contains("no length unit") && Contains("give the unit"));
}

TEST_CASE("an object in another unit is scaled, or refused when strict", "[geometry][import]")
{
  const TemporaryFolder folder;
  struct Slip
  {
    std::vector<std::size_t> rows;
    double factor;
  };
  for (const Slip& slip :
       {Slip{{3}, 1000}, Slip{{3}, 100}, Slip{{3}, 25.4}, Slip{{3}, 10}, Slip{{4}, 2.54}, Slip{{0}, 1000},
        Slip{{0}, 1e-3}, Slip{{1}, 1e-3}, Slip{{1}, 1000}, Slip{{3, 4}, 1000}})
  {
    SurfaceMesh bird = small_bird();
    std::string names;
    for (const std::size_t row : slip.rows) {
      names += bird[row].name + " ";
      for (Vector3& p : bird[row].points)
        p *= slip.factor;
    }
    CAPTURE(names, slip.factor);
    const auto file = folder.write("bird.gltf", test::gltf_bytes(bird));
    const ImportOptions options{.nose = "x", .up = "z"};
    const ImportedMesh mesh = import_mesh({file}, options);
    check_is_small_bird(mesh.parts, 1e-4);
    CHECK_THAT(all_of(mesh.notes), Contains("two units in one scene"));
    ImportOptions strict = options;
    strict.strict = true;
    CHECK_THAT(input_error([&] { import_mesh({file}, strict); }),
               Contains("bird.gltf") && Contains("in one unit"));
  }
}

TEST_CASE("gaps between sound objects are no slip of units", "[geometry][import]")
{
  const TemporaryFolder folder;
  for (const double gap : {0.002, 0.01, 0.03, 0.1, 0.3}) {
    CAPTURE(gap);
    SurfaceMesh bird = small_bird();
    for (const std::size_t row : {1, 3})
      for (Vector3& p : bird[row].points)
        p += row == 1 ? Vector3(gap, 0, 0) : Vector3(0, gap, 0);
    const ImportedMesh mesh =
        import_mesh({folder.write("bird.gltf", test::gltf_bytes(bird))}, {.nose = "x", .up = "z"});
    CAPTURE(all_of(mesh.notes));
    CHECK((bounding_box(mesh.parts).upper - bounding_box(mesh.parts).lower -
           (bounding_box(bird).upper - bounding_box(bird).lower))
              .norm() < 1e-5);
  }
}

TEST_CASE("given axes turn the bird", "[geometry][import]")
{
  const TemporaryFolder folder;
  const char* names[] = {"+x", "-x", "y", "-y", "+z", "-z"};
  const auto direction = [](int i) { return Vector3((i % 2 ? -1.0 : 1.0) * Vector3::Unit(i / 2)); };
  for (int nose = 0; nose < 6; ++nose)
    for (int up = 0; up < 6; ++up) {
      CAPTURE(names[nose], names[up]);
      Eigen::Matrix3d frame; // columns: nose, left, up in the file
      frame << direction(nose), direction(up).cross(direction(nose)), direction(up);
      const SurfaceMesh turned = changed(small_bird(), [&](const Vector3& p) { return Vector3(frame * p); });
      const ImportOptions options{.nose = names[nose], .up = names[up]};
      if (nose / 2 == up / 2) {
        CHECK_THAT(input_error([&] {
                     import_mesh({folder.write("a.gltf", test::gltf_bytes(small_bird()))}, options);
                   }),
                   Contains("not perpendicular"));
        continue;
      }
      const auto file = folder.write("bird.gltf", test::gltf_bytes(turned));
      check_is_small_bird(import_mesh({file}, options).parts);
      // Names of head, left and right tell the rest, whatever the format says; a nose alone or up alone too.
      const auto plain = folder.write("bird.obj", test::obj_bytes(turned));
      const ImportedMesh found = import_mesh({plain});
      check_is_small_bird(found.parts);
      CHECK(found.warnings.empty());
      check_is_small_bird(import_mesh({plain}, {.nose = names[nose]}).parts);
      check_is_small_bird(import_mesh({plain}, {.up = names[up]}).parts);
    }
  const auto file = folder.write("bird.obj", test::obj_bytes(small_bird()));
  for (const char* nonsense : {"w", "+", "xx", "-1", "north"})
    CHECK_THAT(input_error([&] { import_mesh({file}, {.nose = nonsense}); }),
               Contains(nonsense) && Contains("+x, -x"));
}

TEST_CASE("axes of a bird in one piece are found by its shape, with a warning", "[geometry][import]")
{
  const TemporaryFolder folder;
  const SurfaceMesh turned =
      changed(small_bird(), [](const Vector3& p) { return Vector3(-p.y(), p.z(), -p.x()); });
  const ImportedMesh mesh = import_mesh({folder.write("bird.ply", test::ply_bytes(turned))});
  REQUIRE(mesh.parts.size() == 1);
  SurfaceMesh wanted = small_bird();
  CHECK((bounding_box(mesh.parts).upper - 0.5 * (bounding_box(wanted).upper - bounding_box(wanted).lower))
            .norm() < 1e-6);
  CHECK(volume_centre(mesh.parts[0]).x() < 0); // the torso is behind the middle of head, torso and tail
  CHECK_THAT(all_of(mesh.warnings), Contains("narrower end") && Contains("the wings seem to"));
}

TEST_CASE("a bird that stands askew is found by its principal axes", "[geometry][import]")
{
  const TemporaryFolder folder;
  const Eigen::Matrix3d askew =
      (Eigen::AngleAxisd(0.4, Vector3::UnitZ()) * Eigen::AngleAxisd(-0.7, Vector3::UnitX()))
          .toRotationMatrix();
  const SurfaceMesh turned = changed(small_bird(), [&](const Vector3& p) { return Vector3(askew * p); });
  const ImportedMesh mesh = import_mesh({folder.write("bird.obj", test::obj_bytes(turned))});
  const Box left = bounding_box(part(mesh.parts, "wing_left")), head = bounding_box(part(mesh.parts, "head"));
  CHECK(left.centre().y() > 0.35);
  CHECK(head.centre().x() > 0.2);
  CHECK(bounding_box(mesh.parts).upper.y() == Approx(0.75).epsilon(0.02));
}

TEST_CASE("without a mirror plane the file's axes stay, with a warning", "[geometry][import]")
{
  const TemporaryFolder folder;
  SurfacePart lump = make_box({1, 0.5, 0.3});
  for (Vector3& p : lump.points)
    p += 0.4 * p.x() * p.x() * Vector3(0.5, 1, 0.7) +
         Vector3(0, 0.6 * p.x() * p.z(), p.x() * p.y() + p.y() * p.y());
  const ImportedMesh mesh =
      import_mesh({folder.write("lump.obj", test::obj_bytes({lump}))}, {.recentre = false});
  CHECK((mesh.parts[0].points[0] - lump.points[0]).norm() < 1e-6);
  CHECK_THAT(all_of(mesh.warnings), Contains("no mirror plane"));
}

TEST_CASE("the project's own goose keeps every coordinate", "[geometry][import][glb]")
{
  const std::filesystem::path file = std::string(BIRDSTRIKE_SOURCE_DIR) + "/share/meshes/goose.glb";
  const SurfaceMesh plain = read_mesh(file);
  const ImportedMesh mesh = import_mesh({file});
  CHECK_FALSE(mesh.unit_guessed);
  CHECK(mesh.warnings.empty());
  REQUIRE(mesh.parts.size() == plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(mesh.parts[i].name == plain[i].name);
    CHECK(mesh.parts[i].points == plain[i].points);
    CHECK(mesh.parts[i].triangles == plain[i].triangles);
  }
  // As anyone else's file it is found to fly the same way.
  const TemporaryFolder folder;
  const ImportedMesh other =
      import_mesh({folder.write("goose.stl", test::stl_text(plain))}, {.recentre = false});
  CHECK(other.unit == 1);
  for (std::size_t i = 0; i < plain.size(); ++i)
    CHECK((bounding_box(other.parts[i]).lower - bounding_box(plain[i]).lower).norm() < 1e-6);
}
