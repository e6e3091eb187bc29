// SPDX-License-Identifier: GPL-3.0-or-later
// Every format cut short, empty, as noise, with single bytes changed, under a wrong extension: parts, or an InputError
// that names the file; never a crash.
#include "geometry/check.h"
#include "geometry/import/import_mesh.h"
#include "geometry/import/weld.h"
#include "geometry/topology.h"
#include "geometry/write_glb.h"
#include "mesh_files.h"
#include "temporary_folder.h"

#include <set>

using namespace birdstrike;
using Catch::Contains;
using test::input_error;
using test::SampleFile;
using test::TemporaryFolder;

namespace {

//! The same numbers on every machine: Numerical Recipes, section 7.1.
class Dice
{
public:
  explicit Dice(unsigned seed) : state_(seed) {}
  unsigned below(std::size_t limit)
  {
    state_ = state_ * 1664525u + 1013904223u;
    return unsigned((std::uint64_t(state_ >> 8) * limit) >> 24);
  }

private:
  std::uint32_t state_;
};

//! True if the file gave parts; a message must name the file.
bool import_or_refuse(const std::filesystem::path& file)
{
  try {
    const ImportedMesh mesh = import_mesh({file}, {.unit = 1});
    CHECK_FALSE(mesh.parts.empty());
    for (const SurfacePart& part : mesh.parts) {
      CHECK_FALSE(part.triangles.empty());
      for (const Vector3& p : part.points)
        if (!p.allFinite())
          FAIL("a coordinate is not finite");
      find_topology(part);
      check_surface(part);
    }
    return true;
  } catch (const InputError& error) {
    CHECK_THAT(error.what(), Contains(file.filename().string()));
    return false;
  }
}

std::vector<SampleFile> samples(const TemporaryFolder& folder)
{
  const SurfaceMesh bird = test::small_bird();
  std::vector<SampleFile> all = test::sample_files(bird);
  write_glb(bird, folder / "sample.glb");
  std::ifstream stream(folder / "sample.glb", std::ios::binary);
  all.push_back({"sample.glb", {std::istreambuf_iterator<char>(stream), {}}});
  return all;
}

} // namespace

TEST_CASE("files cut anywhere give parts or a message", "[geometry][import][dirty][broken]")
{
  const TemporaryFolder folder;
  Dice dice(1);
  for (const auto& [name, whole] : samples(folder)) {
    CAPTURE(name);
    int refused = 0;
    for (int i = 0; i < 21; ++i) {
      const std::size_t length = i == 20 ? whole.size() - 1 : 1 + dice.below(whole.size() - 1);
      CAPTURE(length);
      refused += !import_or_refuse(folder.write(name, whole.substr(0, length)));
    }
    // Text may end after any line, and assimp does not hold a text PLY to its counts.
    const bool counted =
        name.find(".obj") == std::string::npos && name != "sample_text.stl" && name != "sample.ply";
    CHECK(refused >= (counted ? 15 : 1));
  }
}

TEST_CASE("files with a byte changed give parts or a message", "[geometry][import][dirty][broken]")
{
  const TemporaryFolder folder;
  Dice dice(2);
  for (const auto& [name, whole] : samples(folder)) {
    CAPTURE(name);
    for (int i = 0; i < 20; ++i) {
      std::string changed = whole;
      const unsigned at = dice.below(i % 2 ? whole.size() : std::min<std::size_t>(whole.size(), 200));
      changed[at] = char(i % 4 < 2 ? dice.below(256) : changed[at] ^ 1 << dice.below(8));
      CAPTURE(at, int(changed[at]));
      import_or_refuse(folder.write(name, changed));
    }
  }
}

TEST_CASE("empty files, noise and wrong extensions are refused by name", "[geometry][import][dirty][broken]")
{
  const TemporaryFolder folder;
  Dice dice(3);
  const std::vector<SampleFile> all = samples(folder);
  std::set<std::string> extensions;
  for (const auto& [name, whole] : all)
    extensions.insert(name.substr(name.find('.')));
  for (const std::string& extension : extensions) {
    CAPTURE(extension);
    const std::string name = "bird" + extension;
    CHECK_THAT(input_error([&] { import_mesh({folder.write(name, "")}); }),
               Contains(name) && Contains("empty"));
    for (const std::size_t size : {1, 83, 84, 134, 5000}) {
      std::string noise;
      for (std::size_t i = 0; i < size; ++i)
        noise += char(dice.below(256));
      CAPTURE(size);
      CHECK_FALSE(import_or_refuse(folder.write(name, noise)));
      CHECK_FALSE(import_or_refuse(folder.write(name, std::string(size, '\0'))));
    }
    for (const auto& [other, whole] : all)
      if (other.substr(other.find('.')) != extension) {
        CAPTURE(other);
        import_or_refuse(folder.write(name, whole));
      }
  }
}

TEST_CASE("files that promise more than they hold are refused soon", "[geometry][import][dirty][broken]")
{
  const TemporaryFolder folder;
  std::string stl = test::stl_bytes({test::small_bird()[0]});
  for (int i = 80; i < 84; ++i)
    stl[i] = '\xff';
  CHECK_FALSE(import_or_refuse(folder.write("many.stl", stl)));
  for (const char* count : {"4294967295", "2147483648", "-1", "99999999999999999999"}) {
    CAPTURE(count);
    import_or_refuse(folder.write(
        "many.ply", "ply\nformat binary_little_endian 1.0\nelement vertex " + std::string(count) +
                        "\nproperty float x\nproperty float y\nproperty float z\nelement "
                        "face 1\nproperty list uchar int vertex_indices\nend_header\n"));
    import_or_refuse(
        folder.write("many.off", "OFF\n" + std::string(count) + " 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  }
  for (const char* index : {"-1", "3", "2147483648", "-2147483648", "4294967295", "nan"}) {
    CAPTURE(index);
    const std::string corner = index;
    import_or_refuse(folder.write("i.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 " + corner + "\n"));
    import_or_refuse(folder.write("i.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + corner + "\n"));
  }
  for (const char* number : {"1e38", "-1e39", "1e400", "inf", "nan", "1e-320"}) {
    CAPTURE(number);
    import_or_refuse(folder.write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 " + std::string(number) + "\nf 1 2 3\n"));
    import_or_refuse(folder.write(
        "n.stl", "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 " +
                     std::string(number) + "\nendloop\nendfacet\nendsolid a\n"));
  }
}

TEST_CASE("the weld stands coordinates and corners of any size", "[geometry][import][dirty]")
{
  SurfacePart part{"p", {{0, 0, 0}, {1e300, 0, 0}, {0, -1e300, 0}, {1e-300, 0, 0}}, {{0, 1, 2}, {3, 1, 2}}};
  SurfacePart same = part;
  weld(same, 1e-6);
  CHECK(same.triangles.size() == 2);
  CHECK(same.points.size() == 3); // 1e-300 is at the origin
  same = part;
  weld(same, 0);
  CHECK(same.points.size() == 4);
  same.points.push_back({-0.0, 0, 0});
  same.triangles.push_back({4, 1, 2});
  weld(same, 0);
  CHECK(same.points.size() == 4); // -0 is 0
  same.points[0].x() = -1;
  same.points[3].x() = 1;
  weld(same, 0);
  CHECK(same.points.size() == 4); // a sign makes a difference
  same = part;
  same.points[1].z() = NAN;
  CHECK_THAT(input_error([&] { weld(same, 1e-6); }), Contains("'p'") && Contains("finite"));
  same = part;
  same.triangles[1][2] = 4;
  CHECK_THAT(input_error([&] { weld(same, 1e-6); }), Contains("'p'") && Contains("not there"));
  same.triangles[1][2] = -1;
  CHECK_THROWS_AS(weld(same, 1e-6), InputError);
}
