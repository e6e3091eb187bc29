// SPDX-License-Identifier: BSD-3-Clause
// Files that are either whole or not there.
#include "vtkio/atomic_file.h"

#include "core/error.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace birdstrike {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw OutputError("cannot make the folder " + folder.string() + ": " + error.message());
}

void write_atomically(const fs::path& file, const std::function<std::string(const fs::path&)>& write)
{
  fs::path temporary = file;
  temporary += ".tmp";
  std::string reason = write(temporary);
  if (reason.empty()) {
    std::error_code error;
    fs::rename(temporary, file, error);
    if (!error)
      return;
    reason = error.message();
  }
  std::error_code ignored;
  fs::remove(temporary, ignored);
  throw OutputError("cannot write " + file.string() + ": " + reason);
}

void write_text_atomically(const fs::path& file, const std::string& text)
{
  write_atomically(file, [&](const fs::path& temporary) -> std::string {
    errno = 0;
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    if (out)
      return {};
    return errno != 0 ? std::strerror(errno) : "the disk refused";
  });
}

} // namespace birdstrike
