// SPDX-License-Identifier: GPL-3.0-or-later
// A growing CSV file.
#include "cases/history_file.h"

#include "core/error.h"
#include "core/gauges/history.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <iterator>

namespace birdstrike {

HistoryFile::HistoryFile(std::filesystem::path file) : file_(std::move(file)), out_(file_, std::ios::binary)
{
  if (!out_)
    throw OutputError(fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
}

void HistoryFile::append(const History& history)
{
  fmt::memory_buffer text;
  const std::size_t columns = history.columns.size();
  if (!titled_)
    for (std::size_t c = 0; c < columns; ++c)
      fmt::format_to(std::back_inserter(text), "{}[{}]{}", history.columns[c].name, history.columns[c].unit,
                     c + 1 < columns ? ',' : '\n');
  titled_ = true;
  for (; rows_ < history.rows(); ++rows_)
    for (std::size_t c = 0; c < columns; ++c)
      fmt::format_to(std::back_inserter(text), "{}{}", history.at(rows_, c), c + 1 < columns ? ',' : '\n');
  out_.write(text.data(), static_cast<std::streamsize>(text.size()));
}

void HistoryFile::flush()
{
  if (!out_.flush())
    throw OutputError(fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
}

} // namespace birdstrike
