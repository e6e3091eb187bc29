// SPDX-License-Identifier: GPL-3.0-or-later
// Published sizes and weights of birds: the table.
#include "geometry/birds/biometry.h"

#include "core/error.h"

#include <cmath>
#include <string>

namespace birdstrike {

// Marks as in share/materials: F found at the address given; M as literature commonly quotes it, not verified.
// Where a source gives only a range, its middle is taken as typical. Sources of a species below its row:
const std::vector<Biometry>& biometry_table()
{
  static const std::vector<Biometry> table{
      {"canada-goose",
       "Canada goose",
       "Branta canadensis",
       {3.75, 2.5, 6.5},
       {0.925, 0.75, 1.10},
       {1.56, 1.27, 1.85},
       {0.47, 0.39, 0.55},
       {0.0545, 0.041, 0.068},
       {0.0875, 0.069, 0.106},
       0.28},
      // F liquisearch.com/canada_goose/description: ranges. F scienceinsights.org/how-big-are-canadian-geese-
      // size-weight-and-wingspan: males 3.9 kg, females 3.6 kg. M: wing area.
      {"mallard",
       "mallard",
       "Anas platyrhynchos",
       {1.082, 0.72, 1.58},
       {0.575, 0.50, 0.65},
       {0.895, 0.81, 0.98},
       {0.2815, 0.257, 0.306},
       {0.0525, 0.044, 0.061},
       {0.0445, 0.041, 0.048},
       0.095},
      // F bris.linnaeus.naturalis.nl (taxon 112218): 1082 g (720-1580) after Dunning 1993.
      // F pafoszoo.com/birds/mallard-duck: lengths. M: wing area.
      {"herring-gull",
       "herring gull",
       "Larus argentatus",
       {1.135, 0.71, 1.525},
       {0.61, 0.55, 0.67},
       {1.40, 1.25, 1.55},
       {0.43, 0.38, 0.48},
       {0.0545, 0.044, 0.065},
       {0.064, 0.053, 0.075},
       0.20},
      // F bris.linnaeus.naturalis.nl (taxon 112366): males 1226 g, females 1044 g after Dunning 1993.
      // F viapontica.org/en/european-herring-gull-larus-argentatus: ranges. M: wing area.
      {"starling",
       "common starling",
       "Sturnus vulgaris",
       {0.0823, 0.058, 0.101},
       {0.21, 0.19, 0.23},
       {0.375, 0.31, 0.44},
       {0.128, 0.118, 0.138},
       {0.0285, 0.025, 0.032},
       {0.0295, 0.027, 0.032},
       0.0192},
      // F bris.linnaeus.naturalis.nl (taxon 112534): males 84.7 g, females 79.9 g after Dunning 1993.
      // F zalansite.site/mediawiki (Common_starling, copy of Wikipedia, after Feare): ranges. M: wing area.
      {"rock-pigeon",
       "rock pigeon",
       "Columba livia",
       {0.309, 0.238, 0.380},
       {0.33, 0.29, 0.37},
       {0.67, 0.62, 0.72},
       {0.223, 0.218, 0.228},
       {0.018, 0.017, 0.019},
       {0.0305, 0.026, 0.035},
       0.063},
      // F listoften10.blogspot.com/p/rock-dove-pigeon.html (copy of Wikipedia): ranges; chord and bill are
      // given there as "around", their ranges here are M. M: wing area.
      {"vulture",
       "turkey vulture",
       "Cathartes aura",
       {1.80, 0.80, 2.30},
       {0.67, 0.62, 0.81},
       {1.71, 1.60, 1.83},
       {0.51, 0.49, 0.55},
       {0.024, 0.022, 0.026},
       {0.066, 0.062, 0.070},
       0.44},
      // F liquisearch.com/turkey_vulture/description: ranges. F Know Your Birds of Prey (CD-ROM, 1995): means
      // 67 cm, 171 cm, 1.8 kg. M: chord, bill, tarsus, wing area.
  };
  return table;
}

const Biometry& biometry_of(std::string_view species)
{
  std::string names;
  for (const Biometry& b : biometry_table()) {
    if (b.name == species)
      return b;
    names += (names.empty() ? "" : ", ") + std::string(b.name);
  }
  throw InputError("no bird '" + std::string(species) + "' is known; known are " + names);
}

double body_frontal_area(double mass, bool passerine)
{
  return passerine ? 0.0129 * std::pow(mass, 0.614) : 0.00813 * std::pow(mass, 0.666);
}

} // namespace birdstrike
