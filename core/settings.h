// SPDX-License-Identifier: BSD-3-Clause
// Everything about a run that is not the bird and not the target.
#pragma once

#include <optional>
#include <vector>

namespace birdstrike {

//! Artificial viscosity; formulas and sources in particles/artificial_viscosity.h.
enum class ViscosityKind
{
  limited,  //!< between pairs, on the jump that a linear reconstruction of the velocity leaves: the default
  pairwise, //!< Monaghan's pair viscosity
  switched, //!< the same times a factor that fades where the flow shears or turns
  bulk      //!< 5.58: a pressure q from the particle's own rate of compression
};

struct Viscosity
{
  ViscosityKind kind = ViscosityKind::limited;
  double linear = 2.0;    //!< alpha, or C_l of 5.58 [-]
  double quadratic = 1.5; //!< beta, or C_0 of 5.58 [-]
};

//! A kind with the constants that belong to it: Monaghan's 1 and 2, and for 5.58 those that stand below it.
constexpr Viscosity usual_viscosity(ViscosityKind kind)
{
  switch (kind) {
  case ViscosityKind::pairwise:
  case ViscosityKind::switched:
    return {kind, 1.0, 2.0};
  case ViscosityKind::bulk:
    return {kind, 0.06, 1.5};
  case ViscosityKind::limited:
    break;
  }
  return {};
}

//! A box that repeats along y and z, centred on the x axis; for plane waves.
struct PeriodicBox
{
  double size_y, size_z; //!< [m]
};

struct Settings
{
  double end_time = 0; //!< [s]
  int frames = 60;     //!< states handed to the observer after the one at t = 0, at equal intervals
  std::vector<double>
      frame_times; //!< their times in place of their number, rising, the last one end_time; empty: by frames [s]
  double courant = 0.5; //!< share of the stability limit of time_step.h [-]
  Viscosity viscosity;
  double tension_cutoff = 0; //!< lowest pressure that a particle can carry, <= 0 [Pa]
  double smoothing_shrink =
      1.0; //!< h is kept above this share of its first value; 1: constant h, whose sums conserve
           //!< the energy of the law exactly (see sph_rates.h) [-]
  double smoothing_growth = 1.0; //!< h is kept below this share of its first value [-]
  std::optional<PeriodicBox> periodic;
  bool skip_undisturbed = true; //!< leave particles alone that nothing has reached yet; same results [-]
  int threads = 0;              //!< 0: all that there are
};

} // namespace birdstrike
