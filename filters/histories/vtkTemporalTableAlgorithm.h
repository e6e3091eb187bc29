// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTemporalTableAlgorithm
 * @brief Base of filters that turn a time series into one table with a row per time step.
 *
 * Input:  any vtkDataObject, with or without TIME_STEPS; its leaf datasets are what a subclass sees.
 * Output: vtkTable. It has no time steps of its own: it is the whole series.
 * Holds one time step in memory at a time. An input without time steps counts as one step, at the time that
 * its DATA_TIME_STEP or its field array "TimeValue" says, else 0. AbortExecute between two steps, like an
 * error, leaves the table empty.
 */
#pragma once

#include "BirdStrikeFiltersModule.h"
#include "vtkTableAlgorithm.h"

#include <string>
#include <vector>

class vtkDataSet;

class BIRDSTRIKEFILTERS_EXPORT vtkTemporalTableAlgorithm : public vtkTableAlgorithm
{
public:
  vtkTypeMacro(vtkTemporalTableAlgorithm, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkTemporalTableAlgorithm() = default;
  ~vtkTemporalTableAlgorithm() override = default;

  //! Forget what was gathered before.
  virtual void Clear() = 0;
  //! Gather from the leaf datasets at a time [s]. False if it cannot be done and an error has been reported.
  virtual bool AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves) = 0;
  //! Called once, after the last step. False if it cannot be done and an error has been reported.
  virtual bool FillTable(vtkTable* table) = 0;

  //! All times of the series [s]; empty if the input has none. And the row in them of the step that AddTimeStep
  //! sees.
  const std::vector<double>& GetTimes() const { return this->Times; }
  std::size_t GetStep() const { return this->Step; }

  //! Append a column of doubles to a table.
  static void AddColumn(vtkTable* table, const std::string& title, const std::vector<double>& values);

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTemporalTableAlgorithm(const vtkTemporalTableAlgorithm&) = delete;
  void operator=(const vtkTemporalTableAlgorithm&) = delete;

  std::vector<double> Times; // TIME_STEPS of the input; empty if it has none
  std::size_t Step = 0;      // the one asked for now; 0 again after the last
};
