// SPDX-License-Identifier: GPL-3.0-or-later
// From share/rules/certification.toml to masses by name.
#include "cases/certification.h"

#include "cases/quantity.h"
#include "cases/share_folder.h"
#include "cases/strict_table.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace birdstrike {
namespace {

std::string plain(std::string_view name)
{
  std::string result;
  for (const unsigned char c : name)
    if (!std::isspace(c))
      result += char(std::tolower(c));
  return result;
}

CertificationRule read_rule(StrictTable& table)
{
  CertificationRule rule;
  rule.names = table.texts("names");
  if (rule.names.empty())
    table.fail("names", "at least one name is needed");
  rule.mass_text = table.needed("mass", "the bird's mass, for example \"4 lb\"");
  try {
    rule.mass = parse_quantity(rule.mass_text, Dimension::mass);
  } catch (const InputError& error) {
    table.fail("mass", error.what());
  }
  if (!(rule.mass > 0))
    table.fail("mass", "allowed is above 0");
  rule.speed = table.needed("speed", "the speed in words");
  rule.applies = table.needed("applies", "to what the rule applies, in words");
  rule.confidence = table.needed("confidence", "\"F\" (found at the source) or \"S\" (secondary source)");
  if (rule.confidence != "F" && rule.confidence != "S")
    table.fail("confidence", "allowed are \"F\" (found at the source) and \"S\" (secondary source)");
  rule.source = table.needed("source", "where the rule was read");
  table.finish();
  return rule;
}

} // namespace

std::vector<CertificationRule> read_certification_rules(const std::filesystem::path& file)
{
  const toml::table root = parse_toml(file, "table of rules");
  StrictTable top(root, file.string(), "", 0);
  std::vector<CertificationRule> rules;
  std::set<std::string> seen;
  for (StrictTable& table : top.tables("rule")) {
    rules.push_back(read_rule(table));
    for (const std::string& name : rules.back().names)
      if (!seen.insert(plain(name)).second)
        table.fail("names", fmt::format("\"{}\" names a rule above already", name));
  }
  top.finish();
  require(!rules.empty(), fmt::format("{}: there is no [[rule]] in it", file.string()));
  return rules;
}

const std::vector<CertificationRule>& certification_rules()
{
  static const std::vector<CertificationRule> rules =
      read_certification_rules(share_folder() / "rules" / "certification.toml");
  return rules;
}

std::optional<double> certification_mass(std::string_view name)
{
  const std::string wanted = plain(name);
  for (const CertificationRule& rule : certification_rules())
    for (const std::string& known : rule.names)
      if (plain(known) == wanted)
        return rule.mass;
  return {};
}

std::vector<std::string> certification_names()
{
  std::vector<std::string> lines;
  for (const CertificationRule& rule : certification_rules())
    lines.push_back(fmt::format("{}: {}, {}", rule.names.front(), rule.mass_text, rule.applies));
  return lines;
}

} // namespace birdstrike
