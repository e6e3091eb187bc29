// SPDX-License-Identifier: GPL-3.0-or-later
// A case as TOML text with every default filled in.
#include "cases/case.h"

#include "cases/keys.h"

#include <fmt/format.h>

#include <algorithm>

namespace birdstrike {
namespace {

bool is_bare(const std::string& name)
{
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
}

//! A file beside the case by its whole path, so that the text means the same wherever it stands; names of share stay.
void make_whole(std::string& file, const std::filesystem::path& folder)
{
  std::error_code ignored;
  if (!file.empty() && std::filesystem::is_regular_file(folder / file, ignored))
    file = std::filesystem::absolute(folder / file).lexically_normal().string();
}

} // namespace

std::string to_toml(const Case& parsed)
{
  Case values = parsed; // slots point to what can be written
  if (!parsed.file.empty()) {
    const std::filesystem::path folder = parsed.file.parent_path();
    for (std::string* file : {&values.bird.mesh, &values.target.mesh, &values.target.material})
      make_whole(*file, folder);
    for (TargetPartCase& part : values.target.parts)
      make_whole(part.material, folder);
    for (LawCase& law : values.laws)
      make_whole(law.file, folder);
  }
  std::string text, table;
  const auto line = [&](const Key& key, const std::string& path, const std::string& name, std::size_t part) {
    const auto written = values.written.find(path);
    text +=
        fmt::format("{} = {}{}\n", name,
                    written != values.written.end() ? written->second : to_toml(key.slot(values, part), key),
                    key.text.empty() ? "" : fmt::format(" # {}", key.text));
  };
  const auto open = [&](const std::string& name) {
    if (name != table)
      text += fmt::format("\n[{}]\n", name);
    table = name;
  };
  std::string written_table; // of rows with names
  for (const Key& key : case_keys()) {
    if (key.only && !key.only->holds(values))
      continue;
    const std::string path(key.path);
    const std::size_t star = path.find('*'), dot = path.find('.');
    if (star != std::string::npos) {
      const std::string prefix = path.substr(0, star);
      if (prefix == written_table)
        continue; // all keys of a row stand together
      written_table = prefix;
      const std::vector<std::string> names = names_for(values, key);
      for (std::size_t row = 0; row < names.size(); ++row) {
        open(prefix + (is_bare(names[row]) ? names[row] : toml_string(names[row])));
        for (const Key& of_row : case_keys())
          if (of_row.path.starts_with(prefix + "*.") && (!of_row.only || of_row.only->holds(values)) &&
              !is_empty(of_row.slot(values, row)))
            line(of_row, fmt::format("{}{}.{}", prefix, names[row], of_row.path.substr(star + 2)),
                 std::string(of_row.path.substr(star + 2)), row);
      }
      continue;
    }
    if (dot != std::string::npos && is_empty(key.slot(values, 0)))
      continue;
    if (dot != std::string::npos)
      open(path.substr(0, dot));
    line(key, path, dot == std::string::npos ? path : path.substr(dot + 1), 0);
  }
  return text;
}

} // namespace birdstrike
