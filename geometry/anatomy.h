// SPDX-License-Identifier: GPL-3.0-or-later
// A goose in flight made from numbers: outline, wings, bones and lungs.
#pragma once

#include "geometry/implicit.h"
#include "geometry/surface_mesh.h"

#include <string_view>

namespace birdstrike {

//! Cross-section of a wing at a distance from the bird's middle plane.
struct WingSection
{
  double y;             //!< [m]
  double leading_edge;  //!< x [m]
  double trailing_edge; //!< x [m]
  double z;             //!< of the chord [m]
  double thickness;     //!< largest [m]
};

//! Axes: flies towards +x, left wing +y, up +z; the origin lies in the torso's thickest section. Lengths in
//! metres. Sizes marked [A] keep within the ranges for Branta canadensis at
//! liquisearch.com/canada_goose/description (length 0.75-1.10 m, wingspan 1.27-1.85 m, bill 41-68 mm,
//! mass 2.5-6.5 kg) and their means at
//! scienceinsights.org/how-big-are-canadian-geese-size-weight-and-wingspan (3.6-3.9 kg); all else is chosen
//! so that the bird looks right, weighs 4 kg at the densities of nominal_density, and is resolved by
//! particles 6 mm apart.
struct GooseAnatomy
{
  // Torso with tail: sections from the tail's tip to the root of the neck. Total length with neck, head and
  // bill [A].
  std::vector<Section> torso{
      {-0.385, 0.027, 0.0140, 0.0072}, {-0.379, 0.027, 0.0290, 0.0074}, {-0.367, 0.027, 0.0420, 0.0078},
      {-0.348, 0.026, 0.0490, 0.0084}, {-0.320, 0.025, 0.0495, 0.0100}, {-0.280, 0.023, 0.0450, 0.0145},
      {-0.230, 0.017, 0.0450, 0.0275}, {-0.160, 0.004, 0.0618, 0.0493}, {-0.080, -0.006, 0.0773, 0.0657},
      {0.000, -0.010, 0.0831, 0.0734}, {0.070, -0.008, 0.0802, 0.0705}, {0.130, 0.000, 0.0647, 0.0570},
      {0.175, 0.010, 0.0464, 0.0425},  {0.210, 0.018, 0.0330, 0.0320},  {0.235, 0.021, 0.0200, 0.0200}};
  double torso_exponent = 2.2; //!< of the superellipse; 2 is an ellipse [-] (chosen)
  double edge_radius = 0.0068; //!< of the tail's rim (chosen)

  // Neck, stretched forward as in flight: balls along it, from within the chest to the nape (chosen; free
  // flight with a stretched neck after pmc.ncbi.nlm.nih.gov/articles/PMC3812989).
  std::vector<Ball> neck{{{0.238, 0, 0.021}, 0.0280}, {{0.265, 0, 0.025}, 0.0255},
                         {{0.320, 0, 0.031}, 0.0225}, {{0.380, 0, 0.037}, 0.0210},
                         {{0.430, 0, 0.041}, 0.0205}, {{0.457, 0, 0.044}, 0.0210}};

  // Head: skull, cheek and bill; bill 55 mm [A].
  Vector3 skull_centre{0.497, 0, 0.049}, skull_axes{0.041, 0.0265, 0.0285}; //!< (chosen)
  Vector3 brow_centre{0.522, 0, 0.045}, brow_axes{0.028, 0.0170, 0.0180};   //!< (chosen)
  std::vector<Ball> bill{
      {{0.525, 0, 0.040}, 0.0145}, {{0.555, 0, 0.034}, 0.0110}, {{0.577, 0, 0.030}, 0.0085}};
  double bill_flatness = 0.80; //!< height over width of the bill's front [-] (chosen)
  double head_blend = 0.012;   //!< (chosen)

  // Left wing; the right one is its mirror. Wingspan [A]; thick enough for two layers of particles at 6 mm.
  std::vector<WingSection> wing{
      {0.040, 0.118, -0.150, 0.034, 0.0205},  {0.110, 0.118, -0.130, 0.046, 0.0185},
      {0.200, 0.127, -0.110, 0.062, 0.0162},  {0.310, 0.135, -0.092, 0.076, 0.0147},
      {0.430, 0.112, -0.088, 0.081, 0.0134},  {0.560, 0.056, -0.098, 0.080, 0.0125},
      {0.680, -0.020, -0.117, 0.075, 0.0116}, {0.750, -0.082, -0.136, 0.070, 0.0108},
      {0.778, -0.120, -0.147, 0.068, 0.0100}};
  double wing_camber = 0.055;           //!< rise of the middle line over chord [-] (chosen)
  double wing_trailing_radius = 0.0045; //!< half the thickness of the rear edge (chosen)

  // Bones, one body: spine, pelvis, ribs, sternum with keel, coracoids. Depths are below the torso's skin.
  int rib_pairs = 7;                           //!< (chosen; a goose has nine, some of them short)
  double rib_radius = 0.0045;                  //!< thicker than in life, so that particles catch it (chosen)
  double rib_depth = 0.014;                    //!< of the rib's middle (chosen)
  double first_rib = 0.098, last_rib = -0.082; //!< x where they leave the spine (chosen)
  double rib_sweep = 0.045; //!< how far a rib's lower end lies behind its upper one (chosen)
  double spine_radius = 0.0075, spine_depth = 0.020;   //!< (chosen)
  double spine_front = 0.150, spine_rear = -0.205;     //!< x (chosen)
  Vector3 pelvis_axes{0.062, 0.028, 0.010};            //!< semi-axes of a flat ellipsoid (chosen)
  double pelvis_x = -0.135;                            //!< (chosen)
  double sternum_front = 0.110, sternum_rear = -0.095; //!< x (chosen)
  double sternum_height = 0.040;                       //!< of its plate above the skin of the breast (chosen)
  double sternum_half_width = 0.024;                   //!< (chosen)
  double keel_depth = 0.012;                           //!< of the keel's lower edge (chosen)
  double bone_blend = 0.006;                           //!< (chosen)

  // Lungs: two lobes below the spine, between the ribs.
  Vector3 lung_centre{0.010, 0.033, 0.014}; //!< of the left lobe (chosen)
  Vector3 lung_axes{0.078, 0.022, 0.025};   //!< semi-axes (chosen)
  double lung_clearance = 0.003;            //!< to the bones (chosen)

  double wing_overlap = 0.004; //!< how far a wing reaches into the torso, so that no gap is left (chosen)
  double cut_blend = 0.003;    //!< softness of the edges where wings and lungs are cut (chosen)
};

//! Bodies of the parts, as implicit functions; wing is the left one.
struct GooseBodies
{
  Implicit head, neck, torso, wing, bones, lungs;
};
GooseBodies make_goose_bodies(const GooseAnatomy& anatomy);

//! The goose as closed surfaces named head, neck, torso, wing_left, wing_right, bones, lungs.
//! \throw InputError if the numbers make a body that cannot be meshed
SurfaceMesh make_goose(const GooseAnatomy& anatomy = {});

//! Density of a part from the porosities of the dissertation's section 8.3, (1 - z) 1000 kg/m3: head and neck
//! z = 0.3, torso 0.6, wings 0.7, bones 0.2, lungs 0.8.
//! \param part  head, neck, torso, wings, bones or lungs
//! \throw InputError for another name
double nominal_density(std::string_view part);

} // namespace birdstrike
