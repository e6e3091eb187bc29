// SPDX-License-Identifier: BSD-3-Clause
// In which unit a picture shows a quantity of core/fields.h.
#include "vtkio/display_unit.h"

#include "core/fields.h"
#include "vtkio/shown_array.h"

namespace birdstrike {

std::string si_unit_of_array(const std::string& array)
{
  const std::string name = split_component(array).array;
  if (name == "displacement") // it stands beside the tables
    return "m";
  std::string unit;
  const auto look = [&](const auto& fields) {
    for (const auto& field : fields)
      if (field.name == name || field.name == array)
        unit = field.unit;
  };
  look(particle_fields);
  look(target_fields);
  look(mesh_target_fields);
  look(shell_fields);
  return unit;
}

DisplayUnit display_unit(const std::string& array)
{
  const std::string unit = si_unit_of_array(array);
  if (unit == "Pa")
    return {"MPa", 1e-6};
  if (unit == "m")
    return {"mm", 1e3};
  if (unit == "J/kg")
    return {"kJ/kg", 1e-3};
  return {unit.empty() ? "-" : unit, 1.0};
}

} // namespace birdstrike
