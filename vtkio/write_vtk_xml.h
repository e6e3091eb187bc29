// SPDX-License-Identifier: BSD-3-Clause
// One dataset into one of VTK's XML files, with the reason if that fails.
#pragma once

#include "vtkio/series_options.h"

#include <filesystem>
#include <string>

class vtkDataObject;
class vtkXMLWriter;

namespace birdstrike {

//! Raw, compressed, appended data.
//! \param writer  that suits the dataset
//! \return what went wrong, empty if nothing did: for write_atomically
std::string write_vtk_xml(vtkXMLWriter& writer, vtkDataObject& data, const std::filesystem::path& file,
                          Compression compression = Compression::zlib);

} // namespace birdstrike
