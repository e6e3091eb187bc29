// SPDX-License-Identifier: BSD-3-Clause
// One row per quantity that may leave the program in a frame. Writers and the manual are made from these
// tables: a name or a unit is spelled once.
#pragma once

#include "core/contact/rigid_plate.h"
#include "core/particles/particles.h"

#include <array>
#include <string_view>

namespace birdstrike {

//! A quantity of the particles (point data) or of the target's elements (cell data).
template <class Owner>
struct Field
{
  std::string_view name; //!< array name in VTK, lower_snake_case
  int components;        //!< 1 scalar, 3 vector
  std::string_view unit; //!< SI, "-" when it has none
  std::string_view text;
  double (*value)(const Owner& owner, std::size_t row, int component);
};

// clang-format off
inline constexpr std::array particle_fields{
  Field<Particles>{"velocity", 3, "m/s", "particle velocity in the laboratory frame",
    [](const Particles& p, std::size_t i, int k) { return k == 0 ? p.vx[i] : k == 1 ? p.vy[i] : p.vz[i]; }},
  Field<Particles>{"pressure", 1, "Pa", "from the equation of state and the density carried to this time, compression positive",
    [](const Particles& p, std::size_t i, int) { return p.pressure[i]; }},
  Field<Particles>{"mean_pressure", 1, "Pa", "kernel mean of the pressures around, without the noise of single particles",
    [](const Particles& p, std::size_t i, int) { return p.mean_pressure[i]; }},
  Field<Particles>{"density", 1, "kg/m3", "counted from the neighbours, 4.5; less than the material's at a free surface",
    [](const Particles& p, std::size_t i, int) { return p.density[i]; }},
  Field<Particles>{"internal_energy", 1, "J/kg", "specific internal energy, viscous heat included",
    [](const Particles& p, std::size_t i, int) { return p.energy[i]; }},
  Field<Particles>{"smoothing_length", 1, "m", "h of the kernel 4.13, whose support is 2h",
    [](const Particles& p, std::size_t i, int) { return p.smoothing_length[i]; }},
  Field<Particles>{"mass", 1, "kg", "particle mass, constant",
    [](const Particles& p, std::size_t i, int) { return p.mass[i]; }},
};
//! Integer arrays "part" (row in the table of parts) and "id" (constant over the run) stand beside these.

inline constexpr std::array target_fields{
  Field<RigidPlate>{"contact_force", 3, "N", "force of the bird on the element",
    [](const RigidPlate& t, std::size_t e, int k) { return t.force[e][k]; }},
  Field<RigidPlate>{"contact_pressure", 1, "Pa", "normal contact force over the element's area",
    [](const RigidPlate& t, std::size_t e, int) { return t.force[e][0] / t.element_area(); }},
  Field<RigidPlate>{"contact_impulse", 3, "N s", "time integral of the contact force",
    [](const RigidPlate& t, std::size_t e, int k) { return t.impulse[e][k]; }},
  Field<RigidPlate>{"peak_contact_pressure", 1, "Pa", "largest contact pressure so far, sampled at every step",
    [](const RigidPlate& t, std::size_t e, int) { return t.peak_pressure[e]; }},
};
// clang-format on
//! Point array "displacement" [m] (3 components) stands beside these on the target.

} // namespace birdstrike
