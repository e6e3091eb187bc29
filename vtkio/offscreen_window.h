// SPDX-License-Identifier: BSD-3-Clause
// A render window without a screen.
#pragma once

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkRenderWindow;

namespace birdstrike {

//! A window of that many pixels that draws in memory; needs no X server and no graphics card.
//! \throw OutputError if no OpenGL 3.2 can be had
vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height);

//! Draws the window's renderers and returns its pixels, RGB, 8 bits each.
vtkSmartPointer<vtkImageData> render_image(vtkRenderWindow& window);

} // namespace birdstrike
