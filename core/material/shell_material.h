// SPDX-License-Identifier: BSD-3-Clause
// What a shell is made of: one integration point in plane stress carried over one step.
#pragma once

#include "core/material/failure.h"
#include "core/material/hardening.h"
#include "core/material/plastic_heat.h"
#include "core/material/rate_law.h"

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
  double plastic_work = 0;     //!< of all steps so far [J/m3]
  double plastic_rate = 0;     //!< effective, of the last step that was plastic [1/s]
  double softening = 1;        //!< factor of temperature that is in yield [-]
};

struct ShellMaterial
{
  std::string name;
  double density = 0; //!< [kg/m3]
  double young = 0;   //!< E [Pa]
  double poisson = 0; //!< [-]
  Hardening hardening = NoYield{};
  RateLaw rate = NoRateEffect{};
  PlasticHeat heat{};
  Failure failure = NoFailure{};

  double shear_modulus() const { return 0.5 * young / (1 + poisson); }     //!< [Pa]
  double plane_modulus() const { return young / (1 - poisson * poisson); } //!< E / (1 - nu^2) [Pa]

  //! \throw InputError naming material and quantity: density or E not positive, nu not between -1 and 0.5, a law with
  //!        numbers out of range
  void check() const;
  std::string describe() const; //!< one line for logs
};

//! Carry a point over a step (5.38): elastic, then back to the yield surface
//!   q = sigma_y(eps_p) f(rate) theta(T),  q^2 = xx^2 - xx yy + yy^2 + 3 (xy^2 + yz^2 + zx^2),  zz = 0,
//! along the normal at the end of the step (associated J2 flow, backward Euler). In plane stress that is one equation
//! in lambda = d eps_p / q, as xx + yy, xx - yy and the shears shrink each by their own factor:
//!   1 / (1 + E lambda / (2 (1 - nu))) for the sum, 1 / (1 + 3 G lambda) for the others;
//! it has exactly one root, which Newton's method finds between two bounds that always enclose it. The end state is on
//! the surface to 1e-8 for any finite strain (up to 1e100); a strain that is not a number makes the stress none.
//! The rate is that of plastic strain over the step itself, solved for with the rest: the yield stress then acts as a
//! viscosity that only damps, stable at any dt, while a rate taken from the step before swings at dt below the time
//! in which stress follows rate. Temperature is that of the step's begin.
//! Source: J. C. Simo, R. L. Taylor, Int. J. Numer. Methods Eng. 22 (1986) 649; T. Belytschko, W. K. Liu, B. Moran,
//! Nonlinear Finite Elements for Continua and Structures (2000), section 5.9.
//! \param strain  over the step
//! \param dt      length of the step, for laws with rate; 0: as slow as can be [s]
//! \param point   gets stress, and if it flows plastic_work by the mean of the stresses at both ends of the step, so that
//!                the step's work by that mean is elastic plus plastic work to rounding
//! \return strain across the thickness over the step, elastic -nu/E d(xx + yy) and plastic, which keeps the volume [-]
double update(const ShellMaterial& material, const ShellStrain& strain, double dt, ShellPoint& point);

inline bool has_failed(const ShellPoint& point) { return point.damage >= 1; }

//! Has the material a law of failure?
inline bool can_fail(const ShellMaterial& material)
{
  return !std::holds_alternative<NoFailure>(material.failure);
}

//! \return q of update() [Pa]
double von_mises_stress(const ShellPoint& point);

//! Elastic energy that the stress holds [J/m3].
double elastic_energy(const ShellMaterial& material, const ShellPoint& point);

} // namespace birdstrike
