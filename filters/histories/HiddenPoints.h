// SPDX-License-Identifier: BSD-3-Clause
// Points that nothing is left of: all their cells have eroded.
#pragma once

#include <string>
#include <vector>

class vtkDataSet;

/**
 * For each point of \p data whether every cell that it belongs to is hidden. A cell is hidden where the cell
 * array \p eroded is 1 or its vtkGhostType has HIDDENCELL; a point without any cell is not hidden.
 * Empty if no cell is hidden at all.
 */
std::vector<bool> HiddenPoints(vtkDataSet* data, const std::string& eroded);
