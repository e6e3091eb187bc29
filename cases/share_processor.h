// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that give way on a machine that has other work to do.
#pragma once

namespace birdstrike {

//! A step has some fifteen points where threads wait for each other. By default g++'s OpenMP burns milliseconds there
//! before it sleeps; where other programs want the same processors, it burns the time that the awaited thread needs,
//! and a run was seen to become three to ten times slower. Sleeping at once costs 12 % at 30,000 particles and 20 % at
//! 10,000 on two idle cores; OMP_WAIT_POLICY=active in the environment saves that where nothing else runs.
//! The runtime reads its settings before main() begins, so this sets OMP_WAIT_POLICY to passive and starts the program
//! again. Does nothing if the user has set OMP_WAIT_POLICY or GOMP_SPINCOUNT, or if the system does not let a program
//! start itself.
//! \param argv  as main() got it
void sleep_at_barriers(char** argv);

} // namespace birdstrike
