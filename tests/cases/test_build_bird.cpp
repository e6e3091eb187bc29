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
  return build_bird(parsed, read_bird_mesh(find_mesh(parsed), parsed.bird.mesh_unit, parsed.bird.parts, log),
                    log);
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
  CHECK_THROWS_AS(build(file), InputError);
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
  CHECK_THROWS_WITH(build(file), Catch::Contains("200 m across") && Catch::Contains("bird.mesh_unit") &&
                                     Catch::Contains("\"1 mm\""));
  CHECK(build(file, {"bird.mesh_unit=1 mm"}).density_factor == Approx(1).epsilon(1e-3));
  CHECK_THROWS_WITH(build(file, {"bird.mesh_unit=1 mm", "bird.mass=40 kg"}),
                    Catch::Contains("does not belong to this mesh") && Catch::Contains("1.201 kg"));
}
