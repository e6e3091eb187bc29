// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the time of a run may be quoted: a bird that has flown apart is quickly computed.
#pragma once

#include "core/format_text.h"
#include "measurement.h"

#include <cmath>
#include <string>

namespace birdstrike::peers {

constexpr double least_share_of_neighbours = 0.6; // of those at the start
constexpr double rounding = 1e-9;                 // by which the kinetic energy may have grown

//! Why \p run must not be quoted, as words that follow "rejected: "; empty if it may.
inline std::string fault_of(const Measurement& run)
{
  if (!(run.wall > 0 && std::isfinite(run.wall)))
    return format_text("its time of %g s is no time", run.wall);
  if (!(run.neighbours_start > 0 && run.neighbours_end >= least_share_of_neighbours * run.neighbours_start))
    return format_text(
        "of %.1f neighbours a particle at the start %.1f are left, less than %.0f %%: the bird has "
        "flown apart",
        run.neighbours_start, run.neighbours_end, 100 * least_share_of_neighbours);
  if (!std::isfinite(run.kinetic_end))
    return "its kinetic energy is not finite";
  if (!(run.kinetic_end <= (1 + rounding) * run.kinetic_start))
    return format_text("its kinetic energy grew from %.6g J to %.6g J on a rigid plate", run.kinetic_start,
                       run.kinetic_end);
  return "";
}

} // namespace birdstrike::peers
