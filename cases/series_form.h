// SPDX-License-Identifier: GPL-3.0-or-later
// The words by which a series' form is told, in case files and on the command line.
#pragma once

#include "vtkio/series_options.h"

#include <string>
#include <vector>

namespace birdstrike {

//! A series' form in words: what the keys of [series] and the options of `birdstrike series` hold.
struct SeriesForm
{
  std::string format = "vtu";       //!< of series_formats()
  std::string precision = "single"; //!< of series_precisions()
  std::string compression = "zlib"; //!< of series_compressions()
  double accuracy = SeriesOptions().accuracy;
  std::vector<std::string> fields; //!< of series_fields(), besides those that are always written; empty: all
};

std::vector<std::string> series_formats();      //!< "vtu", "packed", "both"
std::vector<std::string> series_precisions();   //!< "single", "double"
std::vector<std::string> series_compressions(); //!< "none", "lz4", "zlib", "lzma"
std::vector<std::string> series_fields();       //!< every quantity of bird or target that may be left out

//! \param form  words that are among the allowed ones
SeriesOptions series_options(const SeriesForm& form);

} // namespace birdstrike
