// SPDX-License-Identifier: BSD-3-Clause
// One dataset into one of VTK's XML files, with the reason if that fails.
#include "vtkio/write_vtk_xml.h"

#include "vtkio/deflate_compressor.h"
#include "vtkio/vtk_errors.h"

#include <vtkDataObject.h>
#include <vtkErrorCode.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkXMLWriter.h>

#include <cerrno>
#include <cstring>

namespace birdstrike {
namespace {

vtkSmartPointer<vtkDataCompressor> compressor_for(Compression compression)
{
  vtkSmartPointer<vtkDataCompressor> compressor;
  switch (compression) {
  case Compression::none:
    break;
  case Compression::lz4:
    compressor = vtkSmartPointer<vtkLZ4DataCompressor>::New();
    break;
  case Compression::zlib:
    return make_deflate_compressor();
  case Compression::lzma:
    compressor = vtkSmartPointer<vtkLZMADataCompressor>::New();
    break;
  }
  if (compressor)
    compressor->SetCompressionLevel(1); // nearly as small as the higher ones, two to four times as fast
  return compressor;
}

} // namespace

std::string write_vtk_xml(vtkXMLWriter& writer, vtkDataObject& data, const std::filesystem::path& file,
                          Compression compression)
{
  auto errors = vtkSmartPointer<VtkErrors>::New();
  errors->watch(writer);
  writer.SetFileName(file.string().c_str());
  writer.SetInputDataObject(&data);
  writer.SetDataModeToAppended();
  writer.EncodeAppendedDataOff();
  writer.SetCompressor(compressor_for(compression));
  if (compression == Compression::lzma)
    writer.SetBlockSize(1 << 20); // a dictionary needs something to work on
  writer.SetIdTypeToInt32();
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
