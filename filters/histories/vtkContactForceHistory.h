// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactForceHistory
 * @brief Contact force on the target, or a region or part of it, at every time step of a series, its impulse, and the
 * mean pressure as a transducer shows it.
 *
 * Input:  any data whose leaf datasets carry the cell array ForceArrayName, or else the point array of that name, a
 *         vector [N]; leaves without it (the bird) are passed over. Where they are there: ImpulseArrayName, a vector
 *         [N s] of the same kind, the time integral of the force; PressureArrayName, a scalar on the cells [Pa]; the cell
 *         array PartArrayName, a whole number, with the leaf's field array "part_names" (strings) for their names, else
 *         "part_<k>"; and the cell array ErodedArrayName, 1 where a cell has gone.
 *
 * A region (vtkRegionTableAlgorithm) takes hold of the target where it is at the first time step that is read, and goes
 * with it: a cell on the border counts by its share inside, a point wholly or not at all.
 *
 * Output 0, "History": vtkTable, a row per time step:
 * - "time[s]"; "contact_force_x[N]", "..._y...", "..._z...", the sum, and "contact_force[N]", its length.
 * - "impulse_x[N s]", "..._y...", "..._z...", "impulse[N s]": since the first time step. From ImpulseArrayName where all
 *   leaves have it, and then exact whatever the time between frames; else the force's integral by the trapezoidal rule,
 *   which is as good as the frames are dense.
 * - with a RiseTime "contact_force_x_filtered[N]", "..._y...", "..._z...": behind the single pole of the virtual
 *   transducers, with that 10 to 90 % rise time, at rest at the first time step.
 * - with PerPart for each part "contact_force_x_<name>[N]", "..._y...", "..._z...", "contact_force_<name>[N]".
 *
 * Output 1, "Transducer": vtkTable, a row per time step: "time[s]"; "mean_pressure[Pa]", the mean of PressureArrayName over
 * the region; without such an array the sum of the forces' parts across their cells (of points: the length of the whole
 * force) over the area; with a RiseTime "mean_pressure_filtered[Pa]"; "area[m2]" of the region's flat cells, without those
 * that have gone. No pressure, NaN, without an area.
 *
 * NaN where there is no target at that time.
 *
 * If the number of cells or points changes from one step to another a warning says so, and the region takes hold anew.
 *
 * Error: vtkErrorMacro and empty tables when no leaf at any time has the force, it is no vector or too short, or a
 * property is out of its range.
 */
#pragma once

#include "vtkRegionTableAlgorithm.h"

#include <array>
#include <map>
#include <string>
#include <vector>

class vtkDataArray;

class BIRDSTRIKEFILTERS_EXPORT vtkContactForceHistory : public vtkRegionTableAlgorithm
{
public:
  static vtkContactForceHistory* New();
  vtkTypeMacro(vtkContactForceHistory, vtkRegionTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Name of the cell or point array of the contact force. Default "contact_force".
  vtkSetStdStringFromCharMacro(ForceArrayName);
  vtkGetCharFromStdStringMacro(ForceArrayName);
  ///@}

  ///@{ Name of the array of its time integral. Default "contact_impulse".
  vtkSetStdStringFromCharMacro(ImpulseArrayName);
  vtkGetCharFromStdStringMacro(ImpulseArrayName);
  ///@}

  ///@{ Name of the cell array of the pressure. Default "contact_pressure".
  vtkSetStdStringFromCharMacro(PressureArrayName);
  vtkGetCharFromStdStringMacro(PressureArrayName);
  ///@}

  ///@{ Name of the cell array that tells the target's parts apart. Default "part".
  vtkSetStdStringFromCharMacro(PartArrayName);
  vtkGetCharFromStdStringMacro(PartArrayName);
  ///@}

  ///@{ Name of the cell array that is 1 where a cell has eroded. Default "eroded".
  vtkSetStdStringFromCharMacro(ErodedArrayName);
  vtkGetCharFromStdStringMacro(ErodedArrayName);
  ///@}

  ///@{ Whether each part of the target has columns of its own; of an array on cells. Default off.
  vtkSetMacro(PerPart, bool);
  vtkGetMacro(PerPart, bool);
  vtkBooleanMacro(PerPart, bool);
  ///@}

  ///@{ 10 to 90 % rise time of the filter [s]; 0, the default, for none. It is at rest at the first step that is
  /// read: with LimitTime begin some rise times before what is looked at.
  vtkSetMacro(RiseTime, double);
  vtkGetMacro(RiseTime, double);
  ///@}

protected:
  vtkContactForceHistory();
  ~vtkContactForceHistory() override = default;

  void Clear() override;
  bool AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves) override;
  bool FillTable(vtkTable* table) override;
  void FillSecondTable(vtkTable* table) override;

private:
  vtkContactForceHistory(const vtkContactForceHistory&) = delete;
  void operator=(const vtkContactForceHistory&) = delete;

  using Vector = std::array<double, 3>;
  struct Leaf
  {
    vtkDataSet* Data;
    vtkDataArray* Force;
    vtkDataArray* Impulse;
    bool OnCells;
  };
  //! One time step.
  struct Row
  {
    double Time;
    Vector Force, Impulse;
    double Area, Pressed; // area [m2]; pressure times area [N]
    std::map<std::string, Vector> Parts;
    bool Anew = false; // the region took hold of other elements than before
  };
  //! What of a leaf is in the region, 0 to 1, by cell and by point.
  struct Shares
  {
    std::vector<double> OfCells, OfPoints;
  };

  bool Find(vtkDataSet* data, Leaf& leaf);
  //! \return whether it did so anew
  bool TakeHold(double time, const std::vector<Leaf>& leaves);
  void WarnOfEmptyRegion(double time, const std::vector<Leaf>& leaves);
  void AddLeaf(const Leaf& leaf, const Shares& shares, Row& row) const;
  void FillImpulse(vtkTable* table) const;

  std::string ForceArrayName = "contact_force";
  std::string ImpulseArrayName = "contact_impulse";
  std::string PressureArrayName = "contact_pressure";
  std::string PartArrayName = "part";
  std::string ErodedArrayName = "eroded";
  bool PerPart = false;
  double RiseTime = 0;

  bool Found = false;             // some leaf had the force
  bool HasImpulse = true;         // and all of them the impulse
  std::vector<Shares> Held;       // of each leaf with a force
  std::vector<std::string> Parts; // in order of appearance
  std::vector<Row> Rows;
};
