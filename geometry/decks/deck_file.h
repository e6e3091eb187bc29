// SPDX-License-Identifier: GPL-3.0-or-later
// A text file that is either whole or not there, written piece by piece.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

//! One line of letters that every solver knows: printable ASCII, "_" for the rest.
std::string printable(std::string_view text);

//! Writes under a temporary name beside the file; without commit() that is removed and an older file stays.
class DeckFile
{
public:
  //! \param comment  what starts a comment line: "$ ", "# ", "** "
  //! \throw OutputError naming the file if it cannot be opened
  DeckFile(std::filesystem::path file, std::string comment);
  ~DeckFile();
  DeckFile(const DeckFile&) = delete;
  DeckFile& operator=(const DeckFile&) = delete;

  void line(std::string_view text);
  void comment(std::string_view text);
  void comments(const std::vector<std::string>& lines);
  //! Give the file its name. \throw OutputError naming it if the disk refused
  void commit();
  const std::filesystem::path& path() const { return file_; }

private:
  [[noreturn]] void fail(const std::string& reason) const;

  std::filesystem::path file_, temporary_;
  std::string comment_;
  std::ofstream out_;
};

} // namespace birdstrike
