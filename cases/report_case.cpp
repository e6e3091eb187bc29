// SPDX-License-Identifier: GPL-3.0-or-later
// case.toml in rows for the template, and the rules that ask for such a bird.
#include "cases/certification.h"
#include "cases/keys.h"
#include "cases/report_tables.h"
#include "core/error.h"

#include <fmt/format.h>

#include <cmath>

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

//! The rules that ask for a bird of this mass, to half a per cent.
Json rules_of(double mass)
{
  constexpr double near = 0.005;
  Json rules = Json::array();
  try {
    for (const CertificationRule& rule : certification_rules())
      if (std::abs(rule.mass - mass) <= near * mass)
        rules.push_back(
            {{"rule", fmt::format("{}", fmt::join(rule.names, ", "))},
             {"mass", rule.mass_text},
             {"speed", rule.speed},
             {"applies", rule.applies},
             {"read", rule.confidence == "S" ? rule.source + " (secondary source)" : rule.source}});
  } catch (const InputError&) {
    // A program without its table of rules still writes reports.
  }
  return rules;
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
  }
  if (!sections.empty()) {
    page["has_case"] = true;
    page["case_sections"] = std::move(sections);
  }
  if (const auto mass = number_at(run.summary, {"bird", "mass"})) {
    page["rules"] = rules_of(*mass);
    page["has_rules"] = !page["rules"].empty();
  }
}

} // namespace birdstrike
