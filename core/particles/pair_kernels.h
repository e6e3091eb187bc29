// SPDX-License-Identifier: BSD-3-Clause
// The two loops over pairs of particles that cost nearly all the time, as plain functions over plain arrays.
// They are compiled once for each instruction set (pair_kernels.cpp); pair_kernels() picks at run time.
//
// Particles come in clusters of eight neighbours in space; a cluster has one list of partners for all its
// lanes. So the partner is broadcast and the eight lanes are loaded side by side: no gathers, no horizontal
// sums, and each particle's sum has one fixed order whatever the number of threads.
#pragma once

#include <cstdint>
#include <vector>

namespace birdstrike {

constexpr int cluster_size = 8; // rows; the lanes of AVX-512 in double precision

//! Up to cluster_size consecutive rows.
struct Cluster
{
  std::int32_t begin; //!< first row
  std::int32_t count; //!< 1 ... cluster_size rows in use
  std::int64_t first; //!< of its partners
  std::int32_t partners;
};

//! Periodic lengths along y and z; 0 where the box does not repeat [m].
struct Period
{
  double y = 0, z = 0;
};

//! What the rates of one particle need of another; N + 8 entries each, the last eight only read by idle
//! lanes.
struct PairInput
{
  const double *x, *y, *z, *vx, *vy, *vz; //!< [m], [m/s]
  const double* h;                        //!< smoothing length [m]
  const double* weight;                   //!< V = m / rho0 over the lattice's sum V W [m3]
  const double* pressure;                 //!< [Pa]
  const double* stress;                   //!< (p + q) / x^2, x = rho / rho0 [Pa]
  const double* sound_speed;              //!< [m/s]
  const double* inertia;                  //!< rho / x^2, what stands in Q_ij for the density [kg/m3]
  const double* rest_density;             //!< rho0 [kg/m3]
  const double* limiter;                  //!< f of artificial_viscosity.h [-]
  const double *wall_x, *wall_y,
      *wall_z; //!< normal of the particle's own mirror (mirror_planes.h) [-]; null: none has one
  const double *wall_at, *wall_speed; //!< its offset and speed along the normal [m], [m/s]
  const double* wall_open;            //!< 0 for none, up to 1 [-]
  const double* strain_rate[6];       //!< xx, yy, zz, and the sums xy + yx, xz + zx, yz + zy of grad v [1/s]
};

//! Sums over partners, N + 8 entries each.
struct PairOutput
{
  double *fx, *fy, *fz; //!< rho0 dv/dt: - sum V_j (a_ij stress_i + a_ji stress_j + Q_ij) grad_i W_ij [N/m3]
  double*
      gradient[9];  //!< row-major: sum V_j (v_j - v_i) (x) grad_i W_ij, x times the velocity gradient [1/s]
  double* number;   //!< sum V_j W_ij, the compression [-]
  double* pressure; //!< sum V_j p_j W_ij [Pa]
  double* work;     //!< sum V_j a_ij (v_i - v_j) . grad_i W_ij, a_ij = 2 rho0_j / (rho0_i + rho0_j) [1/s]
  double* heating;  //!< rho0 times the viscous heating [W/m3]
  double* mu;       //!< largest |mu_ij| or U_ij [m/s]
  double *wall, *wall_y,
      *wall_z; //!< shares of fx, fy, fz that came from mirror images; the last two of walls only [N/m3]
};

//! A rigid plate in x = 0, |y| <= half_y, |z| <= half_z, that mirrors what stands in front of it (x < 0).
struct MirrorPlate
{
  double half_y = 0, half_z = 0; //!< [m]
  double reach = 0;              //!< twice the largest smoothing length: no image acts further away [m]
  bool present = false;
};

struct PairSettings
{
  bool limited = false;       //!< which of the pair viscosities of artificial_viscosity.h
  double alpha = 0, beta = 0; //!< its constants [-]
  Period period;
  MirrorPlate plate;
};

struct PairKernels
{
  const char* name; //!< instruction set

  //! Rates of the particles of clusters [begin, end).
  void (*rates)(const Cluster* clusters, int begin, int end, const std::int32_t* partners,
                const PairInput& in, const PairSettings& settings, const PairOutput& out);

  //! Of the candidate rows [begin, end): those within reach_i + reach_j of any lane are appended to \p found.
  //! \return rows appended; \p neighbours grows by the pairs closer than h_i + h_j
  int (*search)(const Cluster& cluster, int begin, int end, const double* x, const double* y, const double* z,
                const double* h, const double* reach, Period period, std::int32_t* found,
                std::int64_t* neighbours);
};

//! Builds that this processor can run, the fastest first.
const std::vector<const PairKernels*>& available_pair_kernels();

//! The fastest; BIRDSTRIKE_ISA=plain|avx2|avx512 in the environment asks for another.
//! \throw InputError if that one is not available
const PairKernels& pair_kernels();

} // namespace birdstrike
