// SPDX-License-Identifier: GPL-3.0-or-later
// Making and clearing a run's folder.
#include "cases/output_folder.h"

#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! Names that a run gives in a folder; '*' stands for digits.
constexpr std::array own_files{
    "summary.json",
    "run.pvd",
    "run.bss",
    "histories.csv",
    "transducers.csv",
    "case.toml",
    "run.log",
    "report.html",
    "frames/bird_*.vtu",
    "frames/target_*.vtu",
    "figures/overview.png",
    "figures/by_part.png",
    "figures/by_pressure.png",
    "figures/by_part_*.png",
    "figures/by_pressure_*.png",
    "figures/maximum_pressure.png",
    "figures/contact_force.png",
    "figures/transducers.png",
    "figures/deflection.png",
    "figures/target_deflection.png",
    "figures/target_plastic_strain.png",
};

bool matches(std::string_view name, std::string_view pattern)
{
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos)
    return name == pattern;
  const std::string_view head = pattern.substr(0, star), tail = pattern.substr(star + 1);
  if (name.size() <= head.size() + tail.size() || !name.starts_with(head) || !name.ends_with(tail))
    return false;
  name.remove_prefix(head.size());
  name.remove_suffix(tail.size());
  return name.find_first_not_of("0123456789") == std::string_view::npos;
}

void remove_own_files(const fs::path& folder)
{
  std::error_code error;
  for (const std::string_view pattern : own_files) {
    const fs::path place = folder / fs::path(pattern).parent_path();
    if (!fs::is_directory(place, error))
      continue;
    std::vector<fs::path> old;
    for (const fs::directory_entry& item : fs::directory_iterator(place, error))
      if (matches(item.path().filename().string(), fs::path(pattern).filename().string()))
        old.push_back(item.path());
    for (const fs::path& file : old)
      if (!fs::remove(file, error) && error)
        throw OutputError(fmt::format("{}: left by an earlier run and cannot be removed: {}", file.string(),
                                      error.message()));
  }
}

} // namespace

void prepare_output_folder(const fs::path& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error))
    throw OutputError(fmt::format("{}: the output folder cannot be made: {}; choose another one with -o",
                                  folder.string(), error ? error.message() : "it is not a folder"));
  remove_own_files(folder);
  const fs::path probe = folder / ".birdstrike.tmp";
  if (!std::ofstream(probe).put('\n').flush())
    throw OutputError(fmt::format("{}: the output folder cannot be written: {}; choose another one with -o",
                                  folder.string(), std::strerror(errno)));
  fs::remove(probe, error);
}

} // namespace birdstrike
