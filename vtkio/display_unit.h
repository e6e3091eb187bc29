// SPDX-License-Identifier: BSD-3-Clause
// In which unit a picture shows a quantity of core/fields.h.
#pragma once

#include <string>

namespace birdstrike {

struct DisplayUnit
{
  std::string unit;  //!< "MPa"; "-" if none is known
  double factor = 1; //!< shown value = SI value * factor
};

//! The SI unit of an array of particles or target; "" if it is none of core/fields.h. Components ("velocity_x") have
//! that of their vector.
std::string si_unit_of_array(const std::string& array);

//! Pressures in MPa, lengths in mm, energies in kJ/kg, the rest in its SI unit.
//! \param array  name in core/fields.h, of particles or target
DisplayUnit display_unit(const std::string& array);

} // namespace birdstrike
