// SPDX-License-Identifier: BSD-3-Clause
// Deflection of the target, largest and at chosen points, step by step, and what stays of it.
#include "vtkTargetDeflectionHistory.h"

#include "HiddenCells.h"
#include "LineOnTarget.h"
#include "SteadyTurn.h"
#include "TrailingMean.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>

vtkStandardNewMacro(vtkTargetDeflectionHistory);

namespace {

using Vector = std::array<double, 3>;
constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr Vector NoVector{None, None, None};
constexpr const char* Axes[] = {"x", "y", "z"};

double Length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

} // namespace

vtkTargetDeflectionHistory::vtkTargetDeflectionHistory()
    : Trailing(std::make_unique<TrailingMean>()), Line(std::make_unique<LineOnTarget>())
{
  this->SetNumberOfOutputPorts(2);
}

vtkTargetDeflectionHistory::~vtkTargetDeflectionHistory() = default;

void vtkTargetDeflectionHistory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DisplacementArrayName: " << this->DisplacementArrayName << "\n";
  os << indent << "PointsMove: " << this->PointsMove << "\n";
  for (const ChosenPoint& point : this->Chosen)
    os << indent << "Point " << point.Name << ": " << point.Place[0] << ", " << point.Place[1] << ", "
       << point.Place[2] << "\n";
  os << indent << "Direction: " << this->Direction[0] << ", " << this->Direction[1] << ", "
     << this->Direction[2] << "\n";
  os << indent << "WindowShare: " << this->WindowShare << "\n";
  os << indent << "UseLine: " << this->UseLine << "\n";
  os << indent << "LineStart: " << this->LineStart[0] << ", " << this->LineStart[1] << ", "
     << this->LineStart[2] << "\n";
  os << indent << "LineEnd: " << this->LineEnd[0] << ", " << this->LineEnd[1] << ", " << this->LineEnd[2]
     << "\n";
  os << indent << "LinePoints: " << this->LinePoints << "\n";
  os << indent << "DistanceColumnName: " << this->DistanceColumnName << "\n";
  os << indent << "Details: " << this->Details << "\n";
  os << indent << "IgnoreErodedCells: " << this->IgnoreErodedCells << "\n";
  os << indent << "ErodedArrayName: " << this->ErodedArrayName << "\n";
}

void vtkTargetDeflectionHistory::AddPoint(double x, double y, double z, const char* name)
{
  const bool named = name && *name;
  ChosenPoint point;
  point.Place = {x, y, z};
  point.Name = named ? name : std::to_string(this->Chosen.size());
  this->Chosen.push_back(std::move(point));
  this->Modified();
}

void vtkTargetDeflectionHistory::RemoveAllPoints()
{
  this->Chosen.clear();
  this->Modified();
}

void vtkTargetDeflectionHistory::Clear()
{
  this->Found = false;
  this->Followed = true;
  this->FirstCounts.clear();
  this->Now = State();
  *this->Trailing = TrailingMean();
  for (auto* column : {&this->RowTimes, &this->Deflection, &this->MaxAlong, &this->X, &this->Y, &this->Z})
    column->clear();
  this->Point.clear();
  *this->Line = LineOnTarget();
  this->Profiles.clear();
  for (ChosenPoint& point : this->Chosen)
    point.History.clear();
}

bool vtkTargetDeflectionHistory::CheckProperties()
{
  if (!(this->WindowShare >= 0 && this->WindowShare <= 1)) {
    vtkErrorMacro("Window Share is " << this->WindowShare << "; it is a share of the series' time, 0 to 1.");
    return false;
  }
  const double length = std::hypot(this->Direction[0], this->Direction[1], this->Direction[2]);
  if (!std::isfinite(length)) {
    vtkErrorMacro("Direction has a component that is no finite number.");
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k)
    this->Unit[k] = length > 0 ? this->Direction[k] / length : 0;
  const Vector line{this->LineEnd[0] - this->LineStart[0], this->LineEnd[1] - this->LineStart[1],
                    this->LineEnd[2] - this->LineStart[2]};
  if (this->UseLine && !(Length(line) > 0 && std::isfinite(Length(line)))) {
    vtkErrorMacro(
        "The line has no length: Line Start and Line End are the same place, or no finite numbers.");
    return false;
  }
  std::set<std::string> names;
  for (const ChosenPoint& point : this->Chosen) {
    if (!std::isfinite(point.Place[0] + point.Place[1] + point.Place[2])) {
      vtkErrorMacro("The chosen point '" << point.Name << "' has a coordinate that is no finite number.");
      return false;
    }
    if (point.Name.find_first_of("[],;\"\n") != std::string::npos) {
      vtkErrorMacro("The name of the chosen point '" << point.Name
                                                     << "' has a bracket, quote, comma or semicolon, which a "
                                                        "column's title cannot hold.");
      return false;
    }
    if (!names.insert(point.Name).second) {
      vtkErrorMacro("Two chosen points have the name '" << point.Name << "'; give one of them another.");
      return false;
    }
  }
  return true;
}

double vtkTargetDeflectionHistory::Along(const Vector& u) const
{
  return u[0] * this->Unit[0] + u[1] * this->Unit[1] + u[2] * this->Unit[2];
}

// Fills Now, which has no counts if there is no target at this step.
bool vtkTargetDeflectionHistory::Gather(double time, const std::vector<vtkDataSet*>& leaves)
{
  this->Now = State();
  for (vtkDataSet* leaf : leaves) {
    vtkDataArray* displacement = leaf->GetPointData()->GetArray(this->DisplacementArrayName.c_str());
    if (!displacement)
      continue;
    if (displacement->GetNumberOfComponents() != 3) {
      vtkErrorMacro("The point array '" << this->DisplacementArrayName << "' has "
                                        << displacement->GetNumberOfComponents()
                                        << " components; a displacement has three.");
      return false;
    }
    const vtkIdType count = leaf->GetNumberOfPoints();
    if (displacement->GetNumberOfTuples() != count) {
      vtkErrorMacro("The point array '" << this->DisplacementArrayName << "' has "
                                        << displacement->GetNumberOfTuples() << " rows for " << count
                                        << " points; it must have one for each.");
      return false;
    }
    this->Found = true;
    const std::vector<bool> hidden =
        this->IgnoreErodedCells ? HiddenPoints(leaf, this->ErodedArrayName) : std::vector<bool>();
    this->Now.Counts.push_back(static_cast<std::size_t>(count));
    this->Now.Leaves.push_back(leaf);
    const SteadyTurn turn(leaf);
    for (vtkIdType i = 0; i < count; ++i) {
      Vector u{}, place{};
      displacement->GetTuple(i, u.data());
      leaf->GetPoint(i, place.data());
      if (this->PointsMove)
        place = turn.Back(place, time);
      for (std::size_t k = 0; this->PointsMove && k < 3; ++k)
        place[k] -= u[k];
      const bool there = hidden.empty() || !hidden[static_cast<std::size_t>(i)];
      this->Now.Displacement.push_back(there ? u : NoVector);
      this->Now.Place.push_back(place);
      this->Now.Row.push_back(i);
    }
  }
  return true;
}

void vtkTargetDeflectionHistory::FindNearest()
{
  for (ChosenPoint& point : this->Chosen) {
    point.Distance = None;
    point.Row = -1;
    for (std::size_t i = 0; i < this->Now.Place.size(); ++i) {
      const Vector& p = this->Now.Place[i];
      const double distance = Length({p[0] - point.Place[0], p[1] - point.Place[1], p[2] - point.Place[2]});
      if (std::isnan(Length(this->Now.Displacement[i])) || distance >= point.Distance || std::isnan(distance))
        continue;
      point.Nearest = i;
      point.Row = this->Now.Row[i];
      point.Distance = distance;
    }
  }
}

// A place so far off the target that the nearest point says nothing of it; told of.
void vtkTargetDeflectionHistory::CheckDistances()
{
  vtkBoundingBox box;
  for (const Vector& place : this->Now.Place)
    box.AddPoint(place[0], place[1], place[2]);
  constexpr double near = 0.1; // of the target's size
  const double limit = near * (box.IsValid() ? box.GetDiagonalLength() : 0);
  for (const ChosenPoint& point : this->Chosen)
    if (point.Distance > limit)
      vtkWarningMacro("The chosen point '" << point.Name << "' is " << point.Distance
                                           << " m away from the target, whose nearest point stands for it.");
  const std::vector<LineOnTarget::Sample>& samples = this->Line->Samples();
  if (!samples.empty() &&
      std::all_of(samples.begin(), samples.end(),
                  [limit](const LineOnTarget::Sample& sample) { return sample.Off > limit; }))
    vtkWarningMacro(
        "The line lies nowhere near the target: its deflections are those of the nearest places.");
}

void vtkTargetDeflectionHistory::CheckCounts(double time)
{
  if (this->FirstCounts.empty()) {
    this->FirstCounts = this->Now.Counts;
    this->FindNearest();
    if (this->UseLine) {
      this->Line->Start({this->LineStart[0], this->LineStart[1], this->LineStart[2]},
                        {this->LineEnd[0], this->LineEnd[1], this->LineEnd[2]}, this->LinePoints);
      this->Line->Tie(this->Now.Leaves, this->Now.Place);
    }
    this->CheckDistances();
  }
  if (!this->Followed || this->Now.Counts == this->FirstCounts)
    return;
  this->Followed = false;
  std::size_t before = 0;
  for (const std::size_t count : this->FirstCounts)
    before += count;
  vtkWarningMacro(
      "The target has " << this->Now.Row.size() << " points at " << time << " s, and had " << before
                        << " before: points cannot be followed, so that there is no permanent "
                           "set, and no deflection at chosen points and along a line from there on.");
}

bool vtkTargetDeflectionHistory::AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves)
{
  if (this->RowTimes.empty()) {
    if (!this->CheckProperties())
      return false;
    this->Trailing->Start(this->GetTimes().empty() ? std::vector<double>{time} : this->GetTimes(),
                          this->WindowShare);
  }
  if (!this->Gather(time, leaves))
    return false;
  const bool there = !this->Now.Counts.empty();
  if (there)
    this->CheckCounts(time);
  else
    this->NoteAbsence(time);

  double largest = None, along = None;
  Vector place = NoVector;
  vtkIdType row = -1;
  for (std::size_t i = 0; i < this->Now.Row.size(); ++i) {
    const Vector& u = this->Now.Displacement[i];
    const double length = Length(u), component = this->Along(u);
    if (std::isnan(length))
      continue;
    if (!(std::abs(component) <= std::abs(along)))
      along = component;
    if (length <= largest)
      continue;
    largest = length;
    place = this->Now.Place[i];
    row = this->Now.Row[i];
  }
  this->RowTimes.push_back(time);
  this->Deflection.push_back(largest);
  this->MaxAlong.push_back(along);
  this->X.push_back(place[0]);
  this->Y.push_back(place[1]);
  this->Z.push_back(place[2]);
  this->Point.push_back(row);
  for (ChosenPoint& point : this->Chosen) {
    const bool known = there && this->Followed && !std::isnan(point.Distance);
    point.History.push_back(known ? this->Now.Displacement[point.Nearest] : NoVector);
  }
  this->Profiles.emplace_back();
  for (const LineOnTarget::Sample& sample : this->Line->Samples()) {
    const bool known = there && this->Followed;
    const Vector u = known ? LineOnTarget::Interpolate(sample, this->Now.Displacement) : NoVector;
    this->Profiles.back().push_back(Length(this->Unit) > 0 ? this->Along(u) : Length(u));
  }
  if (there && this->Followed)
    this->Trailing->Add(this->GetStep(), this->Now.Displacement);
  return true;
}

bool vtkTargetDeflectionHistory::FillTable(vtkTable* table)
{
  if (!this->Found) {
    vtkErrorMacro("No dataset of the input has the point array '"
                  << this->DisplacementArrayName << "' at any of its " << this->RowTimes.size()
                  << " time steps; set Displacement Array to the array that holds the displacement"
                  << this->GetArrays() << ".");
    return false;
  }
  this->WarnOfAbsence(this->DisplacementArrayName);
  this->AddTimes(table, this->RowTimes);
  AddColumn(table, "max_deflection[m]", this->Deflection);
  if (this->Details) {
    AddColumn(table, "x[m]", this->X);
    AddColumn(table, "y[m]", this->Y);
    AddColumn(table, "z[m]", this->Z);
    AddIdColumn(table, "point", this->Point);
  }
  if (Length(this->Unit) > 0)
    AddColumn(table, "max_deflection_along[m]", this->MaxAlong);
  this->FillSet(table);
  this->FillChosen(table);
  return true;
}

// What holds for the whole series, of all points.
void vtkTargetDeflectionHistory::FillSet(vtkTable* table) const
{
  const auto constant = [&](const std::string& title, double value) {
    AddColumn(table, title, std::vector<double>(this->RowTimes.size(), value));
  };
  double set = None, along = None, amplitude = None, largestAmplitude = None;
  Vector place = NoVector;
  for (std::size_t i = 0; this->Trailing->Complete() && i < this->Trailing->Count(); ++i) {
    const Vector mean = this->Trailing->Mean(i);
    const double length = Length(mean), component = this->Along(mean), swing = this->Trailing->Amplitude(i);
    if (std::isnan(length))
      continue;
    if (!(swing <= largestAmplitude))
      largestAmplitude = swing;
    if (!(std::abs(component) <= std::abs(along)))
      along = component;
    if (length <= set)
      continue;
    set = length;
    amplitude = swing;
    place = this->Now.Place[i];
  }
  constant("permanent_set[m]", set);
  for (std::size_t k = 0; this->Details && k < 3; ++k)
    constant(std::string(Axes[k]) + "_of_permanent_set[m]", place[k]);
  if (Length(this->Unit) > 0)
    constant("permanent_set_along[m]", along);
  if (!this->Details)
    return;
  constant("residual_amplitude[m]", amplitude);
  constant("max_residual_amplitude[m]", largestAmplitude);
}

void vtkTargetDeflectionHistory::FillChosen(vtkTable* table) const
{
  const std::size_t rows = this->RowTimes.size();
  for (const ChosenPoint& point : this->Chosen) {
    const std::string at = "_at_" + point.Name;
    const auto history = [&](const std::string& title, auto value) {
      std::vector<double> values;
      for (const Vector& u : point.History)
        values.push_back(value(u));
      AddColumn(table, title + at + "[m]", values);
    };
    const auto constant = [&](const std::string& title, double value) {
      AddColumn(table, title + at + "[m]", std::vector<double>(rows, value));
    };
    history("deflection", Length);
    for (std::size_t k = 0; this->Details && k < 3; ++k)
      history(std::string("deflection_") + Axes[k], [k](const Vector& u) { return u[k]; });
    if (Length(this->Unit) > 0)
      history("deflection_along", [this](const Vector& u) { return this->Along(u); });

    if (!this->Details)
      continue;
    const bool known = !std::isnan(point.Distance);
    AddIdColumn(table, "mesh_point" + at, std::vector<vtkIdType>(rows, point.Row));
    constant("distance", point.Distance);
    const bool set = known && this->Trailing->Complete();
    const Vector mean = set ? this->Trailing->Mean(point.Nearest) : NoVector;
    constant("permanent_set", Length(mean));
    if (Length(this->Unit) > 0)
      constant("permanent_set_along", this->Along(mean));
    constant("residual_amplitude", set ? this->Trailing->Amplitude(point.Nearest) : None);
  }
}

void vtkTargetDeflectionHistory::FillSecondTable(vtkTable* table)
{
  const std::vector<LineOnTarget::Sample>& samples = this->Line->Samples();
  if (samples.empty())
    return;
  const auto column = [&](const std::string& title, auto value) {
    std::vector<double> values;
    for (const LineOnTarget::Sample& sample : samples)
      values.push_back(value(sample));
    AddColumn(table, title, values);
  };
  column(this->DistanceColumnName, [](const LineOnTarget::Sample& sample) { return sample.Along; });
  if (this->Details) {
    for (std::size_t k = 0; k < 3; ++k)
      column(std::string(Axes[k]) + "[m]",
             [k](const LineOnTarget::Sample& sample) { return sample.Place[k]; });
    column("off_target[m]", [](const LineOnTarget::Sample& sample) { return sample.Off; });
  }
  for (std::size_t row = 0; row < this->RowTimes.size(); ++row) {
    std::vector<double> profile = this->Profiles[row];
    profile.resize(samples.size(), None); // before there was a target
    std::ostringstream title;
    title << std::setprecision(9) << "deflection_at_" << this->RowTimes[row] << "s[m]";
    AddColumn(table, title.str(), profile);
  }
}
