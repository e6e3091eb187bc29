// SPDX-License-Identifier: GPL-3.0-or-later
// bird.shape = "column": what follows from it for the rest of the case.
#pragma once

#include "cases/case.h"

namespace birdstrike {

//! The box that repeats sideways, a plate of one element over all of it, and, unless it is given, the end of the run:
//! when four fifths of the layers have been shocked, 0.8 sum(layers spacing / u_s) after first contact, with the shock
//! speed u_s of each part's law at the bird's speed.
//! \throw InputError naming the part whose law cannot stop matter of that speed, or bird.columns if the box is too narrow
void complete_column(Case& parsed, bool end_is_given);

} // namespace birdstrike
