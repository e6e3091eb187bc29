// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a frame: particles as lit spheres in front of the plate.
#pragma once

#include "vtkio/cut_plane.h"
#include "vtkio/picture_check.h"
#include "vtkio/series_reader.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace birdstrike {

//! Where the camera stands. Side: looks along +y, flight to the right along +x, +z up.
//! Front: looks along +x, as the bird sees the plate. Top: looks along -z, flight to the right. Isometric: from above,
//! beside and behind the bird. Behind: from above, beside and behind the target, which the bird then does not hide.
enum class View
{
  side,
  front,
  top,
  isometric,
  behind
};

//! "side", "front", "top", "isometric", "behind". \throw InputError listing these for another name
View view_from_name(const std::string& name);

//! What a picture holds along its right and its up axis, seen from the origin [m]: right from, to, up from, to.
using PictureWindow = std::array<double, 4>;

struct SnapshotOptions
{
  std::string colour_by =
      "part"; //!< "part", or a point array of the bird ("pressure", "velocity", "velocity_x" ...)
  std::optional<std::array<double, 2>>
      range; //!< of that array, in its SI unit; the frame's own range otherwise
  View view = View::side;
  std::optional<bool>
      cut;        //!< show only what lies behind the plane, of bird and target, so that inner parts and
                  //!< a dent are seen; otherwise: by part, from the side, yes; else no
  CutPlane plane; //!< of the cut; y = 0 if nothing is said
  std::optional<PictureWindow> window; //!< otherwise what the bounds of the scene look like from there
  std::string target_field;            //!< point or cell array of the target to colour it by ("displacement",
                                       //!< "plastic_strain", ...; vectors by their length); empty: grey
  std::optional<std::array<double, 2>>
      target_range;          //!< of that array, in its SI unit; the frame's own range otherwise
  double target_opacity = 1; //!< 0 ... 1, that what is behind the target is seen
  bool target_edges = true;  //!< lines between the elements
  std::string title;         //!< top left; empty: none
  bool legend = true;        //!< names of the parts, or the scalar bar
  bool time_stamp = true;
  int time_digits = 3;            //!< behind the point of a time in milliseconds; see digits_of
  bool axes = true;               //!< arrows that say where x, y and z point
  bool scale_bar = false;         //!< a round length, at the lower right
  int width = 1280, height = 720; //!< [pixel]
  std::array<double, 3> background = {1.0, 1.0, 1.0}; //!< red, green, blue, each 0 ... 1
};

//! x_min, x_max, y_min, y_max, z_min, z_max [m] of all that a picture has to hold.
using Bounds = std::array<double, 6>;

//! Bounds of bird and plate (with its thickness) in a frame: those of the first one hold a whole run's
//! pictures.
Bounds bounds_of(const Frame& frame);

//! Bounds of the bird in the first frame and of the target in all of them: hold the pictures of a target that bends.
Bounds bounds_of(const std::vector<Frame>& frames);

//! Takes particles into a window [m], those that are not cut away and lie within a box, as large as they are drawn.
void hold_bird(std::optional<PictureWindow>& window, vtkUnstructuredGrid& bird,
               const SnapshotOptions& options, const Bounds& within);
//! Takes what is seen of a target into a window.
void hold_target(std::optional<PictureWindow>& window, vtkUnstructuredGrid& target,
                 const SnapshotOptions& options);

//! Digits behind the point of times in milliseconds [s] with which any two of them look different, three at least.
int digits_of(std::vector<double> times);
//! "1.250 ms".
std::string time_text(double time, int digits);

//! Draws one picture after another with the same camera. Elements of the target that have eroded (cell array "eroded"
//! = 1, or HIDDENCELL in vtkGhostType) are not drawn.
class Snapshot
{
public:
  //! \param bounds  what the camera has to hold in every picture
  //! \throw InputError if options are out of range, OutputError if there is no OpenGL
  Snapshot(const SnapshotOptions& options, const Bounds& bounds);
  ~Snapshot();
  Snapshot(Snapshot&&) noexcept;

  //! \throw InputError if the frame lacks an array to colour by (the message lists those that it has)
  vtkSmartPointer<vtkImageData> draw(const Frame& frame);

  //! The part of the picture that the scene is drawn on: x, y, width, height from the lower left corner [pixel].
  std::array<double, 4> canvas() const;

  //! What is on that part of the picture of a frame, axes and scale bar aside.
  PictureCheck check(vtkImageData& image, const Frame& frame) const;

  //! Draw and write a PNG. \throw InputError as draw, OutputError as write_png
  void write(const Frame& frame, const std::filesystem::path& png);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace birdstrike
