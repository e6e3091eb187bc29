// SPDX-License-Identifier: GPL-3.0-or-later
// A target from any file that holds one.
#include "cases/read_target.h"

#include "core/error.h"
#include "geometry/import_shells/read_shells.h"
#include "vtkio/vtk_to_shells.h"

namespace birdstrike {

ShellImport read_target(const std::filesystem::path& file, double unit)
{
  if (is_vtk_file(file))
    return read_vtk_shells(file, unit);
  require(is_shell_file(file), "target file '" + file.string() + "' has the unknown format '" +
                                   file.extension().string() + "'; known are .vtu, .vtp, .vtk, " +
                                   shell_formats());
  return read_shells(file, unit);
}

} // namespace birdstrike
