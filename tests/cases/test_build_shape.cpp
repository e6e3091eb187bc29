// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/build_shape.h"

#include "cases/build_bird.h"
#include "cases/log.h"
#include "core/error.h"
#include "core/material/porous_bird.h"
#include "core/theory/impact_pressures.h"
#include "scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numbers>

using namespace birdstrike;

namespace {

const char* const shape_case = R"(title = "shape"
[bird]
shape = "cylinder"
mass = "0.55 kg"
spacing = "8 mm"
velocity = "200 m/s"
[bird.parts]
body = { porosity = 0.4 }
[target]
plate = { size = ["0.5 m", "0.4 m"], thickness = "5 mm", elements = [10, 8] }
[run]
end = "0.4 ms"
)";

const char* const column_case = R"(title = "column"
[bird]
shape = "column"
spacing = "1 mm"
velocity = "200 m/s"
[bird.parts]
body = { porosity = 0.4 }
)";

Case parse(const char* text, const std::vector<std::string>& overrides = {})
{
  const scratch::Folder folder;
  return read_case(folder.write("case.toml", text), overrides);
}

BuiltBird build(const char* text, const std::vector<std::string>& overrides = {})
{
  Log log(true);
  return build_bird(parse(text, overrides), log);
}

Vector3 centre_of_mass(const Particles& p)
{
  Vector3 moment = Vector3::Zero();
  for (std::size_t i = 0; i < p.size(); ++i)
    moment += p.mass[i] * p.position(i);
  return moment / total_mass(p);
}

} // namespace

TEST_CASE("shapes have the mass of the case and the volume of its porosity", "[cases][shape]")
{
  for (const char* shape : {"cylinder", "capsule", "sphere", "spheroid"}) {
    INFO(shape);
    const std::string choice = std::string("bird.shape=") + shape;
    const BuiltBird bird = build(shape_case, {choice});
    CHECK(std::abs(total_mass(bird.particles) / 0.55 - 1) < 1e-12);
    REQUIRE(bird.parts.size() == 1);
    CHECK(bird.parts[0].mesh_volume == Approx(0.55 / porous_density(0.4)).epsilon(1e-12));
    CHECK(bird.density_factor == Approx(1).epsilon(0.05));
    const ShapeSize size = size_of_shape(parse(shape_case, {choice}));
    CHECK(size.length / size.diameter == Approx(std::string(shape) == "sphere" ? 1 : 2));
    CHECK(bird.flight.length == Approx(size.length));
    CHECK(bird.flight.flat_radius == Approx(std::string(shape) == "cylinder" ? size.diameter / 2 : 0));
    CHECK(bird.flight.contact_time() == Approx(0.01 / 200));
  }
  CHECK_THROWS_WITH(build(shape_case, {"bird.shape=sphere", "bird.length_over_diameter=2"}),
                    Catch::Contains("bird.length_over_diameter") && Catch::Contains("sphere"));
}

TEST_CASE("a normal impact is one along +x to the last bit", "[cases][shape]")
{
  const BuiltBird bird = build(shape_case, {"bird.impact_angle=90 deg"});
  CHECK(bird.flight.direction == Vector3::UnitX());
  for (std::size_t i = 0; i < bird.particles.size(); ++i)
    REQUIRE(bird.particles.velocity(i) == Vector3(200, 0, 0));
}

TEST_CASE("an oblique bird flies along its own axis at the middle of the plate", "[cases][shape][analytic]")
{
  for (const double degrees : {45.0, 25.0}) {
    INFO(degrees);
    const BuiltBird normal = build(shape_case, {"bird.shape=capsule"});
    const BuiltBird bird =
        build(shape_case, {"bird.shape=capsule", "bird.impact_angle=" + std::to_string(degrees) + " deg"});
    const double angle = degrees * std::numbers::pi / 180;
    const Vector3 path(std::sin(angle), 0, -std::cos(angle));
    const Particles& p = bird.particles;
    for (std::size_t i = 0; i < p.size(); ++i)
      REQUIRE((p.velocity(i) - 200 * path).norm() < 1e-10);
    CHECK(*std::max_element(p.x.begin(), p.x.end()) == Approx(-0.010 - 0.004).epsilon(1e-12));
    CHECK(bird.flight.contact_time() == Approx(0.01 / (200 * std::sin(angle))));
    // From its centre of mass the path leads to the origin.
    const Vector3 centre = centre_of_mass(p);
    CHECK(centre.cross(path).norm() < 1e-12);
    CHECK(centre.dot(path) < 0);
    // The lattice is the normal bird's, turned: each particle has the same place along the axis and distance from it.
    const Vector3 centre_before = centre_of_mass(normal.particles);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector3 now = p.position(i) - centre, before = normal.particles.position(i) - centre_before;
      REQUIRE(now.dot(path) == Approx(before.x()).margin(1e-12));
      REQUIRE(now.norm() == Approx(before.norm()).margin(1e-12));
    }
  }
  CHECK_THROWS_WITH(parse(shape_case, {"bird.impact_angle=5 deg"}),
                    Catch::Contains("allowed is 10 ... 90 deg"));
}

TEST_CASE("a mesh bird may come at an angle, too", "[cases][bird]")
{
  const BuiltBird bird =
      build(scratch::read(BIRDSTRIKE_SOURCE_DIR "/cases/goose-on-rigid-plate.toml").c_str(),
            {"bird.spacing=20 mm", "bird.impact_angle=30 deg"});
  const Vector3 path(0.5, 0, -std::sqrt(0.75)), centre = centre_of_mass(bird.particles);
  CHECK(centre.cross(path).norm() < 1e-9);
  CHECK((bird.particles.velocity(7) - 150 * path).norm() < 1e-9);
}

TEST_CASE("a column follows from its layers, its end from the shock", "[cases][column]")
{
  const Case parsed = parse(column_case, {"bird.parts.body.layers=40", "bird.gap=2 mm"});
  const double u_s = hugoniot(make_porous_law("impact-event", 0.4, porous_density(0.4)), 200).shock_speed;
  CHECK(parsed.run.end_time == Approx(0.002 / 200 + 32 * 0.001 / u_s));
  REQUIRE(parsed.run.periodic);
  CHECK(parsed.run.periodic->size_y == Approx(0.006));
  CHECK(parsed.target.size[1] == Approx(0.006));
  CHECK(parsed.target.elements == std::array{1, 1});
  const BuiltBird bird = build(column_case, {"bird.parts.body.layers=40"});
  CHECK(bird.particles.size() == 40 * 36);
  CHECK(bird.density_factor == 1);
  CHECK(bird.particles.density[0] == Approx(porous_density(0.4)).epsilon(1e-12));
  // What was computed is in the echo, and the echo runs again as it is.
  const std::string echo = to_toml(parsed);
  CHECK(parse(echo.c_str()).run.end_time == parsed.run.end_time);
  CHECK(echo.find("layers = 40") != std::string::npos);
  CHECK(echo.find("\nmass") == std::string::npos);
  CHECK(echo.find("\nmesh") == std::string::npos);
  CHECK(echo.find("\nplate.size") == std::string::npos);
  CHECK(parse(column_case, {"run.end=1 ms"}).run.end_time == Approx(1e-3));
  CHECK(parse(column_case, {"bird.velocity=300 m/s"}).run.end_time < parsed.run.end_time * 1.5);
}

TEST_CASE("parts of a column lie in the order of the file", "[cases][column]")
{
  const BuiltBird bird = build(column_case, {"bird.parts.core.porosity=0", "bird.parts.core.layers=5"});
  const Particles& p = bird.particles;
  REQUIRE(p.size() == 65 * 36);
  for (std::size_t i = 0; i < p.size(); ++i)
    REQUIRE((p.part[i] == 0) == (p.x[i] > -0.010 - 0.060));
}

TEST_CASE("mesh, shape and column each refuse what is not theirs", "[cases][shape][errors]")
{
  CHECK_THROWS_WITH(parse(shape_case, {"bird.mesh=goose.glb"}),
                    Catch::Contains("bird.mesh = \"goose.glb\"") &&
                        Catch::Contains("bird.shape = \"cylinder\"") && Catch::Contains("exactly one"));
  CHECK_THROWS_WITH(parse("title = \"x\"\n"),
                    Catch::Contains("bird.mesh is missing") && Catch::Contains("bird.shape"));
  CHECK_THROWS_WITH(parse(shape_case, {"bird.shape=cube"}),
                    Catch::Contains("one of \"sphere\"") && Catch::Contains("\"column\""));
  CHECK_THROWS_WITH(
      parse(shape_case, {"bird.mesh_unit=1 mm"}),
      Catch::Contains("--set: bird.mesh_unit = \"1 mm\": this key is only for a bird with bird.mesh"));
  CHECK_THROWS_WITH(parse(shape_case, {"bird.columns=7"}),
                    Catch::Contains("only for a column") && Catch::Contains("bird.shape = \"cylinder\""));
  CHECK_THROWS_WITH(parse(shape_case, {"bird.parts.wing.porosity=0.1"}),
                    Catch::Contains("bird.parts.wing") && Catch::Contains("one part"));
  CHECK_THROWS_WITH(parse(column_case, {"bird.mass=1 kg"}),
                    Catch::Contains("bird.mass") && Catch::Contains("not a column"));
  CHECK_THROWS_WITH(parse(column_case, {"bird.columns=4"}),
                    Catch::Contains("bird.columns = 4") && Catch::Contains("6 or more"));
  std::string text = shape_case;
  text.erase(text.find("end ="), 14);
  CHECK_THROWS_WITH(parse(text.c_str()), Catch::Contains("run.end is missing"));
}
