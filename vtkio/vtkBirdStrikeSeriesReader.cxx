// SPDX-License-Identifier: BSD-3-Clause
// Head of a VTK pipeline: a .pvd series, one time step in memory.
#include "vtkio/vtkBirdStrikeSeriesReader.h"

#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <stdexcept>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkBirdStrikeSeriesReader);

vtkBirdStrikeSeriesReader::vtkBirdStrikeSeriesReader() { this->SetNumberOfInputPorts(0); }

void vtkBirdStrikeSeriesReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Time steps: " << this->Index.steps.size() << "\n";
}

int vtkBirdStrikeSeriesReader::RequestInformation(vtkInformation*, vtkInformationVector**,
                                                  vtkInformationVector* outputs)
{
  this->Index.steps.clear();
  try {
    this->Index = birdstrike::read_series_index(this->FileName);
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  std::vector<double> times;
  for (const auto& step : this->Index.steps)
    times.push_back(step.time);
  const double range[2] = {times.front(), times.back()};
  vtkInformation* out = outputs->GetInformationObject(0);
  out->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  out->Set(Pipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkBirdStrikeSeriesReader::RequestData(vtkInformation*, vtkInformationVector**,
                                           vtkInformationVector* outputs)
{
  vtkMultiBlockDataSet* blocks = vtkMultiBlockDataSet::GetData(outputs);
  if (this->Index.steps.empty())
    return 1;
  vtkInformation* out = outputs->GetInformationObject(0);
  const double asked = out->Has(Pipeline::UPDATE_TIME_STEP()) ? out->Get(Pipeline::UPDATE_TIME_STEP())
                                                              : this->Index.steps.front().time;
  const std::size_t step = this->Index.nearest(asked);
  try {
    unsigned int block = 0;
    for (const auto& piece : birdstrike::read_pieces(this->Index, step)) {
      blocks->SetBlock(block, piece.second);
      blocks->GetMetaData(block++)->Set(vtkCompositeDataSet::NAME(), piece.first.c_str());
    }
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
    blocks->Initialize();
    return 1; // never 0: VTK's loop over time steps would then turn for ever
  }
  blocks->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Index.steps[step].time);
  return 1;
}
