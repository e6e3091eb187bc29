// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/mie_grueneisen.h"

#include "core/error.h"
#include "core/format_text.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

MieGrueneisen::MieGrueneisen(double rho0, const MieGrueneisenConstants& constants)
    : rho0_(rho0), modulus_(rho0 * constants.c0 * constants.c0), constants_(constants)
{
  const MieGrueneisenConstants& k = constants_;
  for (const double value : {rho0, k.c0, k.S1, k.S2, k.S3, k.gamma, k.a})
    require(std::isfinite(value), "Mie-Grueneisen equation of state: every constant must be a finite number");
  require(rho0 > 0 && k.c0 > 0 && k.S1 >= 0 && k.gamma >= 0,
          "Mie-Grueneisen equation of state: density and sound speed must be positive, slope and Gamma at "
          "least 0");

  // The last compression up to which the cold pressure rises, its shock curve has not run into its pole, and the matter
  // has not been squeezed to half of its volume.
  constexpr double step = 1e-3, largest = 1.0, smallest = 0.05;
  for (double mu = step; mu <= largest; mu += step) {
    const double c = 1 + mu;
    const double root = 1 - (k.S1 - 1) * mu - k.S2 * mu * mu / c - k.S3 * mu * mu * mu / (c * c);
    if (root < 0.1 || k.gamma + k.a * mu < 0 || !(on_curve(mu).slope > 0))
      break;
    mu_max_ = mu;
  }
  require(mu_max_ >= smallest,
          format_text("Mie-Grueneisen equation of state: with these constants the pressure stops rising at a "
                      "compression of %.3g; at least %.3g is needed",
                      mu_max_, smallest));
  end_ = on_curve(mu_max_);
}

MieGrueneisenConstants MieGrueneisen::constants() const
{
  MieGrueneisenConstants here = constants_;
  here.c0 = std::sqrt(modulus_ / rho0_);
  return here;
}

MieGrueneisen::Cold MieGrueneisen::on_curve(double mu) const
{
  const MieGrueneisenConstants& k = constants_;
  const double c = 1 + mu, m = mu / c; // m = u/u_s on the shock curve
  const double root = 1 - (k.S1 - 1) * mu - (k.S2 + k.S3 * m) * mu * m;
  // d(mu m)/dmu = m (2 - m), d(mu m^2)/dmu = m^2 (3 - 2 m)
  const double root_slope = -(k.S1 - 1) - k.S2 * m * (2 - m) - k.S3 * m * m * (3 - 2 * m);
  const double hugoniot = modulus_ * mu * c / (root * root);
  const double hugoniot_slope = (modulus_ * (1 + 2 * mu) - 2 * hugoniot * root * root_slope) / (root * root);
  const double factor = 1 - 0.5 * (k.gamma + k.a * mu) * m;
  const double factor_slope = -0.5 * (k.a * m + (k.gamma + k.a * mu) / (c * c));
  return {hugoniot * factor, hugoniot_slope * factor + hugoniot * factor_slope};
}

MieGrueneisen::Cold MieGrueneisen::cold(double mu) const
{
  if (mu <= 0)
    return {modulus_ * mu, modulus_};
  if (mu > mu_max_)
    return {end_.pressure + (mu - mu_max_) * end_.slope, end_.slope};
  return on_curve(mu);
}

LawPoint MieGrueneisen::at(double rho, double energy) const
{
  const double mu = rho / rho0_ - 1, G = std::max(0.0, constants_.gamma + constants_.a * mu);
  const Cold part = cold(mu);
  const double p = part.pressure + G * rho0_ * energy;
  const double at_constant_energy = (part.slope + (G > 0 ? constants_.a * rho0_ * energy : 0)) / rho0_;
  const double heating = std::max(p, 0.0) / (rho * rho) * G * rho0_;
  // Only energies far outside of the law could make it negative.
  const double least = 0.01 * modulus_ / rho0_;
  return {p, std::sqrt(std::max(at_constant_energy + heating, least))};
}

std::string MieGrueneisen::describe() const
{
  const MieGrueneisenConstants& k = constants_;
  return format_text(
      "Mie-Grueneisen with energy, rho0 %.6g kg/m3, c0 %.6g m/s, S1 %.4g, S2 %.4g, S3 %.4g, Gamma %.4g, "
      "a %.4g; rises up to mu = %.3g, %.4g MPa at e = 0; source: Steinberg 1991",
      rho0_, std::sqrt(modulus_ / rho0_), k.S1, k.S2, k.S3, k.gamma, k.a, mu_max_, end_.pressure / 1e6);
}

} // namespace birdstrike
