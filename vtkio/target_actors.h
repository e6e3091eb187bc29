// SPDX-License-Identifier: BSD-3-Clause
// The target in a picture: its faces with element edges, in grey or in the colours of a field, and its rim.
#pragma once

#include "vtkio/cut_plane.h"
#include "vtkio/snapshot.h"

#include <vtkNew.h>

class vtkActor;
class vtkPolyDataMapper;
class vtkRenderer;

namespace birdstrike {

class TargetActors
{
public:
  TargetActors(const SnapshotOptions& options, vtkRenderer& renderer);
  ~TargetActors();

  //! \param target  null to show none
  //! \param range   of options.target_field, in SI; not used without one
  //! \throw InputError if the target lacks that array
  void show(vtkUnstructuredGrid* target, const std::array<double, 2>& range);

private:
  struct Surface
  {
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void colour_by_field(vtkUnstructuredGrid& shell, const std::array<double, 2>& range);

  std::string field_;
  std::array<double, 3> direction_; // of the camera
  bool along_axis_;
  std::optional<HalfSpace> keep_;
  Surface with_edges_, edge_on_, rim_;
};

//! Lowest and highest finite value (length, for vectors) of a point or cell array on the
//! elements that are still there, in SI. \throw InputError if the target lacks the array; the message lists those that it has
std::array<double, 2> range_of_target(vtkUnstructuredGrid& target, const std::string& array);

} // namespace birdstrike
