// SPDX-License-Identifier: BSD-3-Clause
// Values of an array as a colour shows them: numbers as they are, vectors by their length.
#include "vtkio/array_range.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {

double length_of_tuple(vtkDataArray& array, vtkIdType row)
{
  if (array.GetNumberOfComponents() == 1)
    return array.GetComponent(row, 0);
  double sum = 0;
  for (int k = 0; k < array.GetNumberOfComponents(); ++k)
    sum += array.GetComponent(row, k) * array.GetComponent(row, k);
  return std::sqrt(sum);
}

std::array<double, 2> finite_range(vtkDataArray& array)
{
  std::array<double, 2> range{0, 0};
  bool first = true;
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) {
    const double value = length_of_tuple(array, i);
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
  for (int k = 0; k < data.GetNumberOfArrays(); ++k)
    names += std::string(names.empty() ? "" : ", ") + data.GetArrayName(k);
  return names;
}

} // namespace birdstrike
