// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/column.h"

#include "core/error.h"
#include "core/theory/impact_pressures.h"

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {

bool is_column(const Case& parsed) { return parsed.bird.shape == "column"; }

void complete_column(Case& parsed, bool end_is_given)
{
  constexpr double shocked = 0.8; // of the layers, at the end of a run that has none given
  const BirdCase& bird = parsed.bird;
  // Particles of two boxes side by side must not meet twice: see Simulation.
  const int fewest = static_cast<int>(std::ceil(4 * 1.16 * bird.smoothing * parsed.run.smoothing_growth));
  if (bird.columns < fewest)
    throw InputError(
        fmt::format("{}: bird.columns = {}: the box that repeats is narrower than twice the reach of a "
                    "particle; allowed is {} or more",
                    parsed.file.string(), bird.columns, fewest));
  const double width = bird.columns * bird.spacing;
  parsed.run.periodic = PeriodicBox{width, width};
  parsed.target.size = {width, width};
  parsed.target.thickness = bird.spacing; // only drawn
  parsed.target.elements = {1, 1};
  if (end_is_given)
    return;
  double end = bird.gap / bird.velocity;
  for (const PartCase& part : bird.parts)
    try {
      end += shocked * part.layers * bird.spacing /
             hugoniot(natural_law(parsed, part), bird.velocity).shock_speed;
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: bird.parts.{}: run.end cannot be computed: {}", parsed.file.string(),
                                   part.name, error.what()));
    }
  parsed.run.end_time = end;
}

} // namespace birdstrike
