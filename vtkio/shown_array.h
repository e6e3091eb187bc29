// SPDX-License-Identifier: BSD-3-Clause
// An array as a picture names it: a quantity, the length of a vector, or one of its components.
#pragma once

#include <vtkType.h>

#include <array>
#include <optional>
#include <string>

class vtkDataArray;
class vtkFieldData;

namespace birdstrike {

//! "velocity_x" is component 0 of "velocity"; of a name without such an end the component is -1.
struct FieldName
{
  std::string array;
  int component = -1;
};
FieldName split_component(const std::string& name);

struct ShownArray
{
  vtkDataArray* array = nullptr;
  int component = -1; //!< -1: the number itself, or a vector's length

  double value(vtkIdType row) const;
};

//! The array of that name, else the component that it names; none if there is neither.
std::optional<ShownArray> find_shown_array(vtkFieldData& data, const std::string& name);

//! Lowest and highest finite value; 0, 0 if there is none.
std::array<double, 2> finite_range(const ShownArray& shown);

//! "velocity, pressure, id": for messages; a vector's components are told, too.
std::string names_of_arrays(vtkFieldData& data);

} // namespace birdstrike
