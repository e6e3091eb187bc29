// SPDX-License-Identifier: BSD-3-Clause
// The steady turning of a spinning target, which its displacements leave out.
#pragma once

#include <array>

class vtkDataSet;

class SteadyTurn
{
public:
  using Vector = std::array<double, 3>;

  //! From the field arrays "spin_centre", a point of the axis [m], and "spin_velocity", along the axis [rad/s]; without
  //! them nothing turns.
  explicit SteadyTurn(vtkDataSet* data);

  //! Where a point that has turned since time 0 would be had it not. \param time [s]
  Vector Back(const Vector& point, double time) const;

private:
  Vector Centre{}, Axis{}; // the latter of length 1
  double Rate = 0;         // [rad/s]
};
