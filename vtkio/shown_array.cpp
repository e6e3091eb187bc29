// SPDX-License-Identifier: BSD-3-Clause
// An array as a picture names it: a quantity, the length of a vector, or one of its components.
#include "vtkio/shown_array.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {

FieldName split_component(const std::string& name)
{
  if (name.size() > 2 && name[name.size() - 2] == '_')
    for (int axis = 0; axis < 3; ++axis)
      if (name.back() == "xyz"[axis])
        return {name.substr(0, name.size() - 2), axis};
  return {name, -1};
}

double ShownArray::value(vtkIdType row) const
{
  const int components = array->GetNumberOfComponents();
  if (component >= 0 || components == 1)
    return array->GetComponent(row, std::max(component, 0));
  double sum = 0;
  for (int k = 0; k < components; ++k)
    sum += array->GetComponent(row, k) * array->GetComponent(row, k);
  return std::sqrt(sum);
}

std::optional<ShownArray> find_shown_array(vtkFieldData& data, const std::string& name)
{
  if (vtkDataArray* array = data.GetArray(name.c_str()))
    return ShownArray{array, -1};
  const FieldName field = split_component(name);
  vtkDataArray* array = field.component < 0 ? nullptr : data.GetArray(field.array.c_str());
  if (array && array->GetNumberOfComponents() == 3)
    return ShownArray{array, field.component};
  return std::nullopt;
}

std::array<double, 2> finite_range(const ShownArray& shown)
{
  std::array<double, 2> range{0, 0};
  bool first = true;
  for (vtkIdType i = 0; i < shown.array->GetNumberOfTuples(); ++i) {
    const double value = shown.value(i);
    if (!std::isfinite(value))
      continue;
    range = first ? std::array<double, 2>{value, value}
                  : std::array<double, 2>{std::min(range[0], value), std::max(range[1], value)};
    first = false;
  }
  return range;
}

std::string names_of_arrays(vtkFieldData& data)
{
  std::string names;
  for (int k = 0; k < data.GetNumberOfArrays(); ++k) {
    if (!data.GetArrayName(k) ||
        std::string(data.GetArrayName(k)).starts_with("vtk")) // VTK's own marks, such as vtkGhostType
      continue;
    names += std::string(names.empty() ? "" : ", ") + data.GetArrayName(k);
    if (vtkDataArray* array = data.GetArray(k); array && array->GetNumberOfComponents() == 3)
      names += " (or " + std::string(data.GetArrayName(k)) + "_x, _y, _z)";
  }
  return names;
}

} // namespace birdstrike
