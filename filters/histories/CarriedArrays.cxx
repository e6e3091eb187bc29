// SPDX-License-Identifier: BSD-3-Clause
// What particles carry, told on a surface.
#include "CarriedArrays.h"

#include "ParallelFor.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <set>

namespace {

struct Neighbour
{
  std::size_t Particle;
  double Weight;
};

// Of the value with the largest sum of weights; of equal sums the first met counts.
double Majority(const std::vector<Neighbour>& near, const std::vector<double>& values, std::size_t components,
                std::size_t component, std::vector<std::pair<double, double>>& sums)
{
  sums.clear();
  for (const Neighbour& n : near) {
    const double value = values[n.Particle * components + component];
    auto known = std::find_if(sums.begin(), sums.end(), [&](const auto& s) { return s.first == value; });
    if (known == sums.end())
      sums.emplace_back(value, n.Weight);
    else
      known->second += n.Weight;
  }
  const auto most = std::max_element(sums.begin(), sums.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == sums.end() ? 0 : most->first;
}

} // namespace

CarriedArrays::CarriedArrays(const std::vector<vtkDataSet*>& leaves, const std::vector<std::string>* names)
{
  std::vector<std::string> wanted;
  if (names)
    wanted = *names;
  else
    for (int k = 0; !leaves.empty() && k < leaves[0]->GetPointData()->GetNumberOfArrays(); ++k)
      if (vtkDataArray* array = leaves[0]->GetPointData()->GetArray(k))
        if (array->GetName() && std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName())
          wanted.emplace_back(array->GetName());
  std::set<std::string> seen;
  for (const std::string& name : wanted) {
    if (!seen.insert(name).second)
      continue;
    Array all{name, {}, 0, true};
    for (vtkDataSet* leaf : leaves) {
      vtkDataArray* array = leaf->GetPointData()->GetArray(name.c_str());
      if (!array || array->GetNumberOfTuples() < leaf->GetNumberOfPoints() ||
          (!all.Of.empty() && array->GetNumberOfComponents() != all.Components))
        break;
      all.Components = array->GetNumberOfComponents();
      all.Average = all.Average && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
      all.Of.push_back(array);
    }
    if (all.Of.size() == leaves.size() && all.Components > 0)
      this->Arrays.push_back(all);
    else
      this->Missing.push_back(name);
  }
}

void CarriedArrays::Interpolate(const SphField& field, const std::vector<ParticleRow>& rows,
                                const std::vector<Vector3d>& places, vtkPointData* to,
                                const std::function<bool(double)>& goOn) const
{
  const auto count = static_cast<vtkIdType>(places.size());
  std::vector<std::vector<double>> from;
  std::vector<vtkSmartPointer<vtkDataArray>> into;
  for (const Array& array : this->Arrays) {
    const auto components = static_cast<std::size_t>(array.Components);
    std::vector<double> values(rows.size() * components);
    for (std::size_t i = 0; i < rows.size(); ++i)
      array.Of[rows[i].Leaf]->GetTuple(rows[i].Row, values.data() + i * components);
    from.push_back(std::move(values));
    auto made = vtkSmartPointer<vtkDataArray>::Take(array.Of[0]->NewInstance());
    if (made->GetDataType() == VTK_BIT) // whose neighbours no two threads may write
      made = vtkSmartPointer<vtkUnsignedCharArray>::New();
    made->SetName(array.Name.c_str());
    made->SetNumberOfComponents(array.Components);
    for (int k = 0; k < array.Components; ++k)
      if (const char* name = array.Of[0]->GetComponentName(k))
        made->SetComponentName(k, name);
    made->SetNumberOfTuples(count);
    to->AddArray(made);
    into.push_back(made);
  }
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);

  ParallelFor(
      places.size(), 1024,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> near;
        std::vector<std::pair<double, double>> sums;
        for (auto v = static_cast<vtkIdType>(begin); v < static_cast<vtkIdType>(end); ++v) {
          near.clear();
          Vector3d uphill{};
          double all = 0;
          const Vector3d& place = places[static_cast<std::size_t>(v)];
          field.ForEachNear(place, [&](std::size_t i, double squared) {
            const double weight = field.Share(i, squared), slope = field.Slope(i, squared);
            for (std::size_t k = 0; k < 3; ++k)
              uphill[k] += slope * (place[k] - field.GetPoints()[i][k]);
            near.push_back({i, weight});
            all += weight;
          });
          if (all <= 0) { // beyond a small kernel, on an edge of the grid that is longer than it
            const std::size_t i = field.Nearest(place);
            near.assign(1, {i, 1});
            all = 1;
            for (std::size_t k = 0; k < 3; ++k)
              uphill[k] = field.GetPoints()[i][k] - place[k];
          }
          const double length = std::sqrt(DistanceSquared(uphill, {}));
          for (int k = 0; k < 3; ++k)
            normals->SetTypedComponent(
                v, k, length > 0 ? static_cast<float>(-uphill[static_cast<std::size_t>(k)] / length) : 0.0F);
          for (std::size_t a = 0; a < from.size(); ++a) {
            const auto components = static_cast<std::size_t>(this->Arrays[a].Components);
            for (std::size_t k = 0; k < components; ++k) {
              double value = 0;
              if (this->Arrays[a].Average) {
                for (const Neighbour& n : near)
                  value += n.Weight * from[a][n.Particle * components + k];
                value /= all;
              } else {
                value = Majority(near, from[a], components, k, sums);
              }
              into[a]->SetComponent(v, static_cast<int>(k), value);
            }
          }
        }
      },
      goOn);
  to->SetNormals(normals);
}
