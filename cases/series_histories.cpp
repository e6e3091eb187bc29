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
vtkSmartPointer<vtkTable> filtered(const std::filesystem::path& pvd, vtkTableAlgorithm* filter,
                                   std::string& complaint)
{
  vtkNew<vtkBirdStrikeSeriesReader> reader;
  reader->SetFileName(pvd.string());
  filter->SetInputConnection(reader->GetOutputPort());
  vtkNew<VtkErrors> errors;
  for (vtkAlgorithm* algorithm : {static_cast<vtkAlgorithm*>(reader), static_cast<vtkAlgorithm*>(filter)})
    errors->watch(*algorithm);
  filter->Update();
  complaint = errors->first();
  return filter->GetOutput();
}

} // namespace

vtkSmartPointer<vtkTable> histories_of_series(const std::filesystem::path& pvd,
                                              const DeflectionOptions& deflection,
                                              const std::function<void(const std::string&)>& warn)
{
  // Says it better than a pipeline if the file is not there.
  if (const std::string warning = read_series_index(pvd).warning; !warning.empty() && warn)
    warn(warning);
  std::string complaint;
  vtkNew<vtkMaximumPressureHistory> pressure_filter;
  const auto histories = filtered(pvd, pressure_filter, complaint);
  if (histories->GetNumberOfRows() == 0)
    throw InputError(fmt::format("{}: no history can be made of it: {}", pvd.string(), complaint));

  vtkNew<vtkTargetDeflectionHistory> filter;
  for (const DeflectionPoint& point : deflection.points)
    filter->AddPoint(point.place[0], point.place[1], point.place[2], point.name.c_str());
  filter->SetDirection(deflection.along[0], deflection.along[1], deflection.along[2]);
  filter->SetWindowShare(deflection.window);
  const auto target = filtered(pvd, filter, complaint);
  if (target->GetNumberOfRows() == histories->GetNumberOfRows()) {
    for (vtkIdType column = 1; column < target->GetNumberOfColumns(); ++column)
      histories->AddColumn(target->GetColumn(column));
    if (!complaint.empty() && warn)
      warn(fmt::format("{}: {}", pvd.string(), complaint));
  } else if (!deflection.points.empty() || deflection.along != DeflectionOptions().along ||
             deflection.window != DeflectionOptions().window)
  {
    throw InputError(fmt::format("{}: no deflection can be made of it: {}", pvd.string(), complaint));
  }
  return histories;
}

std::vector<std::string> mesh_points_used(vtkTable& histories, const DeflectionOptions& deflection)
{
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < deflection.points.size(); ++k) {
    const DeflectionPoint& point = deflection.points[k];
    const std::string name = point.name.empty() ? std::to_string(k) : point.name;
    const auto value = [&](const std::string& column) {
      return histories.GetValueByName(0, column.c_str()).ToDouble();
    };
    const double row = value("mesh_point_at_" + name);
    lines.push_back(fmt::format("deflection at {} ({:g}, {:g}, {:g}) m: ", name, point.place[0],
                                point.place[1], point.place[2]) +
                    (row < 0 ? "the target has no point"
                             : fmt::format("point {:.0f} of the target, {:.4g} mm away", row,
                                           1e3 * value("distance_at_" + name + "[m]"))));
  }
  return lines;
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
