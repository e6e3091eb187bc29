// SPDX-License-Identifier: BSD-3-Clause
// Numbers sampled at every time step, as a table that knows its titles and units.
#pragma once

#include <string>
#include <vector>

namespace birdstrike {

struct HistoryColumn
{
  std::string name; //!< lower_snake_case, for example max_pressure_torso
  std::string unit; //!< SI, "-" when it has none
};

//! Row-major table; column 0 is the time [s].
struct History
{
  std::vector<HistoryColumn> columns;
  std::vector<double> values; //!< rows() x columns.size()

  std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
  double at(std::size_t row, std::size_t column) const { return values[row * columns.size() + column]; }
  //! Column of that name, or columns.size() if there is none.
  std::size_t find(const std::string& name) const;
};

//! Mean of a column over \p from <= time <= \p to [s], values between rows on straight lines. NaN where the interval is
//! empty or the table does not cover it.
double time_mean(const History& history, std::size_t column, double from, double to);

} // namespace birdstrike
