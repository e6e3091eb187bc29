// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMaximumPressureHistory
 * @brief Largest pressure at every time step of a series, over all particles and for each part.
 *
 * Input:  any data whose leaf datasets carry the point array PressureArrayName [Pa]; leaves without it (a
 * target) are passed over. The point array PartArrayName, an integer, tells the parts apart; the leaf's field
 *         array "part_names" (strings) names part k in its row k, else its name is "part_<k>".
 * Output: vtkTable, a row per time step: "time[s]", "max_pressure_all[Pa]", "max_pressure_<name>[Pa]" ...
 *         NaN where a part has no particle with a finite or infinite value at that time; NaN values are
 * skipped. Error:  vtkErrorMacro and an empty table when no leaf at any time has the array, or it is not a
 * scalar.
 */
#pragma once

#include "vtkTemporalTableAlgorithm.h"

#include <map>
#include <string>
#include <vector>

class BIRDSTRIKEFILTERS_EXPORT vtkMaximumPressureHistory : public vtkTemporalTableAlgorithm
{
public:
  static vtkMaximumPressureHistory* New();
  vtkTypeMacro(vtkMaximumPressureHistory, vtkTemporalTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Name of the point array whose maximum is sought. Default "pressure".
  vtkSetStdStringFromCharMacro(PressureArrayName);
  vtkGetCharFromStdStringMacro(PressureArrayName);
  ///@}

  ///@{ Name of the point array that tells the parts apart. Default "part".
  vtkSetStdStringFromCharMacro(PartArrayName);
  vtkGetCharFromStdStringMacro(PartArrayName);
  ///@}

protected:
  vtkMaximumPressureHistory() = default;
  ~vtkMaximumPressureHistory() override = default;

  void Clear() override;
  bool AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves) override;
  bool FillTable(vtkTable* table) override;

private:
  vtkMaximumPressureHistory(const vtkMaximumPressureHistory&) = delete;
  void operator=(const vtkMaximumPressureHistory&) = delete;

  std::size_t ColumnOf(const std::string& part);
  bool AddLeaf(vtkDataSet* leaf);

  std::string PressureArrayName = "pressure";
  std::string PartArrayName = "part";

  bool Found = false; // some leaf had the array
  std::vector<double> RowTimes;
  std::vector<double> All;                        // one a row
  std::vector<std::string> Parts;                 // in order of appearance
  std::map<std::string, std::size_t> PartColumns; // place in Parts
  std::vector<std::vector<double>> PartMaxima;    // for each part, one a row
};
