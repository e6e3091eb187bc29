// SPDX-License-Identifier: BSD-3-Clause
// Cells that have eroded, and points that nothing is left of.
#pragma once

#include <string>
#include <vector>

#include "vtkType.h"

class vtkDataSet;
class vtkDataSetAttributes;

/**
 * For each cell of \p data whether it is hidden: where the cell array \p eroded is 1 or its vtkGhostType has
 * HIDDENCELL or DUPLICATECELL: another piece of the data has the latter. Empty if no cell is hidden at all.
 */
std::vector<bool> HiddenCells(vtkDataSet* data, const std::string& eroded);

/**
 * For each point of \p data whether every cell that it belongs to is hidden; a point without any cell is not hidden.
 * Empty if no cell is hidden at all.
 */
std::vector<bool> HiddenPoints(vtkDataSet* data, const std::string& eroded);

/** Whether the point or cell of these attributes also belongs to another piece of the data, which counts it. */
bool IsDuplicate(vtkDataSetAttributes* data, vtkIdType row);
