// SPDX-License-Identifier: BSD-3-Clause
// Collects what VTK classes complain about, instead of letting them print it.
#include "vtkio/vtk_errors.h"

#include <vtkAlgorithm.h>
#include <vtkExecutive.h>

namespace birdstrike {

void VtkErrors::Execute(vtkObject*, unsigned long, void* data)
{
  if (any() || !data)
    return;
  // VTK hands over "ERROR: In <file>, line <n>\n<class> (<address>): <text>\n\n".
  std::string text = static_cast<const char*>(data);
  if (const auto end = text.find("): "); end != std::string::npos)
    text = text.substr(end + 3);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
    text.pop_back();
  for (char& c : text)
    if (c == '\n')
      c = ' ';
  first_ = text.empty() ? "unknown VTK error" : text;
}

void VtkErrors::watch(vtkObject& object)
{
  object.AddObserver(vtkCommand::ErrorEvent, this);
  object.AddObserver(vtkCommand::WarningEvent, this);
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(&object))
    watch(*algorithm->GetExecutive());
}

} // namespace birdstrike
