// SPDX-License-Identifier: BSD-3-Clause
// The two points of a cloud that are furthest from each other.
#pragma once

#include "CellList.h"

#include <vector>

//! Their distance; 0 of fewer than two points. Exact, but for clouds of which more than 20,000 points lie on nearly
//! one sphere; of these some per cent too small at most.
double LargestDistance(const std::vector<Vector3d>& points);
