// SPDX-License-Identifier: BSD-3-Clause
// How text looks in all pictures.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkTextActor;
class vtkTextProperty;

namespace birdstrike {

//! A sans-serif font of the system where one is found; VTK's own otherwise, whose brackets look like
//! parentheses.
void set_text_style(vtkTextProperty& style, int pixels, const std::array<double, 3>& colour = {0, 0, 0});

enum class Anchor
{
  left,
  centre,
  right
};

//! Text at a place in the window, in pixels from its lower left corner; \p y is the middle of the text's
//! height.
vtkSmartPointer<vtkTextActor> make_text(const std::string& text, double x, double y, int pixels,
                                        Anchor anchor, const std::array<double, 3>& colour);

//! A font no larger than asked for [pixel] with which so many letters fit into a width [pixel].
int fitting_font(int font, double width, std::size_t letters);

//! Letters that fit into a width with a font [pixel].
std::size_t fitting_letters(int font, double width);

//! Black or white, whichever can be read on this background.
std::array<double, 3> readable_on(const std::array<double, 3>& background);

} // namespace birdstrike
