// SPDX-License-Identifier: BSD-3-Clause
// The skin of smoothed particles.
#include "vtkBirdSurface.h"

#include "CarriedArrays.h"
#include "DatasetLeaves.h"
#include "SphSkin.h"
#include "StepLoop.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <sstream>
#include <tuple>

vtkStandardNewMacro(vtkBirdSurface);

// In an order that depends on nothing but where they are.
struct vtkBirdSurface::Particles
{
  std::vector<vtkDataSet*> Leaves;
  double Smoothing = 0; // of all particles; 0: from the array
  std::vector<Vector3d> Points;
  std::vector<double> H;
  std::vector<ParticleRow> Rows;
};

namespace {

vtkSmartPointer<vtkPolyData> ToPolyData(const SphSkin& skin)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(skin.Points.size()));
  for (std::size_t i = 0; i < skin.Points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), skin.Points[i].data());
  auto offsets = vtkSmartPointer<vtkIdTypeArray>::New();
  auto corners = vtkSmartPointer<vtkIdTypeArray>::New();
  const auto count = static_cast<vtkIdType>(skin.Triangles.size());
  offsets->SetNumberOfValues(count + 1);
  corners->SetNumberOfValues(3 * count);
  for (vtkIdType t = 0; t <= count; ++t)
    offsets->SetValue(t, 3 * t);
  for (vtkIdType t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k)
      corners->SetValue(3 * t + k, skin.Triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)]);
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->SetData(offsets, corners);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

//! Radius, in smoothing lengths, of the ball that a lone particle keeps at \p level of the colour function.
double LoneRadius(double level)
{
  double low = 0, high = SphField::Support;
  while (high - low > 1e-9) {
    const double q = (low + high) / 2, a = 2 - q, b = std::max(1 - q, 0.0);
    (0.25 * a * a * a - b * b * b > level ? low : high) = q;
  }
  return low;
}

//! Lone particles whose ball is so small that it may lie between the points of a lattice of \p spacing [m].
std::size_t BetweenPoints(const SphField& field, double spacing, double level)
{
  const double least = std::sqrt(0.75) * spacing / LoneRadius(level);
  std::size_t count = 0;
  for (std::size_t i = 0; i < field.GetSmoothing().size(); ++i)
    count += field.IsAlone(i) && field.GetSmoothing()[i] < least;
  return count;
}

} // namespace

void vtkBirdSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SmoothingLengthArrayName: " << this->SmoothingLengthArrayName << "\n";
  os << indent << "SmoothingLength: " << this->SmoothingLength << "\n";
  os << indent << "SmoothingFactor: " << this->SmoothingFactor << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "GridShare: " << this->GridShare << "\n";
  os << indent << "SurfacePerPart: " << this->SurfacePerPart << "\n";
  os << indent << "PartArrayName: " << this->PartArrayName << "\n";
  os << indent << "AllArrays: " << this->AllArrays << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}

void vtkBirdSurface::AddArray(const char* name)
{
  if (!name || !*name)
    return;
  this->ArrayNames.emplace_back(name);
  this->Modified();
}

void vtkBirdSurface::ClearArrays()
{
  this->ArrayNames.clear();
  this->Modified();
}

int vtkBirdSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

bool vtkBirdSurface::CheckProperties()
{
  const auto within = [this](const char* name, double value, double low, double high) {
    if (value >= low && value <= high)
      return true;
    vtkErrorMacro(<< name << " is " << value << "; it must lie between " << low << " and " << high << ".");
    return false;
  };
  return within("Level", this->Level, 0.05, 0.95) && within("Grid Share", this->GridShare, 0.05, 2) &&
         within("Smoothing Factor", this->SmoothingFactor, 0.1, 10) &&
         within("Smoothing Length", this->SmoothingLength, 0, 1e6) &&
         within("Memory Limit", this->MemoryLimit, 1, 1e9);
}

// Once for each state of the properties, not at every step of a film.
void vtkBirdSurface::Warn(const std::string& text)
{
  if (this->MayWarn)
    vtkWarningMacro(<< text);
}

bool vtkBirdSurface::FindLeaves(vtkDataObject* input, Particles& particles)
{
  const std::vector<DatasetLeaf> leaves = DatasetLeaves(input);
  for (const DatasetLeaf& leaf : leaves)
    if (leaf.Data->GetPointData()->GetArray(this->SmoothingLengthArrayName.c_str()))
      particles.Leaves.push_back(leaf.Data);
  if (!particles.Leaves.empty())
    return true;

  double spacing = 0;
  for (const DatasetLeaf& leaf : leaves)
    if (leaf.Data->GetNumberOfPoints() > 0 && IsPointCloud(leaf.Data)) {
      particles.Leaves.push_back(leaf.Data);
      spacing = spacing > 0 ? spacing : SpacingOf(leaf.Data);
    }
  if (particles.Leaves.empty()) {
    vtkErrorMacro(
        "None of the " << leaves.size() << " datasets of the input has the point array '"
                       << this->SmoothingLengthArrayName
                       << "', and none is a cloud of points; set Smoothing Length Array to the array that "
                          "holds the smoothing length of the particles"
                       << ArraysOf(leaves) << ".");
    return false;
  }
  particles.Smoothing = this->SmoothingLength > 0 ? this->SmoothingLength : SmoothingOverSpacing * spacing;
  if (!(particles.Smoothing > 0) || !std::isfinite(particles.Smoothing)) {
    vtkErrorMacro(
        "The particles have neither the point array '"
        << this->SmoothingLengthArrayName
        << "' nor the field array 'spacing'; set Smoothing Length to some 1.2 times the distance between "
           "neighbours, in metres.");
    return false;
  }
  std::ostringstream text;
  text << "The particles have no point array '" << this->SmoothingLengthArrayName
       << "': " << particles.Smoothing << " m is taken as the smoothing length of all, "
       << (this->SmoothingLength > 0 ? "as Smoothing Length says." : "1.2 times the field array 'spacing'.");
  this->Warn(text.str());
  return true;
}

void vtkBirdSurface::Gather(Particles& particles)
{
  struct Found
  {
    Vector3d Point;
    double H;
    ParticleRow Row;
  };
  std::vector<Found> found;
  vtkIdType all = 0;
  for (std::size_t leaf = 0; leaf < particles.Leaves.size(); ++leaf) {
    vtkDataSet* data = particles.Leaves[leaf];
    vtkDataArray* h = particles.Smoothing > 0
                          ? nullptr
                          : data->GetPointData()->GetArray(this->SmoothingLengthArrayName.c_str());
    const vtkIdType count = data->GetNumberOfPoints();
    all += count;
    for (vtkIdType i = 0; i < count; ++i) {
      Found one{{}, particles.Smoothing, {leaf, i}};
      if (h)
        one.H = i < h->GetNumberOfTuples() ? h->GetComponent(i, 0) : 0;
      one.H *= this->SmoothingFactor;
      data->GetPoint(i, one.Point.data());
      if (one.H > 0 && std::isfinite(one.H) && std::isfinite(one.Point[0]) && std::isfinite(one.Point[1]) &&
          std::isfinite(one.Point[2]))
        found.push_back(one);
    }
  }
  const auto left = static_cast<std::size_t>(all) - found.size();
  if (left > 0)
    this->Warn(
        std::to_string(left) + " of " + std::to_string(all) +
        " particles are left out: their position is not finite, or their smoothing length not above 0.");
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return std::tie(a.Point, a.H, a.Row.Leaf, a.Row.Row) < std::tie(b.Point, b.H, b.Row.Leaf, b.Row.Row);
  });
  for (const Found& one : found) {
    particles.Points.push_back(one.Point);
    particles.H.push_back(one.H);
    particles.Rows.push_back(one.Row);
  }
}

bool vtkBirdSurface::MakeSurfaces(const Particles& particles, vtkMultiBlockDataSet* output)
{
  std::map<long long, std::vector<std::size_t>> groups;
  if (this->SurfacePerPart) {
    std::vector<vtkDataArray*> parts;
    for (vtkDataSet* leaf : particles.Leaves) {
      parts.push_back(leaf->GetPointData()->GetArray(this->PartArrayName.c_str()));
      if (!parts.back() || parts.back()->GetNumberOfTuples() < leaf->GetNumberOfPoints()) {
        vtkErrorMacro("The particles have no point array '"
                      << this->PartArrayName
                      << "' to tell the parts apart; set Part Array, or make one surface of all particles.");
        return false;
      }
    }
    for (std::size_t i = 0; i < particles.Points.size(); ++i) {
      const ParticleRow& row = particles.Rows[i];
      groups[std::llround(parts[row.Leaf]->GetComponent(row.Row, 0))].push_back(i);
    }
  } else {
    for (std::size_t i = 0; i < particles.Points.size(); ++i)
      groups[-1].push_back(i);
  }

  std::vector<double> sorted = particles.H;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double spacing = this->GridShare * sorted[sorted.size() / 2];

  const CarriedArrays arrays(particles.Leaves, this->AllArrays ? nullptr : &this->ArrayNames);
  for (const std::string& name : arrays.GetMissing())
    if (!this->AllArrays)
      this->Warn("The particles have no point array '" + name + "': it is not carried along.");
  vtkFieldData* fields = particles.Leaves[0]->GetFieldData();
  auto* names = vtkStringArray::SafeDownCast(fields ? fields->GetAbstractArray("part_names") : nullptr);

  unsigned int block = 0;
  for (const auto& group : groups) {
    std::vector<Vector3d> points;
    std::vector<double> h;
    std::vector<ParticleRow> rows;
    for (const std::size_t i : group.second) {
      points.push_back(particles.Points[i]);
      h.push_back(particles.H[i]);
      rows.push_back(particles.Rows[i]);
    }
    const SphField field(std::move(points), std::move(h));
    if (const std::size_t missed = BetweenPoints(field, spacing, this->Level); missed > 0) {
      std::ostringstream text;
      text << missed << " particles of " << field.GetPoints().size()
           << " are alone and so small that they may slip through the grid of " << spacing
           << " m; a lower Grid Share shows them all.";
      this->Warn(text.str());
    }
    const auto within = [&](double low, double high) { // shares of this surface's time
      const double start = block, all = static_cast<double>(groups.size());
      return [=, this](double share) {
        this->UpdateProgress((start + low + (high - low) * share) / all);
        return !Stopped(*this);
      };
    };
    const SphSkin skin = MakeSphSkin(field, spacing, this->Level, this->MemoryLimit * 1e6, within(0.1, 0.8));
    vtkSmartPointer<vtkPolyData> surface = ToPolyData(skin);
    arrays.Interpolate(field, rows, skin.Points, surface->GetPointData(), within(0.8, 1));
    surface->GetPointData()->SetActiveScalars(
        this->PartArrayName.c_str()); // ParaView opens it coloured by these
    if (fields)
      surface->GetFieldData()->ShallowCopy(fields);
    std::string name = "bird";
    if (this->SurfacePerPart) {
      const bool named = names && group.first >= 0 && group.first < names->GetNumberOfValues();
      name = named ? std::string(names->GetValue(group.first)) : "part_" + std::to_string(group.first);
    }
    output->SetBlock(block, surface);
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
    ++block;
    this->UpdateProgress(static_cast<double>(block) / static_cast<double>(groups.size()));
    if (Stopped(*this))
      return false;
  }
  return true;
}

int vtkBirdSurface::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputs);
  output->Initialize();
  this->MayWarn = this->Warned != this->GetMTime();
  Particles particles;
  if (!this->CheckProperties() || !this->FindLeaves(vtkDataObject::GetData(inputs[0]), particles))
    return 1;
  bool fine = false;
  try {
    this->Gather(particles);
    if (particles.Points.empty())
      vtkErrorMacro("The input has no particle with a finite position and a smoothing length above 0.");
    else
      fine = this->MakeSurfaces(particles, output);
  } catch (const SkinTooLarge& large) {
    vtkErrorMacro(<< large.what() << ", which does not fit into " << this->MemoryLimit
                  << " MB; raise Grid Share for a coarser grid, or Memory Limit.");
  } catch (const std::bad_alloc&) {
    vtkErrorMacro(
        "The memory of this machine does not do for the surface; raise Grid Share for a coarser grid.");
  }
  this->Warned = this->GetMTime();
  if (!fine)
    output->Initialize();
  return 1;
}
