// SPDX-License-Identifier: BSD-3-Clause
// Colours that colour-blind people can tell apart.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <string>

class vtkLookupTable;

namespace birdstrike {

using Colour = std::array<double, 3>; //!< red, green, blue, each 0 ... 1

//! \throw InputError unless the text is "#rrggbb"
Colour colour_from_text(const std::string& text);

//! "#rrggbb".
std::string text_from_colour(const Colour& colour);

//! Colour of line number k of a plot; repeats after eight.
Colour line_colour(std::size_t k);

//! Colour of a bird's part. Names that occur in birds have fixed roles, after figure 8.7 of the dissertation:
//! head and neck blue, torso orange brown, bones green, wings grey, lungs red. Others take what is left by
//! their number. None is as bright as the target or white paper.
Colour part_colour(const std::string& name, std::size_t number);

//! What values are turned into.
enum class ColourMap
{
  viridis, //!< dark blue to yellow, rising evenly in brightness
  heat     //!< pale to dark red, falling evenly: for the target where the bird has the other one
};

vtkSmartPointer<vtkLookupTable> make_colour_map(double lowest, double highest,
                                                ColourMap map = ColourMap::viridis);

//! Of a target that nothing colours: paler than any part of a bird by 2 : 1 and more in luminance.
inline constexpr Colour plain_target{0xec / 255.0, 0xf0 / 255.0, 0xf5 / 255.0};

} // namespace birdstrike
