// SPDX-License-Identifier: BSD-3-Clause
// Collects what VTK classes complain about, instead of letting them print it.
#pragma once

#include <vtkCommand.h>
#include <vtkSmartPointer.h>

#include <string>

namespace birdstrike {

//! An observer of errors and warnings: object->AddObserver(vtkCommand::ErrorEvent, errors).
class VtkErrors : public vtkCommand
{
public:
  static VtkErrors* New() { return new VtkErrors; }
  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  //! Listen to errors and warnings of \p object, which then prints none.
  void watch(vtkObject& object);

  bool any() const { return !first_.empty(); }
  //! The first complaint in one line, without VTK's file, line and address; empty if there is none.
  const std::string& first() const { return first_; }

private:
  std::string first_;
};

} // namespace birdstrike
