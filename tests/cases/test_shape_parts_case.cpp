// SPDX-License-Identifier: GPL-3.0-or-later
// Heterogeneous substitute birds of a case: mass, size, echo, what is refused, and the birds of chapter 8.
#include "cases/shape_parts_case.h"

#include "cases/build_bird.h"
#include "cases/build_shape.h"
#include "cases/log.h"
#include "cases/share_folder.h"
#include "core/material/porous_bird.h"
#include "scratch.h"

#include <catch2/catch.hpp>

using namespace birdstrike;
using Catch::Contains;

namespace {

std::string case_with(const std::string& parts)
{
  return R"(title = "heterogeneous"
[bird]
shape = "capsule"
mass = "0.55 kg"
spacing = "6 mm"
velocity = "150 m/s"
[target]
plate = { size = ["0.5 m", "0.4 m"], thickness = "5 mm", elements = [10, 8] }
[run]
end = "0.4 ms"
[bird.parts]
)" + parts;
}

const std::string mixture =
    case_with("a = { porosity = 0.2, share = 0.6 }\nb = { porosity = 0.3, share = 0.4 }\n");
const std::string lumps = case_with("torso = { porosity = 0.6, place = \"rest\" }\n"
                                    "bones = { porosity = 0.2, place = \"ribs\" }\n"
                                    "lungs = { porosity = 0.8, place = \"core\" }\n");

Case parse(const std::string& text, const std::vector<std::string>& overrides = {})
{
  const scratch::Folder folder;
  return read_case(folder.write("case.toml", text), overrides);
}

BuiltBird build(const Case& parsed)
{
  Log log(true);
  return build_bird(parsed, log);
}

} // namespace

TEST_CASE("a mixture weighs what it should at the densities of its parts", "[cases][mixture]")
{
  const Case parsed = parse(mixture);
  CHECK(mean_density(parsed) == Approx(0.6 * porous_density(0.2) + 0.4 * porous_density(0.3)));
  const BuiltBird bird = build(parsed);
  CHECK(std::abs(total_mass(bird.particles) / 0.55 - 1) < 1e-12);
  CHECK(bird.density_factor == Approx(1).epsilon(0.01));
  CHECK(bird.parts[0].mesh_volume + bird.parts[1].mesh_volume ==
        Approx(shape_volume("capsule", size_of_shape(parsed))));
  const double all = double(bird.parts[0].particles + bird.parts[1].particles);
  CHECK(double(bird.parts[0].particles) / all == Approx(0.6).margin(1 / all));
  // Another seed moves the parts and nothing else.
  const BuiltBird other = build(parse(mixture, {"bird.seed=2"}));
  CHECK(other.particles.x == bird.particles.x);
  CHECK(other.particles.part != bird.particles.part);
  CHECK(build(parse(mixture, {"bird.seed=1"})).particles.mass == bird.particles.mass);
}

TEST_CASE("a bird with ribs and core has the mean density of their volumes", "[cases][lumps]")
{
  const Case parsed = parse(lumps, {"bird.spacing=3 mm"});
  const BuiltBird bird = build(parsed);
  REQUIRE(bird.parts.size() == 3);
  double volume = 0, mass = 0;
  for (const PartReport& part : bird.parts) {
    volume += part.mesh_volume;
    mass += part.mesh_volume * porous_density(part.porosity);
    CHECK(part.particle_volume == Approx(part.mesh_volume).epsilon(0.1));
  }
  CHECK(mass == Approx(0.55));
  CHECK(volume == Approx(shape_volume("capsule", size_of_shape(parsed))));
  CHECK(mean_density(parsed) == Approx(mass / volume));
  CHECK(std::abs(total_mass(bird.particles) / 0.55 - 1) < 1e-12);
  CHECK(bird.density_factor == Approx(1).epsilon(0.03));
  // Denser bones: the same shares of a smaller bird.
  const Case dense = parse(lumps, {"bird.parts.bones.porosity=0"});
  CHECK(size_of_shape(dense).diameter < size_of_shape(parsed).diameter);
  CHECK(share_of_place("capsule", size_of_shape(dense), {{"t", Place::rest}, {"b", Place::ribs}}, Place::ribs,
                       dense.bird.ribs, {}) == Approx(bird.parts[1].mesh_volume / volume));
}

TEST_CASE("the echo of a heterogeneous bird is the same bird", "[cases][mixture][lumps]")
{
  for (const std::string& text : {mixture, lumps}) {
    const Case parsed = parse(text);
    const std::string echo = to_toml(parsed);
    INFO(echo);
    const Case again = parse(echo);
    CHECK(to_toml(again) == echo);
    CHECK(build(again).particles.part == build(parsed).particles.part);
  }
  CHECK(to_toml(parse(lumps)).find("ribs.depth = 0.2") != std::string::npos);
  CHECK(to_toml(parse(lumps)).find("seed") == std::string::npos);
  CHECK(to_toml(parse(mixture)).find("seed = 1") != std::string::npos);
  CHECK(to_toml(parse(mixture)).find("place") == std::string::npos);
}

TEST_CASE("heterogeneous birds that make no sense are refused", "[cases][mixture][lumps][errors]")
{
  CHECK_THROWS_WITH(parse(mixture, {"bird.parts.b.share=0.3"}),
                    Contains("case.toml: bird.parts") && Contains("a 0.6, b 0.3 sum to 0.9"));
  CHECK_THROWS_WITH(parse(mixture, {"bird.parts.b.share=0"}),
                    Contains("bird.parts.b.share") && Contains("above 0"));
  CHECK_THROWS_WITH(parse(mixture, {"bird.parts.c.porosity=0.1"}), Contains("bird.parts.c.share is missing"));
  CHECK_THROWS_WITH(parse(mixture, {"bird.parts.b.place=ribs"}),
                    Contains("bird.parts.b") && Contains("both"));
  CHECK_THROWS_WITH(parse(lumps, {"bird.parts.fat.porosity=0.1"}),
                    Contains("bird.parts.fat.place is missing"));
  CHECK_THROWS_WITH(parse(lumps, {"bird.parts.lungs.place=middle"}),
                    Contains("one of \"rest\", \"ribs\", \"core\""));
  CHECK_THROWS_WITH(parse(lumps, {"bird.parts.lungs.place=rest"}), Contains("exactly one part must be the"));
  CHECK_THROWS_WITH(parse(lumps, {"bird.ribs.depth=1.5"}), Contains("bird.ribs.depth") && Contains("1"));
  CHECK_THROWS_WITH(parse(lumps, {"bird.ribs.depth=0.9"}),
                    Contains("case.toml") && Contains("reaches into the ribs"));
  CHECK_THROWS_WITH(parse(lumps, {"bird.seed=2"}), Contains("only for a bird.shape with a share"));
  CHECK_THROWS_WITH(parse(mixture, {"bird.core.length=0.5"}), Contains("only for") && Contains("core"));
  CHECK_THROWS_WITH(build(parse(lumps, {"bird.ribs.width=0.001", "bird.ribs.number=1"})),
                    Contains("bird.spacing") && Contains("part bones holds no particle"));
  const std::string bare = case_with("a = { porosity = 0.2 }\nb = { porosity = 0.3 }\n");
  CHECK_THROWS_WITH(parse(bare), Contains("bird.parts.b") && Contains("one part") &&
                                     Contains("share = 0.4") && Contains("place ="));
  CHECK_THROWS_WITH(parse(case_with("a = { porosity = 0.2, place = \"ribs\" }\n")), Contains("none is"));
}

TEST_CASE("the birds of chapter 8 can be built", "[cases][mixture][lumps]")
{
  for (const char* number : {"01", "02", "05", "08", "10", "11", "12", "14", "15", "17", "18"}) {
    INFO(number);
    const Case parsed =
        read_case(find_case(std::string("dissertation/figure-8-") + number), {"bird.spacing=14 mm"});
    CHECK(parsed.bird.velocity == 150);
    const BuiltBird bird = build(parsed);
    CHECK(std::abs(total_mass(bird.particles) / 4 - 1) < 1e-12);
    CHECK(bird.parts.size() == parsed.bird.parts.size());
    CHECK(std::abs(bird.density_factor - 1) <
          0.3); // far off only where 8.3.3 keeps the mass of a denser torso
  }
}
