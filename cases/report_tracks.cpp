// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a series over time, packed.
#include "cases/report_tracks.h"

#include "core/error.h"
#include "vtkio/quantise.h"
#include "vtkio/shown_array.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

vtkDataArray* array_of(vtkUnstructuredGrid& grid, const char* name, bool of_cells)
{
  return of_cells ? grid.GetCellData()->GetArray(name) : grid.GetPointData()->GetArray(name);
}

//! Rows of cells and points that nothing is left of, so that they count for no range; empty without an array "eroded".
struct Gone
{
  std::vector<bool> cells, points;

  explicit Gone(vtkUnstructuredGrid& grid)
  {
    vtkDataArray* eroded = grid.GetCellData()->GetArray("eroded");
    if (!eroded)
      return;
    points.assign(static_cast<std::size_t>(grid.GetNumberOfPoints()), true);
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
      cells.push_back(eroded->GetComponent(cell, 0) == 1);
      grid.GetCellPoints(cell, corners);
      for (vtkIdType k = 0; !cells.back() && k < corners->GetNumberOfIds(); ++k)
        points[static_cast<std::size_t>(corners->GetId(k))] = false;
    }
  }
};

} // namespace

Tracks::Tracks(vtkUnstructuredGrid& first, std::vector<std::size_t> points,
               std::span<const TrackedField> fields)
    : all_points_(static_cast<std::size_t>(first.GetNumberOfPoints())),
      cells_(static_cast<std::size_t>(first.GetNumberOfCells())),
      points_(std::move(points))
{
  for (const TrackedField& field : fields)
    for (const bool of_cells : {false, true})
      if (array_of(first, field.array, of_cells)) {
        fields_.push_back({field, of_cells, {}});
        break;
      }
}

void Tracks::check(vtkUnstructuredGrid& grid) const
{
  require(static_cast<std::size_t>(grid.GetNumberOfPoints()) == all_points_ &&
              static_cast<std::size_t>(grid.GetNumberOfCells()) == cells_,
          fmt::format("it has {} points and {} cells, the first frame {} and {}", grid.GetNumberOfPoints(),
                      grid.GetNumberOfCells(), all_points_, cells_));
  for (const Field& field : fields_)
    require(array_of(grid, field.what.array, field.of_cells) != nullptr,
            fmt::format("it lacks the array \"{}\", which the first frame has", field.what.array));
}

void Tracks::append(vtkUnstructuredGrid& grid)
{
  for (const std::size_t point : points_) {
    std::array<double, 3> place{};
    grid.GetPoint(static_cast<vtkIdType>(point), place.data());
    for (const double x : place)
      position_.push_back(static_cast<float>(x));
  }
  const Gone gone(grid);
  for (Field& field : fields_) {
    vtkDataArray& array = *array_of(grid, field.what.array, field.of_cells);
    const std::vector<bool>& nothing = field.of_cells ? gone.cells : gone.points;
    const auto add = [&](std::size_t row) {
      const double value = field.what.factor * ShownArray{&array}.value(static_cast<vtkIdType>(row));
      field.values.push_back(!nothing.empty() && nothing[row] ? NAN : static_cast<float>(value));
    };
    if (field.of_cells)
      for (std::size_t cell = 0; cell < cells_; ++cell)
        add(cell);
    else
      std::for_each(points_.begin(), points_.end(), add);
  }
  if (vtkDataArray* eroded = grid.GetCellData()->GetArray("eroded"))
    for (std::size_t cell = 0; cell < cells_; ++cell)
      gone_.push_back(eroded->GetComponent(static_cast<vtkIdType>(cell), 0) == 1);
}

void Tracks::add_to(nlohmann::ordered_json& json) const
{
  const std::size_t row = 3 * points_.size();
  std::array<double, 3> low, high;
  low.fill(INFINITY), high.fill(-INFINITY);
  for (std::size_t i = 0; i < position_.size(); ++i)
    if (std::isfinite(position_[i])) {
      low[i % 3] = std::min<double>(low[i % 3], position_[i]);
      high[i % 3] = std::max<double>(high[i % 3], position_[i]);
    }
  // What stands still is there once.
  bool moves = false;
  for (std::size_t i = row; i < position_.size() && !moves; ++i)
    moves = position_[i] != position_[i % row];
  std::vector<std::uint16_t> places(moves ? position_.size() : row);
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = to_16_bits(position_[i], low[i % 3], high[i % 3]);
  json["cells"] = cells_;
  json["low"] = low;
  json["high"] = high;
  json["moves"] = moves;
  json["position"] = packed(std::span<const std::uint16_t>(places), row);

  json["fields"] = nlohmann::ordered_json::array();
  for (const Field& field : fields_) {
    constexpr double outliers = 0.01;
    const auto range = range_without_outliers(field.values, outliers);
    if (!(range[1] > range[0]))
      continue;
    std::vector<std::uint8_t> values(field.values.size());
    bool beyond = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = to_8_bits(field.values[i], range[0], range[1]);
      beyond = beyond || field.values[i] > range[1];
    }
    json["fields"].push_back({{"name", field.what.array},
                              {"title", field.what.title},
                              {"unit", field.what.unit},
                              {"of", field.of_cells ? "cells" : "points"},
                              {"low", range[0]},
                              {"high", range[1]},
                              {"beyond", beyond}, // some values are above the range and are shown as its end
                              {"values", packed(std::span<const std::uint8_t>(values),
                                                field.of_cells ? cells_ : points_.size())}});
  }
  if (std::any_of(gone_.begin(), gone_.end(), [](std::uint8_t gone) { return gone != 0; }))
    json["gone"] = packed(std::span<const std::uint8_t>(gone_), cells_);
}

} // namespace birdstrike
