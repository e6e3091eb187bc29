// SPDX-License-Identifier: BSD-3-Clause
// Whether a picture shows what it should: not empty, not black, nothing cut off.
#pragma once

#include "vtkio/palette.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace birdstrike {

struct PictureCheck
{
  double drawn = 0;   //!< share of the pixels that are not background
  double dark = 0;    //!< share of the drawn pixels that are all but black
  double border = 0;  //!< largest share, of the four sides, of the border pixels that are not background
  double outside = 0; //!< share of the bird's particles that lie beyond the picture; pixels do not tell it
};

//! Count in a part of a picture: x, y, width, height from its lower left corner [pixel].
//! \param image  RGB, 8 bits each
//! \param apart  parts of it that do not count: axes and the scale bar are drawn on a scene that shows nothing, too
PictureCheck check_picture(vtkImageData& image, const std::array<double, 4>& part, const Colour& background,
                           const std::vector<std::array<double, 4>>& apart = {});

//! The whole picture.
PictureCheck check_picture(vtkImageData& image, const Colour& background);

//! What is wrong, as a sentence to be put behind the name of the picture; empty if nothing is.
//! Empty: less than 0.05 % drawn. Black: nine tenths of what is drawn. Cut off: more than 3 % of a side, or of
//! the particles more than 2 % beyond; single ones that fly out of the picture are no fault.
std::string fault_of(const PictureCheck& check);

} // namespace birdstrike
