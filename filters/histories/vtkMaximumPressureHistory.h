// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMaximumPressureHistory
 * @brief Largest pressure at every time step of a series, over all particles and for each part, and where.
 *
 * Input:  any data whose leaf datasets carry the point array PressureArrayName [Pa]; leaves without it (a
 *         target) are passed over. The point array PartArrayName, a whole number, tells the parts apart; the
 *         leaf's field array "part_names" (strings) names part k in its row k, else its name is "part_<k>". The
 *         point array IdArrayName is a particle's number, which stays its own; without it, its row. Of a region
 *         (vtkRegionTableAlgorithm) the particles count that are in it at that time.
 *
 * Output 0, "History": vtkTable, a row per time step: "time[s]", "max_pressure_all[Pa]",
 *         "max_pressure_<name>[Pa]" ...; with Details of the particle that has the largest over all: "x_of_max_pressure[m]",
 *         "y_of_...", "z_of_...", its place at that time, and "id_of_max_pressure". NaN and -1 where a part has no
 *         particle with a value at that time; NaN values are skipped. Of equal pressures the first counts.
 * Output 1, "Peaks": vtkTable, a row for all particles and one for each part: "part", "peak_pressure[Pa]", the
 *         largest of the whole series, "time[s]" when it was, "x[m]", "y[m]", "z[m]" where, and "id".
 *
 * Error:  vtkErrorMacro and empty tables when no leaf at any time has the array, it is not a scalar, or the
 *         region has no size.
 */
#pragma once

#include "vtkRegionTableAlgorithm.h"

#include <array>
#include <map>
#include <string>
#include <vector>

class BIRDSTRIKEFILTERS_EXPORT vtkMaximumPressureHistory : public vtkRegionTableAlgorithm
{
public:
  static vtkMaximumPressureHistory* New();
  vtkTypeMacro(vtkMaximumPressureHistory, vtkRegionTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Name of the point array whose maximum is sought. Default "pressure".
  vtkSetStdStringFromCharMacro(PressureArrayName);
  vtkGetCharFromStdStringMacro(PressureArrayName);
  ///@}

  ///@{ Name of the point array that tells the parts apart. Default "part".
  vtkSetStdStringFromCharMacro(PartArrayName);
  vtkGetCharFromStdStringMacro(PartArrayName);
  ///@}

  ///@{ Name of the point array that numbers the particles. Default "id".
  vtkSetStdStringFromCharMacro(IdArrayName);
  vtkGetCharFromStdStringMacro(IdArrayName);
  ///@}

  ///@{ Whether each part has a column. Default on.
  vtkSetMacro(PerPart, bool);
  vtkGetMacro(PerPart, bool);
  vtkBooleanMacro(PerPart, bool);
  ///@}

  ///@{ Whether the first output also has the place and number of the particle with the largest pressure. Default on.
  vtkSetMacro(Details, bool);
  vtkGetMacro(Details, bool);
  vtkBooleanMacro(Details, bool);
  ///@}

protected:
  vtkMaximumPressureHistory();
  ~vtkMaximumPressureHistory() override = default;

  void Clear() override;
  bool AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves) override;
  bool FillTable(vtkTable* table) override;
  void FillSecondTable(vtkTable* table) override;

private:
  vtkMaximumPressureHistory(const vtkMaximumPressureHistory&) = delete;
  void operator=(const vtkMaximumPressureHistory&) = delete;

  //! A pressure, and whose it is, where and when. NaN and -1 until there is one.
  struct Maximum
  {
    double Pressure, Time;
    std::array<double, 3> Place;
    vtkIdType Id;
    Maximum();
    bool IsBelow(double pressure) const;
  };
  //! What one column gathers.
  struct Column
  {
    std::string Name;           // of the part
    std::vector<double> Maxima; // one a row
    Maximum Peak;               // of all rows
  };

  std::size_t ColumnOf(const std::string& part);
  bool AddLeaf(vtkDataSet* leaf);

  std::string PressureArrayName = "pressure";
  std::string PartArrayName = "part";
  std::string IdArrayName = "id";
  bool PerPart = true;
  bool Details = true;

  bool Found = false; // some leaf had the array
  std::vector<double> RowTimes;
  std::vector<Maximum> All;                       // one a row
  std::vector<Column> Parts;                      // in order of appearance
  std::map<std::string, std::size_t> PartColumns; // place in Parts
};
