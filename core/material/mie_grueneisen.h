// SPDX-License-Identifier: BSD-3-Clause
// Mie-Grueneisen law: pressure from density and internal energy, with the shock curve as reference.
#pragma once

#include "core/material/law_point.h"

#include <string>

namespace birdstrike {

//! Constants of MieGrueneisen. Water of Steinberg (LLNL UCRL-MA-106439, 1991): c0 1480 m/s, S1 2.56, S2 -1.986,
//! S3 0.2286, Gamma 0.4934, a 1.3937.
struct MieGrueneisenConstants
{
  double c0 = 0;                 //!< sound speed at rest [m/s]
  double S1 = 0, S2 = 0, S3 = 0; //!< shock curve u_s = c0 + (S1 + S2 (u/u_s) + S3 (u/u_s)^2) u [-]
  double gamma = 0;              //!< Grueneisen's Gamma at rho0 [-]
  double a = 0;                  //!< its change with density, rho Gamma = rho0 (gamma + a mu) [-]
};

//! p = p_H (1 - G mu / (2 (1 + mu))) + G rho0 e,  G = gamma + a mu,  mu = rho/rho0 - 1, e = specific energy above rest;
//!   p_H = rho0 c0^2 mu (1 + mu) / [1 - (S1 - 1) mu - S2 mu^2/(1 + mu) - S3 mu^3/(1 + mu)^2]^2
//! in compression and p_H = rho0 c0^2 mu without its factor in tension. Where e is that behind a shock, e_H = p_H mu /
//! (2 rho), p is p_H itself. c^2 = dp/drho|e + (p/rho^2) dp/de; the second term is left out in tension, where it could
//! outweigh the first. Linear in e.
//! Valid up to mu_max(), where the shock curve turns or ends; from there the part without e goes on along its tangent.
//! Source: D. J. Steinberg, UCRL-MA-106439; the local Gamma in the factor makes p = p_H on the Hugoniot.
class MieGrueneisen
{
public:
  static constexpr bool linear_in_energy = true;

  //! \param rho0 reference density [kg/m3]
  //! \throw InputError if a constant is not a finite number, rho0 or c0 not positive, S1 or gamma negative, or the
  //!        pressure does not rise for at least 5 % of compression
  MieGrueneisen(double rho0, const MieGrueneisenConstants& constants);

  double reference_density() const { return rho0_; }
  double mu_max() const { return mu_max_; }
  //! Of this law; after rescaled() the sound speed is the one that belongs to the new density.
  MieGrueneisenConstants constants() const;

  LawPoint at(double rho, double energy) const;
  LawPoint at(double rho) const { return at(rho, 0); }

  //! The same p of rho/rho0 and of the energy per initial volume, rho0 e.
  MieGrueneisen rescaled(double density) const
  {
    MieGrueneisen law = *this;
    law.rho0_ = density;
    return law;
  }
  std::string describe() const;

private:
  struct Cold
  {
    double pressure, slope; // of the part without e: [Pa], over mu [Pa]
  };
  Cold on_curve(double mu) const;
  Cold cold(double mu) const;

  double rho0_;
  double modulus_; //!< rho0 c0^2 of the constants [Pa]
  MieGrueneisenConstants constants_;
  double mu_max_ = 0;
  Cold end_{};
};

} // namespace birdstrike
