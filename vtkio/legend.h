// SPDX-License-Identifier: BSD-3-Clause
// What explains a picture's colours: the list of parts, or a bar with numbers.
#pragma once

#include "vtkio/scene.h"

#include <array>
#include <string>
#include <vector>

class vtkRenderer;

namespace birdstrike {

//! Part of a window in pixels from its lower left corner.
struct Rectangle
{
  double x, y, width, height;
};

//! Dots and names, one below the other when the rectangle is upright, else one beside the other.
void add_part_legend(vtkRenderer& renderer, const Rectangle& place, const std::vector<LegendEntry>& parts,
                     int font, const Colour& text);

//! A bar with numbers and a title with its unit, upright or lying as the rectangle is.
//! \param range       in SI; what is shown is in display_unit(array)
//! \param title_font  no larger than this, so that two bars have titles alike; see bar_title_font
void add_scalar_bar(vtkRenderer& renderer, const Rectangle& place, const std::string& array,
                    const std::array<double, 2>& range, int font, const Colour& text,
                    ColourMap map = ColourMap::viridis, int title_font = 1000);

//! That the title of such a bar would have of its own: it is broken between words, and shrinks if that is not enough.
int bar_title_font(const Rectangle& place, const std::string& array, int font);

} // namespace birdstrike
