// SPDX-License-Identifier: GPL-3.0-or-later
// What a case leaves unsaid about its target.
#pragma once

#include "cases/case.h"

namespace birdstrike {

//! Contact by springs where none is given, but for a rigid plate, which mirrors. Usual supports where none are given: a plate
//! and a panel are clamped along their edges, a leading edge at spar and ribs, a blade at its root; none where target.free
//! is true.
//! \throw InputError naming the key: a moving target without material, a mesh without supports, a support without nodes or
//!        with a component that is none, supports of a free target, a spin without axis or of a free target, a deflection
//!        whose name does not do for a title
void complete_target(Case& parsed, bool contact_given = true);

//! Which of moves x, y, z and turns x, y, z a text holds.
//! \throw InputError without a place, listing what is allowed
std::array<bool, 6> held_components(const std::string& fix);

} // namespace birdstrike
