// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bird starts before a target that is a mesh.
#include "cases/place_before.h"

#include "cases/approach.h"
#include "core/error.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>

namespace birdstrike {

std::vector<std::string> place_before(const Case& parsed, const ShellMesh& target, Particles& bird,
                                      Flight& flight)
{
  std::vector<double> reach;
  for (const ShellMeshPart& part : target.parts)
    reach.push_back(0.5 * (bird.spacing + part.thickness));
  const Approach found = approach(bird, flight.direction, reach, target);
  if (!std::isfinite(found.way)) {
    Eigen::AlignedBox3d box;
    for (const Vector3& point : target.points)
      box.extend(point);
    throw InputError(fmt::format(
        "{}: nothing of the bird meets the target, which fills x {:.3f} to {:.3f} m, y {:.3f} to {:.3f} m, z "
        "{:.3f} to {:.3f} m: the bird flies at the origin, or bird.offset beside it; {}",
        parsed.file.string(), box.min()[0], box.max()[0], box.min()[1], box.max()[1], box.min()[2],
        box.max()[2],
        parsed.target.shape == "mesh" ? "shift the mesh, or set its target.mesh.unit"
                                      : "turn or enlarge the target"));
  }
  // Across a plate, as where it is the mirror of the flow.
  const double gap = parsed.target.shape == "plate" ? parsed.bird.gap / flight.direction[0] : parsed.bird.gap;
  const Vector3 shift = (found.way - gap) * flight.direction;
  for (std::size_t i = 0; i < bird.size(); ++i) {
    bird.x[i] += shift[0];
    bird.y[i] += shift[1];
    bird.z[i] += shift[2];
  }
  flight.gap = gap * flight.direction[0];
  std::vector<std::string> warnings;
  if (found.missed > 0)
    warnings.push_back(
        fmt::format("{:.1f} % of the bird's mass flies past the target; enlarge it unless that is meant",
                    100 * found.missed));
  const double tail = (gap + flight.length) / flight.speed, end = parsed.run.end_time;
  if (tail > end)
    warnings.push_back(fmt::format("the run ends at {:g} ms, before the {} has reached the target at {:.3g} "
                                   "ms; enlarge run.end for the whole impact",
                                   1e3 * end, gap / flight.speed > end ? "nose" : "tail",
                                   1e3 * (gap / flight.speed > end ? gap / flight.speed : tail)));
  return warnings;
}

} // namespace birdstrike
