// SPDX-License-Identifier: GPL-3.0-or-later
// What one solver was asked for, and what it found.
#pragma once

#include <optional>
#include <string>

namespace birdstrike::peers {

//! One impact. Every solver gets the same.
struct Work
{
  double spacing = 0; //!< of the lattice [m]
  long steps = 0;     //!< timed, after those of the warm-up
  int threads = 1;
  bool skip = false; //!< may BirdStrike leave particles alone that nothing has reached yet? No peer does.
};

constexpr long warm_up = 5; // steps before the clock starts

//! One run. What could not be measured is NaN.
struct Measurement
{
  std::string solver; //!< "birdstrike" or "pysph"
  double spacing = 0; //!< [m]
  long particles = 0;
  long steps = 0;  //!< timed
  double wall = 0; //!< time of these steps [s]
  double time = 0; //!< of the impact at their end [s]
  double neighbours_start =
      0; //!< mean number within 2h of a particle, itself not counted, when the clock starts
  double neighbours_end = 0; //!< the same when it stops
  double kinetic_start = 0;  //!< energy at t = 0 [J]
  double kinetic_end = 0;    //!< [J]
  std::optional<long> rebuilds =
      {};                 //!< of lists of neighbours in these steps; none where they are found in each
  double peak_memory = 0; //!< resident set of the process [bytes]

  double updates_per_second() const { return static_cast<double>(particles * steps) / wall; }
  double pairs_per_second() const { return updates_per_second() * neighbours_end; }
};

//! As one line of JSON with these members.
std::string to_line(const Measurement& run);

//! The last line of \p output that is a JSON object.
//! \throw RunError if there is none, or a member is missing
Measurement from_output(const std::string& output);

} // namespace birdstrike::peers
