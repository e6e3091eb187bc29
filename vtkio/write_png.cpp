// SPDX-License-Identifier: BSD-3-Clause
// An image on disk.
#include "vtkio/write_png.h"

#include "vtkio/atomic_file.h"
#include "vtkio/vtk_errors.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkPNGWriter.h>

#include <cerrno>
#include <cstring>

namespace birdstrike {

void write_png(vtkImageData& image, const std::filesystem::path& file)
{
  if (file.has_parent_path())
    make_folder(file.parent_path());
  write_atomically(file, [&](const std::filesystem::path& temporary) -> std::string {
    auto errors = vtkSmartPointer<VtkErrors>::New();
    auto writer = vtkSmartPointer<vtkPNGWriter>::New();
    errors->watch(*writer);
    writer->SetFileName(temporary.string().c_str());
    writer->SetInputData(&image);
    errno = 0;
    writer->Write();
    if (!errors->any() && writer->GetErrorCode() == vtkErrorCode::NoError)
      return {};
    if (errno != 0)
      return std::strerror(errno);
    return errors->any() ? errors->first() : vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
  });
}

} // namespace birdstrike
