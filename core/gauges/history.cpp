// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/history.h"

namespace birdstrike {

std::size_t History::find(const std::string& name) const
{
  std::size_t column = 0;
  while (column < columns.size() && columns[column].name != name)
    ++column;
  return column;
}

} // namespace birdstrike
