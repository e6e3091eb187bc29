// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the ranges in the table of keys.
#pragma once

#include "cases/keys.h"

namespace birdstrike {

inline Range above(double low) { return {low, {}, true}; }
inline Range at_least(double low) { return {low, {}, false}; }
inline Range at_most(double high) { return {{}, high, false}; }
inline Range within(double low, double high) { return {low, high, false}; }
inline Range above_within(double low, double high) { return {low, high, true}; }

//! The rows of [target], a part of case_keys().
std::vector<Key> target_keys();

} // namespace birdstrike
