// SPDX-License-Identifier: GPL-3.0-or-later
// histories.csv, written while the run goes on.
#pragma once

#include <filesystem>
#include <fstream>

namespace birdstrike {

struct History;

//! Titles are name[unit]; numbers are the shortest text that reads back to the same double.
class HistoryFile
{
public:
  //! \throw OutputError naming the file and the reason
  explicit HistoryFile(std::filesystem::path file);

  void append(const History& history); //!< the rows that are not yet in the file
  void flush();                        //!< to disk. \throw OutputError if any of it was not written

private:
  std::filesystem::path file_;
  std::ofstream out_;
  std::size_t rows_ = 0;
  bool titled_ = false;
};

} // namespace birdstrike
