// SPDX-License-Identifier: BSD-3-Clause
// A target from VTK data.
#include "vtkio/vtk_to_shells.h"

#include "core/error.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace birdstrike {

namespace {

class Converter
{
public:
  Converter(vtkDataSet& data, double unit, const std::string& name) : data_(data), builder_(name, unit)
  {
    for (const char* title : {"part", "PartId", "part_id", "region"})
      if (!part_)
        part_ = array_of(*data.GetCellData(), title, data.GetNumberOfCells());
    thickness_ = array_of(*data.GetCellData(), "thickness", data.GetNumberOfCells());
    vtkDataArray* uniform = data.GetFieldData() ? data.GetFieldData()->GetArray("thickness") : nullptr;
    if (uniform && uniform->GetNumberOfValues() == 1)
      uniform_thickness_ = uniform->GetComponent(0, 0);
  }

  ShellImport convert()
  {
    for (vtkIdType p = 0; p < data_.GetNumberOfPoints(); ++p)
      builder_.node(p, Vector3(data_.GetPoint(p)), 0);
    for (vtkIdType c = 0; c < data_.GetNumberOfCells(); ++c)
      take_cell(c);
    for (const auto& [number, parts] : thicknesses_)
      for (const auto& [thickness, key] : parts)
        builder_.name_part(key, parts.size() == 1 ? "part_" + std::to_string(number) : key);
    take_sets();
    return std::move(builder_).finish();
  }

private:
  static vtkDataArray* array_of(vtkDataSetAttributes& attributes, const char* title, vtkIdType rows)
  {
    vtkDataArray* array = attributes.GetArray(title);
    return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == rows ? array
                                                                                              : nullptr;
  }

  void take_cell(vtkIdType row)
  {
    vtkCell& cell = *data_.GetCell(row);
    const auto point = [&](vtkIdType k) {
      return static_cast<std::int64_t>(cell.GetPointId(static_cast<int>(k)));
    };
    const vtkIdType points = cell.GetNumberOfPoints();
    const std::string kind = cell.GetClassName();
    std::size_t corners = 0;
    switch (cell.GetCellType()) {
    case VTK_TRIANGLE:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
      corners = 3;
      break;
    case VTK_QUAD:
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
      corners = 4;
      break;
    case VTK_PIXEL: // row by row instead of around
      add(row, {point(0), point(1), point(3), point(2)});
      return;
    case VTK_TRIANGLE_STRIP: // every second one is turned round
      for (vtkIdType k = 0; k + 2 < points; ++k)
        add(row, k % 2 ? std::vector{point(k + 1), point(k), point(k + 2)}
                       : std::vector{point(k), point(k + 1), point(k + 2)});
      return;
    case VTK_POLYGON:
      if (points != 3 && points != 4)
        throw InputError(where(row) + " is a polygon of " + std::to_string(points) +
                         " corners; divide polygons into triangles and quads");
      corners = static_cast<std::size_t>(points);
      break;
    default:
      require(cell.GetCellDimension() != 2,
              where(row) + " is a " + kind + ", which is not read; divide it into triangles and quads");
      builder_.count(kind, 0);
      return;
    }
    if (points > static_cast<vtkIdType>(corners))
      builder_.count(kind, 0, "read with their corners only");
    std::vector<std::int64_t> ring;
    for (std::size_t k = 0; k < corners; ++k)
      ring.push_back(point(static_cast<vtkIdType>(k)));
    add(row, ring);
  }

  std::string where(vtkIdType row) const { return builder_.name() + ": cell " + std::to_string(row); }

  void add(vtkIdType row, const std::vector<std::int64_t>& corners)
  {
    std::int64_t number = 1;
    if (part_) {
      const double value = part_->GetComponent(row, 0);
      require(std::abs(value) < 1e9 && value == std::floor(value),
              where(row) + " has " + std::to_string(value) + " in its array '" + part_->GetName() +
                  "'; numbers of parts must be whole");
      number = static_cast<std::int64_t>(value);
    }
    const double thickness = thickness_ ? thickness_->GetComponent(row, 0) : uniform_thickness_;
    require(std::isfinite(thickness) && thickness >= 0,
            where(row) + " has the thickness " + std::to_string(thickness) + "; it must be positive");
    auto& parts = thicknesses_[number];
    const auto [at, is_new] = parts.try_emplace(thickness, "part_" + std::to_string(number) + "_" +
                                                               std::to_string(parts.size() + 1));
    builder_.element(++element_, corners, at->second, 0);
    if (is_new)
      builder_.set_thickness(at->second, thickness, 0);
  }

  void take_sets()
  {
    const std::string prefix = "node_set_";
    vtkPointData& arrays = *data_.GetPointData();
    for (int a = 0; a < arrays.GetNumberOfArrays(); ++a) {
      const std::string title = arrays.GetArrayName(a) ? arrays.GetArrayName(a) : "";
      vtkDataArray* array = arrays.GetArray(a);
      if (!title.starts_with(prefix) || title == prefix || !array || array->GetNumberOfComponents() != 1)
        continue;
      for (vtkIdType p = 0; p < std::min(array->GetNumberOfTuples(), data_.GetNumberOfPoints()); ++p)
        if (array->GetComponent(p, 0) != 0)
          builder_.node_in_set(title.substr(prefix.size()), p, 0);
    }
  }

  vtkDataSet& data_;
  ShellBuilder builder_;
  vtkDataArray* part_ = nullptr;
  vtkDataArray* thickness_ = nullptr;
  double uniform_thickness_ = 0;
  std::int64_t element_ = -1;
  std::map<std::int64_t, std::map<double, std::string>> thicknesses_; // keys of parts by number and thickness
};

//! Readers trust the points that cells name; a damaged file names others.
void require_points(vtkDataSet& data, const std::string& name)
{
  auto ids = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType c = 0; c < data.GetNumberOfCells(); ++c) {
    data.GetCellPoints(c, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      require(ids->GetId(k) >= 0 && ids->GetId(k) < data.GetNumberOfPoints(),
              name + ": cell " + std::to_string(c) + " names point " + std::to_string(ids->GetId(k)) +
                  ", which is not in the file");
  }
}

} // namespace

ShellImport to_shells(vtkDataSet& data, double unit, const std::string& name)
{
  require_points(data, "target file '" + name + "'");
  return Converter(data, unit, name).convert();
}

} // namespace birdstrike
