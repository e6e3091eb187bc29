// SPDX-License-Identifier: BSD-3-Clause
// The loop over time steps that all histories share.
#include "vtkTemporalTableAlgorithm.h"

#include "DatasetLeaves.h"
#include "StepLoop.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace {

std::vector<vtkDataSet*> LeavesOf(vtkDataObject* data)
{
  std::vector<vtkDataSet*> leaves;
  for (const DatasetLeaf& leaf : DatasetLeaves(data))
    leaves.push_back(leaf.Data);
  return leaves;
}

double TimeOf(vtkDataObject* data)
{
  if (data->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    return data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  std::vector<vtkDataObject*> places{data};
  for (vtkDataSet* leaf : LeavesOf(data))
    places.push_back(leaf);
  for (vtkDataObject* place : places) {
    vtkDataArray* time = place->GetFieldData() ? place->GetFieldData()->GetArray("TimeValue") : nullptr;
    if (time && time->GetNumberOfTuples() > 0)
      return time->GetComponent(0, 0);
  }
  return 0.0;
}

} // namespace

void vtkTemporalTableAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LimitTime: " << this->LimitTime << "\n";
  os << indent << "StartTime: " << this->StartTime << "\n";
  os << indent << "EndTime: " << this->EndTime << "\n";
  os << indent << "TimeColumnName: " << this->TimeColumnName << "\n";
  os << indent << "Time steps: " << this->Times.size() << "\n";
  os << indent << "Step: " << this->Step << "\n";
}

void vtkTemporalTableAlgorithm::AddColumn(vtkTable* table, const std::string& title,
                                          const std::vector<double>& values)
{
  auto column = vtkSmartPointer<vtkDoubleArray>::New();
  column->SetName(title.c_str());
  column->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t row = 0; row < values.size(); ++row)
    column->SetValue(static_cast<vtkIdType>(row), values[row]);
  table->AddColumn(column);
}

void vtkTemporalTableAlgorithm::WarnOfAbsence(const std::string& array)
{
  if (!this->Absent.empty())
    vtkWarningMacro("No dataset of the input has '"
                    << array << "' at " << this->Absent.size() << " time steps, the first at "
                    << this->Absent.front() << " s: their rows are empty. Is a frame damaged or missing?");
}

void vtkTemporalTableAlgorithm::AddIdColumn(vtkTable* table, const std::string& title,
                                            const std::vector<vtkIdType>& values)
{
  auto column = vtkSmartPointer<vtkIdTypeArray>::New();
  column->SetName(title.c_str());
  for (const vtkIdType value : values)
    column->InsertNextValue(value);
  table->AddColumn(column);
}

int vtkTemporalTableAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkTemporalTableAlgorithm::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                                  vtkInformationVector* outputs)
{
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  this->Times.clear();
  this->NoTimes.clear();
  this->Step = 0;
  if (in->Has(Pipeline::TIME_STEPS())) {
    const double* times = in->Get(Pipeline::TIME_STEPS());
    this->Times.assign(times, times + in->Length(Pipeline::TIME_STEPS()));
    if (this->LimitTime)
      this->NoTimes = LimitTimes(this->Times, this->StartTime, this->EndTime);
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port) {
    vtkInformation* out = outputs->GetInformationObject(port);
    out->Remove(Pipeline::TIME_STEPS());
    out->Remove(Pipeline::TIME_RANGE());
  }
  return 1;
}

int vtkTemporalTableAlgorithm::RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                                                   vtkInformationVector* outputs)
{
  if (!this->Superclass::RequestUpdateExtent(request, inputs, outputs))
    return 0;
  if (!this->Times.empty())
    inputs[0]->GetInformationObject(0)->Set(Pipeline::UPDATE_TIME_STEP(), this->Times[this->Step]);
  return 1;
}

int vtkTemporalTableAlgorithm::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                           vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  std::vector<vtkTable*> tables;
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port) {
    tables.push_back(vtkTable::GetData(outputs, port));
    tables.back()->Initialize();
  }
  if (this->Step == 0) {
    this->Absent.clear();
    this->Arrays = ArraysOf(DatasetLeaves(input));
    this->Clear();
  }

  const std::size_t steps = this->Times.empty() ? 1 : this->Times.size();
  const std::vector<vtkDataSet*> leaves = input ? LeavesOf(input) : std::vector<vtkDataSet*>();
  bool fine = !leaves.empty() && this->NoTimes.empty();
  const double time = this->Times.empty() ? (input ? TimeOf(input) : 0) : this->Times[this->Step];
  if (fine)
    fine = this->AddTimeStep(time, leaves);
  else if (!this->NoTimes.empty())
    vtkErrorMacro(<< this->NoTimes);
  else
    vtkErrorMacro("The input has no dataset at time step "
                  << this->Step + 1 << " of " << steps << "; its reader failed there, or the step is empty.");

  ShowStep(*this, this->Step, steps, time);
  const bool last = this->Step + 1 >= steps;
  const bool stopped = !last && Stopped(*this);
  if (fine && !last && !stopped) {
    ++this->Step;
    request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
    return 1;
  }

  // The end, good or bad: the next execution starts afresh.
  request->Remove(Pipeline::CONTINUE_EXECUTING());
  this->Step = 0;
  if (fine && !stopped && this->FillTable(tables[0])) {
    if (tables.size() > 1)
      this->FillSecondTable(tables[1]);
  } else {
    tables[0]->Initialize();
  }
  this->Clear();
  return 1;
}
