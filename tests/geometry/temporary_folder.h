// SPDX-License-Identifier: GPL-3.0-or-later
// A folder that lives as long as a test, and small helpers for mesh files in it.
#pragma once

#include "core/error.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace birdstrike::test {

class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    static std::atomic<int> count{0};
    path_ = std::filesystem::temp_directory_path() /
            ("birdstrike-geometry-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::filesystem::path write(const std::string& name, const std::string& content) const
  {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }

private:
  std::filesystem::path path_;
};

//! What an InputError says; fails the test if none is thrown.
template <class Action>
std::string input_error(Action action)
{
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  FAIL("no InputError was thrown");
  return {};
}

} // namespace birdstrike::test
