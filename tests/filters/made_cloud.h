// SPDX-License-Identifier: BSD-3-Clause
// Clouds of particles, as frames have them, for the tests of the filters.
#pragma once

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

struct CloudParticle
{
  std::array<double, 3> place;
  std::array<double, 3> velocity{};
  double mass = 1, h = 0.012;
  int part = 0;
};

using Cloud = std::vector<CloudParticle>;

//! A cubic lattice in a box of 2 \p half where \p inside holds; \p h is 1.2 spacings.
inline Cloud made_cloud(double half, double spacing,
                        const std::function<bool(const std::array<double, 3>&)>& inside)
{
  Cloud cloud;
  const int n = static_cast<int>(half / spacing) + 1;
  for (int i = -n; i < n; ++i)
    for (int j = -n; j < n; ++j)
      for (int k = -n; k < n; ++k) {
        const std::array<double, 3> p{(i + 0.5) * spacing, (j + 0.5) * spacing, (k + 0.5) * spacing};
        if (inside(p))
          cloud.push_back({.place = p, .mass = 1000 * spacing * spacing * spacing, .h = 1.2 * spacing});
      }
  return cloud;
}

inline Cloud made_ball(double radius, double spacing)
{
  return made_cloud(radius, spacing, [radius](const std::array<double, 3>& p) {
    return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < radius * radius;
  });
}

//! With the arrays mass, velocity, smoothing_length and part; points without cells.
inline vtkSmartPointer<vtkPolyData> to_data(const Cloud& cloud)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> mass, velocity, h;
  vtkNew<vtkIntArray> part;
  mass->SetName("mass");
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  h->SetName("smoothing_length");
  part->SetName("part");
  for (const CloudParticle& p : cloud) {
    points->InsertNextPoint(p.place.data());
    mass->InsertNextValue(p.mass);
    velocity->InsertNextTuple(p.velocity.data());
    h->InsertNextValue(p.h);
    part->InsertNextValue(p.part);
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(mass);
  data->GetPointData()->AddArray(velocity);
  data->GetPointData()->AddArray(h);
  data->GetPointData()->AddArray(part);
  return data;
}

//! All that a filter complains about, one after the other; it then prints nothing.
class Messages
{
public:
  void watch(vtkObject& object)
  {
    object.AddObserver(vtkCommand::ErrorEvent, listener);
    object.AddObserver(vtkCommand::WarningEvent, listener);
  }
  const std::string& text() const { return listener->all; }

private:
  struct Listener : vtkCommand
  {
    static Listener* New() { return new Listener; }
    void Execute(vtkObject*, unsigned long, void* data) override { all += static_cast<const char*>(data); }
    std::string all;
  };
  vtkNew<Listener> listener;
};
