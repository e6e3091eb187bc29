// SPDX-License-Identifier: GPL-3.0-or-later
// What names and shapes of objects tell of a bird's directions.
#pragma once

#include "geometry/import/symmetry.h"

#include <optional>
#include <string>

namespace birdstrike {

//! Unit vectors in the file's axes, where names tell them.
struct AxisEvidence
{
  std::optional<Vector3>
      nose;                //!< from the rest to head, beak, bill, skull or neck; else from a tail to the rest
  std::string nose_source; //!< "'head'", or "the far end from 'tail'"
  std::optional<Vector3> left; //!< from the objects named right to those named left
  std::optional<Vector3> down; //!< from the rest to legs, feet or toes
};
AxisEvidence find_evidence(const SurfaceMesh& parts);

//! +1 or -1: the end of \p along at which the surface is much narrower in the direction \p left; 0 if neither is.
double narrow_end(const SurfaceSamples& samples, const Vector3& along, const Vector3& left);

//! +1 or -1: the side of the middle in direction \p high on which the tips of the wings lie; 0 if on neither.
double wing_side(const SurfaceSamples& samples, const Vector3& high, const Vector3& left);

} // namespace birdstrike
