// SPDX-License-Identifier: GPL-3.0-or-later
// Which columns of a run's tables stand together in a chart.
#include "cases/report_charts.h"

#include "vtkio/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

std::string hex(const Colour& colour)
{
  const auto byte = [](double part) { return static_cast<int>(std::lround(255 * part)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

//! "contact_force_x" -> "contact force x"
std::string spaced(std::string name)
{
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

ChartLine line_of(const History& table, std::size_t column, double factor, const std::string& name,
                  const std::string& colour)
{
  ChartLine line{name, colour, false, {}, {}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    line.x.push_back(1e3 * table.at(row, 0));
    line.y.push_back(factor * table.at(row, column));
  }
  return line;
}

bool is_flat_zero(const ChartLine& line)
{
  return std::all_of(line.y.begin(), line.y.end(), [](double y) { return y == 0 || std::isnan(y); });
}

class Charts
{
public:
  explicit Charts(const History& table) : table_(table) {}

  //! The columns that the test picks; those that are zero throughout are left out.
  template <class Test>
  std::vector<ChartLine> lines(double factor, Test picks, std::size_t cut = 0) const
  {
    std::vector<ChartLine> result;
    for (std::size_t c = 1; c < table_.columns.size(); ++c)
      if (picks(table_.columns[c].name)) {
        ChartLine line = line_of(table_, c, factor, spaced(table_.columns[c].name.substr(cut)),
                                 hex(line_colour(result.size())));
        if (!is_flat_zero(line))
          result.push_back(std::move(line));
      }
    return result;
  }

  void add(const std::string& title, const std::string& unit, const std::vector<ChartLine>& lines)
  {
    Json made = lines.empty() ? Json() : chart(title, unit, lines);
    if (!made.is_null())
      result.push_back(std::move(made));
  }

  Json result = Json::array();

private:
  const History& table_;
};

void add_pressure(Charts& charts)
{
  const std::string prefix = "max_pressure_";
  std::vector<ChartLine> lines = charts.lines(
      1e-6, [&](const std::string& name) { return name.starts_with(prefix); }, prefix.size());
  std::erase_if(lines, [](const ChartLine& line) { return line.name == "all"; }); // the largest of the others
  for (std::size_t part = 0; part < lines.size(); ++part)
    lines[part].colour = hex(part_colour(lines[part].name, part));
  charts.add("Largest pressure in the bird", "MPa", lines);
}

std::vector<ChartLine> along_axes(const Charts& charts, const std::string& prefix, double factor)
{
  std::vector<ChartLine> lines = charts.lines(
      factor, [&](const std::string& name) { return name.starts_with(prefix); }, prefix.size());
  for (ChartLine& line : lines)
    line.name = "along " + line.name;
  return lines;
}

std::vector<ChartLine> energies(const Charts& charts)
{
  const std::string suffix = " energy";
  std::vector<ChartLine> lines = charts.lines(
      1e-3, [](const std::string& name) { return name.ends_with("_energy") || name == "external_work"; });
  constexpr std::size_t colours = 8;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    lines[k].dashed = k >= colours; // the colours come again
    if (lines[k].name.ends_with(suffix))
      lines[k].name.resize(lines[k].name.size() - suffix.size());
  }
  return lines;
}

//! A straight line of theory over the time of the others.
void add_theory(std::vector<ChartLine>& lines, const Json& summary, const char* key, const char* name,
                std::size_t colour)
{
  if (const auto value = number_at(summary, {"theory", key}); value && !lines.empty() && !lines[0].x.empty())
    lines.push_back({name,
                     hex(line_colour(colour)),
                     true,
                     {lines[0].x.front(), lines[0].x.back()},
                     {1e-6 * *value, 1e-6 * *value}});
}

void add_transducers(Json& all, const ReportFolder& run)
{
  Charts charts(run.transducers);
  const std::string suffix = "_filtered";
  std::vector<ChartLine> lines =
      charts.lines(1e-6, [&](const std::string& name) { return name.ends_with(suffix); });
  for (ChartLine& line : lines)
    line.name.resize(line.name.size() - suffix.size());
  if (lines.empty())
    return;
  const std::size_t count = lines.size();
  add_theory(lines, run.summary, "hugoniot_pressure", "theory: plane shock", count);
  add_theory(lines, run.summary, "stagnation_standing_shock", "theory: stagnation", count + 1);
  charts.add("Transducers, filtered", "MPa", lines);
  for (Json& one : charts.result)
    all.push_back(std::move(one));
}

} // namespace

Json report_charts(const ReportFolder& run, std::vector<std::string>& replaced)
{
  Charts charts(run.history);
  const auto starts = [](const char* prefix) {
    return [prefix](const std::string& name) { return name.starts_with(prefix); };
  };
  add_pressure(charts);
  charts.add("Contact force on the target", "kN", along_axes(charts, "contact_force_", 1e-3));
  charts.add("Impulse on the target", "N s", along_axes(charts, "impulse_", 1));
  charts.add("Deflection of the target", "mm", charts.lines(1e3, [](const std::string& name) {
    return name == "max_deflection" || name.starts_with("deflection_");
  }));
  charts.add("Energies", "kJ", energies(charts));
  charts.add("Error of the energy balance", "%", charts.lines(100, starts("energy_balance_error")));
  charts.add("Elements eroded", "", charts.lines(1, starts("eroded_elements")));
  if (run.history.rows() > 1)
    replaced.insert(replaced.end(), {"maximum_pressure", "contact_force", "deflection"});
  const std::size_t before = charts.result.size();
  add_transducers(charts.result, run);
  if (charts.result.size() > before)
    replaced.emplace_back("transducers");
  return charts.result;
}

} // namespace birdstrike
