// SPDX-License-Identifier: BSD-3-Clause
// Largest value that each point or cell has had over a time series, and when.
#include "vtkPeakOverTime.h"

#include "DatasetLeaves.h"
#include "RunningPeaks.h"
#include "StepLoop.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkPeakOverTime);

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkPeakOverTime::vtkPeakOverTime() = default;
vtkPeakOverTime::~vtkPeakOverTime() = default;

void vtkPeakOverTime::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Smallest: " << this->Smallest << "\n";
  os << indent << "UpToCurrentTime: " << this->UpToCurrentTime << "\n";
  os << indent << "IdArrayName: " << this->IdArrayName << "\n";
  os << indent << "LimitTime: " << this->LimitTime << "\n";
  os << indent << "StartTime: " << this->StartTime << "\n";
  os << indent << "EndTime: " << this->EndTime << "\n";
}

void vtkPeakOverTime::Forget()
{
  this->Done = 0;
  this->Peaks.clear();
  this->Lost.clear();
  this->Numbered.clear();
  this->Absent.clear();
  this->AbsenceTold = false;
  this->ComponentName.clear();
}

int vtkPeakOverTime::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

// Called when the input or a setting has changed: what was gathered is void.
int vtkPeakOverTime::RequestInformation(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  this->Forget();
  this->Times.clear();
  this->NoTimes.clear();
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  if (in->Has(Pipeline::TIME_STEPS())) {
    const double* times = in->Get(Pipeline::TIME_STEPS());
    this->Times.assign(times, times + in->Length(Pipeline::TIME_STEPS()));
    if (this->LimitTime)
      this->NoTimes = LimitTimes(this->Times, this->StartTime, this->EndTime);
  }
  return 1;
}

int vtkPeakOverTime::RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                                         vtkInformationVector* outputs)
{
  if (!this->Superclass::RequestUpdateExtent(request, inputs, outputs))
    return 0;
  this->Wanted = 1;
  if (this->Times.empty())
    return 1;
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  vtkInformation* out = outputs->GetInformationObject(0);
  this->Now =
      out->Has(Pipeline::UPDATE_TIME_STEP()) ? out->Get(Pipeline::UPDATE_TIME_STEP()) : this->Times.back();
  this->Wanted = this->Times.size();
  if (this->UpToCurrentTime)
    while (this->Wanted > 0 && this->Times[this->Wanted - 1] > this->Now)
      --this->Wanted;
  if (this->Done > this->Wanted) // time has gone back
    this->Forget();
  in->Set(Pipeline::UPDATE_TIME_STEP(), this->Done < this->Wanted ? this->Times[this->Done] : this->Now);
  return 1;
}

vtkDataArray* vtkPeakOverTime::ArrayOf(vtkDataSet* leaf, bool& onPoints) const
{
  vtkDataArray* array = leaf->GetPointData()->GetArray(this->ArrayName.c_str());
  onPoints = array != nullptr;
  if (!array)
    array = leaf->GetCellData()->GetArray(this->ArrayName.c_str());
  const vtkIdType rows = onPoints ? leaf->GetNumberOfPoints() : leaf->GetNumberOfCells();
  return array && array->GetNumberOfTuples() == rows ? array : nullptr;
}

vtkDataArray* vtkPeakOverTime::IdsOf(vtkDataSet* leaf, bool onPoints) const
{
  vtkDataArray* ids = onPoints ? leaf->GetPointData()->GetArray(this->IdArrayName.c_str()) : nullptr;
  return ids && ids->GetNumberOfTuples() == leaf->GetNumberOfPoints() ? ids : nullptr;
}

bool vtkPeakOverTime::Add(double time, vtkDataObject* input)
{
  bool fine = true;
  for (const DatasetLeaf& piece : DatasetLeaves(input)) {
    bool onPoints = false;
    vtkDataArray* array = this->ArrayOf(piece.Data, onPoints);
    const std::string key = this->KeyOf(piece);
    if (!array || !fine || this->Lost.count(key))
      continue;
    if (this->Component >= array->GetNumberOfComponents()) {
      vtkErrorMacro("The array '" << array->GetName() << "' has " << array->GetNumberOfComponents()
                                  << " components; Component is " << this->Component
                                  << ", and they count from 0 (-1 is the length of a vector).");
      fine = false;
      continue;
    }
    if (this->Component >= 0 && array->GetNumberOfComponents() > 1) {
      const char* name = array->GetComponentName(this->Component);
      constexpr const char* axes[] = {"x", "y", "z"};
      this->ComponentName = name                                  ? name
                            : array->GetNumberOfComponents() == 3 ? axes[this->Component]
                                                                  : std::to_string(this->Component);
    }
    const bool numbered = this->IdsOf(piece.Data, onPoints) != nullptr;
    if (this->Numbered.try_emplace(piece.Index, numbered).first->second != numbered) {
      vtkWarningMacro("The points that carry '" << array->GetName() << "' have numbers, '"
                                                << this->IdArrayName
                                                << "', at some times and none at others, first at " << time
                                                << " s: they cannot be followed and have no peak.");
      for (const std::string& lost : {"of " + std::to_string(piece.Whole), std::to_string(piece.Index)})
        if (piece.IsPiece || lost == std::to_string(piece.Index)) {
          this->Lost.insert(lost);
          this->Peaks.erase(lost);
        }
      continue;
    }
    auto& peaks = this->Peaks[key];
    if (!peaks)
      peaks = std::make_unique<RunningPeaks>();
    const std::size_t before = peaks->Rows();
    if (peaks->Add(time, array, this->Component, this->IdsOf(piece.Data, onPoints), this->Smallest))
      continue;
    vtkWarningMacro("The number of " << (onPoints ? "points" : "cells") << " that carry '" << array->GetName()
                                     << "' goes from " << before << " to " << array->GetNumberOfTuples()
                                     << " at " << time << " s, and no point array '" << this->IdArrayName
                                     << "' numbers them: they cannot be followed and have no peak.");
    this->Lost.insert(key);
    this->Peaks.erase(key);
  }
  return fine;
}

std::string vtkPeakOverTime::ResultName() const
{
  return (this->Smallest ? "lowest_" : "peak_") + this->ArrayName +
         (this->ComponentName.empty() ? "" : "_" + this->ComponentName);
}

// Points with numbers of their own may go from one piece of a partitioned dataset to another; nothing else may.
std::string vtkPeakOverTime::KeyOf(const DatasetLeaf& piece) const
{
  bool onPoints = false;
  const bool numbered = this->ArrayOf(piece.Data, onPoints) && this->IdsOf(piece.Data, onPoints);
  return numbered && piece.IsPiece ? "of " + std::to_string(piece.Whole) : std::to_string(piece.Index);
}

void vtkPeakOverTime::Put(const DatasetLeaf& piece) const
{
  vtkDataSet* leaf = piece.Data;
  const auto peaks = this->Peaks.find(this->KeyOf(piece));
  bool onPoints = false;
  if (peaks == this->Peaks.end() || !this->ArrayOf(leaf, onPoints))
    return;
  if (onPoints)
    peaks->second->Put(leaf->GetPointData(), this->ResultName(), this->IdsOf(leaf, true),
                       leaf->GetNumberOfPoints());
  else
    peaks->second->Put(leaf->GetCellData(), this->ResultName(), nullptr, leaf->GetNumberOfCells());
}

int vtkPeakOverTime::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  bool fine = input && this->NoTimes.empty();
  if (!this->NoTimes.empty())
    vtkErrorMacro(<< this->NoTimes);

  const bool timeless = this->Times.empty();
  if (fine && this->Done < this->Wanted) {
    vtkInformation* info = input->GetInformation();
    const double own =
        info->Has(vtkDataObject::DATA_TIME_STEP()) ? info->Get(vtkDataObject::DATA_TIME_STEP()) : 0;
    const double time = timeless ? own : this->Times[this->Done];
    bool there = false;
    for (const DatasetLeaf& piece : DatasetLeaves(input)) {
      bool onPoints = false;
      there = there || this->ArrayOf(piece.Data, onPoints);
    }
    if (!there)
      this->Absent.push_back(time);
    fine = this->Add(time, input);
    ++this->Done;
    ShowStep(*this, this->Done - 1, this->Wanted, time);
    const bool shown =
        timeless || (this->Done == this->Wanted && time == this->Now); // this very step is asked for
    const bool stopped = !shown && Stopped(*this);
    if (fine && !shown && !stopped) {
      request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
      return 1;
    }
    fine = fine && !stopped;
    if (stopped)
      this->Forget();
  }
  request->Remove(Pipeline::CONTINUE_EXECUTING());
  if (fine && this->Peaks.empty() && this->Lost.empty() && this->Done > 0) {
    vtkErrorMacro("No dataset of the input has the point or cell array '"
                  << this->ArrayName << "' at any of the " << this->Done
                  << " time steps; set Array to another" << ArraysOf(DatasetLeaves(input)) << ".");
    fine = false;
  }
  if (fine && !this->Absent.empty() && !this->AbsenceTold) {
    vtkWarningMacro("No dataset of the input has '" << this->ArrayName << "' at " << this->Absent.size()
                                                    << " time steps, the first at " << this->Absent.front()
                                                    << " s; the peaks leave them out.");
    this->AbsenceTold = true;
  }
  if (!fine) {
    this->Forget();
    output->Initialize();
    return 1;
  }
  CopyLeaves(input, output);
  for (const DatasetLeaf& piece : DatasetLeaves(output))
    this->Put(piece);
  if (!timeless)
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Now);
  if (timeless)
    this->Forget();
  return 1;
}
