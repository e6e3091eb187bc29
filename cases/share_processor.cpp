// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/share_processor.h"

#include <cstdlib>

#include <unistd.h>

namespace birdstrike {

void sleep_at_barriers(char** argv)
{
  if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT"))
    return; // the user's choice, or the second start
  setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", argv); // returns only if it failed; then the run is as good as before
}

} // namespace birdstrike
