// SPDX-License-Identifier: GPL-3.0-or-later
// A run's series as data for the turning view of a report: few frames, small numbers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct ViewOptions
{
  int frames = 40;       //!< at most, evenly spaced over the run, first and last among them
  int particles = 30000; //!< at most, evenly spaced by number
};

struct ReportView
{
  std::string
      data; //!< JSON for share/report/src/decode.js, fit to stand in a <script>; empty if there is nothing to see
  int frames = 0, all_frames = 0;        //!< shown and in the series
  long particles = 0, all_particles = 0; //!< shown and in the bird
  bool target = false;                   //!< whether there is one
  std::vector<std::string> gaps;         //!< what is missing and why, a sentence each
};

//! Positions have 16 bits in the box that all of them stay in, fields 8 bits in the range that all but a hundredth of
//! their values above the lowest stay in. What cannot be read is told in gaps, and never thrown.
//! \param pvd  run.pvd, which may be missing
ReportView make_report_view(const std::filesystem::path& pvd, const ViewOptions& options);

//! Numbers 0 ... all-1, \p shown of them, evenly spaced, first and last among them; all of them if shown >= all.
std::vector<std::size_t> evenly(std::size_t all, std::size_t shown);

} // namespace birdstrike
