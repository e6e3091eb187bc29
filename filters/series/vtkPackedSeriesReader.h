// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPackedSeriesReader
 * @brief Opens a packed series of BirdStrike (.bss): a whole run in one small file.
 *
 * Input:  FileName.
 * Output: vtkMultiBlockDataSet with a block of vtkUnstructuredGrid a piece ("bird", "target"), with the arrays that
 *         the run wrote (SI units) within the accuracy that it was asked for; TIME_STEPS and TIME_RANGE [s].
 * Error:  vtkErrorMacro and an empty output when the file is missing or damaged. A frame that was cut short, because
 *         the run was killed, is left out without a word.
 */
#pragma once

#include "BirdStrikeSeriesModule.h"
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

class PackedFile;

class BIRDSTRIKESERIES_EXPORT vtkPackedSeriesReader : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkPackedSeriesReader* New();
  vtkTypeMacro(vtkPackedSeriesReader, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Path of the .bss file.
  void SetFileName(const char* name);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  //! 1 if the file begins as a packed series does.
  static int CanReadFile(const char* name);

protected:
  vtkPackedSeriesReader();
  ~vtkPackedSeriesReader() override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPackedSeriesReader(const vtkPackedSeriesReader&) = delete;
  void operator=(const vtkPackedSeriesReader&) = delete;

  std::string FileName;
  std::unique_ptr<PackedFile> File; // null: not opened yet
  std::pair<std::uintmax_t, std::filesystem::file_time_type>
      Stamp; // size and time of the file that was opened
};
