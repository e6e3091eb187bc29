// SPDX-License-Identifier: BSD-3-Clause
// The loop over time steps that all histories share.
#include "vtkTemporalTableAlgorithm.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
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
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data)) {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      if (auto* leaf = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
        leaves.push_back(leaf);
  } else if (auto* leaf = vtkDataSet::SafeDownCast(data)) {
    leaves.push_back(leaf);
  }
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
  this->Step = 0;
  if (in->Has(Pipeline::TIME_STEPS())) {
    const double* times = in->Get(Pipeline::TIME_STEPS());
    this->Times.assign(times, times + in->Length(Pipeline::TIME_STEPS()));
  }
  vtkInformation* out = outputs->GetInformationObject(0);
  out->Remove(Pipeline::TIME_STEPS());
  out->Remove(Pipeline::TIME_RANGE());
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
  vtkTable* table = vtkTable::GetData(outputs);
  table->Initialize();
  if (this->Step == 0)
    this->Clear();

  const std::size_t steps = this->Times.empty() ? 1 : this->Times.size();
  const std::vector<vtkDataSet*> leaves = input ? LeavesOf(input) : std::vector<vtkDataSet*>();
  bool fine = !leaves.empty();
  if (fine) {
    const double time = this->Times.empty() ? TimeOf(input) : this->Times[this->Step];
    fine = this->AddTimeStep(time, leaves);
  } else {
    vtkErrorMacro("The input has no dataset at time step "
                  << this->Step + 1 << " of " << steps << "; its reader failed there, or the step is empty.");
  }

  this->UpdateProgress(static_cast<double>(this->Step + 1) / static_cast<double>(steps));
  const bool last = this->Step + 1 >= steps;
  if (fine && !last && !this->GetAbortExecute()) {
    ++this->Step;
    request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
    return 1;
  }

  // The end, good or bad: the next execution starts afresh.
  request->Remove(Pipeline::CONTINUE_EXECUTING());
  this->Step = 0;
  if (!fine || (this->GetAbortExecute() && !last) || !this->FillTable(table))
    table->Initialize();
  this->Clear();
  return 1;
}
