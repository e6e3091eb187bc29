// SPDX-License-Identifier: BSD-3-Clause
// Rates of change of the particles: the right-hand sides of 4.10, 4.11 and 4.12.
//
// The sums are written with volumes, V_k = m_k / rho_k (4.5), in place of 4.10's m_k / rho_i:
//   (div v)_i = sum V_k (v_k - v_i) . grad_i W_ik            drho/dt = -rho div v
//   dv_i/dt   = -(1/rho_i) sum V_k (s_i + s_k + Q_ik) grad_i W_ik
//   de_i/dt   =  (1/rho_i) sum V_k (s_i + Q_ik / 2) (v_i - v_k) . grad_i W_ik
// with s = p + q. Where all particles have one density the two forms are the same. Across an interface between
// materials 4.10 is not: it weighs the partner's mass against the particle's own density and is wrong by the ratio
// of the two. Source: A. Colagrossi, M. Landrini, J. Comput. Phys. 191 (2003) 448. Either way each pair's force has
// its equal opposite, and the energy rate is what the same forces take from the motion, so momentum and energy are
// conserved whatever h, density and neighbours do.
#pragma once

#include "core/contact/rigid_plate.h"
#include "core/particles/neighbours.h"
#include "core/settings.h"

namespace birdstrike {

//! N rows beside those of Particles.
struct Rates
{
  std::vector<double> ax, ay, az;          //!< acceleration [m/s2]
  std::vector<double> density;             //!< [kg/m3/s]
  std::vector<double> energy;              //!< specific, viscous share included [W/kg]
  std::vector<double> viscous;             //!< the viscous share [W/kg]
  std::vector<double> wall_force;          //!< x component of the plate's force on the particle [N]
  std::vector<double> divergence;          //!< div v [1/s]
  std::vector<double> approach;            //!< largest |mu| of the pair viscosity, or l |div v| of 5.58 [m/s]
  std::vector<double> limiter;             //!< factor of the pair viscosity for the next evaluation [-]

  void resize(std::size_t count);
  void reorder(const std::vector<std::int32_t>& order);
};

//! Evaluates the rates; owns the scratch arrays so that a step allocates nothing.
class SphRates
{
public:
  SphRates(const Settings& settings, const RigidPlate* plate, const PairKernels& kernels = pair_kernels());

  //! Pressure, sound speed and smoothing length of \p particles from their density, then \p rates.
  //! \param particles  positions, density at the time of the rates; pressure, sound_speed, smoothing_length are set
  //! \param vx,vy,vz   velocity at the same time, N entries each [m/s]
  //! \param density    at the same time [kg/m3]
  void evaluate(Particles& particles, const std::vector<double>& vx, const std::vector<double>& vy,
                const std::vector<double>& vz, const std::vector<double>& density, const Neighbours& neighbours,
                Rates& rates);

private:
  const PairKernels& kernels_;
  Settings settings_;
  PairSettings pair_settings_;
  std::vector<double> x_, y_, z_, vx_, vy_, vz_, h_, weight_, stress_, sound_speed_, density_, limiter_;
  std::vector<double> fx_, fy_, fz_, gradient_[9], heating_, mu_, wall_;

  void prepare(Particles& particles, const std::vector<double>& vx, const std::vector<double>& vy,
               const std::vector<double>& vz, const std::vector<double>& density, const Rates& rates);
  void finish(const Particles& particles, Rates& rates);
};

} // namespace birdstrike
