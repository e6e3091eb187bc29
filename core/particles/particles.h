// SPDX-License-Identifier: BSD-3-Clause
// The bird: SPH particles as a structure of arrays, and the parts they belong to.
#pragma once

#include "core/material/equation_of_state.h"
#include "core/particles/kernel.h"
#include "core/types.h"

#include <cstdint>
#include <string>
#include <vector>

namespace birdstrike {

//! One material part of the bird (head, neck, torso, ...).
struct Part
{
  std::string name;
  EquationOfState eos;        //!< its reference_density is the density of the undisturbed particles
  double porosity = 0;        //!< z, volume share of air [-]; 0 where the law has none
  double particle_volume = 0; //!< that each of its particles stands for; 0: spacing^3 [m3]
  double mesh_volume = 0; //!< volume of the CAD part less the inner parts that it encloses [m3]; 0 if unknown
};

//! N particles; every array has N entries. Rows are reordered while a run goes on: \p id is what stays.
struct Particles
{
  std::vector<Part> parts;
  double spacing = 0;           //!< of the lattice that the particles started on [m]
  double initial_smoothing = 0; //!< h at the reference density [m]
  Lattice lattice;              //!< that they started on

  std::vector<double> x, y, z;    //!< position [m]
  std::vector<double> vx, vy, vz; //!< velocity [m/s]
  std::vector<double> mass;       //!< [kg]
  std::vector<double> density;    //!< [kg/m3]
  std::vector<double> energy;     //!< specific internal energy, viscous heat included [J/kg]
  std::vector<double> pressure;   //!< from the equation of state, compression positive [Pa]
  std::vector<double>
      mean_pressure; //!< sum V p W / sum V W over the neighbours: what a body around feels; the
                     //!< pressures of single particles carry the noise of their arrangement [Pa]
  std::vector<double> sound_speed;      //!< [m/s]
  std::vector<double> smoothing_length; //!< h of 4.13; the kernel ends at 2h [m]
  std::vector<std::uint8_t> part;       //!< row in parts
  std::vector<std::int32_t> id;         //!< 0 ... N-1, constant over the run, survives sorting

  std::size_t size() const { return x.size(); }
  //! Undisturbed volume that particle i stands for [m3]. Its mass is density times this unless somebody changed it.
  double volume(std::size_t i) const
  {
    const double given = parts[part[i]].particle_volume;
    return given > 0 ? given : spacing * spacing * spacing;
  }
  void resize(std::size_t count);

  Vector3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vector3 velocity(std::size_t i) const { return {vx[i], vy[i], vz[i]}; }

  //! Row of every id: the inverse of \p id, shape N.
  std::vector<std::int32_t> row_of_id() const;
};

//! Where and what a particle is before the first step; the fill makes these.
struct Seed
{
  Vector3 position;  //!< [m]
  std::uint8_t part; //!< row in the table of parts
};

//! Particles at rest state (p = 0, e = 0) from seeds on a lattice.
//! \param parts          materials; each density is eos.reference_density
//! \param seeds          N seeds; particle id = row
//! \param spacing        lattice spacing; each particle stands for spacing^3 of volume, or its part's particle_volume [m]
//! \param velocity       initial velocity of all particles [m/s]
//! \param smoothing      h over spacing [-]
//! \param lattice        that the seeds lie on
//! \throw InputError if there is no seed, or a seed names a part that is not there
Particles make_particles(std::vector<Part> parts, const std::vector<Seed>& seeds, double spacing,
                         const Vector3& velocity, double smoothing, const Lattice& lattice = cubic_lattice);

double total_mass(const Particles& particles);      //!< [kg]
Vector3 total_momentum(const Particles& particles); //!< [kg m/s]
double kinetic_energy(const Particles& particles);  //!< [J]

} // namespace birdstrike
