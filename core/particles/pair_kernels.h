// SPDX-License-Identifier: BSD-3-Clause
// The two loops over pairs of particles that cost nearly all the time, as plain functions over plain records.
// They are compiled once for each instruction set (pair_kernels.cpp); pair_kernels() picks at run time.
//
// Particles come in quads, up to four that are close to each other, and the list says which quad meets which. A pair of
// quads is sixteen pairs of particles: one side is loaded four times over, the other has each number four times, and
// nothing is gathered. Each pair is computed once, for both sides; pair_schedule.h has the order in which they add.
//
// The state is in double precision, pairs are computed in single. So that a difference of positions loses nothing,
// positions are whole numbers of a tiny unit, modulo 2^32: 2^-26 of a spacing, or 2^-32 of a box that repeats, in which
// the nearest image then costs nothing. Differences are exact wherever the pair is, and d_ij = -d_ji to the bit. All
// listed pairs are nearer than 2^31 units, because quads are compact (neighbours.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace birdstrike {

constexpr int quad_size = 4;

//! Up to quad_size consecutive rows of particles; record k of the arrays below belongs to quad k.
struct Quad
{
  std::int32_t begin;    //!< first row
  std::int32_t count;    //!< 1 ... quad_size rows in use
  std::int64_t first;    //!< of its partners: itself, then quads behind it that have it for a partner
  std::int32_t partners; //!< how many
  std::int32_t alike; //!< how many of them, the first ones, have the one rest density that its own rows have
};

//! Where a quad is and how far it reaches, for the search. Idle lanes have a reach of -1e30.
struct alignas(16) QuadPlace
{
  std::int32_t x[quad_size], y[quad_size], z[quad_size]; //!< see PairUnits
  float support[quad_size];                              //!< h [spacings]
  float reach[quad_size];                                //!< h and skin [spacings]
};

//! What the rates of one particle need of another. Idle lanes have no weight and stand where the quad's first row stands.
struct alignas(64) QuadState
{
  std::int32_t x[quad_size], y[quad_size], z[quad_size]; //!< see PairUnits
  float vx[quad_size], vy[quad_size], vz[quad_size];     //!< [m/s]
  float support[quad_size];                              //!< h [spacings]
  float weight[quad_size];         //!< 8 / pi V, V = m / rho0 over the lattice's sum V W [spacings^3]
  float pressure[quad_size];       //!< [Pa]
  float stress[quad_size];         //!< (p + q) / x^2, x = rho / rho0 [Pa]
  float sound_speed[quad_size];    //!< times alpha / 2 [m/s]
  float lightness[quad_size];      //!< x^2 / rho, inverse of what stands in Q_ij for the density [m3/kg]
  float smooth[quad_size];         //!< 1 - f of artificial_viscosity.h [-]
  float strain_rate[6][quad_size]; //!< xx, yy, zz, and xy + yx, xz + zx, yz + zy of grad v [m/s per spacing]
  float rest_density[quad_size];   //!< rho0 [kg/m3]
};

//! The particles' own mirrors (mirror_planes.h).
struct alignas(64) QuadWalls
{
  float x[quad_size], y[quad_size], z[quad_size]; //!< normal [-]
  float height[quad_size];                        //!< of the particle above its wall [spacings]
  float speed[quad_size];                         //!< along the normal [m/s]
  float open[quad_size];                          //!< 0 for none, up to 1 [-]
};

//! Sums over partners, all but mu times the particle's own QuadState.weight and over the factors below, by which a pair so
//! need not be multiplied; lengths in spacings.
struct alignas(64) QuadSums
{
  enum Row
  {
    fx, //!< rho0 dv/dt: - sum V_j (a_ij stress_i + a_ji stress_j + Q_ij) grad_i W_ij [Pa/spacing]
    fy,
    fz,
    number, //!< sum V_j W_ij, the compression [-]
    gradient, //!< nine rows: sum V_j (v_j - v_i) (x) grad_i W_ij, x times the velocity gradient [m/s per spacing]
    pressure = gradient + 9, //!< sum V_j p_j W_ij [Pa]
    heating,                 //!< rho0 times the viscous heating [Pa m/s per spacing]
    extra_work, //!< sum V_j (a_ij - 1) (v_i - v_j) . grad_i W_ij, a_ij = 2 rho0_j / (rho0_i + rho0_j) [m/s per spacing]
    wall,   //!< share of fx that came from mirror images
    wall_y, //!< the same of fy, images in walls only
    wall_z,
    mu, //!< largest |mu_ij| or U_ij [m/s]
    rows
  };
  // They are added to four at a time.
  static_assert(number == fx + 3 && heating == gradient + 10 && extra_work == gradient + 11 &&
                mu == wall + 3);
  float of[rows * quad_size];

  float* row(int r) { return of + r * quad_size; }
  double at(int r, std::size_t lane) const { return of[static_cast<std::size_t>(r * quad_size) + lane]; }

  static constexpr double force_factor = 6, gradient_factor = -6, heating_factor = 3, work_factor = 6;
};

//! Unit of the whole-number positions along each axis; spacings.
struct PairUnits
{
  double x = 0, y = 0, z = 0;
};

//! A rigid plate in x = 0, |y| <= half_y, |z| <= half_z, that mirrors what stands in front of it (x < 0). Lengths in
//! spacings.
struct MirrorPlate
{
  bool present = false, endless = false; //!< endless: the plate of a box that repeats has no rim
  double half_y = 0, half_z = 0;
  double reach = 0; //!< no pair that is further apart acts; both gaps together must be less
};

struct PairSettings
{
  bool limited = false; //!< which of the pair viscosities of artificial_viscosity.h
  double beta = 0;      //!< its quadratic constant; the linear one is in QuadState.sound_speed [-]
  PairUnits unit;
  MirrorPlate plate;
};

struct PairInput
{
  const QuadState* quads;
  const QuadWalls* walls; //!< null: no particle has one
  const float*
      gap; //!< of each quad: from the row in front of the plate that is nearest to it; 1e30 without one [spacings]
  const float *absolute_y,
      *absolute_z; //!< quad_size a quad, lanes' places on the plate [spacings]
};

//! Quads [begin, end).
struct QuadRun
{
  std::int32_t begin, end;
};

struct PairKernels
{
  const char* name; //!< instruction set

  //! All that a quad and its partners have to do with each other, added to the sums of both; \p sums has all quads.
  void (*rates)(const Quad* quads, std::int32_t quad, const std::int32_t* partners, const PairInput& in,
                const PairSettings& settings, QuadSums* sums);

  //! Of the candidates in \p runs: those with a pair within reach_i + reach_j are written to \p found, in their order.
  //! \return how many; \p neighbours grows by the pairs closer than h_i + h_j
  int (*search)(const QuadPlace& quad, const QuadPlace* places, const QuadRun* runs, int run_count,
                const PairUnits& unit, std::int32_t* found, std::int64_t* neighbours);
};

//! Builds that this processor can run, the fastest first.
const std::vector<const PairKernels*>& available_pair_kernels();

//! The fastest; BIRDSTRIKE_ISA=plain|avx2|avx512 in the environment asks for another.
//! \throw InputError if that one is not available
const PairKernels& pair_kernels();

} // namespace birdstrike
