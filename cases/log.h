// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says: to the screen, and to run.log once there is a folder for it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace birdstrike {

class Log
{
public:
  explicit Log(bool quiet);
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  void info(const std::string& line);      //!< screen (unless quiet) and file
  void warn(const std::string& line);      //!< the same, marked as a warning, and shown even if quiet
  void file_only(const std::string& line); //!< for what the screen shows in another way

  //! Write to that file from now on, and first all that was said so far.
  //! \throw OutputError if it cannot be written
  void open(const std::filesystem::path& file);

  //! Warnings go there instead of to the screen; to the file as ever.
  void divert_warnings(std::function<void(const std::string&)> where) { warnings_ = std::move(where); }

  bool quiet() const { return quiet_; }

private:
  struct Sinks;
  void keep(int level, const std::string& line);

  bool quiet_;
  std::function<void(const std::string&)> warnings_;
  std::vector<std::pair<int, std::string>> backlog_; //!< said before open()
  std::unique_ptr<Sinks> sinks_;
};

} // namespace birdstrike
