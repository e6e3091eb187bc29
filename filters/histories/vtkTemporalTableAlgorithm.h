// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTemporalTableAlgorithm
 * @brief Base of filters that turn a time series into one table with a row per time step.
 *
 * Input:  any vtkDataObject, with or without TIME_STEPS; its leaf datasets are what a subclass sees.
 * Output: vtkTable. It has no time steps of its own: it is the whole series.
 * Holds one time step in memory at a time, and shows its number and time as progress. An input without time
 * steps counts as one step, at the time that its DATA_TIME_STEP or its field array "TimeValue" says, else 0.
 * With LimitTime only the steps from StartTime to EndTime are read. An abort between two steps, like an error,
 * leaves the tables empty.
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

  ///@{ Whether only the time steps from StartTime to EndTime, both included, are read. Default off.
  vtkSetMacro(LimitTime, bool);
  vtkGetMacro(LimitTime, bool);
  vtkBooleanMacro(LimitTime, bool);
  ///@}

  ///@{ First and last time of a limited range [s]. Default 0 and 1e30, the end of the series.
  vtkSetMacro(StartTime, double);
  vtkGetMacro(StartTime, double);
  vtkSetMacro(EndTime, double);
  vtkGetMacro(EndTime, double);
  ///@}

  ///@{ Title of the first column, the time [s]. Default "time[s]"; the charts of ParaView look for "Time".
  vtkSetStdStringFromCharMacro(TimeColumnName);
  vtkGetCharFromStdStringMacro(TimeColumnName);
  ///@}

protected:
  vtkTemporalTableAlgorithm() = default;
  ~vtkTemporalTableAlgorithm() override = default;

  //! Forget what was gathered before.
  virtual void Clear() = 0;
  //! Gather from the leaf datasets at a time [s]. False if it cannot be done and an error has been reported.
  virtual bool AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves) = 0;
  //! Called once, after the last step. False if it cannot be done and an error has been reported.
  virtual bool FillTable(vtkTable* table) = 0;
  //! Called after FillTable by filters with two output ports.
  virtual void FillSecondTable(vtkTable*) {}

  //! All times that are read [s]; empty if the input has none. And the row in them of the step that AddTimeStep
  //! sees.
  const std::vector<double>& GetTimes() const { return this->Times; }
  std::size_t GetStep() const { return this->Step; }

  //! Note that no leaf has what is looked for at a time [s]; the rows that this leaves empty are told of at the end.
  void NoteAbsence(double time) { this->Absent.push_back(time); }
  void WarnOfAbsence(const std::string& array);

  //! What arrays the first step has, for a message that asks for one of them; see DatasetLeaves.h.
  const std::string& GetArrays() const { return this->Arrays; }

  //! Append the column of times.
  void AddTimes(vtkTable* table, const std::vector<double>& times) const
  {
    AddColumn(table, this->TimeColumnName, times);
  }
  //! Append a column of doubles, or of whole numbers, to a table.
  static void AddColumn(vtkTable* table, const std::string& title, const std::vector<double>& values);
  static void AddIdColumn(vtkTable* table, const std::string& title, const std::vector<vtkIdType>& values);

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTemporalTableAlgorithm(const vtkTemporalTableAlgorithm&) = delete;
  void operator=(const vtkTemporalTableAlgorithm&) = delete;

  bool LimitTime = false;
  double StartTime = 0;
  double EndTime = 1e30;

  std::string TimeColumnName = "time[s]";

  std::vector<double> Times; // those of the input's TIME_STEPS that are read; empty if it has none
  std::string NoTimes;       // why none is read of an input that has some; else empty
  std::vector<double> Absent;
  std::string Arrays;
  std::size_t Step = 0; // the one asked for now; 0 again after the last
};
