// SPDX-License-Identifier: BSD-3-Clause
// What a step must know of all particles together, found in one pass over them.
#pragma once

#include "core/particles/sph_rates.h"
#include "core/types.h"

#include <array>
#include <limits>
#include <vector>

namespace birdstrike {

//! Smallest over all particles of what limits the time step; see time_step.h.
struct StepLimits
{
  double sound = 1e300;        //!< h / (c + 0.6 (alpha c + beta |mu|)) [s]
  double acceleration = 1e300; //!< h^2 / a^2 [s4]
  double compression = 1e300;  //!< max(rho, rho0) / |drho/dt| [s]
  double flight = 1e300;       //!< h^2 / v^2 [s2]
};

//! Largest values of one part.
struct PartPeaks
{
  double pressure = -std::numeric_limits<double>::infinity();      //!< [Pa]
  double mean_pressure = -std::numeric_limits<double>::infinity(); //!< [Pa]
};

struct BirdSums
{
  Vector3 momentum = Vector3::Zero(); //!< [kg m/s]
  double kinetic = 0, internal = 0;   //!< [J]
  double viscous_power = 0;           //!< [W]
  bool finite = true;                 //!< are all states and rates?
  StepLimits limits;
};

//! Owns what the pass needs beside the particles, so that a step allocates nothing.
class BirdPass
{
public:
  //! Take velocities and energies by \p rates through \p duration [s], then sum. One order for any number of threads.
  void kick(Particles& particles, const Rates& rates, const Viscosity& viscosity, double duration);

  const BirdSums& sums() const { return sums_; }
  const std::vector<PartPeaks>& peaks() const { return peaks_; } //!< of each part

private:
  BirdSums sums_;
  std::vector<PartPeaks> peaks_, peaks_of_chunk_; // chunk by chunk, part by part
  std::vector<BirdSums> sums_of_chunk_;
  std::vector<double> rest_density_; // of each part [kg/m3]
};

} // namespace birdstrike
