// SPDX-License-Identifier: BSD-3-Clause
// Samples between two points, each tied to the nearest place on a mesh.
#include "LineOnTarget.h"

#include "vtkCell.h"
#include "vtkGenericCell.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <cmath>
#include <limits>

namespace {

constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr double NoWeight = 1e-9; // of a corner across from the edge that a sample lies on: rounding

//! The dataset with its points moved; itself if its points cannot be.
vtkSmartPointer<vtkDataSet> Moved(vtkDataSet* leaf, const LineOnTarget::Vector* places)
{
  auto* mesh = vtkPointSet::SafeDownCast(leaf);
  if (!mesh)
    return leaf;
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    points->SetPoint(i, places[i].data());
  auto moved = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  moved->CopyStructure(mesh);
  moved->SetPoints(points);
  return moved;
}

double Distance(const double* a, const double* b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace

void LineOnTarget::Start(const Vector& start, const Vector& end, int count)
{
  this->All.clear();
  for (int k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / (count - 1);
    Vector place{};
    for (std::size_t i = 0; i < 3; ++i)
      place[i] = start[i] + share * (end[i] - start[i]);
    this->All.push_back({share * Distance(start.data(), end.data()), place, None, {}, {}});
  }
}

void LineOnTarget::Tie(const std::vector<vtkDataSet*>& leaves, const std::vector<Vector>& places)
{
  std::size_t offset = 0;
  for (vtkDataSet* leaf : leaves) {
    const auto points = static_cast<std::size_t>(leaf->GetNumberOfPoints());
    if (leaf->GetNumberOfCells() > 0) {
      const vtkSmartPointer<vtkDataSet> mesh = Moved(leaf, places.data() + offset);
      auto locator = vtkSmartPointer<vtkStaticCellLocator>::New();
      locator->SetDataSet(mesh);
      locator->BuildLocator();
      auto cell = vtkSmartPointer<vtkGenericCell>::New();
      for (Sample& sample : this->All) {
        Vector closest{}, parameters{}, again{};
        vtkIdType number = -1;
        int part = 0;
        double squared = 0;
        locator->FindClosestPoint(sample.Place.data(), closest.data(), cell, number, part, squared);
        if (number < 0 || sample.Off <= std::sqrt(squared))
          continue;
        mesh->GetCell(number, cell);
        std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
        cell->EvaluatePosition(closest.data(), again.data(), part, parameters.data(), squared,
                               weights.data());
        sample.Off = Distance(sample.Place.data(), closest.data());
        sample.Corners.clear();
        for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
          sample.Corners.push_back(offset + static_cast<std::size_t>(cell->GetPointId(static_cast<int>(k))));
        sample.Weights = std::move(weights);
      }
    } else {
      for (Sample& sample : this->All)
        for (std::size_t i = offset; i < offset + points; ++i) {
          const double off = Distance(sample.Place.data(), places[i].data());
          if (sample.Off <= off || std::isnan(off))
            continue;
          sample.Off = off;
          sample.Corners = {i};
          sample.Weights = {1};
        }
    }
    offset += points;
  }
}

LineOnTarget::Vector LineOnTarget::Interpolate(const Sample& sample, const std::vector<Vector>& values)
{
  if (sample.Corners.empty())
    return {None, None, None};
  Vector sum{};
  for (std::size_t k = 0; k < sample.Corners.size(); ++k)
    if (std::abs(sample.Weights[k]) > NoWeight) // else a corner that is gone would make NaN of it
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] += sample.Weights[k] * values[sample.Corners[k]][i];
  return sum;
}
