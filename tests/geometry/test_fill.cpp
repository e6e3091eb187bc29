// SPDX-License-Identifier: GPL-3.0-or-later
// Particles of a fill: volume, centre, symmetry, who wins, and what is refused.
#include "geometry/fill.h"
#include "geometry/measure.h"
#include "geometry/place.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

#include <algorithm>
#include <cmath>

using namespace birdstrike;
using Catch::Contains;
using test::input_error;

namespace {

SurfacePart ball(double diameter, const Vector3& centre = Vector3::Zero())
{
  SurfaceMesh mesh{make_shape("sphere", {diameter, diameter}, {64, 32})};
  translate(mesh, centre);
  return mesh.front();
}

Vector3 centre_of(const std::vector<Seed>& seeds)
{
  Vector3 sum = Vector3::Zero();
  for (const Seed& seed : seeds)
    sum += seed.position;
  return sum / double(seeds.size());
}

double filled(const Fill& fill, std::size_t part)
{
  return double(fill.parts[part].particles) * std::pow(fill.spacing, 3);
}

} // namespace

TEST_CASE("a block of whole cells is filled exactly, wherever it stands", "[geometry][fill]")
{
  SurfaceMesh mesh{make_box({0.1, 0.05, 0.03})};
  translate(mesh, {0.0123, 0.0045, -0.0321});
  const Fill fill = fill_lattice(mesh, {"torso"}, 0.01);
  REQUIRE(fill.seeds.size() == 10 * 5 * 3);
  CHECK(fill.parts[0].mesh_volume == Approx(1.5e-4));
  CHECK((centre_of(fill.seeds) - Vector3(0.0123, 0.0045, -0.0321)).norm() < 1e-12);
  double smallest = 1;
  for (const Seed& s : fill.seeds)
    smallest = std::min(smallest, s.position.x());
  CHECK(smallest == Approx(0.0123 - 0.045));
}

TEST_CASE("volume and centre of a filled ball come nearer with the spacing", "[geometry][fill]")
{
  const Vector3 centre(0.011, -0.007, 0.003);
  const SurfaceMesh mesh{ball(0.1, centre)};
  const double volume = signed_volume(mesh[0]);
  for (const auto& [spacing, error] : {std::pair{0.01, 0.06}, {0.005, 0.02}, {0.0025, 0.005}}) {
    const Fill fill = fill_lattice(mesh, {"torso"}, spacing);
    CAPTURE(spacing);
    CHECK(filled(fill, 0) == Approx(volume).epsilon(error));
    CHECK((centre_of(fill.seeds) - centre).norm() < 0.02 * spacing);
  }
}

TEST_CASE("a symmetric mesh gets a symmetric lattice", "[geometry][fill]")
{
  for (const double spacing : {0.007, 0.0093}) { // even and odd numbers of cells across
    const Fill fill = fill_lattice({make_shape("capsule", {0.1, 0.2}, {32, 16})}, {"torso"}, spacing);
    std::vector<std::array<double, 3>> left, right;
    for (const Seed& s : fill.seeds) {
      if (s.position.y() > 0)
        left.push_back({s.position.x(), s.position.y(), s.position.z()});
      if (s.position.y() < 0)
        right.push_back({s.position.x(), -s.position.y(), s.position.z()});
    }
    std::sort(left.begin(), left.end());
    std::sort(right.begin(), right.end());
    REQUIRE(!left.empty());
    CHECK(left == right);
  }
}

TEST_CASE("the inner solid wins, and its volume is taken from the outer one", "[geometry][fill]")
{
  const SurfacePart outer = ball(0.1), inner = ball(0.05, {0.01, 0, 0});
  const double outer_volume = signed_volume(outer), inner_volume = signed_volume(inner);
  const SurfaceMesh orders[] = {{outer, inner}, {inner, outer}};
  for (const int k : {0, 1}) {
    const std::vector<std::string> names =
        k == 0 ? std::vector<std::string>{"torso", "bones"} : std::vector<std::string>{"bones", "torso"};
    const Fill fill = fill_lattice(orders[k], names, 0.0025);
    REQUIRE(fill.parts[k].name == "torso");
    CHECK(fill.parts[k].mesh_volume == Approx(outer_volume - inner_volume));
    CHECK(fill.parts[1 - k].mesh_volume == Approx(inner_volume));
    CHECK(filled(fill, 1 - k) == Approx(inner_volume).epsilon(0.02));
    for (const Seed& s : fill.seeds) {
      const double r = (s.position - Vector3(0.01, 0, 0)).norm();
      if (r < 0.0245)
        CHECK(fill.parts[s.part].name == "bones");
      if (r > 0.0255)
        CHECK(fill.parts[s.part].name == "torso");
    }
  }
}

TEST_CASE("solids of three levels each lose only what lies directly within", "[geometry][fill]")
{
  const SurfaceMesh mesh{ball(0.1), ball(0.06), ball(0.03)};
  const Fill fill = fill_lattice(mesh, {"torso", "lungs", "bones"}, 0.003);
  CHECK(fill.parts[0].mesh_volume == Approx(signed_volume(mesh[0]) - signed_volume(mesh[1])));
  CHECK(fill.parts[1].mesh_volume == Approx(signed_volume(mesh[1]) - signed_volume(mesh[2])));
  CHECK(fill.parts[2].mesh_volume == Approx(signed_volume(mesh[2])));
}

TEST_CASE("where two solids merely overlap, the smaller wins", "[geometry][fill]")
{
  const Fill fill = fill_lattice({ball(0.1), ball(0.06, {0.06, 0, 0})}, {"torso", "neck"}, 0.004);
  int in_both = 0;
  for (const Seed& s : fill.seeds)
    if (s.position.norm() < 0.049 && (s.position - Vector3(0.06, 0, 0)).norm() < 0.029) {
      ++in_both;
      CHECK(fill.parts[s.part].name == "neck");
    }
  CHECK(in_both > 20);
  std::vector<std::array<double, 3>> places;
  for (const Seed& s : fill.seeds)
    places.push_back({s.position.x(), s.position.y(), s.position.z()});
  std::sort(places.begin(), places.end());
  CHECK(std::adjacent_find(places.begin(), places.end()) == places.end()); // nobody sits twice
}

TEST_CASE("overlaps and gaps between parts are told with their volume", "[geometry][fill][analytic]")
{
  SurfaceMesh mesh{make_box({0.1, 0.1, 0.1}), make_box({0.06, 0.04, 0.04}), make_box({0.04, 0.05, 0.05})};
  const auto shift = [&](int object, const Vector3& by) {
    for (Vector3& p : mesh[object].points)
      p += by;
  };
  shift(1, {0.07, 0, 0});  // reaches 10 mm into the first: 0.01 x 0.04 x 0.04
  shift(2, {0, 0, 0.078}); // its lower face stands 3 mm above the first
  const Fill fill = fill_lattice(mesh, {"torso", "neck", "head"}, 0.004);
  REQUIRE(fill.overlaps.size() == 1);
  CHECK(fill.overlaps[0].volume == Approx(1.6e-5).epsilon(0.02));
  CHECK(fill.overlaps[0].share == Approx(1.0 / 6).epsilon(0.02));
  REQUIRE(fill.gaps.size() == 1);
  CHECK(fill.gaps[0].volume == Approx(0.04 * 0.05 * 0.003).epsilon(0.05));
  CHECK(fill.parts[0].mesh_volume == Approx(1e-3 - 1.6e-5).epsilon(2e-3)); // the smaller one has the overlap
  CHECK(fill.parts[1].mesh_volume == Approx(9.6e-5).epsilon(1e-2));        // to a line in a hundred
}

TEST_CASE("in the close-packed lattice each particle has twelve nearest neighbours",
          "[geometry][fill][analytic]")
{
  const double spacing = 0.006, nearest = std::pow(2, 1.0 / 6) * spacing;
  const Fill fill = fill_mesh({ball(0.1)}, {"torso"}, {.spacing = spacing, .lattice = "fcc"});
  std::size_t inner = 0;
  for (const Seed& a : fill.seeds) {
    int touching = 0;
    for (const Seed& b : fill.seeds) {
      const double distance = (a.position - b.position).norm();
      CHECK((&a == &b || distance > 0.999 * nearest));
      touching += distance > 0 && distance < 1.001 * nearest;
    }
    if (a.position.norm() < 0.03) {
      ++inner;
      CHECK(touching == 12);
    }
  }
  CHECK(inner > 100);
  CHECK(filled(fill, 0) == Approx(signed_volume(ball(0.1))).epsilon(0.02));
}

TEST_CASE("a number of particles is met as nearly as the lattice can, relaxed exactly", "[geometry][fill]")
{
  for (const char* lattice : {"cubic", "fcc", "leaning"})
    for (const std::size_t wanted : {500u, 5000u}) {
      const Fill fill = fill_mesh({ball(0.1)}, {"torso"}, {.particles = wanted, .lattice = lattice});
      CAPTURE(lattice, wanted, fill.seeds.size());
      CHECK(std::abs(double(fill.seeds.size()) / double(wanted) - 1) < 0.02);
      CHECK(filled(fill, 0) == Approx(signed_volume(ball(0.1))).epsilon(0.04));
    }
  const Fill relaxed = fill_mesh({ball(0.1)}, {"torso"}, {.particles = 777, .lattice = "fcc", .relax = true});
  CHECK(relaxed.seeds.size() == 777);
  CHECK_THAT(
      input_error([] { fill_mesh({ball(0.1)}, {"torso"}, {.spacing = 0.01, .lattice = "hexagonal"}); }),
      Contains("hexagonal") && Contains("cubic, fcc and leaning"));
}

TEST_CASE("relaxed particles stay within their parts, which have their volumes", "[geometry][fill]")
{
  const SurfaceMesh mesh{ball(0.1), ball(0.05, {0.01, 0.005, 0}), ball(0.04, {0.06, 0, 0})};
  const std::vector<std::string> names{"torso", "lungs", "head"};
  const Fill fill = fill_mesh(mesh, names, {.spacing = 0.005, .lattice = "fcc", .relax = true});
  const Solids solids(mesh, 1);
  for (const Seed& seed : fill.seeds) {
    const int owner = solids.owner(seed.position);
    REQUIRE(owner >= 0);
    REQUIRE(names[owner] == fill.parts[seed.part].name);
  }
  for (const FilledPart& part : fill.parts)
    CHECK(double(part.particles) * part.particle_volume == Approx(part.mesh_volume).epsilon(1e-12));
  CHECK(fill.density_deviation < 0.02);
  const Fill again = fill_mesh(mesh, names, {.spacing = 0.005, .lattice = "fcc", .relax = true});
  bool same = again.seeds.size() == fill.seeds.size();
  for (std::size_t i = 0; same && i < fill.seeds.size(); ++i)
    same = again.seeds[i].position == fill.seeds[i].position;
  CHECK(same); // the same bits on every call
}

TEST_CASE("objects of one part are counted together", "[geometry][fill]")
{
  const SurfaceMesh mesh{ball(0.05, {0, 0.1, 0}), ball(0.04), ball(0.05, {0, -0.1, 0})};
  const Fill fill = fill_lattice(mesh, {"wings", "torso", "wings"}, 0.004);
  REQUIRE(fill.parts.size() == 2);
  CHECK(fill.parts[0].name == "wings");
  CHECK(fill.parts[0].mesh_volume == Approx(2 * signed_volume(mesh[0])));
  CHECK(fill.parts[0].particles + fill.parts[1].particles == fill.seeds.size());
}

TEST_CASE("a spacing too fine for the memory is refused with one that fits", "[geometry][fill]")
{
  const SurfaceMesh mesh{ball(0.1)};
  const std::string text = input_error([&] { fill_lattice(mesh, {"torso"}, 1e-6); });
  CHECK_THAT(text, Contains("0.001 mm") && Contains("particles") && Contains("GB") && Contains("fits"));
  CHECK_THAT(input_error([&] { fill_lattice(mesh, {"torso"}, 1e-300); }), Contains("fits"));
  CHECK_THAT(input_error([&] { fill_lattice(mesh, {"torso"}, 0); }), Contains("positive"));
  CHECK_THAT(input_error([&] { fill_lattice(mesh, {"torso"}, std::nan("")); }), Contains("positive"));
}

TEST_CASE("a part too thin for the spacing is named with a remedy", "[geometry][fill]")
{
  SurfaceMesh mesh{make_box({0.1, 0.1, 0.1}), make_box({0.05, 0.05, 0.002})};
  for (Vector3& p : mesh[1].points)
    p.z() += 0.0025; // between the layers, whether they lie in the middle or half a cell off
  const std::string text = input_error([&] { fill_lattice(mesh, {"torso", "bones"}, 0.01); });
  CHECK_THAT(text, Contains("'bones'") && Contains("10 mm") && Contains("or less"));
  double remedy = 0;
  std::sscanf(text.substr(text.find("use a spacing of ")).c_str(), "use a spacing of %lf", &remedy);
  REQUIRE(remedy > 0);
  CHECK_NOTHROW(fill_lattice(mesh, {"torso", "bones"}, 1e-3 * remedy));
}

TEST_CASE("inside-out and open solids are not filled", "[geometry][fill]")
{
  SurfacePart flipped = ball(0.1);
  for (auto& t : flipped.triangles)
    std::swap(t[0], t[1]);
  CHECK_THAT(input_error([&] { fill_lattice({flipped}, {"torso"}, 0.01); }), Contains("inside out"));
  SurfacePart open = ball(0.1);
  open.triangles.pop_back();
  CHECK_THAT(input_error([&] { fill_lattice({open}, {"torso"}, 0.01); }), Contains("open"));
  CHECK_THROWS_AS(fill_lattice({}, {}, 0.01), InputError);
  CHECK_THROWS_AS(fill_lattice({ball(0.1)}, {}, 0.01), InputError);
}
