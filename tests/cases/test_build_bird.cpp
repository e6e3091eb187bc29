// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/build_bird.h"

#include "cases/log.h"
#include "core/error.h"
#include "core/material/porous_bird.h"
#include "scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace birdstrike;
using scratch::box;
using scratch::box_case;

namespace {

BuiltBird build(const fs::path& file, const std::vector<std::string>& overrides = {})
{
  Log log(true);
  const Case parsed = read_case(file, overrides);
  return build_bird(parsed, log);
}

const fs::path goose = BIRDSTRIKE_SOURCE_DIR "/cases/goose-on-rigid-plate.toml";

} // namespace

TEST_CASE("the bird weighs what the case says at every spacing", "[cases][bird]")
{
  for (const char* spacing : {"20 mm", "13.7 mm", "10 mm"}) {
    const BuiltBird bird = build(goose, {std::string("bird.spacing=") + spacing});
    INFO(spacing);
    CHECK(std::abs(total_mass(bird.particles) / 4 - 1) < 1e-12);
    double parts = 0;
    std::size_t particles = 0;
    for (const PartReport& part : bird.parts) {
      INFO(part.name);
      parts += part.mass;
      particles += part.particles;
      // One factor for all parts: each keeps the ratio of densities that its porosity gives.
      CHECK(part.density == Approx(bird.density_factor * porous_density(part.porosity)).epsilon(1e-12));
    }
    CHECK(parts == Approx(4).epsilon(1e-12));
    CHECK(particles == bird.particles.size());
  }
}

TEST_CASE("the bird starts in front of the plate at the gap, flying towards it", "[cases][bird]")
{
  const double spacing = 0.02, gap = 0.05;
  const BuiltBird bird = build(goose, {"bird.spacing=20 mm", "bird.gap=50 mm"});
  const Particles& p = bird.particles;
  CHECK(*std::max_element(p.x.begin(), p.x.end()) == Approx(-(gap + spacing / 2)).epsilon(1e-12));
  CHECK(std::all_of(p.vx.begin(), p.vx.end(), [](double v) { return v == 150; }));
  CHECK(std::all_of(p.vy.begin(), p.vy.end(), [](double v) { return v == 0; }));
  double moment_y = 0, moment_z = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    moment_y += p.mass[i] * p.y[i];
    moment_z += p.mass[i] * p.z[i];
  }
  CHECK(std::abs(moment_y) < 1e-12); // aimed at the middle
  CHECK(std::abs(moment_z) < 1e-12);
}

TEST_CASE("yaw turns the bird and changes neither mass nor velocity", "[cases][bird]")
{
  const BuiltBird ahead = build(goose, {"bird.spacing=20 mm"});
  const BuiltBird turned = build(goose, {"bird.spacing=20 mm", "bird.yaw=90 deg"});
  const auto extent = [](const std::vector<double>& v) {
    return *std::max_element(v.begin(), v.end()) - *std::min_element(v.begin(), v.end());
  };
  CHECK(extent(turned.particles.x) == Approx(extent(ahead.particles.y)).epsilon(1e-9));
  CHECK(extent(turned.particles.y) == Approx(extent(ahead.particles.x)).epsilon(1e-9));
  CHECK(total_mass(turned.particles) == Approx(4).epsilon(1e-12));
  CHECK(turned.particles.vx.front() == 150);
}

TEST_CASE("parts of mesh and case have to agree", "[cases][bird][errors]")
{
  const scratch::Folder folder;
  folder.write("box.obj", box("torso", 0.1, 0.05, 0.05) + box("head", 0.02, 0.02, 0.02, 6, 9));
  const fs::path file = folder.write("case.toml", box_case);
  CHECK_THROWS_WITH(build(file), Catch::Contains("case.toml: bird.parts.head is missing") &&
                                     Catch::Contains("object \"head\""));
  CHECK_THROWS_WITH(build(file, {"bird.parts.head.porosity=0.3", "bird.parts.beak.porosity=0.3"}),
                    Catch::Contains("bird.parts.beak") &&
                        Catch::Contains("has no such part; it has torso, head"));
}

TEST_CASE("an object may be a part by its own name", "[cases][bird]")
{
  const scratch::Folder folder;
  folder.write("box.obj", box("gelatine", 0.1, 0.05, 0.05));
  const fs::path file = folder.write("case.toml", box_case);
  CHECK(build(file).parts[0].name == "torso"); // one closed surface is the only part there is
  std::string text = box_case;
  text.replace(text.find("torso"), 5, "gelatine");
  const BuiltBird bird = build(folder.write("case.toml", text));
  REQUIRE(bird.parts.size() == 1);
  CHECK(bird.parts[0].name == "gelatine");
  CHECK(bird.parts[0].particles == 2000);
  CHECK(bird.parts[0].mesh_volume == Approx(0.002).epsilon(1e-6));
}

TEST_CASE("a mesh in another unit or for another mass is refused with a remedy", "[cases][bird][errors]")
{
  const scratch::Folder folder;
  folder.write("box.obj", box("torso", 100, 50, 50));
  const fs::path file = folder.write("case.toml", box_case);
  CHECK_THROWS_WITH(build(file, {"bird.mesh_unit=1 m"}), Catch::Contains("200 m across") &&
                                                             Catch::Contains("bird.mesh_unit") &&
                                                             Catch::Contains("\"1 mm\""));
  CHECK(build(file, {"bird.mesh_unit=1 mm"}).density_factor == Approx(1).epsilon(1e-3));
  CHECK_THROWS_WITH(build(file, {"bird.mesh_unit=1 mm", "bird.mass=40 kg"}),
                    Catch::Contains("does not belong to this mesh") && Catch::Contains("1.201 kg"));
}

TEST_CASE("what is met exactly is the mass, the density, or the mass without the densities", "[cases][bird]")
{
  const BuiltBird mass = build(goose, {"bird.spacing=20 mm", "bird.mass=3.8 kg"});
  const BuiltBird particle_mass =
      build(goose, {"bird.spacing=20 mm", "bird.mass=3.8 kg", "bird.exact=particle-mass"});
  CHECK(total_mass(mass.particles) == Approx(3.8).epsilon(1e-12));
  CHECK(total_mass(particle_mass.particles) == Approx(3.8).epsilon(1e-12));
  CHECK(particle_mass.density_factor == 1);
  CHECK(particle_mass.mass_factor == Approx(mass.density_factor).epsilon(1e-12));
  for (std::size_t part = 0; part < mass.parts.size(); ++part) {
    const PartReport &a = mass.parts[part], &b = particle_mass.parts[part];
    CHECK(a.mass == Approx(b.mass).epsilon(1e-12));
    CHECK(a.density == Approx(mass.density_factor * porous_density(a.porosity)).epsilon(1e-12));
    CHECK(b.density == Approx(porous_density(b.porosity)).epsilon(1e-12));
  }
  CHECK_THROWS_WITH(read_case(goose, {"bird.exact=density"}),
                    Catch::Contains("bird.mass") && Catch::Contains("density"));
}

TEST_CASE("a density stands for the porosity of a mixture, and for the density of an own law",
          "[cases][bird]")
{
  const scratch::Folder folder;
  folder.write("box.obj", box("torso", 0.1, 0.05, 0.05));
  const fs::path file = folder.write("case.toml", box_case);
  CHECK_THROWS_WITH(read_case(file, {"bird.parts.torso.density=700 kg/m3"}), Catch::Contains("both given"));
  std::string text = box_case;
  const auto at = text.find("porosity = 0.4");
  REQUIRE(at != std::string::npos);
  text.replace(at, 14, "density = \"700 kg/m3\"");
  const fs::path dense = folder.write("dense.toml", text);
  const BuiltBird bird = build(dense, {"bird.mass=1.4 kg"});
  CHECK(bird.density_factor == Approx(1).epsilon(1e-3)); // 2 litres of it
  CHECK(bird.parts[0].porosity == Approx(300 / (1000 - 1.225)));
  CHECK_THROWS_WITH(read_case(dense, {"bird.parts.torso.density=1500 kg/m3"}),
                    Catch::Contains("1500") && Catch::Contains("own law"));
  const Case again = read_case(folder.write("again.toml", to_toml(read_case(dense))));
  CHECK(again.bird.parts[0].density == 700);
}

TEST_CASE("patterns say which objects belong to a part", "[cases][bird]")
{
  const scratch::Folder folder;
  folder.write("box.obj", box("Hull_01", 0.1, 0.05, 0.05) + box("x7", 0.02, 0.02, 0.02, 6, 9));
  const fs::path file = folder.write("case.toml", box_case);
  CHECK_THROWS_WITH(build(file), Catch::Contains("'Hull_01'") && Catch::Contains("sternum") &&
                                     Catch::Contains("objects = [\"Hull_01\"]"));
  const BuiltBird bird = build(file, {"bird.parts.torso.objects=[\"hull*\"]", "bird.parts.lungs.porosity=0.8",
                                      "bird.parts.lungs.objects=[\"y?\", \"x?\"]", "bird.mass=1.2 kg"});
  REQUIRE(bird.parts.size() == 2);
  CHECK(bird.parts[0].name == "torso");
  CHECK(bird.parts[1].name == "lungs");
}

TEST_CASE("a case may name a species, a rule for its mass, and a number of particles", "[cases][bird]")
{
  const scratch::Folder folder;
  std::string text = box_case;
  const auto parts = text.find("[bird.parts]"), target = text.find("[target]");
  REQUIRE(parts != std::string::npos);
  text.erase(parts, target - parts);
  const auto mesh = text.find("mesh"), end = text.find('\n', mesh);
  text.replace(mesh, end - mesh, "species = \"mallard\"\nwings = \"folded\"\nneck = \"drawn-in\"");
  const auto mass = text.find("mass"), mass_end = text.find('\n', mass);
  text.replace(mass, mass_end - mass, "mass = \"29.631\"");
  const auto spacing = text.find("spacing"), spacing_end = text.find('\n', spacing);
  text.replace(spacing, spacing_end - spacing, "particles = 1500");
  const fs::path file = folder.write("case.toml", text);
  const BuiltBird bird = build(file, {"bird.yaw=20 deg"});
  CHECK(total_mass(bird.particles) == Approx(1.0).epsilon(0.01));
  CHECK(std::abs(double(bird.particles.size()) / 1500 - 1) < 0.02);
  CHECK(bird.parts.size() >= 6);
  for (const PartReport& part : bird.parts) {
    CAPTURE(part.name);
    CHECK(part.points.amount == Approx(part.mass).epsilon(1e-9));
    CHECK(part.body.amount == Approx(part.mesh_volume * part.density).epsilon(1e-9));
  }
  const Case again = read_case(folder.write("again.toml", to_toml(read_case(file))));
  CHECK(again.bird.particles == 1500);
  CHECK(again.bird.mass == read_case(file).bird.mass);
  CHECK_THROWS_WITH(read_case(file, {"bird.species=dodo"}),
                    Catch::Contains("dodo") && Catch::Contains("herring-gull"));
  CHECK_THROWS_WITH(read_case(file, {"bird.mesh=goose.glb"}), Catch::Contains("bird.mesh") &&
                                                                  Catch::Contains("bird.species") &&
                                                                  Catch::Contains("exactly one"));
  CHECK_THROWS_WITH(read_case(file, {"bird.mass=31.789"}), Catch::Contains("bird.mass"));
}

TEST_CASE("the lattice lies along the flight, however the bird is turned", "[cases][bird]")
{
  const BuiltBird bird = build(goose, {"bird.spacing=20 mm", "bird.yaw=30 deg", "bird.roll=10 deg"});
  const Particles& p = bird.particles;
  for (std::size_t i = 1; i < p.size(); ++i) {
    const double cells = (p.x[i] - p.x[0]) / 0.02;
    REQUIRE(std::abs(cells - std::round(cells)) < 1e-9);
  }
}
