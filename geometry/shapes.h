// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds and test bodies as closed surfaces, axis along x, centred on the origin.
#pragma once

#include "geometry/surface_mesh.h"

#include <string_view>

namespace birdstrike {

//! Facets that a shape gets. The facets are blown up so that they enclose exactly the smooth shape's volume.
struct Facets
{
  int around = 96; //!< about the axis
  int along = 48;  //!< from pole to pole
};

//! Outer size of a body of revolution about x. A sphere has length = diameter.
struct ShapeSize
{
  double diameter; //!< D [m]
  double length;   //!< L, rounded ends included [m]
};

//! Names of shape_size and make_shape: "sphere", "cylinder", "capsule" (hemispherical-ended cylinder),
//! "spheroid" (prolate). The usual substitute birds; see Heimbs, Comput. Struct. 89 (2011) 2093.
std::vector<std::string_view> shape_names();

//! Size of the shape that holds a mass, with V = mass / density and a = L/D:
//!   sphere    V = pi D^3 / 6                 (aspect must be 1)
//!   cylinder  V = pi D^3 a / 4
//!   capsule   V = pi D^3 (3a - 1) / 12       (a >= 1; 4 lb at 938 kg/m3 and a = 2: D = 0.114 m)
//!   spheroid  V = pi D^3 a / 6
//! \param mass     [kg]
//! \param density  [kg/m3]
//! \param aspect   L/D [-]
//! \throw InputError for an unknown name (lists the known ones), or a mass, density or aspect out of range
ShapeSize shape_size(std::string_view name, double mass, double density, double aspect);

//! Volume of the smooth shape [m3]: the formulas above.
double shape_volume(std::string_view name, const ShapeSize& size);

//! Square of the shape's radius at \p x from its middle; negative beyond its ends [m2].
//! \throw InputError for an unknown name
double squared_radius(std::string_view name, const ShapeSize& size, double x);

//! Closed, outward oriented surface of that shape; its volume equals shape_volume to rounding. The part's
//! name is the shape's. \throw InputError for an unknown name, a size out of range, or fewer than 8 facets
//! around or 4 along
SurfacePart make_shape(std::string_view name, const ShapeSize& size, const Facets& facets = {});

//! Rectangular block of 12 triangles, centred on the origin, named "box".
//! \param size  edge lengths along x, y, z [m]
//! \throw InputError unless they are positive
SurfacePart make_box(const Vector3& size);

} // namespace birdstrike
