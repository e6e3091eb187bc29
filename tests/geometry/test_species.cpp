// SPDX-License-Identifier: GPL-3.0-or-later
// Birds made from numbers: sound solids, published sizes, wanted masses, poses; and what cannot be made.
#include "geometry/species.h"

#include "geometry/anatomy.h"
#include "geometry/birds/biometry.h"
#include "geometry/check.h"
#include "geometry/fill.h"
#include "geometry/import/read_mesh.h"
#include "geometry/inside.h"
#include "geometry/part_of_object.h"
#include "geometry/write_surface.h"
#include "temporary_folder.h"

#include <algorithm>
#include <cmath>

using namespace birdstrike;

namespace {

const SurfacePart& part(const SurfaceMesh& bird, const std::string& name)
{
  const auto found = std::find_if(bird.begin(), bird.end(), [&](const auto& p) { return p.name == name; });
  REQUIRE(found != bird.end());
  return *found;
}
double volume(const SurfaceMesh& bird, const std::string& name) { return signed_volume(part(bird, name)); }

bool touch(const SurfaceMesh& bird, const std::string& a, const std::string& b)
{
  const Inside inside(part(bird, b));
  const auto& points = part(bird, a).points;
  return std::any_of(points.begin(), points.end(), [&](const Vector3& p) { return inside.contains(p); });
}

void check_solids(const SurfaceMesh& bird, bool legs)
{
  std::vector<std::string> names{"head", "neck", "torso", "wing_left", "wing_right", "bones", "lungs"};
  if (legs)
    names.insert(names.end(), {"leg_left", "leg_right"});
  REQUIRE(bird.size() == names.size());
  const auto reports = require_solids(bird, "made");
  for (std::size_t i = 0; i < names.size(); ++i) {
    CAPTURE(names[i]);
    CHECK(reports[i].name == names[i]);
    CHECK(reports[i].components == (names[i] == "lungs" ? 2u : 1u));
  }
}

//! Mass of parts at their nominal densities. A little is counted twice where neighbours overlap.
void check_mass(const SurfaceMesh& bird, double wanted)
{
  double mass = 700 * (volume(bird, "head") + volume(bird, "neck")) +
                300 * (volume(bird, "wing_left") + volume(bird, "wing_right")) + 800 * volume(bird, "bones") +
                200 * volume(bird, "lungs") +
                400 * (volume(bird, "torso") - volume(bird, "bones") - volume(bird, "lungs"));
  if (bird.size() > 7)
    mass += 800 * (volume(bird, "leg_left") + volume(bird, "leg_right"));
  CHECK(mass > 0.985 * wanted);
  CHECK(mass < 1.03 * wanted);
}

void check_symmetry(const SurfaceMesh& bird)
{
  const SurfacePart &left = part(bird, "wing_left"), &right = part(bird, "wing_right");
  REQUIRE(left.points.size() == right.points.size());
  double worst = 0;
  for (std::size_t i = 0; i < left.points.size(); ++i)
    worst = std::max(worst, (left.points[i] - right.points[i].cwiseProduct(Vector3(1, -1, 1))).norm());
  CHECK(worst == 0);
  CHECK(signed_volume(left) == Approx(signed_volume(right)).epsilon(1e-9));
  const double width = bounding_box(part(bird, "torso")).upper.y();
  for (const char* middle : {"head", "neck", "torso", "bones", "lungs"}) {
    CAPTURE(middle);
    CHECK(std::abs(volume_centre(part(bird, middle)).y()) < 0.02 * width);
  }
}

void check_joints(const SurfaceMesh& bird)
{
  CHECK((touch(bird, "neck", "torso") || touch(bird, "torso", "neck")));
  CHECK((touch(bird, "neck", "head") || touch(bird, "head", "neck")));
  CHECK(touch(bird, "wing_left", "torso"));
  CHECK(touch(bird, "wing_right", "torso"));
  const Inside torso(part(bird, "torso"));
  for (const char* inner : {"bones", "lungs"})
    for (const Vector3& p : part(bird, inner).points)
      REQUIRE(torso.contains(p));
  if (bird.size() > 7)
    CHECK(touch(bird, "leg_left", "torso"));
}

void check_bird(const BirdForm& form)
{
  const Biometry& size = biometry_of(form.species);
  const double mass = form.mass == 0 ? size.mass.typical : form.mass;
  const double scale = std::cbrt(mass / size.mass.typical);
  const SurfaceMesh bird = make_bird(form);
  check_solids(bird, form.legs);
  check_mass(bird, mass);
  check_symmetry(bird);
  check_joints(bird);
  const Box box = bounding_box(bird);
  const Vector3 lengths = box.upper - box.lower;
  if (form.neck == NeckPose::out)
    CHECK(lengths.x() == Approx(scale * size.length.typical).epsilon(0.03));
  else
    CHECK(lengths.x() < 0.99 * scale * size.length.typical);
  const double span = lengths.y() / (scale * size.wingspan.typical);
  if (form.wings == WingPose::spread)
    CHECK(span == Approx(1).epsilon(0.03));
  else if (form.wings == WingPose::half_folded)
    CHECK(span == Approx(0.52).margin(0.05));
  else
    CHECK(span < 0.25);
  CHECK(bounding_box(part(bird, "head")).upper.x() == box.upper.x());
  CHECK(bounding_box(part(bird, "torso")).lower.x() == box.lower.x());
}

BirdForm coarse(std::string_view species, NeckPose neck, WingPose wings, bool legs, double mass = 0)
{
  BirdForm form{std::string(species), mass, neck, wings, legs, 0};
  form.detail = biometry_of(species).length.typical / 25;
  return form;
}

} // namespace

TEST_CASE("a mallard of 4 lb in flight is scaled from published sizes", "[geometry][species]")
{
  check_bird(coarse("mallard", NeckPose::out, WingPose::spread, false, 1.814));
}

TEST_CASE("a herring gull with its neck drawn in, wings half folded and legs", "[geometry][species]")
{
  check_bird(coarse("herring-gull", NeckPose::drawn_in, WingPose::half_folded, true));
}

TEST_CASE("a starling with folded wings fills to the wanted mass, and comes back from a CAD file",
          "[geometry][species]")
{
  const SurfaceMesh bird = make_bird(coarse("starling", NeckPose::drawn_in, WingPose::folded, false));
  check_solids(bird, false);
  check_joints(bird);
  std::vector<std::string> parts;
  for (const SurfacePart& p : bird)
    parts.push_back(part_of_object(p.name));
  const double spacing = 0.0012;
  const Fill fill = fill_lattice(bird, parts, spacing);
  double mass = 0;
  for (const FilledPart& p : fill.parts)
    mass += double(p.particles) * std::pow(spacing, 3) * nominal_density(p.name);
  CHECK(mass == Approx(0.0823).epsilon(0.03));

  const test::TemporaryFolder folder;
  write_surface(bird, folder / "starling.glb");
  const SurfaceMesh back = read_mesh(folder / "starling.glb");
  check_solids(back, false);
  for (const SurfacePart& p : bird) {
    CAPTURE(p.name);
    CHECK(volume(back, p.name) == Approx(signed_volume(p)).epsilon(1e-4));
    CHECK((volume_centre(part(back, p.name)) - volume_centre(p)).norm() < 1e-6);
  }
}

TEST_CASE("every species in every pose is sound and as published", "[geometry][species][long]")
{
  for (const std::string_view species : species_names())
    for (const NeckPose neck : {NeckPose::out, NeckPose::drawn_in})
      for (const WingPose wings : {WingPose::spread, WingPose::half_folded, WingPose::folded}) {
        CAPTURE(species, int(neck), int(wings));
        check_bird(coarse(species, neck, wings, neck == NeckPose::drawn_in));
      }
}

TEST_CASE("every species at the detail of its size is sound", "[geometry][species][long]")
{
  for (const std::string_view species : species_names()) {
    CAPTURE(species);
    BirdForm form;
    form.species = species;
    check_bird(form);
  }
}

TEST_CASE("a bird that cannot be made is refused with what is known", "[geometry][species]")
{
  BirdForm form;
  form.species = "duck";
  CHECK_THAT(test::input_error([&] { make_bird(form); }),
             Catch::Contains("'duck'") && Catch::Contains("canada-goose, mallard, herring-gull, starling"));
  form.species = "starling";
  for (double mass : {-0.08, 0.02, 4.0, std::nan("")}) {
    CAPTURE(mass);
    form.mass = mass;
    CHECK_THAT(test::input_error([&] { make_bird(form); }), Catch::Contains("0.058 kg to 0.101 kg"));
  }
  form.mass = 0;
  for (double detail : {-1.0, 1e-6, std::nan("")}) {
    CAPTURE(detail);
    form.detail = detail;
    CHECK_THAT(test::input_error([&] { make_bird(form); }), Catch::Contains("thousandth"));
  }
}

TEST_CASE("a mass outside of what a species weighs is remarked", "[geometry][species]")
{
  BirdForm form;
  form.species = "mallard";
  CHECK(mass_remark(form).empty());
  form.mass = 1.5;
  CHECK(mass_remark(form).empty());
  form.mass = 1.814;
  CHECK_THAT(mass_remark(form), Catch::Contains("0.72 kg to 1.58 kg, not 1.814 kg"));
}
