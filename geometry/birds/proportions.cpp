// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of a bird where no measured length says it: the table.
#include "geometry/birds/proportions.h"

#include "core/error.h"

#include <algorithm>

namespace birdstrike {

namespace {

// All chosen, to look like the bird in flight. Share of the wings in the mass: higher than in life for wings
// thick enough to be filled with particles, as in the goose of geometry/anatomy.h (26 %).
std::vector<Proportions> make_table()
{
  Proportions goose;
  goose.name = "canada-goose";
  goose.passerine = false;
  goose.core = 0.475;
  goose.tail = 0.135;
  goose.skull = 0.09;
  goose.tail_half_thickness = 0.0072;
  goose.tail_rows = {{0, 0.026}, {0.06, 0.036}, {0.2, 0.048}, {0.45, 0.051}, {0.75, 0.047}};
  goose.flatness = 1.13;
  goose.neck_base = 0.36;
  goose.neck_top = 0.74;
  goose.skull_half_width = 0.34;
  goose.skull_half_height = 0.36;
  goose.bill_base = 0.26;
  goose.bill_middle = 0.20;
  goose.bill_tip = 0.14;
  goose.bill_flatness = 0.85;
  goose.bill_droop = 0.16;
  goose.wing = {{0, 0, 1.22, 0},
                {0.15, 0.015, 1.24, 0.030},
                {0.30, 0.032, 1.24, 0.055},
                {0.42, 0.038, 1.20, 0.066},
                {0.56, 0.005, 1.10, 0.070},
                {0.72, -0.065, 0.92, 0.064},
                {0.86, -0.140, 0.64, 0.054},
                {0.95, -0.205, 0.37, 0.046},
                {0.98, -0.236, 0.22, 0.044},
                {1, -0.255, 0.03, 0.042}};
  goose.shoulder = 0.26;
  goose.wing_share = 0.24;
  goose.fingers = 0;
  goose.slot = 0;
  goose.webbed = true;

  Proportions mallard = goose;
  mallard.name = "mallard";
  mallard.core = 0.525;
  mallard.tail = 0.135;
  mallard.skull = 0.105;
  mallard.tail_rows = {{0, 0.012}, {0.08, 0.022}, {0.3, 0.036}, {0.6, 0.046}, {0.85, 0.049}};
  mallard.flatness = 1.10;
  mallard.neck_base = 0.5;
  mallard.neck_top = 0.8;
  mallard.skull_half_width = 0.33;
  mallard.skull_half_height = 0.37;
  mallard.bill_base = 0.185;
  mallard.bill_middle = 0.19;
  mallard.bill_tip = 0.2;
  mallard.bill_flatness = 0.42;
  mallard.bill_droop = 0.18;
  mallard.wing = {{0, 0, 1.20, 0},
                  {0.14, 0.035, 1.24, 0.030},
                  {0.28, 0.068, 1.24, 0.052},
                  {0.40, 0.075, 1.16, 0.062},
                  {0.54, 0.020, 1.04, 0.062},
                  {0.70, -0.075, 0.84, 0.052},
                  {0.85, -0.180, 0.56, 0.038},
                  {0.95, -0.265, 0.30, 0.026},
                  {0.98, -0.299, 0.17, 0.023},
                  {1, -0.320, 0.03, 0.020}};
  mallard.wing_share = 0.20;

  Proportions gull = goose;
  gull.name = "herring-gull";
  gull.core = 0.465;
  gull.tail = 0.235;
  gull.skull = 0.115;
  gull.tail_half_thickness = 0.0068;
  gull.tail_rows = {{0, 0.076}, {0.05, 0.088}, {0.3, 0.083}, {0.65, 0.064}};
  gull.flatness = 1.08;
  gull.neck_base = 0.62;
  gull.neck_top = 0.94;
  gull.skull_half_width = 0.37;
  gull.skull_half_height = 0.41;
  gull.bill_base = 0.13;
  gull.bill_middle = 0.095;
  gull.bill_tip = 0.075;
  gull.bill_flatness = 1.45;
  gull.bill_droop = 0.17;
  gull.wing = {{0, 0, 1.10, 0},
               {0.12, 0.035, 1.16, 0.040},
               {0.26, 0.085, 1.20, 0.082},
               {0.38, 0.112, 1.18, 0.104},
               {0.48, 0.100, 1.12, 0.108},
               {0.62, 0.045, 1.00, 0.098},
               {0.78, -0.045, 0.78, 0.070},
               {0.91, -0.145, 0.46, 0.034},
               {0.98, -0.207, 0.21, 0.012},
               {1, -0.225, 0.03, 0.006}};
  gull.shoulder = 0.24;
  gull.wing_share = 0.26;

  Proportions starling = goose;
  starling.name = "starling";
  starling.passerine = true;
  starling.core = 0.470;
  starling.tail = 0.205;
  starling.skull = 0.137;
  starling.tail_half_thickness = 0.0072;
  starling.tail_rows = {{0, 0.056}, {0.05, 0.060}, {0.3, 0.055}, {0.65, 0.049}};
  starling.flatness = 1.05;
  starling.neck_base = 0.72;
  starling.neck_top = 1.0;
  starling.skull_half_width = 0.38;
  starling.skull_half_height = 0.4;
  starling.bill_base = 0.125;
  starling.bill_middle = 0.078;
  starling.bill_tip = 0.036;
  starling.bill_flatness = 0.95;
  starling.bill_droop = 0.16;
  starling.wing = {{0, 0, 1.42, 0},
                   {0.14, 0.045, 1.42, 0.030},
                   {0.27, 0.080, 1.34, 0.050},
                   {0.38, 0.080, 1.20, 0.058},
                   {0.54, 0.015, 0.98, 0.058},
                   {0.70, -0.085, 0.76, 0.050},
                   {0.85, -0.205, 0.50, 0.040},
                   {0.95, -0.300, 0.26, 0.032},
                   {0.98, -0.334, 0.14, 0.030},
                   {1, -0.355, 0.03, 0.028}};
  starling.shoulder = 0.27;
  starling.wing_share = 0.20;
  starling.webbed = false;

  Proportions pigeon = starling;
  pigeon.name = "rock-pigeon";
  pigeon.passerine = false;
  pigeon.core = 0.500;
  pigeon.tail = 0.235;
  pigeon.skull = 0.103;
  pigeon.tail_rows = {{0, 0.074}, {0.05, 0.086}, {0.25, 0.084}, {0.6, 0.064}};
  pigeon.flatness = 1.08;
  pigeon.neck_base = 0.62;
  pigeon.neck_top = 0.92;
  pigeon.skull_half_width = 0.4;
  pigeon.skull_half_height = 0.44;
  pigeon.bill_base = 0.16;
  pigeon.bill_middle = 0.115;
  pigeon.bill_tip = 0.085;
  pigeon.bill_flatness = 1.0;
  pigeon.bill_droop = 0.26;
  pigeon.wing = {{0, 0, 1.28, 0},
                 {0.14, 0.050, 1.34, 0.040},
                 {0.27, 0.092, 1.34, 0.072},
                 {0.38, 0.098, 1.26, 0.086},
                 {0.54, 0.045, 1.06, 0.090},
                 {0.70, -0.050, 0.82, 0.086},
                 {0.85, -0.170, 0.56, 0.080},
                 {0.95, -0.265, 0.32, 0.076},
                 {0.98, -0.302, 0.19, 0.075},
                 {1, -0.325, 0.03, 0.074}};
  pigeon.shoulder = 0.26;
  pigeon.wing_share = 0.20;

  Proportions vulture = goose;
  vulture.name = "vulture";
  vulture.core = 0.475;
  vulture.tail = 0.335;
  vulture.skull = 0.078;
  vulture.tail_half_thickness = 0.0062;
  vulture.tail_rows = {{0, 0.034}, {0.05, 0.056}, {0.16, 0.076}, {0.35, 0.082}, {0.7, 0.068}};
  vulture.flatness = 1.12;
  vulture.neck_base = 0.52;
  vulture.neck_top = 0.9;
  vulture.skull_half_width = 0.30;
  vulture.skull_half_height = 0.34;
  vulture.bill_base = 0.28;
  vulture.bill_middle = 0.24;
  vulture.bill_tip = 0.17;
  vulture.bill_flatness = 1.35;
  vulture.bill_droop = 0.42;
  vulture.wing = {{0, 0, 1.02, 0},
                  {0.12, 0.022, 1.08, 0.030},
                  {0.26, 0.050, 1.13, 0.072},
                  {0.40, 0.062, 1.14, 0.112},
                  {0.55, 0.048, 1.10, 0.150},
                  {0.70, 0.018, 1.03, 0.185},
                  {0.84, -0.018, 0.97, 0.220},
                  {0.93, -0.045, 0.93, 0.248},
                  {1, -0.070, 0.88, 0.272}};
  vulture.shoulder = 0.27;
  vulture.wing_share = 0.30;
  vulture.fingers = 6;
  vulture.slot = 0.20;
  vulture.webbed = false;

  return {goose, mallard, gull, starling, pigeon, vulture};
}

} // namespace

const Proportions& proportions_of(std::string_view species)
{
  static const std::vector<Proportions> table = make_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Proportions& p) { return p.name == species; });
  require(found != table.end(), "no proportions of the bird '" + std::string(species) + "' are known");
  return *found;
}

} // namespace birdstrike
