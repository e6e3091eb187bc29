// SPDX-License-Identifier: GPL-3.0-or-later
// case.toml in rows for the template, with the rule that the bird's mass comes from.
#include "cases/certification.h"
#include "cases/keys.h"
#include "cases/report_tables.h"

#include <exception>

namespace birdstrike {
namespace {

std::string text_of(const Entry& entry)
{
  if (entry.values.size() == 1 && !entry.is_list && std::holds_alternative<std::string>(entry.values[0]))
    return without_folders(std::get<std::string>(entry.values[0])); // without its quotes
  return without_folders(entry.found);
}

std::string meaning(const std::vector<std::string>& path)
{
  const Key* key = find_key(path);
  return key ? std::string(key->text) : "";
}

} // namespace

void add_case_table(Json& page, const ReportFolder& run)
{
  Json sections = Json::array();
  for (const Entry& entry : run.case_entries) {
    if (entry.path.size() == 1) {
      if (entry.path[0] == "title" || entry.path[0] == "source")
        page[entry.path[0]] = text_of(entry);
      if (entry.path[0] == "title")
        continue;
    }
    const std::string section = entry.path.size() == 1 ? "case" : entry.path[0];
    if (sections.empty() || sections.back()["name"] != section)
      sections.push_back({{"name", section}, {"keys", Json::array()}});
    sections.back()["keys"].push_back(
        {{"key", join(entry.path)}, {"value", text_of(entry)}, {"text", meaning(entry.path)}});
    if (join(entry.path) == "bird.mass")
      try {
        if (certification_mass(text_of(entry)))
          page["rule"] = text_of(entry);
      } catch (const std::exception&) {
        // Without its rules the program still knows the mass.
      }
  }
  if (!sections.empty()) {
    page["has_case"] = true;
    page["case_sections"] = std::move(sections);
  }
}

} // namespace birdstrike
