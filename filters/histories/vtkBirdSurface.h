// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkBirdSurface
 * @brief The skin of smoothed particles: the surface on which the solver's own kernel finds space half filled.
 *
 * Input: any data whose leaf datasets are particles, points with the array SmoothingLengthArrayName [m]; leaves
 * without it (a target) are passed over. If no leaf has it, datasets of points and vertices are particles, and
 * SmoothingLength, or else 1.2 times the field array "spacing", is the smoothing length of all; a warning says so.
 * Neither masses nor densities are needed: see SphField.h.
 *
 * Output: vtkMultiBlockDataSet. One block "bird" (the particles of all leaves together), or one a part, named after
 * it; each a vtkPolyData of triangles that is closed, every edge having two. Point data: every array of the
 * particles that was chosen, by kernel-normalised interpolation (whole numbers such as "part": the one of most
 * weight), and "Normals", out of the bird. Field data: that of the first leaf.
 *
 * The same particles give the same bits, in any order and with any number of threads. The lattice starts at the
 * lowest corner of the particles: moved particles have the moved skin.
 *
 * Particles whose position or smoothing length is not finite, or not positive, are left out with a warning. Error:
 * vtkErrorMacro and an empty output when there are no particles, a property is out of its range, or MemoryLimit
 * does not do.
 */
#pragma once

#include "BirdStrikeFiltersModule.h"
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <array>
#include <string>
#include <vector>

class vtkDataSet;
struct ParticleRow;

class BIRDSTRIKEFILTERS_EXPORT vtkBirdSurface : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkBirdSurface* New();
  vtkTypeMacro(vtkBirdSurface, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Name of the point array of the smoothing length h [m]; the kernel ends at 2 h. Default "smoothing_length".
  vtkSetStdStringFromCharMacro(SmoothingLengthArrayName);
  vtkGetCharFromStdStringMacro(SmoothingLengthArrayName);
  ///@}

  ///@{ Smoothing length of all particles [m], of data without that array. Default 0: 1.2 times the field array
  /// "spacing".
  vtkSetMacro(SmoothingLength, double);
  vtkGetMacro(SmoothingLength, double);
  ///@}

  ///@{ Factor on every smoothing length, above 0. More than 1 gives a smoother skin that closes small gaps.
  /// Default 1.
  vtkSetMacro(SmoothingFactor, double);
  vtkGetMacro(SmoothingFactor, double);
  ///@}

  ///@{ Level of the colour function at the skin, 0.05 to 0.95. Default ln 2, exact for flat free surfaces.
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{ Spacing of the grid over the median smoothing length, 0.05 to 2. Default 0.5.
  vtkSetMacro(GridShare, double);
  vtkGetMacro(GridShare, double);
  ///@}

  ///@{ Whether every part has a surface of its own, so that organs are seen inside. Default off.
  vtkSetMacro(SurfacePerPart, bool);
  vtkGetMacro(SurfacePerPart, bool);
  vtkBooleanMacro(SurfacePerPart, bool);
  ///@}

  ///@{ Name of the point array that tells the parts apart. Default "part".
  vtkSetStdStringFromCharMacro(PartArrayName);
  vtkGetCharFromStdStringMacro(PartArrayName);
  ///@}

  ///@{ Whether all point arrays come along, or those that AddArray names. Default on.
  vtkSetMacro(AllArrays, bool);
  vtkGetMacro(AllArrays, bool);
  vtkBooleanMacro(AllArrays, bool);
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{ Memory that grid and surface may take [MB]. Default 2000.
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

protected:
  vtkBirdSurface() = default;
  ~vtkBirdSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBirdSurface(const vtkBirdSurface&) = delete;
  void operator=(const vtkBirdSurface&) = delete;

  struct Particles;
  bool CheckProperties();
  bool FindLeaves(vtkDataObject* input, Particles& particles);
  void Gather(Particles& particles);
  bool MakeSurfaces(const Particles& particles, vtkMultiBlockDataSet* output);
  void Warn(const std::string& text);

  std::string SmoothingLengthArrayName = "smoothing_length";
  std::string PartArrayName = "part";
  double SmoothingLength = 0;
  double SmoothingFactor = 1;
  double Level = 0.69314718055994531;
  double GridShare = 0.5;
  double MemoryLimit = 2000;
  bool SurfacePerPart = false;
  bool AllArrays = true;
  std::vector<std::string> ArrayNames;
  vtkMTimeType Warned = 0; // properties as they were when the last warning was given
  bool MayWarn = true;
};
