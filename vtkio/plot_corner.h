// SPDX-License-Identifier: BSD-3-Clause
// A corner of a plot that no curve passes through.
#pragma once

#include "vtkio/plot.h"

#include <array>
#include <optional>

namespace birdstrike {

//! What the axes span.
struct PlotBox
{
  std::array<double, 2> x, y;
};

struct PlotCorner
{
  bool right, top;
};

//! The box with room for a legend above all curves, if there is no corner for it and beside them it would take too much
//! of the width; else the box as it is.
PlotBox with_headroom(const Plot& plot, PlotBox box, const std::array<double, 2>& size);

//! The first of upper right, upper left, lower right, lower left with room for a legend.
//! \param size  of the legend, as shares of the plot's width and height
//! \return none if curves or markers pass through all of them, or there is no room at all
std::optional<PlotCorner> free_corner(const Plot& plot, const PlotBox& box,
                                      const std::array<double, 2>& size);

} // namespace birdstrike
