// SPDX-License-Identifier: GPL-3.0-or-later
// The two history filters behind the series reader.
#include "cases/series_histories.h"

#include "core/error.h"
#include "filters/histories/vtkMaximumPressureHistory.h"
#include "filters/histories/vtkTargetDeflectionHistory.h"
#include "vtkio/vtkBirdStrikeSeriesReader.h"
#include "vtkio/vtk_errors.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkTable.h>

#include <algorithm>

namespace birdstrike {
namespace {

//! Runs a filter on the series; its table is empty if the series has not what it needs.
template <class Filter>
vtkSmartPointer<vtkTable> filtered(const std::filesystem::path& pvd, std::string& complaint)
{
  vtkNew<vtkBirdStrikeSeriesReader> reader;
  reader->SetFileName(pvd.string());
  vtkNew<Filter> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  vtkNew<VtkErrors> errors;
  for (vtkAlgorithm* algorithm : {static_cast<vtkAlgorithm*>(reader), static_cast<vtkAlgorithm*>(filter)})
    errors->watch(*algorithm);
  filter->Update();
  complaint = errors->first();
  return filter->GetOutput();
}

} // namespace

vtkSmartPointer<vtkTable> histories_of_series(const std::filesystem::path& pvd)
{
  read_series_index(pvd); // says it better than a pipeline if the file is not there
  std::string complaint;
  const auto pressure = filtered<vtkMaximumPressureHistory>(pvd, complaint);
  if (pressure->GetNumberOfRows() == 0)
    throw InputError(fmt::format("{}: no history can be made of it: {}", pvd.string(), complaint));
  const auto deflection = filtered<vtkTargetDeflectionHistory>(pvd, complaint);
  if (deflection->GetNumberOfRows() == pressure->GetNumberOfRows())
    for (vtkIdType column = 1; column < deflection->GetNumberOfColumns(); ++column)
      pressure->AddColumn(deflection->GetColumn(column));
  return pressure;
}

History to_history(vtkTable& table)
{
  History history;
  for (vtkIdType column = 0; column < table.GetNumberOfColumns(); ++column) {
    const std::string title = table.GetColumnName(column);
    const std::size_t open = title.find('[');
    history.columns.push_back(
        open == std::string::npos
            ? HistoryColumn{title, "-"}
            : HistoryColumn{title.substr(0, open), title.substr(open + 1, title.size() - open - 2)});
  }
  for (vtkIdType row = 0; row < table.GetNumberOfRows(); ++row)
    for (vtkIdType column = 0; column < table.GetNumberOfColumns(); ++column)
      history.values.push_back(table.GetValue(row, column).ToDouble());
  return history;
}

} // namespace birdstrike
