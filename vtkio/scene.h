// SPDX-License-Identifier: BSD-3-Clause
// The three-dimensional part of a picture: particles and target before a fixed camera.
#pragma once

#include "vtkio/cut_plane.h"
#include "vtkio/palette.h"
#include "vtkio/snapshot.h"
#include "vtkio/target_actors.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;
class vtkPointGaussianMapper;
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

//! What the colours of a picture mean, in SI; a range is not used where nothing is coloured by it.
struct Ranges
{
  std::array<double, 2> bird{0, 1}, target{0, 1};
  //! The target's: its own where bird and target both show a field, or one would vanish before the other.
  ColourMap target_map = ColourMap::viridis;
};

//! Ranges that the options fix; the others hold all of the frames.
//! \throw InputError if a frame lacks an array to colour by
Ranges ranges_of(const std::vector<Frame>& frames, const SnapshotOptions& options);

class Scene
{
public:
  //! \param width, height  of the part of the window that the renderer draws on [pixel]
  Scene(const SnapshotOptions& options, const Bounds& bounds, double width, double height);
  ~Scene();

  void show(const Frame& frame, const Ranges& ranges);

  vtkRenderer& renderer() { return *renderer_; }
  double metres_per_pixel() const { return metres_per_pixel_; }
  //! Share of the particles, of those that are not cut away, whose middles lie beyond the sides of the picture.
  double share_outside(vtkUnstructuredGrid& bird) const;

private:
  void place_camera(const Bounds& bounds, double aspect, double height);
  void show_bird(vtkUnstructuredGrid& bird, const std::array<double, 2>& range);

  SnapshotOptions options_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkPointGaussianMapper> bird_mapper_;
  vtkNew<vtkActor> bird_;
  TargetActors target_;
  double metres_per_pixel_ = 0;
  std::array<double, 3> centre_{};    //!< of the picture, in space [m]
  std::array<double, 2> half_size_{}; //!< of the picture, along right and up [m]
};

//! Of a particle as it is drawn, over the edge of the cube that it stands for: half, and a little more so that a dense
//! bird shows no gaps.
inline constexpr double ball_radius = 0.62;

//! Whether a picture with these options leaves out what lies before the plane.
bool is_cut(const SnapshotOptions& options);
//! What a picture that is cut keeps: the side away from the camera.
std::optional<HalfSpace> kept(const SnapshotOptions& options);
//! "cut at y = 0", "cut at x = -12 mm".
std::string cut_text(const CutPlane& plane);

//! Unit vectors of the camera: where it looks, and what is up in the picture.
struct CameraAxes
{
  std::array<double, 3> direction, up;
};
CameraAxes camera_axes(View view);

//! Of the picture of a box seen from there.
double width_over_height(const Bounds& bounds, View view);
//! Of a picture with these options: of its window, else of the box.
double width_over_height(const Bounds& bounds, const SnapshotOptions& options);

} // namespace birdstrike
