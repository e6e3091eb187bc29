// SPDX-License-Identifier: BSD-3-Clause
// VTK arrays from the tables of core/fields.h.
#pragma once

#include "core/fields.h"
#include "core/types.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace birdstrike {

//! One array of doubles for every row of the table.
//! \param count  tuples of every array
//! \param row    row(k) is the owner's row that becomes tuple k
template <class Owner, std::size_t N, class Row>
void add_field_arrays(vtkFieldData& data, const std::array<Field<Owner>, N>& fields, const Owner& owner,
                      vtkIdType count, Row row)
{
  for (const Field<Owner>& field : fields) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(std::string(field.name).c_str());
    array->SetNumberOfComponents(field.components);
    array->SetNumberOfTuples(count);
    for (vtkIdType k = 0; k < count; ++k)
      for (int component = 0; component < field.components; ++component)
        array->SetTypedComponent(k, component, field.value(owner, row(k), component));
    data.AddArray(array);
  }
}

//! A number that belongs to the whole dataset.
inline void add_field_value(vtkFieldData& data, const char* name, double value)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->InsertNextValue(value);
  data.AddArray(array);
}

//! The same of a vector.
inline void add_field_vector(vtkFieldData& data, const char* name, const Vector3& value)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(value.data());
  data.AddArray(array);
}

} // namespace birdstrike
