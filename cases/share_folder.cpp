// SPDX-License-Identifier: GPL-3.0-or-later
// The share folder, the catalogue in it, and what is looked up there.
#include "cases/share_folder.h"

#include "cases/case.h"
#include "cases/case_entries.h"
#include "cases/study.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace fs = std::filesystem;

namespace birdstrike {

//! The places in which the share folder may be, the first one first.
static std::vector<fs::path> share_places()
{
  std::error_code ignored;
  std::vector<fs::path> places;
  if (const char* named = std::getenv("BIRDSTRIKE_SHARE"); named && *named)
    places.emplace_back(named);
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  if (!program.empty())
    places.push_back(program.parent_path().parent_path() / "share" / "birdstrike");
  places.emplace_back(BIRDSTRIKE_SOURCE_SHARE);
  return places;
}

fs::path share_folder()
{
  std::error_code ignored;
  for (const fs::path& place : share_places())
    if (fs::is_directory(place / "meshes", ignored))
      return place;
  return {};
}

fs::path find_share_file(const fs::path& name)
{
  std::error_code ignored;
  for (const fs::path& place : share_places())
    if (fs::is_regular_file(place / name, ignored))
      return place / name;
  return {};
}

fs::path catalogue_folder()
{
  std::error_code ignored;
  const fs::path share = share_folder();
  if (share.empty() || fs::is_directory(share / "cases", ignored))
    return share.empty() ? fs::path() : share / "cases";
  return fs::absolute(share).lexically_normal().parent_path() / "cases";
}

std::vector<CatalogueEntry> catalogue()
{
  std::vector<CatalogueEntry> entries;
  std::error_code ignored;
  const fs::path folder = catalogue_folder();
  if (folder.empty() || !fs::is_directory(folder, ignored))
    return entries;
  for (const fs::directory_entry& item : fs::recursive_directory_iterator(folder)) {
    if (item.path().extension() != ".toml")
      continue;
    CatalogueEntry entry{(item.path().lexically_relative(folder)).replace_extension().string(), "",
                         item.path()};
    try {
      const std::vector<Entry> keys = read_entries(item.path());
      if (is_figures(keys))
        continue;
      entry.study = is_study(keys);
      for (const Entry& key : keys)
        if (key.path.size() == 1 && key.path[0] == "title" &&
            std::holds_alternative<std::string>(key.values.at(0)))
          entry.title = std::get<std::string>(key.values[0]);
    } catch (const std::exception&) {
      // A broken file stays in the list, without its title: running it says what is wrong.
    }
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return entries;
}

//! \param study  which kind is listed when there is none of that name
static fs::path find_in_catalogue(const std::string& path_or_name, bool study)
{
  std::error_code ignored;
  if (fs::exists(path_or_name, ignored))
    return path_or_name;
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.name == path_or_name)
      return entry.file;
    if (entry.study == study)
      names.push_back(entry.name);
  }
  throw InputError(fmt::format(
      "{}: no such {} file, nor a name of the catalogue ({})", path_or_name, study ? "study" : "case",
      names.empty() ? "which was not found" : fmt::format("{}", fmt::join(names, ", "))));
}

fs::path find_case(const std::string& path_or_name) { return find_in_catalogue(path_or_name, false); }
fs::path find_study(const std::string& path_or_name) { return find_in_catalogue(path_or_name, true); }

fs::path find_mesh(const Case& parsed)
{
  std::error_code ignored;
  std::vector<fs::path> places;
  const fs::path mesh = parsed.bird.mesh;
  if (mesh.is_absolute()) {
    places.push_back(mesh);
  } else {
    places.push_back(parsed.file.parent_path() / mesh);
    if (const fs::path share = share_folder(); !share.empty())
      places.push_back(share / "meshes" / mesh);
  }
  std::vector<std::string> names;
  for (const fs::path& place : places) {
    if (fs::is_regular_file(place, ignored) || fs::is_directory(place, ignored))
      return place;
    names.push_back(place.string());
  }
  throw InputError(fmt::format("{}: bird.mesh = \"{}\": no such file; looked for {}", parsed.file.string(),
                               parsed.bird.mesh, fmt::join(names, " and ")));
}

} // namespace birdstrike
