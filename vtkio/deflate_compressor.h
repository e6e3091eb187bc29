// SPDX-License-Identifier: BSD-3-Clause
// VTK's zlib compression by libdeflate: the same format, so every reader knows it, in a fraction of the time.
#pragma once

#include <vtkSmartPointer.h>

class vtkDataCompressor;

namespace birdstrike {

//! For vtkXMLWriter::SetCompressor; writes what vtkZLibDataCompressor reads, at one level whatever it is told.
vtkSmartPointer<vtkDataCompressor> make_deflate_compressor();

} // namespace birdstrike
