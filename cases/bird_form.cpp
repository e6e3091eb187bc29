// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/bird_form.h"

#include "core/error.h"
#include "geometry/birds/biometry.h"

#include <fmt/format.h>

#include <algorithm>

namespace birdstrike {
namespace {

//! Row of a name, which stands for the enumerator of that value.
int row_of(const std::string& name, const std::vector<std::string>& names, const char* what)
{
  const auto at = std::find(names.begin(), names.end(), name);
  require(at != names.end(),
          fmt::format("there is no pose of the {} \"{}\"; known are {}", what, name, fmt::join(names, ", ")));
  return static_cast<int>(at - names.begin());
}

} // namespace

std::vector<std::string> neck_names() { return {"out", "drawn-in"}; }
std::vector<std::string> wing_names() { return {"spread", "half-folded", "folded"}; }

double species_mass(const std::string& species) { return biometry_of(species).mass.typical; }

BirdForm form_of(const BirdCase& bird)
{
  BirdForm form;
  form.species = bird.species;
  form.mass = bird.mass;
  form.neck = static_cast<NeckPose>(row_of(bird.neck, neck_names(), "neck"));
  form.wings = static_cast<WingPose>(row_of(bird.wings, wing_names(), "wings"));
  form.legs = bird.legs;
  return form;
}

} // namespace birdstrike
