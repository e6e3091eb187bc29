// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTargetDeflectionHistory
 * @brief Largest deflection of the target at every time step of a series, and where it is.
 *
 * Input:  any data whose leaf datasets carry the point array DisplacementArrayName, a vector [m]; leaves
 * without it (the bird) are passed over. Output: vtkTable, a row per time step: "time[s]",
 * "max_deflection[m]" (length of the largest displacement), "x[m]", "y[m]", "z[m]" (where that point was
 * before the load), "point" (its row in its dataset). Of equal deflections the first counts. NaN and point -1
 * while there is no target; NaN values are skipped. Error:  vtkErrorMacro and an empty table when no leaf at
 * any time has the array, or it is not a vector.
 */
#pragma once

#include "vtkTemporalTableAlgorithm.h"

#include <string>
#include <vector>

class BIRDSTRIKEFILTERS_EXPORT vtkTargetDeflectionHistory : public vtkTemporalTableAlgorithm
{
public:
  static vtkTargetDeflectionHistory* New();
  vtkTypeMacro(vtkTargetDeflectionHistory, vtkTemporalTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Name of the point array to measure. Default "displacement".
  vtkSetStdStringFromCharMacro(DisplacementArrayName);
  vtkGetCharFromStdStringMacro(DisplacementArrayName);
  ///@}

  ///@{ Whether the points of the data have moved with the target, so that the place before the load is the
  /// point
  /// less its displacement. Default on.
  vtkSetMacro(PointsMove, bool);
  vtkGetMacro(PointsMove, bool);
  vtkBooleanMacro(PointsMove, bool);
  ///@}

protected:
  vtkTargetDeflectionHistory() = default;
  ~vtkTargetDeflectionHistory() override = default;

  void Clear() override;
  bool AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves) override;
  bool FillTable(vtkTable* table) override;

private:
  vtkTargetDeflectionHistory(const vtkTargetDeflectionHistory&) = delete;
  void operator=(const vtkTargetDeflectionHistory&) = delete;

  std::string DisplacementArrayName = "displacement";
  bool PointsMove = true;

  bool Found = false; // some leaf had the array
  std::vector<double> RowTimes, Deflection, X, Y, Z;
  std::vector<vtkIdType> Point;
};
