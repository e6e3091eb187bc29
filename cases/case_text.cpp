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
  bool parts_written = false;
  for (const Key& key : case_keys()) {
    const std::string path(key.path);
    const std::size_t star = path.find('*'), dot = path.find('.');
    if (star != std::string::npos) {
      if (parts_written)
        continue; // all keys of a part stand together
      parts_written = true;
      for (std::size_t part = 0; part < values.bird.parts.size(); ++part) {
        const std::string& name = values.bird.parts[part].name;
        open("bird.parts." + (is_bare(name) ? name : toml_string(name)));
        for (const Key& of_part : case_keys())
          if (of_part.path.starts_with("bird.parts.*."))
            line(of_part, fmt::format("bird.parts.{}.{}", name, of_part.path.substr(star + 2)),
                 std::string(of_part.path.substr(star + 2)), part);
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
