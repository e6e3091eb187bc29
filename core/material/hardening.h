// SPDX-License-Identifier: BSD-3-Clause
// The one list of hardening laws. To add one: write core/material/<name>_hardening.h with the members below, include it
// here, add it to the list, and its name in cases/material_file.
#pragma once

#include "core/material/linear_hardening.h"
#include "core/material/power_hardening.h"
#include "core/material/tabulated_hardening.h"

#include <variant>

namespace birdstrike {

//! Every law has
//!   YieldPoint at(double plastic_strain) const; // slow, at room temperature; must not fall
//!   void check() const;                         // throws InputError
//!   std::string describe() const;               // a few words for logs
//! The yield stress of a moment is at(eps_p).stress times the factors of rate_law.h and plastic_heat.h.
using Hardening = std::variant<NoYield, LinearHardening, PowerHardening, TabulatedHardening>;

} // namespace birdstrike
