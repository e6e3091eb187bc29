// SPDX-License-Identifier: BSD-3-Clause
// Samples between two points, each tied to the nearest place on a mesh.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

class vtkDataSet;

class LineOnTarget
{
public:
  using Vector = std::array<double, 3>;

  //! One of the samples, which divide the line evenly; the first and the last are its ends.
  struct Sample
  {
    double Along;                     // distance from the line's start [m]
    Vector Place;                     // on the line [m]
    double Off;                       // distance to the mesh [m]; NaN if there is no mesh
    std::vector<std::size_t> Corners; // of the cell whose values are interpolated: rows over all leaves
    std::vector<double> Weights;      // of the corners; their sum is 1
  };

  //! Place \p count samples, two or more, from \p start to \p end [m].
  void Start(const Vector& start, const Vector& end, int count);

  //! Tie the samples to the mesh, the nearest place on any cell of any leaf. Points without cells count as such.
  //! \param leaves  datasets
  //! \param places  of their points, leaf after leaf [m]
  void Tie(const std::vector<vtkDataSet*>& leaves, const std::vector<Vector>& places);

  const std::vector<Sample>& Samples() const { return this->All; }

  //! Values of points, one row for each place of Tie, interpolated; NaN where a corner has one, or nothing is tied.
  static Vector Interpolate(const Sample& sample, const std::vector<Vector>& values);

private:
  std::vector<Sample> All;
};
