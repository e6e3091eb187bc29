// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/flight_check.h"

#include <fmt/format.h>

#include <algorithm>

namespace birdstrike {

std::vector<std::string> flight_warnings(const Particles& bird, const RigidPlate* plate,
                                         const Settings& settings)
{
  if (settings.periodic) // a plane wave is not meant to run to the end
    return {};
  double past = 0, mass = 0, nose = -1e300, tail = 1e300, speed = 0;
  for (std::size_t i = 0; i < bird.size(); ++i) {
    mass += bird.mass[i];
    const double way = bird.vx[i] > 0 ? -bird.x[i] / bird.vx[i] : 0; // until it meets the plate's plane [s]
    past += plate && plate->element_at(bird.y[i] + way * bird.vy[i], bird.z[i] + way * bird.vz[i]) < 0
                ? bird.mass[i]
                : 0;
    nose = std::max(nose, bird.x[i]);
    tail = std::min(tail, bird.x[i]);
    speed = std::max(speed, bird.vx[i]); // into the plate
  }

  std::vector<std::string> warnings;
  if (past > 0)
    warnings.push_back(
        fmt::format("{:.1f} % of the bird's mass flies past the plate of {:g} m x {:g} m; enlarge "
                    "target.plate.size unless that is meant",
                    100 * past / mass, plate->size_y, plate->size_z));
  if (plate && speed > 0 && -tail / speed > settings.end_time)
    warnings.push_back(
        fmt::format("the run ends at {:g} ms, before the {} has reached the plate at {:.3g} ms; enlarge "
                    "run.end for the whole impact",
                    1e3 * settings.end_time, -nose / speed > settings.end_time ? "nose" : "tail",
                    1e3 * (-nose / speed > settings.end_time ? -nose : -tail) / speed));
  if (settings.tension_cutoff < 0)
    warnings.push_back(
        fmt::format("run.tension_cutoff = {:g} Pa lets the bird's surface pull: particles there count too "
                    "few neighbours, "
                    "which reads as tension, and the bird contracts in free flight; 0 has no such skin",
                    settings.tension_cutoff));
  if (plate && -nose < bird.initial_smoothing)
    warnings.push_back(
        fmt::format("the bird starts within {:.3g} mm of the plate, the reach of its particles at this "
                    "spacing, and feels it at once; enlarge bird.gap or refine bird.spacing",
                    1e3 * bird.initial_smoothing));
  return warnings;
}

} // namespace birdstrike
