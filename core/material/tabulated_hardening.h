// SPDX-License-Identifier: BSD-3-Clause
// Yield stress over plastic strain as rows of a table.
#pragma once

#include "core/material/yield_point.h"

#include <algorithm>
#include <string>
#include <vector>

namespace birdstrike {

//! Straight lines between the rows; constant beyond the last one.
class TabulatedHardening
{
public:
  //! \param plastic_strain  N >= 1 values, the first 0, rising: true strain less its elastic part [-]
  //! \param stress          N values, the first positive, not falling: true stress [Pa]
  //! \throw InputError naming the row (counted from 1) that breaks this
  TabulatedHardening(std::vector<double> plastic_strain, std::vector<double> stress);

  void check() const {} // nothing that the constructor let through
  YieldPoint at(double plastic_strain) const
  {
    // Few rows: from the front is faster than halving.
    std::size_t k = 0;
    while (k + 1 < strain_.size() && plastic_strain >= strain_[k + 1])
      ++k;
    return {stress_[k] + slope_[k] * std::max(plastic_strain - strain_[k], 0.0), slope_[k]};
  }
  std::string describe() const;

private:
  std::vector<double> strain_, stress_, slope_;
};

} // namespace birdstrike
