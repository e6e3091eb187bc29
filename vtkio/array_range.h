// SPDX-License-Identifier: BSD-3-Clause
// Values of an array as a colour shows them: numbers as they are, vectors by their length.
#pragma once

#include <vtkType.h>

#include <array>
#include <string>

class vtkDataArray;
class vtkFieldData;

namespace birdstrike {

double length_of_tuple(vtkDataArray& array, vtkIdType row);

//! Lowest and highest finite value or length; 0, 0 if there is none.
std::array<double, 2> finite_range(vtkDataArray& array);

//! "pressure, part, id": for messages.
std::string names_of_arrays(vtkFieldData& data);

} // namespace birdstrike
