// SPDX-License-Identifier: BSD-3-Clause
// A source of made-up time series for the tests of the filters.
#pragma once

#include <vtkDataObject.h>
#include <vtkDataObjectAlgorithm.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include "vtkio/vtk_errors.h"

#include <functional>
#include <string>
#include <vector>

namespace {

//! Calls Make for the data at the time asked for; that of the first time tells its type.
class MadeSeries : public vtkDataObjectAlgorithm
{
public:
  static MadeSeries* New();
  vtkTypeMacro(MadeSeries, vtkDataObjectAlgorithm);
  std::vector<double> Times; // empty: publishes none
  std::function<vtkSmartPointer<vtkDataObject>(double)> Make;
  int Executions = 0;

protected:
  MadeSeries() { this->SetNumberOfInputPorts(0); }
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkSmartPointer<vtkDataObject> made = this->Make(this->Times.empty() ? 0 : this->Times[0]);
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(),
                                          vtkSmartPointer<vtkDataObject>::Take(made->NewInstance()));
    return 1;
  }
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    if (this->Times.empty())
      return 1;
    const double range[2] = {this->Times.front(), this->Times.back()};
    vtkInformation* out = outputs->GetInformationObject(0);
    out->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), this->Times.data(),
             static_cast<int>(this->Times.size()));
    out->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    ++this->Executions;
    vtkInformation* out = outputs->GetInformationObject(0);
    const double time = out->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
                            ? out->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
                            : 0;
    out->Get(vtkDataObject::DATA_OBJECT())->ShallowCopy(this->Make(time));
    return 1;
  }
};
vtkStandardNewMacro(MadeSeries);

//! A filter behind a made-up series, and what it complains of.
template <class Filter>
struct FilterRun
{
  vtkNew<MadeSeries> source;
  vtkNew<Filter> filter;
  vtkSmartPointer<birdstrike::VtkErrors> errors = vtkSmartPointer<birdstrike::VtkErrors>::New();

  FilterRun(std::vector<double> times, std::function<vtkSmartPointer<vtkDataObject>(double)> make)
  {
    source->Times = std::move(times);
    source->Make = std::move(make);
    filter->SetInputConnection(source->GetOutputPort());
    errors->watch(*filter);
  }
};

} // namespace

//! Points at (i, 0, 0) with a scalar "pressure" and, unless empty, "part".
inline vtkSmartPointer<vtkPolyData> made_particles(const std::vector<double>& pressure,
                                                   const std::vector<int>& part,
                                                   const std::vector<std::string>& names = {})
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> p;
  p->SetName("pressure");
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    points->InsertNextPoint(static_cast<double>(i), 0, 0);
    p->InsertNextValue(pressure[i]);
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(p);
  if (!part.empty()) {
    vtkNew<vtkIntArray> parts;
    parts->SetName("part");
    for (const int k : part)
      parts->InsertNextValue(k);
    data->GetPointData()->AddArray(parts);
  }
  if (!names.empty()) {
    vtkNew<vtkStringArray> strings;
    strings->SetName("part_names");
    for (const std::string& name : names)
      strings->InsertNextValue(name);
    data->GetFieldData()->AddArray(strings);
  }
  return data;
}

inline double value(vtkTable& table, vtkIdType row, const char* column)
{
  return table.GetValueByName(row, column).ToDouble();
}
