// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/law_table.h"

#include "cases/quantity.h"
#include "core/error.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <optional>
#include <string>

namespace birdstrike {
namespace {

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blank = " \t\r\"";
  const std::size_t from = text.find_first_not_of(blank);
  return from == std::string_view::npos ? std::string_view()
                                        : text.substr(from, text.find_last_not_of(blank) - from + 1);
}

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    cells.emplace_back(trimmed(std::string_view(line).substr(from, to - from)));
    from = to + 1;
  }
  return cells;
}

struct Column
{
  std::string_view name;
  Dimension dimension;
  std::string unit{};
  std::optional<std::size_t> place{};

  //! Is the title this column's? Then remember where it stands and in which unit.
  void recognise(const std::string& title, std::size_t at, const std::string& line_place)
  {
    const std::size_t open = title.find('['), close = title.rfind(']');
    if (trimmed(title.substr(0, open)) != name)
      return;
    if (open == std::string::npos || close == std::string::npos || close < open)
      throw InputError(fmt::format("{}: column \"{}\": its unit is missing, for example \"{} [{}]\"",
                                   line_place, title, name, si_unit(dimension)));
    place = at;
    unit = title.substr(open + 1, close - open - 1);
    try {
      parse_quantity("1 " + unit, dimension);
    } catch (const InputError&) {
      throw InputError(fmt::format("{}: column \"{}\": \"{}\" is not a unit of {}; \"{}\" is one", line_place,
                                   title, unit, name, si_unit(dimension)));
    }
  }

  double value(const std::vector<std::string>& cells, const std::string& line_place) const
  {
    const std::string text = *place < cells.size() ? cells[*place] : "";
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !(number - number == 0))
      throw InputError(fmt::format("{}: {} \"{}\": a number is needed", line_place, name, text));
    return parse_quantity(fmt::format("{} {}", number, unit), dimension);
  }
};

//! \param before  values of the rows before
void check_row(const Column& column, double value, const std::vector<double>& before,
               const std::string& place)
{
  if (!before.empty() && !(value > before.back()))
    throw InputError(fmt::format("{}: {} must rise from row to row; {:.10g} {} comes after {:.10g}", place,
                                 column.name, value, si_unit(column.dimension), before.back()));
}

} // namespace

LawTable read_law_table(const std::filesystem::path& file)
{
  std::error_code ignored;
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file, ignored))
    throw InputError(fmt::format("{}: no such file, or it cannot be read; a table of density and pressure is "
                                 "needed (.csv)",
                                 file.string()));
  LawTable table;
  Column density{"density", Dimension::density}, pressure{"pressure", Dimension::pressure};
  bool titled = false;
  int line_number = 0;
  for (std::string line; std::getline(in, line);) {
    const std::string place = fmt::format("{}:{}", file.string(), ++line_number);
    if (line_number == 1 && line.starts_with("\xEF\xBB\xBF"))
      line.erase(0, 3); // some spreadsheets mark UTF-8 so
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#')
      continue;
    const std::vector<std::string> cells = cells_of(line);
    if (!titled) {
      for (std::size_t k = 0; k < cells.size(); ++k) {
        density.recognise(cells[k], k, place);
        pressure.recognise(cells[k], k, place);
      }
      if (!density.place || !pressure.place)
        throw InputError(fmt::format(
            "{}: the title line needs the columns \"density [kg/m3]\" and \"pressure [Pa]\"; found is \"{}\"",
            place, text));
      titled = true;
      continue;
    }
    const double rho = density.value(cells, place), p = pressure.value(cells, place);
    check_row(density, rho, table.density, place);
    check_row(pressure, p, table.pressure, place);
    if (table.density.empty() && (!(rho > 0) || p != 0))
      throw InputError(fmt::format("{}: the first row is the undisturbed material: its density must be "
                                   "positive and its pressure 0; found "
                                   "are {:.10g} kg/m3 and {:.10g} Pa",
                                   place, rho, p));
    table.density.push_back(rho);
    table.pressure.push_back(p);
  }
  if (table.density.size() < 4)
    throw InputError(fmt::format("{}:{}: a table needs at least 4 rows of density and pressure, and has {}",
                                 file.string(), line_number, table.density.size()));
  return table;
}

} // namespace birdstrike
