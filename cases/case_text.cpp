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

//! Names that the '*' of "bird.parts.*" or "eos.*" stands for.
std::vector<std::string> names_of(const Case& values, const std::string& prefix)
{
  std::vector<std::string> names;
  if (prefix == "eos.")
    for (const LawCase& law : values.laws)
      names.push_back(law.name);
  else
    for (const PartCase& part : values.bird.parts)
      names.push_back(part.name);
  return names;
}

} // namespace

std::string to_toml(const Case& parsed)
{
  Case values = parsed; // slots point to what can be written
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
  std::string written_tables; // prefixes of the paths with '*' that are done
  for (const Key& key : case_keys()) {
    const std::string path(key.path);
    const std::size_t star = path.find('*'), dot = path.find('.');
    if (star != std::string::npos) {
      const std::string prefix = path.substr(0, star);
      if (written_tables == prefix)
        continue; // all keys of a part or of a law stand together
      written_tables = prefix;
      const std::vector<std::string> names = names_of(values, prefix);
      for (std::size_t row = 0; row < names.size(); ++row) {
        open(prefix + (is_bare(names[row]) ? names[row] : toml_string(names[row])));
        for (const Key& of_row : case_keys())
          if (of_row.path.starts_with(prefix + "*.") &&
              !(prefix == "eos." && is_empty(of_row.slot(values, row)))) {
            const std::string key_name(of_row.path.substr(star + 2));
            line(of_row, prefix + names[row] + "." + key_name, key_name, row);
          }
      }
      continue;
    }
    if (dot != std::string::npos)
      open(path.substr(0, dot));
    line(key, path, dot == std::string::npos ? path : path.substr(dot + 1), 0);
  }
  return text;
}

} // namespace birdstrike
