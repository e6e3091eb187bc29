// SPDX-License-Identifier: GPL-3.0-or-later
// STEP and IGES where the build has no OpenCASCADE: what to do instead.
#include "core/error.h"
#include "geometry/import/formats.h"

namespace birdstrike {

bool cad_is_read() { return false; }

RawScene read_cad(const std::filesystem::path& file, double)
{
  throw InputError(
      "mesh file '" + file.string() +
      "' holds curved CAD faces, which this build cannot read; export STL, OBJ or glTF, or build with "
      "OpenCASCADE (Debian: libocct-data-exchange-dev, then cmake -DBIRDSTRIKE_OCCT=ON)");
}

} // namespace birdstrike
