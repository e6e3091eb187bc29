// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPeakOverTime
 * @brief Largest value that each point or cell has had over a time series, and when: an envelope map.
 *
 * Input:  any data; the array ArrayName is followed, on points or, where these have none, on cells, a scalar or a
 *         vector, of any unit. Leaves without it are passed through. Points are followed by the point array
 *         IdArrayName where there is one (particles may be sorted, come and go), else, as cells always, by their row.
 *
 * Output: the input at the time asked for, with the arrays "peak_<name>" [unit of <name>] and
 *         "time_of_peak_<name>" [s]; with Smallest "lowest_<name>", "time_of_lowest_<name>". The name of a single
 *         component is "<name>_x" and so on. Of equal values the first counts; NaN values are skipped, and NaN stands
 *         where there was no value.
 *
 * Reads the series from its first step (or StartTime), one time step in memory: once to the end, or with
 * UpToCurrentTime to the time asked for, and then goes on from there while time goes forward.
 *
 * Error:  vtkErrorMacro and no output when no leaf has the array at any time, or it has too few components. If the number
 *         of points or cells of a leaf changes and there are no ids, a warning says so and the leaf has no such arrays.
 *         An abort between two steps leaves the output empty.
 */
#pragma once

#include "BirdStrikeFiltersModule.h"
#include "vtkPassInputTypeAlgorithm.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

class RunningPeaks;
class vtkDataArray;
class vtkDataSet;
struct DatasetLeaf;

class BIRDSTRIKEFILTERS_EXPORT vtkPeakOverTime : public vtkPassInputTypeAlgorithm
{
public:
  static vtkPeakOverTime* New();
  vtkTypeMacro(vtkPeakOverTime, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Name of the point or cell array to follow. Default "contact_pressure".
  vtkSetStdStringFromCharMacro(ArrayName);
  vtkGetCharFromStdStringMacro(ArrayName);
  ///@}

  ///@{ Which component of a vector is followed, from 0; -1, the default, is its length.
  vtkSetClampMacro(Component, int, -1, 8);
  vtkGetMacro(Component, int);
  ///@}

  ///@{ Whether the smallest value is sought instead of the largest. Default off.
  vtkSetMacro(Smallest, bool);
  vtkGetMacro(Smallest, bool);
  vtkBooleanMacro(Smallest, bool);
  ///@}

  ///@{ Whether only steps up to the time asked for count. Default off: the whole series.
  vtkSetMacro(UpToCurrentTime, bool);
  vtkGetMacro(UpToCurrentTime, bool);
  vtkBooleanMacro(UpToCurrentTime, bool);
  ///@}

  ///@{ Name of the point array that numbers the particles. Default "id".
  vtkSetStdStringFromCharMacro(IdArrayName);
  vtkGetCharFromStdStringMacro(IdArrayName);
  ///@}

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

protected:
  vtkPeakOverTime();
  ~vtkPeakOverTime() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPeakOverTime(const vtkPeakOverTime&) = delete;
  void operator=(const vtkPeakOverTime&) = delete;

  void Forget();
  bool Add(double time, vtkDataObject* input);
  std::string KeyOf(const DatasetLeaf& piece) const;
  void Put(const DatasetLeaf& piece) const;
  std::string ResultName() const;
  vtkDataArray* ArrayOf(vtkDataSet* leaf, bool& onPoints) const;
  vtkDataArray* IdsOf(vtkDataSet* leaf, bool onPoints) const;

  std::string ArrayName = "contact_pressure";
  int Component = -1;
  bool Smallest = false;
  bool UpToCurrentTime = false;
  std::string IdArrayName = "id";
  bool LimitTime = false;
  double StartTime = 0;
  double EndTime = 1e30;

  std::vector<double> Times; // those of the input's TIME_STEPS that are read
  std::string NoTimes;       // why none is read of an input that has some; else empty
  std::size_t Done = 0;      // steps that have been taken in
  std::size_t Wanted = 0;    // steps that must have been for the output asked for
  double Now = 0;            // the time asked for
  std::map<std::string, std::unique_ptr<RunningPeaks>> Peaks; // by KeyOf the leaf
  std::map<unsigned int, bool> Numbered;                      // whether the leaf of that index had ids
  std::set<std::string> Lost;                                 // leaves that cannot be followed
  std::vector<double> Absent;                                 // times at which no dataset has the array
  bool AbsenceTold = false;
  std::string ComponentName; // of the component that is followed
};
