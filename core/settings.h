// SPDX-License-Identifier: BSD-3-Clause
// Everything about a run that is not the bird and not the target.
#pragma once

#include <optional>

namespace birdstrike {

//! Artificial viscosity.
enum class ViscosityKind
{
  bulk,    //!< 5.58: a pressure q from the particle's own rate of compression
  pairwise //!< Monaghan's pair viscosity, times the shear switch when that is on
};

struct Viscosity
{
  ViscosityKind kind = ViscosityKind::pairwise;
  double linear = 1.0;      //!< C_l of 5.58, or alpha [-]
  double quadratic = 2.0;   //!< C_0 of 5.58, or beta [-]
  bool shear_switch = true; //!< pairwise only: times (div v)^2 / ((div v)^2 + S:S/2 + |curl v|^2/2)
};

//! 5.58 with the constants that stand below it.
inline constexpr Viscosity dissertation_viscosity{ViscosityKind::bulk, 0.06, 1.5, false};

//! A box that repeats along y and z, centred on the x axis; for plane waves.
struct PeriodicBox
{
  double size_y, size_z; //!< [m]
};

struct Settings
{
  double end_time = 0;  //!< [s]
  int frames = 60;      //!< states handed to the observer after the one at t = 0, at equal intervals
  double courant = 0.5; //!< share of the stability limit of time_step.h [-]
  Viscosity viscosity;
  double tension_cutoff = 0; //!< lowest pressure that a particle can carry, <= 0 [Pa]
  double smoothing_shrink =
      1.0; //!< h is kept above this share of its first value; 1: constant h, whose sums conserve
           //!< the energy of the law exactly (see sph_rates.h) [-]
  double smoothing_growth = 1.0; //!< h is kept below this share of its first value [-]
  std::optional<PeriodicBox> periodic;
  int threads = 0; //!< 0: all that there are
};

} // namespace birdstrike
