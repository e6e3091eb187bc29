// SPDX-License-Identifier: BSD-3-Clause
// One row per quantity that may leave the program in a frame. Writers and the manual are made from these
// tables: a name or a unit is spelled once.
#pragma once

#include "core/contact/rigid_plate.h"
#include "core/mesh_target.h"
#include "core/particles/particles.h"

#include <algorithm>
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

//! Largest value over the points through the thickness of an element.
template <class Value>
double largest_in(const Shells& shells, std::size_t element, Value value)
{
  const ShellPoint* const first = shells.points.data() + shells.first_point(element);
  double largest = 0;
  for (int k = 0; k < shells.section_of(element).points; ++k)
    largest = std::max(largest, value(first[k]));
  return largest;
}

inline constexpr std::array mesh_target_fields{
  Field<MeshTarget>{"contact_force", 3, "N", "force of the bird on the element",
    [](const MeshTarget& t, std::size_t e, int k) { return t.loads.force.empty() ? 0.0 : t.loads.force[e][k]; }},
  Field<MeshTarget>{"contact_pressure", 1, "Pa", "normal contact force over the element's area",
    [](const MeshTarget& t, std::size_t e, int) { return t.loads.pressure.empty() ? 0.0 : t.loads.pressure[e]; }},
  Field<MeshTarget>{"contact_impulse", 3, "N s", "time integral of the contact force",
    [](const MeshTarget& t, std::size_t e, int k) { return t.loads.impulse.empty() ? 0.0 : t.loads.impulse[e][k]; }},
  Field<MeshTarget>{"peak_contact_pressure", 1, "Pa", "largest contact pressure so far, sampled at every step",
    [](const MeshTarget& t, std::size_t e, int) { return t.loads.peak_pressure.empty() ? 0.0 : t.loads.peak_pressure[e]; }},
};

//! Of the elements of a structure.
inline constexpr std::array shell_fields{
  Field<Shells>{"thickness", 1, "m", "of the element now",
    [](const Shells& s, std::size_t e, int) { return s.thickness[e]; }},
  Field<Shells>{"density", 1, "kg/m3", "of the element's material",
    [](const Shells& s, std::size_t e, int) { return s.section_of(e).material.density; }},
  Field<Shells>{"von_mises", 1, "Pa", "effective stress, the largest through the thickness",
    [](const Shells& s, std::size_t e, int) { return largest_in(s, e, von_mises_stress); }},
  Field<Shells>{"plastic_strain", 1, "-", "effective plastic strain, the largest through the thickness",
    [](const Shells& s, std::size_t e, int) { return largest_in(s, e, [](const ShellPoint& p) { return p.plastic_strain; }); }},
  Field<Shells>{"damage", 1, "-", "of the failure law, the largest through the thickness; failed from 1 on",
    [](const Shells& s, std::size_t e, int) { return largest_in(s, e, [](const ShellPoint& p) { return p.damage; }); }},
  Field<Shells>{"eroded", 1, "-", "1 once the element has failed and carries nothing any more, else 0",
    [](const Shells& s, std::size_t e, int) { return static_cast<double>(s.gone[e]); }},
};
// clang-format on
//! Point arrays "displacement" [m] and, of structures, "velocity" [m/s] (3 components each) stand beside these on the
//! target, and the integer cell array "part".

} // namespace birdstrike
