// SPDX-License-Identifier: BSD-3-Clause
// What a shell is made of: one integration point in plane stress carried over one step.
#pragma once

#include <string>

namespace birdstrike {

//! Strain over one step in the axes of the element's midsurface; shears are engineering ones (gamma) [-].
struct ShellStrain
{
  double xx, yy, xy, yz, zx;
};

//! State of one integration point through the thickness, in the axes of the element.
struct ShellPoint
{
  double xx = 0, yy = 0, xy = 0, yz = 0, zx = 0; //!< Cauchy stress, tension positive; zz is zero [Pa]
  double plastic_strain = 0;                     //!< effective [-]
  double yield = 0;            //!< quasi-static yield stress of the moment [Pa]; 0 before the first step
  double temperature_rise = 0; //!< by plastic work [K]
  double damage = 0;           //!< has failed from 1 on [-]
};

struct ShellMaterial
{
  std::string name;
  double density = 0; //!< [kg/m3]
  double young = 0;   //!< E [Pa]
  double poisson = 0; //!< [-]

  double shear_modulus() const { return 0.5 * young / (1 + poisson); }     //!< [Pa]
  double plane_modulus() const { return young / (1 - poisson * poisson); } //!< E / (1 - nu^2) [Pa]
};

//! Carry a point over a step (5.38).
//! \param strain  over the step
//! \param dt      length of the step, for laws with rate [s]
//! \return strain across the thickness over the step, from plane stress [-]
double update(const ShellMaterial& material, const ShellStrain& strain, double dt, ShellPoint& point);

inline bool has_failed(const ShellPoint& point) { return point.damage >= 1; }

//! Has the material a law of failure?
bool can_fail(const ShellMaterial& material);

} // namespace birdstrike
