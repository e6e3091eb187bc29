// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFragments
 * @brief Pieces of debris: what hangs together, what each piece weighs and how it flies.
 *
 * Input: any data; every leaf dataset is looked at on its own.
 * - Particles (points with the array SmoothingLengthArrayName, or a dataset of points and vertices) hang together
 *   where their distance is below ReachFactor times the mean of their smoothing lengths; 2, the default, is the
 *   support of the solver's kernel: beyond it they do not feel each other.
 * - Cells hang together where they share a point. Eroded cells (cell array ErodedArrayName = 1, or HIDDENCELL in
 *   vtkGhostType) are gone.
 *
 * Output port 0: the input with the integer array "fragment", on points of particles, else on cells: 0 the largest by
 * mass, -1 what belongs to none (eroded cells, fragments below MinimumCount, particles at no finite place).
 *
 * Output port 1: vtkTable, a row a fragment: "dataset" (name of the leaf's block), "fragment", "count" (of particles
 * or cells), "mass[kg]", "centre_x[m]" ... the centre of mass, "velocity_x[m/s]" ... its velocity, "momentum_x[kg
 * m/s]" ..., "kinetic_energy[J]", the sum over particles or nodes, "kinetic_energy_of_centre[J]", M V^2 / 2 (the
 * difference is spin and inner motion), "extent[m]", the largest distance between two of its points.
 *
 * Fragments are ordered by mass, then count, then by place along x, y, z; the same particles in another order give
 * the same table, bit for bit.
 *
 * The mass of a shell is its area times thickness (cell array ThicknessArrayName, or a field array of that name, which
 * holds for all) times density; of a solid its volume times density. The density is the cell array DensityArrayName,
 * or else Density. An element's mass is spread evenly over its nodes, as in the solver.
 *
 * What is not known is NaN, with a warning the first time: no masses (order is then by count, centre and velocity are
 * plain means), no velocities. Error: vtkErrorMacro, an input passed on without fragments and an empty table when
 * no leaf can be looked at, a smoothing length is missing, or a property is out of its range.
 */
#pragma once

#include "BirdStrikeFiltersModule.h"
#include "vtkDataObjectAlgorithm.h"

#include <string>

class vtkDataSet;
class vtkTable;
struct DatasetLeaf;
struct Fragments;

class BIRDSTRIKEFILTERS_EXPORT vtkFragments : public vtkDataObjectAlgorithm
{
public:
  static vtkFragments* New();
  vtkTypeMacro(vtkFragments, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //! The table of port 1.
  vtkTable* GetTable();

  enum
  {
    ParticlesAndCells,
    OnlyParticles,
    OnlyCells
  };

  ///@{ Which datasets are looked at; the others pass unchanged. Default ParticlesAndCells.
  vtkSetMacro(Kind, int);
  vtkGetMacro(Kind, int);
  ///@}

  ///@{ Name of the point array of the smoothing length [m]. Default "smoothing_length".
  vtkSetStdStringFromCharMacro(SmoothingLengthArrayName);
  vtkGetCharFromStdStringMacro(SmoothingLengthArrayName);
  ///@}

  ///@{ Smoothing length of all particles [m], of data without that array. Default 0: 1.2 times the field array
  /// "spacing".
  vtkSetMacro(SmoothingLength, double);
  vtkGetMacro(SmoothingLength, double);
  ///@}

  ///@{ Distance below which particles hang together, over the mean of their smoothing lengths; above 0. Default 2.
  vtkSetMacro(ReachFactor, double);
  vtkGetMacro(ReachFactor, double);
  ///@}

  ///@{ Name of the point array of the particles' masses [kg]. Default "mass".
  vtkSetStdStringFromCharMacro(MassArrayName);
  vtkGetCharFromStdStringMacro(MassArrayName);
  ///@}

  ///@{ Name of the point array of the velocities [m/s]. Default "velocity".
  vtkSetStdStringFromCharMacro(VelocityArrayName);
  vtkGetCharFromStdStringMacro(VelocityArrayName);
  ///@}

  ///@{ Name of the cell array that is 1 where a cell has eroded. Default "eroded".
  vtkSetStdStringFromCharMacro(ErodedArrayName);
  vtkGetCharFromStdStringMacro(ErodedArrayName);
  ///@}

  ///@{ Name of the cell or field array of the shells' thickness [m]. Default "thickness".
  vtkSetStdStringFromCharMacro(ThicknessArrayName);
  vtkGetCharFromStdStringMacro(ThicknessArrayName);
  ///@}

  ///@{ Name of the cell array of the density [kg/m3]. Default "density".
  vtkSetStdStringFromCharMacro(DensityArrayName);
  vtkGetCharFromStdStringMacro(DensityArrayName);
  ///@}

  ///@{ Density of cells without that array [kg/m3]. Default 0: not known.
  vtkSetMacro(Density, double);
  vtkGetMacro(Density, double);
  ///@}

  ///@{ Fragments of fewer particles or cells are left out. Default 1.
  vtkSetMacro(MinimumCount, int);
  vtkGetMacro(MinimumCount, int);
  ///@}

protected:
  vtkFragments();
  ~vtkFragments() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFragments(const vtkFragments&) = delete;
  void operator=(const vtkFragments&) = delete;

  bool CheckProperties();
  bool AreParticles(vtkDataSet* leaf) const;
  bool AddParticles(const DatasetLeaf& leaf, vtkTable* table);
  bool AddCells(const DatasetLeaf& leaf, vtkTable* table);
  void Warn(const std::string& text);

  std::string SmoothingLengthArrayName = "smoothing_length";
  std::string MassArrayName = "mass";
  std::string VelocityArrayName = "velocity";
  std::string ErodedArrayName = "eroded";
  std::string ThicknessArrayName = "thickness";
  std::string DensityArrayName = "density";
  double SmoothingLength = 0;
  double ReachFactor = 2;
  double Density = 0;
  int MinimumCount = 1;
  int Kind = ParticlesAndCells;
  vtkMTimeType Warned = 0; // properties as they were when the last warning was given
  bool MayWarn = true;
};
