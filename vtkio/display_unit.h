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

//! Pressures in MPa, lengths in mm, energies in kJ/kg, the rest in its SI unit.
//! \param array  name in core/fields.h, of particles or target
DisplayUnit display_unit(const std::string& array);

} // namespace birdstrike
