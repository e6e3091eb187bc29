// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkBirdStrikeSeriesReader
 * @brief Head of a VTK pipeline: a series of unstructured grids (.pvd or packed), one time step in memory.
 *
 * Input:  FileName, a .pvd, a packed series (.bss) or the folder of a run.
 * Output: vtkMultiBlockDataSet, one named block per piece of the requested time step ("bird", "target");
 *         TIME_STEPS and TIME_RANGE [s].
 * Error:  vtkErrorMacro and an empty output when the .pvd or a frame is missing or broken.
 */
#pragma once

#include "vtkio/series_reader.h"

#include <vtkMultiBlockDataSetAlgorithm.h>

#include <string>

class vtkBirdStrikeSeriesReader : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkBirdStrikeSeriesReader* New();
  vtkTypeMacro(vtkBirdStrikeSeriesReader, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Path of the .pvd file.
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

protected:
  vtkBirdStrikeSeriesReader();
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBirdStrikeSeriesReader(const vtkBirdStrikeSeriesReader&) = delete;
  void operator=(const vtkBirdStrikeSeriesReader&) = delete;

  std::string FileName;
  birdstrike::SeriesIndex Index;
};
