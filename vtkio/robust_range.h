// SPDX-License-Identifier: BSD-3-Clause
// One colour scale for many pictures, whatever single points do.
#pragma once

#include "vtkio/shown_array.h"

#include <array>

namespace birdstrike {

//! What 98 % of the values of the worst frame stay below, and above: a single particle does not turn everything else
//! into one colour. The ends are rounded outwards to two digits; an end near zero becomes zero.
class RobustRange
{
public:
  //! The values of one frame. \param share  of them that the scale is to hold
  void add(const ShownArray& shown, double share = 0.98);

  bool empty() const { return empty_; }
  //! First less than second, in SI; 0 to 1 if nothing was added.
  std::array<double, 2> range() const;
  double high() const { return high_; } //!< not rounded

private:
  bool empty_ = true;
  double low_ = 0, high_ = 0;
};

//! Down (or up) to a number of two digits.
double rounded_outwards(double value, bool up);

} // namespace birdstrike
