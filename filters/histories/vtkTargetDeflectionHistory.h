// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTargetDeflectionHistory
 * @brief Deflection of the target at every time step of a series, largest and at chosen points, and what
 * stays of it.
 *
 * Input: any data whose leaf datasets carry the point array DisplacementArrayName, a vector [m] from the place
 * before the load; leaves without it (the bird) are passed over. All lengths are in metres. A deflection
 * without further word is the length of the displacement, never negative; components have the sign of their
 * axis, so that the bird's flight, along +x, pushes a plate to positive x; "along" is the component along
 * Direction.
 *
 * Output 0, "History": vtkTable, a row per time step:
 * - "time[s]"; "max_deflection[m]"; "x[m]", "y[m]", "z[m]": where that point was before the load; "point": its
 *   row in its dataset. Of equal deflections the first counts.
 * - "max_deflection_along[m]", with a Direction: the component of largest magnitude, with its sign.
 * - for each chosen point: "deflection_at_<name>[m]", "deflection_x_at_<name>[m]", ..._y_..., ..._z_..., with a
 *   Direction "deflection_along_at_<name>[m]".
 *
 * These hold for the whole series and are the same in every row:
 * - "permanent_set[m]": largest length of the time mean of a point's displacement over the series' last part
 *   (WindowShare); "x_of_permanent_set[m]", "y_of_...", "z_of_...": where that point was before the load; with a
 *   Direction "permanent_set_along[m]": the mean component of largest magnitude, with its sign.
 * - "residual_amplitude[m]": how far that point still swings about its mean in that part, and
 *   "max_residual_amplitude[m]" any point. A target that has come to rest has amplitudes far below its set.
 *   The amplitude is made of the largest distances of the three components from their means: exact for a
 *   vibration along one line, never too small. It sees no more than the steps of the series do.
 * - for each chosen point: "mesh_point_at_<name>", the point of the mesh that stands for it, the nearest one
 *   before the load, as row in its dataset; "distance_at_<name>[m]" between the two;
 *   "permanent_set_at_<name>[m]"; with a Direction "permanent_set_along_at_<name>[m]";
 *   "residual_amplitude_at_<name>[m]".
 *
 * Output 1, "Line", with UseLine: vtkTable, a row for each of LinePoints samples between LineStart and LineEnd,
 * places before the load: "distance[m]" from the start, with Details "x[m]", "y[m]", "z[m]", "off_target[m]", the distance to the
 * nearest place on the target, whose deflection it is, and for every time step "deflection_at_<time>s[m]", with a
 * Direction its component along it. An empty table without UseLine.
 *
 * With IgnoreErodedCells, points that only belong to hidden cells (cell array ErodedArrayName = 1, or
 * HIDDENCELL in vtkGhostType) count as if they were not there. NaN and point -1 where there is nothing: no
 * target yet, a chosen point that has eroded, a set of a point that was not there in the whole last part, an
 * amplitude from a single step. NaN displacements are skipped.
 *
 * A target that turns steadily has displacements without its turning: places before the load then come from the field
 * arrays "spin_centre" [m] and "spin_velocity" [rad/s] and the time since the start.
 *
 * Points are followed by their row. If the number of points changes from one step to another, a warning says
 * so; chosen points and the line have NaN from there on, and there is no permanent set.
 *
 * Error: vtkErrorMacro and an empty table when no leaf at any time has the array, it is not a vector or too
 * short, or a property is out of its range.
 */
#pragma once

#include "vtkTemporalTableAlgorithm.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class LineOnTarget;
class TrailingMean;

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

  ///@{ Points whose deflection is wanted, by their place before the load [m]. The name, part of the columns'
  /// titles, is "0", "1", ... by order if none is given; two points cannot share one. Without brackets, quotes, commas, semicolons.
  void AddPoint(double x, double y, double z, const char* name = nullptr);
  void AddPlace(double x, double y, double z) { this->AddPoint(x, y, z); }
  void RemoveAllPoints();
  int GetNumberOfPoints() const { return static_cast<int>(this->Chosen.size()); }
  ///@}

  ///@{ Direction of the columns "along"; of any length but zero, which is the default and means none. (1, 0, 0)
  /// is the bird's flight.
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{ Last part of the series' time over which permanent set is the mean, 0 (its last step) to 1. Default 0.2.
  vtkSetMacro(WindowShare, double);
  vtkGetMacro(WindowShare, double);
  ///@}

  ///@{ Whether the second output has the deflection along a line. Default off.
  vtkSetMacro(UseLine, bool);
  vtkGetMacro(UseLine, bool);
  vtkBooleanMacro(UseLine, bool);
  ///@}

  ///@{ The line's ends, places before the load [m], and how many samples divide it evenly, 2 or more. Default
  /// from (0, -0.1, 0) to (0, 0.1, 0) with 51.
  vtkSetVector3Macro(LineStart, double);
  vtkGetVector3Macro(LineStart, double);
  vtkSetVector3Macro(LineEnd, double);
  vtkGetVector3Macro(LineEnd, double);
  vtkSetClampMacro(LinePoints, int, 2, 100000);
  vtkGetMacro(LinePoints, int);
  ///@}

  ///@{ Title of the first column of the second output. Default "distance[m]"; the charts of ParaView look for
  /// "arc_length".
  vtkSetStdStringFromCharMacro(DistanceColumnName);
  vtkGetCharFromStdStringMacro(DistanceColumnName);
  ///@}

  ///@{ Whether the outputs have more than what one plots: in the first time, largest deflection, deflection at the chosen points
  /// and permanent set, and those along the Direction. Default on.
  vtkSetMacro(Details, bool);
  vtkGetMacro(Details, bool);
  vtkBooleanMacro(Details, bool);
  ///@}

  ///@{ Whether points that only belong to hidden cells are skipped. Default on.
  vtkSetMacro(IgnoreErodedCells, bool);
  vtkGetMacro(IgnoreErodedCells, bool);
  vtkBooleanMacro(IgnoreErodedCells, bool);
  ///@}

  ///@{ Name of the cell array that is 1 where a cell has eroded. Default "eroded".
  vtkSetStdStringFromCharMacro(ErodedArrayName);
  vtkGetCharFromStdStringMacro(ErodedArrayName);
  ///@}

protected:
  vtkTargetDeflectionHistory();
  ~vtkTargetDeflectionHistory() override;

  void Clear() override;
  bool AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves) override;
  bool FillTable(vtkTable* table) override;
  void FillSecondTable(vtkTable* table) override;

private:
  vtkTargetDeflectionHistory(const vtkTargetDeflectionHistory&) = delete;
  void operator=(const vtkTargetDeflectionHistory&) = delete;

  using Vector = std::array<double, 3>;
  struct ChosenPoint
  {
    Vector Place;
    std::string Name;
    std::size_t Nearest = 0;     // in Now
    vtkIdType Row = -1;          // in its dataset
    double Distance = 0;         // from there; NaN if there is no point
    std::vector<Vector> History; // its displacement, one a row
  };
  // All points of the target at one step, leaf after leaf.
  struct State
  {
    std::vector<std::size_t> Counts;         // of each leaf
    std::vector<Vector> Displacement, Place; // NaN where hidden; before the load
    std::vector<vtkIdType> Row;              // in its dataset
    std::vector<vtkDataSet*> Leaves;
  };

  bool CheckProperties();
  bool Gather(double time, const std::vector<vtkDataSet*>& leaves);
  void FindNearest();
  void CheckCounts(double time);
  void CheckDistances();
  double Along(const Vector& u) const;
  void FillChosen(vtkTable* table) const;
  void FillSet(vtkTable* table) const;

  std::string DisplacementArrayName = "displacement";
  bool PointsMove = true;
  std::vector<ChosenPoint> Chosen;
  double Direction[3] = {0, 0, 0};
  double WindowShare = 0.2;
  bool UseLine = false;
  double LineStart[3] = {0, -0.1, 0};
  double LineEnd[3] = {0, 0.1, 0};
  int LinePoints = 51;
  std::string DistanceColumnName = "distance[m]";
  bool Details = true;
  bool IgnoreErodedCells = true;
  std::string ErodedArrayName = "eroded";

  bool Found = false;                   // some leaf had the array
  bool Followed = true;                 // the counts have not changed
  std::vector<std::size_t> FirstCounts; // of each leaf, at the first step with a target
  Vector Unit{};                        // along Direction; zero if there is none
  State Now;                            // the step that was added last and had a target
  std::unique_ptr<TrailingMean> Trailing;
  std::unique_ptr<LineOnTarget> Line;
  std::vector<std::vector<double>> Profiles; // over the line, one a row
  std::vector<double> RowTimes, Deflection, MaxAlong, X, Y, Z;
  std::vector<vtkIdType> Point;
};
