// SPDX-License-Identifier: BSD-3-Clause
// In which unit a picture shows a quantity of core/fields.h.
#include "vtkio/display_unit.h"

#include "core/fields.h"

namespace birdstrike {

DisplayUnit display_unit(const std::string& array)
{
  std::string unit = array == "displacement" ? "m" : "-"; // it stands beside the tables
  for (const auto& field : particle_fields)
    if (field.name == array)
      unit = field.unit;
  for (const auto& field : target_fields)
    if (field.name == array)
      unit = field.unit;
  if (unit == "Pa")
    return {"MPa", 1e-6};
  if (unit == "m")
    return {"mm", 1e3};
  if (unit == "J/kg")
    return {"kJ/kg", 1e-3};
  return {unit, 1.0};
}

} // namespace birdstrike
