// SPDX-License-Identifier: GPL-3.0-or-later
// STEP and IGES: volumes of smooth solids, names, units; or, without OpenCASCADE, what to do.
#include "geometry/import/import_mesh.h"
#include "geometry/import/read_mesh.h"
#include "geometry/measure.h"
#include "geometry/topology.h"
#include "temporary_folder.h"

#include <cstdlib>
#include <numbers>

using namespace birdstrike;
using Catch::Contains;
using test::input_error;
using test::TemporaryFolder;

#ifdef BIRDSTRIKE_CAD_SAMPLE

namespace {

std::filesystem::path write_sample(const TemporaryFolder& folder, const std::string& name,
                                   const std::string& unit)
{
  const std::filesystem::path file = folder / name;
  const std::string command =
      std::string(BIRDSTRIKE_CAD_SAMPLE) + " '" + file.string() + "' " + unit + " >/dev/null 2>&1";
  REQUIRE(std::system(command.c_str()) == 0);
  return file;
}

} // namespace

TEST_CASE("solids of a CAD file become closed parts with their names and volumes", "[geometry][import][cad]")
{
  constexpr double pi = std::numbers::pi;
  const TemporaryFolder folder;
  for (const auto& [name, unit_name, unit] : {std::tuple{"mm.step", "MM", 1e-3},
                                              {"inch.stp", "INCH", 0.0254},
                                              {"m.STEP", "M", 1.0},
                                              {"mm.igs", "MM", 1e-3},
                                              {"inch.IGES", "INCH", 0.0254}})
  {
    CAPTURE(name);
    const std::string file_name = name;
    const auto file = write_sample(folder,
                                   file_name == "m.STEP"      ? "m.step"
                                   : file_name == "inch.IGES" ? "inch.igs"
                                                              : file_name,
                                   unit_name);
    std::filesystem::rename(file, folder / file_name);
    const bool step = file_name.find("ig") == std::string::npos && file_name.find("IG") == std::string::npos;
    const ImportedMesh mesh = import_mesh({folder / file_name}, {.nose = "z", .up = "y", .recentre = false});
    CHECK(mesh.unit == Approx(unit).epsilon(1e-9));
    CHECK_FALSE(mesh.unit_guessed);
    REQUIRE(mesh.parts.size() == (step ? 3 : 2));
    const double head = 4.0 / 3.0 * pi * std::pow(0.03, 3), torso = pi * 0.04 * 0.04 * 0.2;
    for (const SurfacePart& part : mesh.parts) {
      CAPTURE(part.name);
      const double volume = part.name == "torso" ? torso : head;
      CHECK(signed_volume(part) < volume); // corners lie on the surface
      CHECK(signed_volume(part) > 0.996 * volume);
      CHECK(find_topology(part).closed());
      CHECK(find_topology(part).mixed_edges == 0);
    }
    CHECK(mesh.parts[0].name == "torso");
    CHECK(mesh.parts[1].name == "head");
    CHECK((volume_centre(mesh.parts[1]) - Vector3(0.22, 0, 0)).norm() < 1e-4); // nose was +z
    if (step) {
      CHECK(mesh.parts[2].name == "lump");
      CHECK((volume_centre(mesh.parts[2]) - Vector3(0, 0, 0.1)).norm() < 1e-4); // up was +y
    }
    CHECK(signed_volume(read_mesh(folder / file_name)[0]) ==
          Approx(signed_volume(mesh.parts[0])).epsilon(1e-6));
  }
}

TEST_CASE("damaged CAD files are refused by name", "[geometry][import][cad][dirty][broken]")
{
  const TemporaryFolder folder;
  for (const std::string name : {"whole.step", "whole.igs"}) {
    std::ifstream stream(write_sample(folder, name, "MM"), std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    const std::string cut_name = "cut" + name.substr(5);
    int refused = 0;
    for (const double share : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9}) {
      CAPTURE(name, share);
      const auto file = folder.write(cut_name, whole.substr(0, std::size_t(share * double(whole.size()))));
      try {
        const SurfaceMesh mesh = read_mesh(file); // what is whole in it
        CHECK(!mesh.empty());
      } catch (const InputError& error) {
        CHECK_THAT(error.what(), Contains(cut_name));
        ++refused;
      }
    }
    CHECK(refused >= 3);
    CHECK_THAT(input_error([&] { read_mesh(folder.write(cut_name, "hello world\n")); }), Contains(cut_name));
    CHECK_THAT(input_error([&] { read_mesh(folder.write(cut_name, "")); }), Contains("empty"));
  }
}

#else

TEST_CASE("without OpenCASCADE a CAD file is refused with what to export", "[geometry][import][cad]")
{
  const TemporaryFolder folder;
  for (const char* name : {"bird.step", "bird.STP", "bird.iges"})
    CHECK_THAT(input_error([&] { read_mesh(folder.write(name, "ISO-10303-21;")); }),
               Contains(name) && Contains("export STL, OBJ or glTF"));
}

#endif
