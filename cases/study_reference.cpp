// SPDX-License-Identifier: GPL-3.0-or-later
// Published values from CSV files that name their source.
#include "cases/study_reference.h"

#include "cases/quantity.h"
#include "cases/share_folder.h"
#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <fstream>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

fs::path find_reference(const fs::path& study, const std::string& written)
{
  std::error_code ignored;
  std::vector<fs::path> places{study.parent_path() / written};
  if (const fs::path share = share_folder(); !share.empty())
    places.push_back(share / "reference" / written);
  std::vector<std::string> names;
  for (const fs::path& place : places) {
    if (fs::is_regular_file(place, ignored))
      return place;
    names.push_back(place.string());
  }
  throw InputError(fmt::format("no such reference file; looked for {}", fmt::join(names, " and ")));
}

std::string trimmed(std::string text)
{
  const char* blank = " \t\r";
  const std::size_t from = text.find_first_not_of(blank), to = text.find_last_not_of(blank);
  return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

//! The two cells of a line.
std::array<std::string, 2> cells(const std::string& line, const std::string& place)
{
  const std::size_t comma = line.find(',');
  require(comma != std::string::npos && line.find(',', comma + 1) == std::string::npos,
          fmt::format("{}: two values with a comma between them are needed; found: {}", place, line));
  return {trimmed(line.substr(0, comma)), trimmed(line.substr(comma + 1))};
}

//! "MPa" of "pressure[MPa]"; "1" of "count[-]".
std::string unit_of(const std::string& title, const std::string& place)
{
  const std::size_t open = title.find('[');
  require(open != std::string::npos && title.ends_with(']'),
          fmt::format("{}: the title \"{}\" lacks its unit, for example pressure[MPa]", place, title));
  const std::string unit = title.substr(open + 1, title.size() - open - 2);
  return unit == "-" ? "1" : unit;
}

double number(const std::string& text, const std::string& place)
{
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  require(error == std::errc() && end == text.data() + text.size() && value - value == 0,
          fmt::format("{}: \"{}\" is not a number", place, text));
  return value;
}

} // namespace

Reference read_reference(const fs::path& study, const std::string& written, const std::string& x_unit,
                         const std::string& y_unit)
{
  Reference result;
  result.file = find_reference(study, written);
  const std::array wanted{x_unit.empty() ? std::string("1") : x_unit, y_unit.empty() ? "1" : y_unit};
  std::array<std::string, 2> units;
  std::ifstream in(result.file);
  int count = 0;
  for (std::string line; std::getline(in, line);) {
    const std::string place = fmt::format("{}:{}", result.file.string(), ++count);
    line = trimmed(line);
    if (line.empty())
      continue;
    if (line.front() == '#') {
      const std::string remark = trimmed(line.substr(1));
      if (remark.starts_with("name:"))
        result.name = trimmed(remark.substr(5));
      if (remark.starts_with("source:"))
        result.source = trimmed(remark.substr(7));
      continue;
    }
    const std::array<std::string, 2> both = cells(line, place);
    if (units[0].empty()) {
      for (int k = 0; k < 2; ++k) {
        units[k] = unit_of(both[k], place);
        require(same_kind(units[k], wanted[k]),
                fmt::format("{}: \"{}\" cannot be shown in {}", place, both[k], wanted[k]));
      }
      continue;
    }
    result.x.push_back(from_si(to_si(number(both[0], place), units[0]), wanted[0]));
    result.y.push_back(from_si(to_si(number(both[1], place), units[1]), wanted[1]));
  }
  const std::string file = result.file.string();
  require(
      !result.name.empty() && !result.source.empty(),
      fmt::format("{}: lines \"# name: ...\" and \"# source: ...\" are needed: values without a source are "
                  "not shown",
                  file));
  require(!result.x.empty(), fmt::format("{}: there are no values", file));
  return result;
}

} // namespace birdstrike
