// SPDX-License-Identifier: BSD-3-Clause
// What filters that loop over time steps have in common: which steps, what is shown, whether to stop.
#include "StepLoop.h"

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <sstream>

std::string LimitTimes(std::vector<double>& times, double start, double end)
{
  if (times.empty())
    return {};
  constexpr double endless = 1e29; // filters' default is beyond [s]
  const double first = times.front(), last = times.back();
  const double more = 1e-9 * std::max(std::abs(first), std::abs(last));
  std::vector<double> kept;
  for (const double time : times)
    if (time >= start - more && time <= end + more)
      kept.push_back(time);
  std::ostringstream why;
  if (kept.empty()) {
    why << "No time step lies ";
    if (end < endless)
      why << "between Start Time " << start << " s and End Time " << end;
    else
      why << "after Start Time " << start;
    why << " s; the series has " << times.size() << " from " << first << " s to " << last << " s.";
    kept.push_back(first);
  }
  times = std::move(kept);
  return why.str();
}

void ShowStep(vtkAlgorithm& filter, std::size_t step, std::size_t steps, double time)
{
  std::ostringstream text;
  text << "time step " << step + 1 << " of " << steps << ", " << time << " s";
  filter.SetProgressText(text.str().c_str());
  filter.UpdateProgress(static_cast<double>(step + 1) / static_cast<double>(steps));
}

bool Stopped(vtkAlgorithm& filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230000)
  // GetAbortOutput stays true after CheckAbort, which tells those downstream that this output is void.
  return filter.CheckAbort() || filter.GetAbortExecute();
#else
  return filter.GetAbortExecute() != 0;
#endif
}
