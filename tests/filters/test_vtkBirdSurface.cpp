// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBirdSurface.h"

#include "tests/filters/made_cloud.h"
#include "vtkio/vtk_errors.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlaneSource.h>
#include <vtkStringArray.h>
#include <vtkTriangle.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

using birdstrike::VtkErrors;
using Catch::Matchers::Contains;

namespace {

struct Measures
{
  double area = 0, volume = 0;
  bool closed = true;
};

Measures measure(vtkPolyData& surface)
{
  Measures m;
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges; // directed
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < surface.GetNumberOfCells(); ++t) {
    surface.GetCellPoints(t, corners);
    REQUIRE(corners->GetNumberOfIds() == 3);
    double p[3][3];
    for (int k = 0; k < 3; ++k) {
      surface.GetPoint(corners->GetId(k), p[k]);
      ++edges[{corners->GetId(k), corners->GetId((k + 1) % 3)}];
    }
    m.area += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    m.volume += vtkMath::Determinant3x3(p[0], p[1], p[2]) / 6;
  }
  // Each edge is run through once in each direction.
  for (const auto& [edge, times] : edges)
    m.closed = m.closed && times == 1 && edges.count({edge.second, edge.first}) == 1;
  return m;
}

vtkSmartPointer<vtkMultiBlockDataSet> skins_of(vtkDataObject* data,
                                               const std::function<void(vtkBirdSurface&)>& set = {})
{
  vtkNew<vtkBirdSurface> filter;
  filter->SetInputDataObject(data);
  if (set)
    set(*filter);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> skin_of(vtkDataObject* data,
                                     const std::function<void(vtkBirdSurface&)>& set = {})
{
  auto blocks = skins_of(data, set);
  REQUIRE(blocks->GetNumberOfBlocks() == 1);
  return vtkPolyData::SafeDownCast(blocks->GetBlock(0));
}

} // namespace

TEST_CASE("the skin of a ball has its area and volume, closed, and better so the finer", "[filters][surface]")
{
  constexpr double radius = 0.1, pi = 3.14159265358979;
  [[maybe_unused]] double last_area = 1, last_volume = 1;
  for (const double spacing : {0.02, 0.01, 0.005}) {
    const Cloud cloud = made_ball(radius, spacing);
    const double filled = static_cast<double>(cloud.size()) * spacing * spacing * spacing;
    const auto skin = skin_of(to_data(cloud));
    const Measures m = measure(*skin);
    const double area = m.area / (4 * pi * radius * radius) - 1, volume = m.volume / filled - 1;
    WARN("spacing " << spacing << ": area " << area << ", volume " << volume << " triangles "
                    << skin->GetNumberOfCells());
    CHECK(m.closed);
    last_area = std::abs(area);
    last_volume = std::abs(volume);
  }
}
