// SPDX-License-Identifier: BSD-3-Clause
// Rates of change of the particles: 4.10, 4.11 and 4.12 in terms of the number of particles in a place.
//
// Every particle k stands for one cell of the lattice at the start, V_k (m_k / rho0_k, but for masses scaled alone), and x_k = rho_k / rho0_k is
// its compression. With s = (p + q) / x^2,
//   dx_i/dt = D_i = sum V_k (v_i - v_k) . grad_i W_ik                       drho/dt = rho0 D
//   dv_i/dt = -(1/rho0_i) sum V_k (a_ik s_i + a_ki s_k + Q_ik) grad_i W_ik
//   de_i/dt =  (1/rho0_i) sum V_k (a_ik s_i + Q_ik / 2) (v_i - v_k) . grad_i W_ik
//   a_ik = 2 rho0_k / (rho0_i + rho0_k)
// where V_k is divided by sum V W of the undisturbed lattice, 0.9985 at h = 1.25 spacings, so that x = 1 there.
// In one material these are 4.10 to 4.12, because m_k = rho0 V_k for all. Across an interface 4.10 is wrong by the
// ratio of the densities, as it weighs the partner's mass against the particle's own density; counting cells is not.
// a is 1 within one material. Between two it gives the lighter one's pressure the greater say, as the acoustic Riemann
// problem does: a particle of water whose light neighbours move by a few per cent counts a density, and so a pressure,
// that would throw particles a thousand times lighter about. (With a = 1 everywhere a random mixture 1 : 1000 lost 15 % of
// its energy at a time step that serves water.) The price: what is booked as work across an interface is not exactly the
// integral of each law; the sum is.
// Sources: X. Y. Hu, N. A. Adams, J. Comput. Phys. 213 (2006) 844; F. Ott, E. Schnetter, arXiv:physics/0303112.
//
// The weights V_k must not be the present volumes m_k / rho_k (A. Colagrossi, M. Landrini, J. Comput. Phys. 191 (2003)
// 448), good as they are for water: sums over present volumes smooth the strain rate in space, and through a front
// that compresses by r in one step they integrate to (r - 1/r) / 2 in place of ln r. The plate pressure of a plane
// wave was 2 % too high at r = 1.6 and 5 % at r = 4. At constant h, D_i is the time derivative of sum V_k W_ik and has
// no such error.
//
// That sum itself is at hand in the same loop, so 4.10 only carries the compression through one step: at its end
// x_i = sum V_k W_ik takes its place, and nothing drifts. Particles at a free surface miss partners, so x < 1 there
// and, with the tension cut-off, p = 0, which is the condition at a free surface; bodies that approach each other or
// the plate are compressed only when the gap has closed. (Viscosity acts from the reach of the kernel on.)
//
// Each pair's force has its equal opposite along the line between the two, and the energy rate is what the same forces
// take from the motion: momentum, angular momentum and energy are conserved whatever h and neighbours do, to the single
// precision of the pairs (pair_kernels.h): over whole impacts momentum is kept to some 1e-9 of itself. With an h
// that varies (settings.smoothing_shrink < 1) the terms of dh/dt are left out of D and of the force: the sums still
// close, but the energy booked as internal then differs from the law's integral of p/rho^2 drho by some per cent.
#pragma once

#include "core/contact/mirror_planes.h"
#include "core/contact/rigid_plate.h"
#include "core/particles/neighbours.h"
#include "core/settings.h"

#include <optional>

namespace birdstrike {

//! N rows beside those of Particles.
struct Rates
{
  std::vector<double> ax, ay, az;     //!< acceleration [m/s2]
  std::vector<double> density;        //!< [kg/m3/s]
  std::vector<double> summed_density; //!< rho0 sum V_k W_ik [kg/m3]
  std::vector<double> energy;         //!< specific, viscous share included [W/kg]
  std::vector<double> viscous;        //!< the viscous share [W/kg]
  std::vector<double> wall_force;     //!< x component of the target's force on the particle [N]
  std::vector<Vector3> image_force;   //!< of the images in the particle's wall on it; empty without walls [N]
  std::vector<double> divergence;     //!< div v [1/s]
  std::vector<double> approach;       //!< largest |mu| of the pair viscosity, or l |div v| of 5.58 [m/s]
  std::vector<double> limiter;        //!< f of artificial_viscosity.h for the next evaluation [-]
  std::vector<float>
      strain_rate[6]; //!< symmetric part of grad v for the next evaluation, see QuadState [1/s]

  void resize(std::size_t count);
  void reorder(const std::vector<std::int32_t>& order);
};

//! Evaluates the rates; owns the scratch arrays so that a step allocates nothing.
class SphRates
{
public:
  SphRates(const Settings& settings, const RigidPlate* plate, const PairKernels& kernels = pair_kernels());

  //! Pressure, sound speed and mean pressure of \p particles from their density, then \p rates.
  //! \param particles  positions and smoothing lengths at the time of the rates; pressure, sound speed are set
  //! \param vx,vy,vz   velocity at the same time, N entries each [m/s]
  //! \param density    at the same time [kg/m3]; that of \p particles is the one at the end of the step before
  //! \param rates      of the evaluation before, in the order of \p particles, and no other: what was left alone keeps its density
  //! \param walls      mirrors of the particles, N rows; null where there are none
  //! \param energy     specific internal energy at the same time, but for the half of the pressure's work over this step
  //!                   that its new value does, e' of 5.52; matters to laws with energy only [J/kg]
  void evaluate(Particles& particles, const std::vector<double>& vx, const std::vector<double>& vy,
                const std::vector<double>& vz, const std::vector<double>& density,
                const std::vector<double>& energy, const Neighbours& neighbours, Rates& rates,
                const MirrorPlanes* walls = nullptr);

  //! Quads that the last evaluation left alone because nothing has reached them yet.
  long skipped() const { return skipped_; }

private:
  const PairKernels& kernels_;
  Settings settings_;
  PairSettings pair_settings_;
  Viscosity bulk_;         // 5.58's constants
  double lattice_sum_ = 0; // of the undisturbed lattice [-]
  struct PartConstants
  {
    double rest_density, per_density; // rho0 [kg/m3], 1 / rho0
    double cell;                      // undisturbed volume that a particle stands for [m3]
    float weight;                     // see QuadState
    bool with_energy;                 // does its pressure depend on the energy?
  };
  std::vector<PartConstants> parts_;

  std::vector<QuadState> states_;
  std::vector<QuadSums> sums_;
  std::vector<QuadWalls> walls_;
  std::vector<float> gap_;                     // see PairInput
  std::vector<float> absolute_y_, absolute_z_; // the same
  std::vector<double> shock_stress_;           // q / x^2 of 5.58, rows; empty for other viscosities [Pa]
  std::vector<std::uint8_t> undisturbed_;      // of each quad: flies as it did at the start, without pressure
  std::vector<std::uint8_t> active_;           // of each quad: not so, or one of those it meets is not
  std::optional<Eigen::Vector3f> flight_;      // velocity at the start [m/s]
  long skipped_ = 0;

  struct Trial // what the rates are found for; rows of the particles
  {
    const std::vector<double>&vx, &vy, &vz, &density, &energy;
  };
  void read_parts(const Particles& particles);
  void prepare(Particles& particles, const Trial& trial, const Quad& list, std::size_t quad,
               const Rates& rates);
  void prepare_walls(const Particles& particles, const MirrorPlanes& walls, const Quad& list,
                     std::size_t quad);
  void find_active(const Neighbours& neighbours);
  void finish(Particles& particles, const Quad& list, const QuadState& state, const QuadSums& sums,
              Rates& rates) const;
  void leave_alone(Particles& particles, const Quad& list, Rates& rates) const;
};

} // namespace birdstrike
