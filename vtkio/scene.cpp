// SPDX-License-Identifier: BSD-3-Clause
// The three-dimensional part of a picture: particles and target before a fixed camera.
#include "vtkio/scene.h"

#include "core/error.h"
#include "vtkio/scale_bar.h"
#include "vtkio/shown_array.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

using Vector = Eigen::Vector3d;

// Each splat is a square that faces the camera; this makes it a sphere lit from the upper left.
constexpr const char* sphere_shader = "//VTK::Color::Impl\n"
                                      "float r2 = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);\n"
                                      "if (r2 > 1.0) { discard; }\n"
                                      "vec3 normal = vec3(offsetVCVSOutput.xy, sqrt(1.0 - r2));\n"
                                      "float light = max(dot(normal, vec3(-0.46, 0.57, 0.68)), 0.0);\n"
                                      "float gloss = 0.18 * pow(light, 24.0);\n"
                                      "ambientColor = diffuseColor * (0.38 + 0.70 * light) + vec3(gloss);\n"
                                      "diffuseColor = vec3(0.0);\n";

ShownArray find_array(vtkUnstructuredGrid& bird, const std::string& name)
{
  if (const auto shown = find_shown_array(*bird.GetPointData(), name))
    return *shown;
  throw InputError("cannot colour by \"" + name + "\": the bird has no such array; it has " +
                   names_of_arrays(*bird.GetPointData()));
}

std::string part_name(vtkUnstructuredGrid& bird, int part)
{
  auto* names = vtkStringArray::SafeDownCast(bird.GetFieldData()->GetAbstractArray("part_names"));
  return names && part < names->GetNumberOfValues() ? names->GetValue(part) : "part_" + std::to_string(part);
}

// By ball_radius of the cube that a particle stands for. The cube is
// that of the lattice at the start; series that do not tell it (other solvers') give it by mass and density.
std::vector<float> radii_of(vtkUnstructuredGrid& bird)
{
  const auto count = static_cast<std::size_t>(bird.GetNumberOfPoints());
  vtkDataArray* spacing = bird.GetFieldData()->GetArray("spacing");
  if (spacing && spacing->GetNumberOfTuples() == 1 && spacing->GetTuple1(0) > 0)
    return std::vector<float>(count, static_cast<float>(ball_radius * spacing->GetTuple1(0)));
  const ShownArray mass = find_array(bird, "mass"), density = find_array(bird, "density");
  std::vector<float> radii(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<vtkIdType>(i);
    radii[i] = static_cast<float>(ball_radius * std::cbrt(mass.value(k) / density.value(k)));
  }
  return radii;
}

} // namespace

std::vector<LegendEntry> parts_of(vtkUnstructuredGrid& bird)
{
  vtkDataArray& part = *find_array(bird, "part").array;
  std::vector<bool> there(256, false);
  for (vtkIdType i = 0; i < part.GetNumberOfTuples(); ++i)
    there[static_cast<std::size_t>(std::clamp(part.GetComponent(i, 0), 0.0, 255.0))] = true;
  std::vector<LegendEntry> entries;
  for (int k = 0; k < 256; ++k)
    if (there[static_cast<std::size_t>(k)])
      entries.push_back({part_name(bird, k), part_colour(part_name(bird, k), static_cast<std::size_t>(k))});
  return entries;
}

std::array<double, 2> range_of(vtkUnstructuredGrid& bird, const std::string& array)
{
  return finite_range(find_array(bird, array));
}

namespace {

//! The range that is fixed, else the one that holds all those found, widened if it is a single value.
std::array<double, 2> chosen_range(const std::optional<std::array<double, 2>>& fixed,
                                   const std::vector<std::array<double, 2>>& found)
{
  if (fixed)
    return *fixed;
  if (found.empty())
    return {0, 1};
  std::array<double, 2> all = found.front();
  for (const auto& range : found)
    all = {std::min(all[0], range[0]), std::max(all[1], range[1])};
  if (!(all[1] > all[0]))
    all[1] = all[0] + (all[0] != 0 ? 0.01 * std::abs(all[0]) : 1.0);
  return all;
}

} // namespace

Ranges ranges_of(const std::vector<Frame>& frames, const SnapshotOptions& options)
{
  std::vector<std::array<double, 2>> bird, target;
  for (const Frame& frame : frames) {
    if (frame.bird && options.colour_by != "part")
      bird.push_back(range_of(*frame.bird, options.colour_by));
    if (frame.target && !options.target_field.empty())
      target.push_back(range_of_target(*frame.target, options.target_field));
  }
  return {chosen_range(options.range, bird), chosen_range(options.target_range, target),
          bird.empty() || target.empty() ? ColourMap::viridis : ColourMap::heat};
}

bool is_cut(const SnapshotOptions& options)
{
  return options.cut.value_or(options.view == View::side && options.colour_by == "part");
}

std::optional<HalfSpace> kept(const SnapshotOptions& options)
{
  if (!is_cut(options))
    return std::nullopt;
  const double along = camera_axes(options.view).direction[static_cast<std::size_t>(options.plane.axis)];
  return HalfSpace{options.plane, along < 0 ? -1.0 : 1.0};
}

std::string cut_text(const CutPlane& plane)
{
  const std::string place = plane.at == 0  ? "0"
                            : plane.at < 0 ? "-" + length_text(-plane.at)
                                           : length_text(plane.at);
  return fmt::format("cut at {} = {}", "xyz"[plane.axis], place);
}

CameraAxes camera_axes(View view)
{
  switch (view) {
  case View::front:
    return {{1, 0, 0}, {0, 0, 1}};
  case View::top:
    return {{0, 0, -1}, {0, 1, 0}};
  case View::isometric:
  case View::behind: {
    // From the bird's right, ahead of the plate and above, so that the face that is hit can be seen.
    const Vector d = Vector(view == View::behind ? -0.72 : 0.72, 0.62, -0.42).normalized();
    const Vector up = (Vector::UnitZ() - d * d.z()).normalized();
    return {{d.x(), d.y(), d.z()}, {up.x(), up.y(), up.z()}};
  }
  case View::side:
    break;
  }
  return {{0, 1, 0}, {0, 0, 1}};
}

Scene::Scene(const SnapshotOptions& options, const Bounds& bounds, double width, double height)
    : options_(options), target_(options, *renderer_)
{
  bird_mapper_->EmissiveOff();
  bird_mapper_->SetScaleFactor(1.0);
  bird_mapper_->SetScaleArray("radius");
  bird_mapper_->SetTriangleScale(1.0);
  bird_mapper_->SetSplatShaderCode(sphere_shader);
  bird_mapper_->SetScalarModeToUsePointFieldData();
  bird_mapper_->SelectColorArray("colour");
  bird_mapper_->SetColorModeToDirectScalars();
  bird_mapper_->ScalarVisibilityOn();
  bird_->SetMapper(bird_mapper_);
  bird_->GetProperty()->LightingOff(); // the shader does it

  renderer_->SetBackground(options.background[0], options.background[1], options.background[2]);
  renderer_->AddActor(bird_);
  if (options.target_opacity < 1) {
    renderer_->SetUseDepthPeeling(true);
    renderer_->SetMaximumNumberOfPeels(8);
  }
  place_camera(bounds, width / height, height);
}

Scene::~Scene() = default;

namespace {

//! Half the size, along right, up and depth, of a box as the camera sees it.
Vector half_size(const Bounds& bounds, View view)
{
  const CameraAxes axes = camera_axes(view);
  const Vector direction(axes.direction.data()), up(axes.up.data()), right = direction.cross(up);
  const Vector low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  const Vector centre = (low + high) / 2;
  Vector half = Vector::Zero();
  for (int corner = 0; corner < 8; ++corner) {
    const Vector p((corner & 1 ? high : low).x(), (corner & 2 ? high : low).y(),
                   (corner & 4 ? high : low).z());
    const Vector seen((p - centre).dot(right), (p - centre).dot(up), (p - centre).dot(direction));
    half = half.cwiseMax(seen.cwiseAbs());
  }
  return half;
}

} // namespace

double width_over_height(const Bounds& bounds, View view)
{
  const Vector half = half_size(bounds, view);
  return std::max(half.x(), 1e-9) / std::max(half.y(), 1e-9);
}

double width_over_height(const Bounds& bounds, const SnapshotOptions& options)
{
  if (!options.window)
    return width_over_height(bounds, options.view);
  const PictureWindow& w = *options.window;
  return std::max(w[1] - w[0], 1e-9) / std::max(w[3] - w[2], 1e-9);
}

void Scene::place_camera(const Bounds& bounds, double aspect, double height)
{
  const CameraAxes axes = camera_axes(options_.view);
  const Vector direction(axes.direction.data()), up(axes.up.data());
  const Vector low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  Vector centre = (low + high) / 2, half = half_size(bounds, options_.view);
  if (const auto& w = options_.window) {
    const Vector right = direction.cross(up);
    centre += right * (((*w)[0] + (*w)[1]) / 2 - centre.dot(right)) +
              up * (((*w)[2] + (*w)[3]) / 2 - centre.dot(up));
    half.x() = ((*w)[1] - (*w)[0]) / 2;
    half.y() = ((*w)[3] - (*w)[2]) / 2;
  }
  const double reach = std::max({half.x(), half.y(), half.z(), 1e-6});
  vtkCamera& camera = *renderer_->GetActiveCamera();
  const Vector eye = centre - direction * 10 * reach;
  camera.ParallelProjectionOn();
  camera.SetFocalPoint(centre.x(), centre.y(), centre.z());
  camera.SetPosition(eye.x(), eye.y(), eye.z());
  camera.SetViewUp(up.x(), up.y(), up.z());
  camera.SetParallelScale(1.04 * std::max({half.y(), half.x() / aspect, 1e-9}));
  metres_per_pixel_ = 2 * camera.GetParallelScale() / height;
  target_.set_scale(metres_per_pixel_);
  centre_ = {centre.x(), centre.y(), centre.z()};
  half_size_ = {camera.GetParallelScale() * aspect, camera.GetParallelScale()};
  camera.SetClippingRange(1 * reach,
                          19 * reach); // debris may leave the box towards the camera or away from it
}

void Scene::show(const Frame& frame, const Ranges& ranges)
{
  bird_->SetVisibility(frame.bird != nullptr);
  if (frame.bird)
    show_bird(*frame.bird, ranges.bird);
  target_.show(frame.target, ranges);
}

double Scene::share_outside(vtkUnstructuredGrid& bird) const
{
  const CameraAxes axes = camera_axes(options_.view);
  const Vector direction(axes.direction.data()), up(axes.up.data()), right = direction.cross(up);
  const std::optional<HalfSpace> keep = kept(options_);
  double shown = 0, outside = 0;
  for (vtkIdType i = 0; i < bird.GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    bird.GetPoint(i, p.data());
    if ((keep && keep->depth(p) < 0) || !std::isfinite(p[0] + p[1] + p[2]))
      continue;
    const Vector place = Vector(p.data()) - Vector(centre_.data());
    ++shown;
    outside += std::abs(place.dot(right)) > half_size_[0] || std::abs(place.dot(up)) > half_size_[1];
  }
  return shown > 0 ? outside / shown : 0;
}

void Scene::show_bird(vtkUnstructuredGrid& bird, const std::array<double, 2>& range)
{
  const bool by_part = options_.colour_by == "part";
  const ShownArray values = find_array(bird, options_.colour_by);
  const std::vector<float> radii = radii_of(bird);
  vtkSmartPointer<vtkLookupTable> map = make_colour_map(range[0], range[1]);
  std::vector<Colour> part_colours;
  for (int k = 0; by_part && k < 256; ++k)
    part_colours.push_back(part_colour(part_name(bird, k), static_cast<std::size_t>(k)));

  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkFloatArray> radius;
  radius->SetName("radius");
  vtkNew<vtkUnsignedCharArray> colour;
  colour->SetName("colour");
  colour->SetNumberOfComponents(3);
  const std::optional<HalfSpace> keep = kept(options_);
  for (vtkIdType i = 0; i < bird.GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    bird.GetPoint(i, p.data());
    if ((keep && keep->depth(p) < 0) || !std::isfinite(p[0] + p[1] + p[2]))
      continue;
    Colour c;
    if (by_part)
      c = part_colours[static_cast<std::size_t>(std::clamp(values.value(i), 0.0, 255.0))];
    else
      map->GetColor(values.value(i), c.data());
    points->InsertNextPoint(p.data());
    radius->InsertNextValue(radii[static_cast<std::size_t>(i)]);
    for (const double part : c)
      colour->InsertNextValue(static_cast<unsigned char>(std::lround(255 * part)));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(radius);
  data->GetPointData()->AddArray(colour);
  bird_mapper_->SetInputData(data);
}

} // namespace birdstrike
