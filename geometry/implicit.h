// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies as functions of a point: negative inside, about the distance to the surface outside. They blend.
#pragma once

#include "core/types.h"

#include <functional>
#include <vector>

namespace birdstrike {

//! [m] at a point [m]; only the zero surface is exact, the distance elsewhere is a fair estimate.
using Implicit = std::function<double(const Vector3&)>;

//! A ball of the given radius at a point of a chain.
struct Ball
{
  Vector3 centre; //!< [m]
  double radius;  //!< [m]
};

//! Distance to the hull of two balls (a rod with a taper).
double tapered_rod(const Vector3& point, const Ball& a, const Ball& b);

Implicit ellipsoid(const Vector3& centre, const Vector3& semi_axes);
//! Flat plate normal to z with an elliptic outline and a round rim of radius \p half_thickness [m].
Implicit elliptic_plate(const Vector3& centre, double semi_x, double semi_y, double half_thickness);

//! A round body along the curve through the balls (monotone in each coordinate and in the radius), made of
//! \p per_span hulls between each two.
Implicit chain(const std::vector<Ball>& balls, int per_span);

//! Smaller of the two, rounded where they differ by less than \p blend [m]: joins bodies with a fillet.
double blended_minimum(double a, double b, double blend);
//! Larger of the two, rounded likewise: cuts with a soft edge.
double blended_maximum(double a, double b, double blend);

Implicit unite(std::vector<Implicit> bodies, double blend);
//! What of \p body is at least \p clearance away from \p tool (negative: reaches into it).
Implicit cut(Implicit body, Implicit tool, double clearance, double blend);

//! Cross-section of a body along x: a superellipse |y/w|^n + |(z - z0)/h|^n = 1.
struct Section
{
  double x;           //!< [m]
  double middle;      //!< z0 [m]
  double half_width;  //!< w [m]
  double half_height; //!< h [m]
};
//! Body through sections (x growing) with monotone cubics between them, all grown by \p rounding at the end.
//! \param exponent  n: 2 is an ellipse, more is fuller [-]
Implicit loft(std::vector<Section> sections, double exponent, double rounding);

//! Cubic through (x, y) rows without overshoot (Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238);
//! constant outside.
class MonotoneCurve
{
public:
  MonotoneCurve(std::vector<double> x, std::vector<double> y);
  double operator()(double x) const;

private:
  std::vector<double> x_, y_, slope_;
};

} // namespace birdstrike
