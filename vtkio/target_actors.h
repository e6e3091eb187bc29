// SPDX-License-Identifier: BSD-3-Clause
// The target in a picture: its faces with element edges, in grey or in the colours of a field, and its rim.
#pragma once

#include "vtkio/cut_plane.h"
#include "vtkio/snapshot.h"

#include <vtkNew.h>

class vtkActor;
class vtkPolyDataMapper;
class vtkPolyData;
class vtkRenderer;

namespace birdstrike {

struct Ranges;

class TargetActors
{
public:
  TargetActors(const SnapshotOptions& options, vtkRenderer& renderer);
  ~TargetActors();

  //! \param target  null to show none
  //! \param ranges  with that of options.target_field, in SI, and its colour map; not used without one
  //! \throw InputError if the target lacks that array
  void show(vtkUnstructuredGrid* target, const Ranges& ranges);

  //! Lines between elements that are only few pixels wide would cover them: they fade, see show.
  void set_scale(double metres_per_pixel) { metres_per_pixel_ = metres_per_pixel; }

private:
  struct Surface
  {
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void colour_by_field(vtkUnstructuredGrid& shell, const Ranges& ranges);
  void set_edges(vtkPolyData& faces);

  std::string field_;
  std::array<double, 3> direction_; // of the camera
  bool along_axis_, edges_;
  double metres_per_pixel_ = 0;
  std::optional<HalfSpace> keep_;
  Surface with_edges_, edge_on_, rim_;
  Surface outline_; //!< the rim's lines: a pale plate on a light page, a sheet thinner than a pixel
};

//! Lowest and highest finite value (length, for vectors) of a point or cell array on the
//! elements that are still there, in SI. \throw InputError if the target lacks the array; the message lists those that it has
std::array<double, 2> range_of_target(vtkUnstructuredGrid& target, const std::string& array);

} // namespace birdstrike
