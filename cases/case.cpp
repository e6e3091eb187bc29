// SPDX-License-Identifier: GPL-3.0-or-later
// Case files: from entries to values, by the table of keys.
#include "cases/case.h"

#include "cases/case_entries.h"
#include "cases/keys.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace birdstrike {
namespace {

//! Puts one entry's value where its key says.
class Assignment
{
public:
  Assignment(const Entry& entry, const Key& key) : entry_(entry), key_(key) {}

  void operator()(double* slot) const { *slot = real(single()); }
  void operator()(int* slot) const { *slot = integer(single()); }
  void operator()(std::array<double, 2>* slot) const
  {
    pair();
    *slot = {real(entry_.values[0]), real(entry_.values[1])};
  }
  void operator()(std::array<int, 2>* slot) const
  {
    pair();
    *slot = {integer(entry_.values[0]), integer(entry_.values[1])};
  }
  void operator()(bool* slot) const
  {
    const bool* value = std::get_if<bool>(&single());
    if (!value)
      fail(kind_of(key_) + " is needed");
    *slot = *value;
  }
  void operator()(std::string* slot) const { *slot = text(); }
  void operator()(ViscosityKind* slot) const
  {
    *slot = text() == "pairwise" ? ViscosityKind::pairwise : ViscosityKind::bulk;
  }

private:
  [[noreturn]] void fail(const std::string& problem) const
  {
    throw InputError(fmt::format("{}: {} = {}: {}", entry_.place, join(entry_.path), entry_.found, problem));
  }

  const Scalar& single() const
  {
    if (entry_.is_list || entry_.values.size() != 1)
      fail(kind_of(key_) + " is needed");
    return entry_.values.front();
  }

  void pair() const
  {
    if (!entry_.is_list || entry_.values.size() != 2)
      fail(kind_of(key_) + " is needed");
  }

  void check_range(double value) const
  {
    const Range& range = key_.range;
    const bool low = !range.low || value > *range.low || (value == *range.low && !range.low_open);
    if (!low || (range.high && value > *range.high))
      fail(fmt::format("allowed is {}", describe(range, key_.dimension)));
  }

  double real(const Scalar& scalar) const
  {
    double value = 0;
    const std::string* written = std::get_if<std::string>(&scalar);
    if (key_.dimension == Dimension::number) {
      if (const auto* whole = std::get_if<std::int64_t>(&scalar))
        value = static_cast<double>(*whole);
      else if (const auto* fraction = std::get_if<double>(&scalar))
        value = *fraction;
      else
        fail("a number without unit and quotes is needed, for example 1.25");
      if (!(value - value == 0))
        fail("a finite number is needed");
    } else {
      try {
        // A bare number lacks its unit: let the same place complain about it as for "6".
        value = parse_quantity(written ? *written : entry_.is_list ? "1" : entry_.found, key_.dimension);
      } catch (const InputError& error) {
        fail(error.what());
      }
    }
    check_range(value);
    return value;
  }

  int integer(const Scalar& scalar) const
  {
    const auto* value = std::get_if<std::int64_t>(&scalar);
    if (!value)
      fail(kind_of(key_) + " is needed");
    check_range(static_cast<double>(*value));
    return static_cast<int>(*value);
  }

  std::string text() const
  {
    const Scalar& scalar = single();
    const std::string* value = std::get_if<std::string>(&scalar);
    std::string result;
    if (value)
      result = *value;
    else if (entry_.place == "--set") // --set title=7: the shell eats quotes, a text is meant
      result = entry_.found;
    else
      fail(kind_of(key_) + " is needed");
    if (key_.choices) {
      const std::vector<std::string> choices = key_.choices();
      if (!key_.or_law && std::find(choices.begin(), choices.end(), result) == choices.end())
        fail(kind_of(key_) + " is needed");
    }
    return result;
  }

  const Entry& entry_;
  const Key& key_;
};

[[noreturn]] void unknown_key(const Entry& entry)
{
  const std::string path = join(entry.path);
  for (const Key& key : case_keys())
    if (key.path.starts_with(path + "."))
      throw InputError(fmt::format("{}: {} = {}: this is a table of keys, for example {}", entry.place, path,
                                   entry.found, key.path));
  const std::string nearest = nearest_key(entry.path);
  throw InputError(fmt::format("{}: unknown key {}; {}", entry.place, path,
                               nearest.empty() ? "`birdstrike cases --keys` lists the known ones"
                                               : fmt::format("did you mean {}?", nearest)));
}

//! Row of a part, made at its first mention.
std::size_t part_row(Case& parsed, const std::string& name)
{
  auto& parts = parsed.bird.parts;
  for (std::size_t row = 0; row < parts.size(); ++row)
    if (parts[row].name == name)
      return row;
  parts.emplace_back();
  parts.back().name = name;
  return parts.size() - 1;
}

//! The same for a law.
std::size_t law_row(Case& parsed, const std::string& name, const std::string& place)
{
  auto& laws = parsed.laws;
  for (std::size_t row = 0; row < laws.size(); ++row)
    if (laws[row].name == name)
      return row;
  laws.emplace_back();
  laws.back().name = name;
  laws.back().place = place;
  return laws.size() - 1;
}

//! Row that the '*' of a key stands for; 0 if it has none.
std::size_t row_of(Case& parsed, const Key& key, const Entry& entry)
{
  if (key.path.find('*') == std::string_view::npos)
    return 0;
  return entry.path[0] == "eos" ? law_row(parsed, entry.path[1], entry.place)
                                : part_row(parsed, entry.path[2]);
}

//! "[run]" with nothing below it: the keys that it lacks are complained about one by one.
bool is_empty_section(const Entry& entry)
{
  const std::string prefix = join(entry.path) + ".";
  return entry.is_table && std::any_of(case_keys().begin(), case_keys().end(),
                                       [&](const Key& key) { return key.path.starts_with(prefix); });
}

bool is_part_table(const Entry& entry)
{
  return entry.is_table && entry.path.size() == 3 && entry.path[0] == "bird" && entry.path[1] == "parts";
}

bool is_law_table(const Entry& entry)
{
  return entry.is_table && entry.path.size() == 2 && entry.path[0] == "eos";
}

std::string place_of(const std::map<std::string, std::string>& places, const std::string& path,
                     const std::string& file)
{
  const auto found = places.find(path);
  return found == places.end() ? file : found->second;
}

//! Names of laws exist and are nobody else's, and every part has the porosity that its law needs.
//! \param places  of the keys that were given
void check_part_laws(const Case& parsed, const std::map<std::string, std::string>& places)
{
  const std::string file = parsed.file.string();
  const Key& eos = *find_key({"bird", "parts", "*", "eos"});
  const Key& porosity = *find_key({"bird", "parts", "*", "porosity"});
  const std::vector<std::string> porous = eos.choices();
  for (const LawCase& law : parsed.laws)
    if (std::find(porous.begin(), porous.end(), law.name) != porous.end())
      throw InputError(fmt::format("{}: eos.{}: this name is taken by a law of porous flesh; choose another",
                                   law.place, law.name));
  for (const PartCase& part : parsed.bird.parts) {
    const std::string path = "bird.parts." + part.name;
    if (std::any_of(parsed.laws.begin(), parsed.laws.end(),
                    [&](const LawCase& law) { return law.name == part.eos; }))
    {
      if (part.porosity != 0)
        throw InputError(fmt::format("{}: {}.porosity = {}: the law \"{}\" has none; leave the porosity out",
                                     place_of(places, path + ".porosity", file), path, part.porosity,
                                     part.eos));
    } else if (std::find(porous.begin(), porous.end(), part.eos) == porous.end()) {
      std::string own;
      for (const LawCase& law : parsed.laws)
        own += fmt::format(", \"{}\"", law.name);
      throw InputError(fmt::format("{}: {}.eos = {}: {} is needed{}", place_of(places, path + ".eos", file),
                                   path, toml_string(part.eos), kind_of(eos),
                                   own.empty() ? "; the case has none" : "; the case has " + own.substr(2)));
    } else if (!places.contains(path + ".porosity")) {
      throw InputError(fmt::format("{}: {}.porosity is missing: {} is needed ({})", file, path,
                                   kind_of(porosity), porosity.text));
    }
  }
}

//! Where the paths with '*' and those without are given, all required ones have to be.
void require_keys(Case& parsed, const std::set<std::string>& given, const std::string& file)
{
  const auto check = [&](const Key& key, const std::string& path) {
    if (!key.required || given.contains(path))
      return;
    std::string kind = kind_of(key);
    throw InputError(fmt::format("{}: {} is missing: {} is needed ({})", file, path, kind, key.text));
  };
  for (const Key& key : case_keys()) {
    const std::size_t star = key.path.find('*');
    if (star == std::string_view::npos) {
      check(key, std::string(key.path));
      continue;
    }
    const auto check_named = [&](const std::string& name) {
      check(key, std::string(key.path.substr(0, star)) + name + std::string(key.path.substr(star + 1)));
    };
    if (key.path.starts_with("eos."))
      for (const LawCase& law : parsed.laws)
        check_named(law.name);
    else
      for (const PartCase& part : parsed.bird.parts)
        check_named(part.name);
  }
}

} // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  std::vector<Entry> entries = read_entries(file);
  for (const std::string& text : overrides)
    apply_override(entries, parse_override(text));

  Case parsed;
  parsed.file = file;
  std::set<std::string> given;
  std::map<std::string, std::string> places;
  for (const Entry& entry : entries) {
    if (is_part_table(entry)) {
      part_row(parsed, entry.path[2]);
      continue;
    }
    if (is_law_table(entry)) {
      law_row(parsed, entry.path[1], entry.place);
      continue;
    }
    if (is_empty_section(entry))
      continue;
    const Key* key = find_key(entry.path);
    if (!key)
      unknown_key(entry);
    const std::size_t row = row_of(parsed, *key, entry);
    if (entry.is_table)
      throw InputError(fmt::format("{}: {} is an empty table: {} is needed", entry.place, join(entry.path),
                                   kind_of(*key)));
    std::visit(Assignment(entry, *key), key->slot(parsed, row));
    given.insert(join(entry.path));
    places[join(entry.path)] = entry.place;
    if (key->dimension != Dimension::number)
      parsed.written[join(entry.path)] = entry.found;
  }
  require_keys(parsed, given, file.string());
  check_part_laws(parsed, places);
  if (parsed.run.viscosity.kind == ViscosityKind::bulk) { // its own constants, where the case gives none
    if (!given.contains("run.viscosity_linear"))
      parsed.run.viscosity.linear = dissertation_viscosity.linear;
    if (!given.contains("run.viscosity_quadratic"))
      parsed.run.viscosity.quadratic = dissertation_viscosity.quadratic;
  }
  if (!parsed.target.rigid)
    throw InputError(
        fmt::format("{}: target.rigid = false: deformable targets are not available yet; allowed is true",
                    file.string()));
  if (parsed.bird.parts.empty())
    throw InputError(
        fmt::format("{}: bird.parts is missing: every part of the mesh needs its porosity, for example "
                    "torso = {{ porosity = 0.6 }} under [bird.parts]",
                    file.string()));
  return parsed;
}

} // namespace birdstrike
