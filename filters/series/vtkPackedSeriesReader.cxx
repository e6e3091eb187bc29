// SPDX-License-Identifier: BSD-3-Clause
// Opens a packed series of BirdStrike.
#include "vtkPackedSeriesReader.h"

#include "PackedFile.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkPackedSeriesReader);

vtkPackedSeriesReader::vtkPackedSeriesReader() { this->SetNumberOfInputPorts(0); }
vtkPackedSeriesReader::~vtkPackedSeriesReader() = default;

void vtkPackedSeriesReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Time steps: " << (this->File ? this->File->Times().size() : 0) << "\n";
}

void vtkPackedSeriesReader::SetFileName(const char* name)
{
  const std::string text = name ? name : "";
  if (text == this->FileName)
    return;
  this->FileName = text;
  this->File.reset();
  this->Modified();
}

int vtkPackedSeriesReader::CanReadFile(const char* name)
{
  try {
    return name && !PackedFile(name).Times().empty();
  } catch (const std::exception&) {
    return 0;
  }
}

int vtkPackedSeriesReader::RequestInformation(vtkInformation*, vtkInformationVector**,
                                              vtkInformationVector* outputs)
{
  std::error_code ignored; // what cannot be looked at cannot be opened either, and is told of there
  const auto stamp = std::make_pair(std::filesystem::file_size(this->FileName, ignored),
                                    std::filesystem::last_write_time(this->FileName, ignored));
  if (!this->File || stamp != this->Stamp) {
    this->File.reset();
    this->Stamp = stamp;
    try {
      this->File = std::make_unique<PackedFile>(this->FileName);
    } catch (const std::exception& error) {
      vtkErrorMacro("Cannot read " << this->FileName << ": " << error.what() << ".");
      return 0;
    }
    if (!this->File->Complaint().empty())
      vtkWarningMacro(<< this->File->Complaint() << ".");
  }
  const std::vector<double>& times = this->File->Times();
  const double range[2] = {times.front(), times.back()};
  vtkInformation* out = outputs->GetInformationObject(0);
  out->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  out->Set(Pipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkPackedSeriesReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkMultiBlockDataSet* blocks = vtkMultiBlockDataSet::GetData(outputs);
  if (!this->File)
    return 1;
  const std::vector<double>& times = this->File->Times();
  vtkInformation* out = outputs->GetInformationObject(0);
  const double asked =
      out->Has(Pipeline::UPDATE_TIME_STEP()) ? out->Get(Pipeline::UPDATE_TIME_STEP()) : times.front();
  const auto nearest = std::min_element(times.begin(), times.end(), [asked](double a, double b) {
    return std::abs(a - asked) < std::abs(b - asked);
  });
  try {
    unsigned int block = 0;
    for (const auto& piece : this->File->Read(static_cast<std::size_t>(nearest - times.begin()))) {
      blocks->SetBlock(block, piece.second);
      blocks->GetMetaData(block++)->Set(vtkCompositeDataSet::NAME(), piece.first.c_str());
    }
  } catch (const std::exception& error) {
    vtkErrorMacro("Cannot read " << this->FileName << ": " << error.what() << ".");
    blocks->Initialize();
    return 1; // never 0: VTK's loops over time steps would then turn for ever
  }
  blocks->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), *nearest);
  return 1;
}
