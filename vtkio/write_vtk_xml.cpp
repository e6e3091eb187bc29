// SPDX-License-Identifier: BSD-3-Clause
// One dataset into one of VTK's XML files, with the reason if that fails.
#include "vtkio/write_vtk_xml.h"

#include "vtkio/vtk_errors.h"

#include <vtkDataObject.h>
#include <vtkErrorCode.h>
#include <vtkSmartPointer.h>
#include <vtkXMLWriter.h>
#include <vtkZLibDataCompressor.h>

#include <cerrno>
#include <cstring>

namespace birdstrike {

std::string write_vtk_xml(vtkXMLWriter& writer, vtkDataObject& data, const std::filesystem::path& file)
{
  auto errors = vtkSmartPointer<VtkErrors>::New();
  auto compressor = vtkSmartPointer<vtkZLibDataCompressor>::New();
  compressor->SetCompressionLevel(1); // as small as level 6, twice as fast
  errors->watch(writer);
  writer.SetFileName(file.string().c_str());
  writer.SetInputDataObject(&data);
  writer.SetDataModeToAppended();
  writer.EncodeAppendedDataOff();
  writer.SetCompressor(compressor);
  errno = 0;
  const bool written = writer.Write() == 1;
  const int system_error = errno;
  if (written && writer.GetErrorCode() == vtkErrorCode::NoError && !errors->any())
    return {};
  // VTK's own words for a full disk or a missing folder hide the system's reason.
  if (system_error != 0)
    return std::strerror(system_error);
  if (writer.GetErrorCode() != vtkErrorCode::NoError)
    return vtkErrorCode::GetStringFromErrorCode(writer.GetErrorCode());
  return errors->any() ? errors->first() : "VTK does not say why";
}

} // namespace birdstrike
