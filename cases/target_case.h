// SPDX-License-Identifier: GPL-3.0-or-later
// The target of a case file.
#pragma once

#include "geometry/targets/blade.h"
#include "geometry/targets/leading_edge.h"
#include "geometry/targets/windshield.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace birdstrike {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

struct TargetPartCase
{
  std::string name;
  double thickness = not_given; //!< [m]
  std::string material;         //!< empty: that of the target
};

struct SupportCase
{
  std::string name;
  std::string nodes;                                           //!< a node set of the mesh; empty: by the box
  std::array<double, 3> low{not_given, not_given, not_given};  //!< corner of a box [m]
  std::array<double, 3> high{not_given, not_given, not_given}; //!< opposite corner [m]
  std::string fix = "clamped";                                 //!< of support_kinds(), or components
};

struct DeflectionCase
{
  std::string name;
  std::array<double, 3> at{}; //!< place before the load; the nearest node is followed [m]
};

struct TargetCase
{
  std::string shape = "plate";
  std::array<double, 2> size{};           //!< of a plate, along y and z [m]
  double thickness = 0;                   //!< of a plate [m]
  std::array<int, 2> elements{1, 1};      //!< of a plate, along y and z
  std::array<double, 2> refinement{1, 1}; //!< of a plate: largest over smallest element, along y and z [-]
  LeadingEdge leading_edge;
  Windshield windshield;
  Blade blade;
  std::string mesh;                  //!< file, for shape "mesh"
  double mesh_unit = 1;              //!< [m]
  double mesh_thickness = not_given; //!< of the parts of a mesh that have none [m]

  bool rigid = true;
  std::string contact = "mirror"; //!< or "penalty"
  double friction = 0;            //!< [-]
  double contact_stiffness = 1;   //!< on the derived one [-]

  std::string material;                    //!< file of share/materials or beside the case
  bool failure = true;                     //!< by the law of the material
  int points = 5;                          //!< through the thickness
  double hourglass = 0.05, drilling = 0.1; //!< [-]
  bool warping = true;
  double courant = 0.9;                                               //!< [-]
  double damping = 0;                                                 //!< [1/s]
  double failed_share = 1;                                            //!< [-]
  double spin = 0;                                                    //!< [rad/s]
  std::array<double, 3> spin_axis{not_given, not_given, not_given};   //!< direction [-]
  std::array<double, 3> spin_centre{not_given, not_given, not_given}; //!< a point of the axis [m]

  bool free = false; //!< nothing holds the target
  std::vector<TargetPartCase> parts;
  std::vector<SupportCase> supports;
};

//! Names for target.shape.
std::vector<std::string> target_shapes();

//! "clamped", "simply-supported", "symmetry-x", "symmetry-y", "symmetry-z"; besides, any list of x y z rx ry rz.
std::vector<std::string> support_kinds();

} // namespace birdstrike
