// SPDX-License-Identifier: BSD-3-Clause
// The target in a picture: its faces with element edges, in grey or in the colours of a field, and its rim.
#include "vtkio/target_actors.h"

#include "core/error.h"
#include "vtkio/palette.h"
#include "vtkio/scene.h"
#include "vtkio/shown_array.h"
#include "vtkio/slab.h"
#include "vtkio/visible_shell.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolygon.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

constexpr Colour edge_colour{0.50, 0.53, 0.57}, rim_colour{0.36, 0.39, 0.43};

void paint(vtkProperty& look, const Colour& colour) { look.SetColor(colour[0], colour[1], colour[2]); }

ShownArray find_target_array(vtkUnstructuredGrid& target, const std::string& name)
{
  for (vtkDataSetAttributes* data : {static_cast<vtkDataSetAttributes*>(target.GetPointData()),
                                     static_cast<vtkDataSetAttributes*>(target.GetCellData())})
    if (const auto shown = find_shown_array(*data, name))
      return *shown;
  const std::string of_points = names_of_arrays(*target.GetPointData()),
                    of_cells = names_of_arrays(*target.GetCellData());
  throw InputError("cannot colour the target by \"" + name + "\": it has no such array; it has " + of_points +
                   (of_points.empty() || of_cells.empty() ? "" : ", ") + of_cells);
}

//! The faces of a slab for which the test holds, with their data.
template <class Test>
vtkSmartPointer<vtkPolyData> faces_of(vtkPolyData& slab, Test test)
{
  auto some = vtkSmartPointer<vtkPolyData>::New();
  some->SetPoints(slab.GetPoints());
  some->GetPointData()->ShallowCopy(slab.GetPointData());
  some->GetCellData()->CopyAllocate(slab.GetCellData(), slab.GetNumberOfCells());
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkIdList> corners;
  for (vtkIdType face = 0; face < slab.GetNumberOfCells(); ++face) {
    slab.GetCellPoints(face, corners);
    if (!test(face, *corners))
      continue;
    some->GetCellData()->CopyData(slab.GetCellData(), face, faces->InsertNextCell(corners));
  }
  some->SetPolys(faces);
  return some;
}

//! Length of an element's side, from what the faces cover [m].
double mean_side(vtkPolyData& faces)
{
  double area = 0, normal[3];
  vtkNew<vtkIdList> corners;
  for (vtkIdType face = 0; face < faces.GetNumberOfCells(); ++face) {
    faces.GetCellPoints(face, corners);
    area +=
        vtkPolygon::ComputeArea(faces.GetPoints(), corners->GetNumberOfIds(), corners->GetPointer(0), normal);
  }
  return faces.GetNumberOfCells() > 0 ? std::sqrt(area / static_cast<double>(faces.GetNumberOfCells())) : 0;
}

} // namespace

std::array<double, 2> range_of_target(vtkUnstructuredGrid& target, const std::string& array)
{
  return finite_range(find_target_array(*visible_shell(target, false), array));
}

TargetActors::TargetActors(const SnapshotOptions& options, vtkRenderer& renderer)
    : field_(options.target_field),
      direction_(camera_axes(options.view).direction),
      along_axis_(options.view == View::side || options.view == View::top),
      edges_(options.target_edges),
      keep_(kept(options))
{
  for (Surface* surface : {&with_edges_, &edge_on_, &rim_}) {
    surface->mapper->ScalarVisibilityOff();
    surface->actor->SetMapper(surface->mapper);
    vtkProperty& look = *surface->actor->GetProperty();
    paint(look, plain_target);
    look.SetEdgeColor(edge_colour[0], edge_colour[1], edge_colour[2]);
    // Colours are to be compared with those of the bar, a dent's inside is seen at a flat angle, and a target without
    // colours stays pale at any angle; its bends are seen all the same.
    look.SetAmbient(0.72);
    look.SetDiffuse(0.28);
    look.SetLineWidth(1);
    look.SetInterpolationToFlat();
    look.SetOpacity(options.target_opacity);
    renderer.AddActor(surface->actor);
  }
  if (along_axis_) { // of a flat target nothing else is seen; of one that is cut open, the section
    paint(*rim_.actor->GetProperty(), rim_colour);
    rim_.actor->GetProperty()->SetAmbient(0.35);
    rim_.actor->GetProperty()->SetDiffuse(0.65);
  }
  outline_.mapper->ScalarVisibilityOff();
  outline_.actor->SetMapper(outline_.mapper);
  vtkProperty& look = *outline_.actor->GetProperty();
  paint(look, rim_colour);
  look.LightingOff();
  look.SetRepresentationToWireframe();
  look.SetOpacity(options.target_opacity);
  renderer.AddActor(outline_.actor);
}

TargetActors::~TargetActors() = default;

void TargetActors::show(vtkUnstructuredGrid* target, const Ranges& ranges)
{
  for (Surface* surface : {&with_edges_, &edge_on_, &rim_, &outline_})
    surface->actor->SetVisibility(target != nullptr);
  if (!target)
    return;
  const auto shell = visible_shell(*target, keep_);
  const auto slab = make_slab(*shell, thickness_of(*target));
  vtkDataArray& rim = *slab->GetCellData()->GetArray("rim");
  const auto is_rim = [&](vtkIdType face) { return rim.GetComponent(face, 0) == 1; };
  // Seen edge-on, the element edges would lie side by side and paint the face black.
  const auto faces_camera = [&](vtkIdList& corners) {
    std::array<double, 3> n{};
    vtkPolygon::ComputeNormal(slab->GetPoints(), static_cast<int>(corners.GetNumberOfIds()),
                              corners.GetPointer(0), n.data());
    return std::abs(n[0] * direction_[0] + n[1] * direction_[1] + n[2] * direction_[2]) > 0.1;
  };
  const auto in_view =
      faces_of(*slab, [&](vtkIdType face, vtkIdList& c) { return !is_rim(face) && faces_camera(c); });
  with_edges_.mapper->SetInputData(in_view);
  set_edges(*in_view);
  edge_on_.mapper->SetInputData(
      faces_of(*slab, [&](vtkIdType face, vtkIdList& c) { return !is_rim(face) && !faces_camera(c); }));
  const auto rim_faces = faces_of(*slab, [&](vtkIdType face, vtkIdList&) { return is_rim(face); });
  rim_.mapper->SetInputData(rim_faces);
  outline_.mapper->SetInputData(rim_faces);
  // Where the rim itself is seen it needs no lines, but a thin sheet would vanish between two rows of pixels.
  constexpr double thin = 1.5;
  outline_.actor->SetVisibility(!along_axis_ || thickness_of(*target) < thin * metres_per_pixel_);
  const double ahead =
      -2 * metres_per_pixel_; // of the faces that it bounds; that moves nothing in the picture
  outline_.actor->SetPosition(ahead * direction_[0], ahead * direction_[1], ahead * direction_[2]);
  if (!field_.empty())
    colour_by_field(*shell, ranges);
}

void TargetActors::set_edges(vtkPolyData& faces)
{
  constexpr double fine = 3,
                   coarse = 12; // pixels of an element's side: no lines, and lines as dark as they can be
  vtkProperty& look = *with_edges_.actor->GetProperty();
  const double pixels = metres_per_pixel_ > 0 ? mean_side(faces) / metres_per_pixel_ : coarse;
  const double share = std::clamp((pixels - fine) / (coarse - fine), 0.0, 1.0);
  look.SetEdgeVisibility(edges_ && share > 0);
  if (!field_.empty())
    return; // any grey may be near to one of the colours
  Colour line;
  for (std::size_t k = 0; k < 3; ++k)
    line[k] = plain_target[k] + share * (edge_colour[k] - plain_target[k]);
  look.SetEdgeColor(line.data());
}

void TargetActors::colour_by_field(vtkUnstructuredGrid& shell, const Ranges& ranges)
{
  const ShownArray shown = find_target_array(shell, field_);
  const bool of_points = shell.GetPointData()->GetArray(shown.array->GetName()) != nullptr;
  vtkSmartPointer<vtkLookupTable> map =
      make_colour_map(ranges.target[0], ranges.target[1], ranges.target_map);
  map->SetVectorModeToMagnitude();
  if (shown.component >= 0) {
    map->SetVectorModeToComponent();
    map->SetVectorComponent(shown.component);
  }
  map->SetNanColor(0.74, 0.77, 0.80, 1);
  for (Surface* surface : {&with_edges_, &edge_on_, &rim_}) {
    if (surface == &rim_ && along_axis_ && keep_)
      continue; // the section stays dark, or the dent would not be seen against what lies behind it
    surface->mapper->SetLookupTable(map);
    surface->mapper->UseLookupTableScalarRangeOn();
    surface->mapper->SetColorModeToMapScalars();
    surface->mapper->ScalarVisibilityOn();
    if (of_points)
      surface->mapper->SetScalarModeToUsePointFieldData();
    else
      surface->mapper->SetScalarModeToUseCellFieldData();
    surface->mapper->SelectColorArray(shown.array->GetName());
  }
}

} // namespace birdstrike
