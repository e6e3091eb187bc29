// SPDX-License-Identifier: BSD-3-Clause
// The three-dimensional part of a picture: particles and target before a fixed camera.
#pragma once

#include "vtkio/palette.h"
#include "vtkio/snapshot.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;
class vtkPointGaussianMapper;
class vtkPolyDataMapper;
class vtkRenderer;

namespace birdstrike {

//! A part of the bird as the legend shows it.
struct LegendEntry
{
  std::string name;
  Colour colour;
};

//! Names and colours of the parts that have particles in this grid.
std::vector<LegendEntry> parts_of(vtkUnstructuredGrid& bird);

//! Lowest and highest finite value (length, for vectors) of a point array, in SI.
//! \throw InputError if the grid lacks the array; the message lists those that it has
std::array<double, 2> range_of(vtkUnstructuredGrid& bird, const std::string& array);

class Scene
{
public:
  //! \param width, height  of the part of the window that the renderer draws on [pixel]
  Scene(const SnapshotOptions& options, const Bounds& bounds, double width, double height);
  ~Scene();

  //! \param range  of the array to colour by, in SI; not used by part
  void show(const Frame& frame, const std::array<double, 2>& range);

  vtkRenderer& renderer() { return *renderer_; }

private:
  void place_camera(const Bounds& bounds, double aspect);
  void show_bird(vtkUnstructuredGrid& bird, const std::array<double, 2>& range);
  void show_target(vtkUnstructuredGrid& target);

  SnapshotOptions options_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkPointGaussianMapper> bird_mapper_;
  vtkNew<vtkActor> bird_;
  vtkNew<vtkPolyDataMapper> target_mapper_;
  vtkNew<vtkActor> target_;
};

//! Whether a picture with these options leaves out the particles with y < 0.
bool is_cut(const SnapshotOptions& options);

//! Unit vectors of the camera: where it looks, and what is up in the picture.
struct CameraAxes
{
  std::array<double, 3> direction, up;
};
CameraAxes camera_axes(View view);

} // namespace birdstrike
