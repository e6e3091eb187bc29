// SPDX-License-Identifier: GPL-3.0-or-later
// histories.csv and its kin, read back.
#include "cases/history_table.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

HistoryColumn column_of(const std::string& title)
{
  const std::size_t bracket = title.find('[');
  if (bracket == std::string::npos)
    return {title, "-"};
  require(title.ends_with(']'), fmt::format("the column title \"{}\" has no unit in brackets", title));
  return {title.substr(0, bracket), title.substr(bracket + 1, title.size() - bracket - 2)};
}

//! Numbers of a line up to the first cell that is none.
std::vector<double> numbers_in(const std::string& line)
{
  std::vector<double> values;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    double value = std::numeric_limits<double>::quiet_NaN();
    if (end > at) {
      const auto [next, error] = std::from_chars(line.data() + at, line.data() + end, value);
      if (error != std::errc() || next != line.data() + end)
        break;
    }
    values.push_back(value);
    at = end + 1;
  }
  return values;
}

} // namespace

History read_history_table(const fs::path& csv)
{
  std::ifstream in(csv, std::ios::binary);
  std::string line;
  require(in && std::getline(in, line), "it cannot be read, or is empty");
  History table;
  std::istringstream titles(line);
  for (std::string title; std::getline(titles, title, ',');)
    table.columns.push_back(column_of(title));
  require(!table.columns.empty() && table.columns[0].name == "time", "its first column is not the time");
  for (std::size_t row = 2; std::getline(in, line); ++row) {
    const std::vector<double> values = numbers_in(line);
    const bool cut_off = in.eof(); // without its end a line may be half a number
    const bool last = cut_off || in.peek() == std::ifstream::traits_type::eof();
    if (values.size() != table.columns.size() || cut_off) {
      require(last, fmt::format("row {} has not {} numbers", row, table.columns.size()));
      break;
    }
    table.values.insert(table.values.end(), values.begin(), values.end());
  }
  return table;
}

HistoryValues read_history_column(const fs::path& csv, const std::string& column)
{
  History table;
  try {
    table = read_history_table(csv);
  } catch (const InputError& error) {
    throw OutputError(
        fmt::format("{}: {}; delete this run's folder and run it again", csv.string(), error.what()));
  }
  const std::size_t wanted = table.find(column);
  if (wanted >= table.columns.size()) {
    std::string names;
    for (std::size_t k = 1; k < table.columns.size(); ++k)
      names += (names.empty() ? "" : ", ") + table.columns[k].name;
    throw OutputError(fmt::format("{} has no column \"{}\"; it has {}", csv.string(), column, names));
  }
  HistoryValues result{table.columns[wanted].unit, {}, {}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    result.time.push_back(table.at(row, 0));
    result.values.push_back(table.at(row, wanted));
  }
  return result;
}

} // namespace birdstrike
