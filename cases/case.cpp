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
      if (std::find(choices.begin(), choices.end(), result) == choices.end())
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
    for (const PartCase& part : parsed.bird.parts)
      check(key, std::string(key.path.substr(0, star)) + part.name + std::string(key.path.substr(star + 1)));
  }
}

} // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  std::vector<Entry> entries;
  for (const std::string& text : overrides)
    entries.push_back(parse_override(text));
  return read_case_with(file, entries);
}

Case read_case_with(const std::filesystem::path& file, const std::vector<Entry>& overrides)
{
  std::vector<Entry> entries = read_entries(file);
  if (is_study(entries))
    throw InputError(
        fmt::format("{0}: this is a study, a set of runs: `birdstrike study {0}` runs it", file.string()));
  for (const Entry& entry : overrides)
    apply_override(entries, entry);

  Case parsed;
  parsed.file = file;
  std::set<std::string> given;
  for (const Entry& entry : entries) {
    if (is_part_table(entry)) {
      part_row(parsed, entry.path[2]);
      continue;
    }
    if (is_empty_section(entry))
      continue;
    const Key* key = find_key(entry.path);
    if (!key)
      unknown_key(entry);
    const std::size_t part =
        key->path.find('*') == std::string_view::npos ? 0 : part_row(parsed, entry.path[2]);
    if (entry.is_table)
      throw InputError(fmt::format("{}: {} is an empty table: {} is needed", entry.place, join(entry.path),
                                   kind_of(*key)));
    std::visit(Assignment(entry, *key), key->slot(parsed, part));
    given.insert(join(entry.path));
    if (key->dimension != Dimension::number)
      parsed.written[join(entry.path)] = entry.found;
  }
  require_keys(parsed, given, file.string());
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
