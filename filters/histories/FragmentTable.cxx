// SPDX-License-Identifier: BSD-3-Clause
// Fragments as rows of a table and as an array on the data.
#include "FragmentTable.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace {

void Append(vtkTable* table, const char* column, double value)
{
  vtkDoubleArray::SafeDownCast(table->GetColumnByName(column))->InsertNextValue(value);
}

constexpr const char* Numbers[] = {"mass[kg]",           "centre_x[m]",        "centre_y[m]",
                                   "centre_z[m]",        "velocity_x[m/s]",    "velocity_y[m/s]",
                                   "velocity_z[m/s]",    "momentum_x[kg m/s]", "momentum_y[kg m/s]",
                                   "momentum_z[kg m/s]", "kinetic_energy[J]",  "kinetic_energy_of_centre[J]",
                                   "extent[m]"};

} // namespace

void StartFragmentTable(vtkTable* table)
{
  table->Initialize();
  vtkNew<vtkStringArray> dataset;
  dataset->SetName("dataset");
  table->AddColumn(dataset);
  vtkNew<vtkIntArray> fragment;
  fragment->SetName("fragment");
  table->AddColumn(fragment);
  vtkNew<vtkIdTypeArray> count;
  count->SetName("count");
  table->AddColumn(count);
  for (const char* name : Numbers) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
}

void AddFragmentRows(vtkTable* table, const std::string& dataset, const Fragments& fragments)
{
  for (std::size_t f = 0; f < fragments.Rows.size(); ++f) {
    const Fragment& row = fragments.Rows[f];
    vtkStringArray::SafeDownCast(table->GetColumnByName("dataset"))->InsertNextValue(dataset);
    vtkIntArray::SafeDownCast(table->GetColumnByName("fragment"))->InsertNextValue(static_cast<int>(f));
    vtkIdTypeArray::SafeDownCast(table->GetColumnByName("count"))->InsertNextValue(row.Count);
    const double values[] = {row.Mass,        row.Centre[0],   row.Centre[1],     row.Centre[2],
                             row.Velocity[0], row.Velocity[1], row.Velocity[2],   row.Momentum[0],
                             row.Momentum[1], row.Momentum[2], row.KineticEnergy, row.KineticEnergyOfCentre,
                             row.Extent};
    for (std::size_t k = 0; k < std::size(values); ++k)
      Append(table, Numbers[k], values[k]);
  }
}

void AddFragmentArray(vtkDataSetAttributes* data, std::int64_t count, const std::vector<FragmentItem>& items,
                      const Fragments& fragments)
{
  vtkNew<vtkIntArray> array;
  array->SetName("fragment");
  array->SetNumberOfValues(count);
  array->FillValue(-1);
  for (std::size_t i = 0; i < items.size(); ++i)
    array->SetValue(items[i].Row, static_cast<int>(fragments.Of[i]));
  data->AddArray(array);
}
