// SPDX-License-Identifier: BSD-3-Clause
// A picture to be: scenes, and the texts around them.
#pragma once

#include "vtkio/legend.h"
#include "vtkio/scene.h"

#include <vtkNew.h>

#include <memory>

class vtkImageData;
class vtkRenderWindow;
class vtkRenderer;

namespace birdstrike {

//! \throw InputError unless sizes, background and ranges are in range
void check_options(const SnapshotOptions& options);

//! A window whose ground layer holds texts and legends, and whose upper layer holds scenes.
class Page
{
public:
  Page(int width, int height, const Colour& background);
  ~Page();

  //! The scene draws on that part of the page from now on.
  void place(Scene& scene, const Rectangle& where);
  //! Small arrows that say where x, y and z point, in the lower left corner of that part of the page.
  void add_axes(View view, const Rectangle& where, double size);

  vtkRenderer& ground() { return *ground_; }
  vtkSmartPointer<vtkImageData> draw();
  //! Take all texts and legends away.
  void clear_ground();

private:
  void set_viewport(vtkRenderer& renderer, const Rectangle& where);

  int width_, height_;
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> ground_;
};

} // namespace birdstrike
