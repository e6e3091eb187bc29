// SPDX-License-Identifier: GPL-3.0-or-later
// Screen and run.log, by spdlog.
#include "cases/log.h"

#include "core/error.h"

#include <fmt/format.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

namespace birdstrike {

struct Log::Sinks
{
  spdlog::logger screen{"screen", std::make_shared<spdlog::sinks::stdout_sink_mt>()};
  spdlog::logger errors{"errors", std::make_shared<spdlog::sinks::stderr_sink_mt>()};
  std::unique_ptr<spdlog::logger> file;
};

Log::Log(bool quiet) : quiet_(quiet), sinks_(std::make_unique<Sinks>())
{
  sinks_->screen.set_pattern("%v");
  sinks_->screen.flush_on(spdlog::level::info);
  sinks_->errors.set_pattern("%v");
}
Log::~Log() = default;

void Log::keep(int level, const std::string& line)
{
  if (sinks_->file)
    sinks_->file->log(static_cast<spdlog::level::level_enum>(level), "{}", line);
  else
    backlog_.emplace_back(level, line);
}

void Log::info(const std::string& line)
{
  if (!quiet_)
    sinks_->screen.info("{}", line);
  keep(spdlog::level::info, line);
}

void Log::warn(const std::string& line)
{
  if (warnings_)
    warnings_(line);
  else
    sinks_->errors.warn("birdstrike: warning: {}", line);
  keep(spdlog::level::warn, line);
}

void Log::file_only(const std::string& line) { keep(spdlog::level::info, line); }

void Log::open(const std::filesystem::path& file)
{
  try {
    sinks_->file = std::make_unique<spdlog::logger>(
        "file", std::make_shared<spdlog::sinks::basic_file_sink_mt>(file.string(), true));
  } catch (const spdlog::spdlog_ex& error) {
    throw OutputError(fmt::format("{}: cannot be written: {}", file.string(), error.what()));
  }
  sinks_->file->set_pattern("%Y-%m-%d %H:%M:%S.%e %-7l %v");
  sinks_->file->flush_on(spdlog::level::info);
  for (const auto& [level, line] : backlog_)
    sinks_->file->log(static_cast<spdlog::level::level_enum>(level), "{}", line);
  backlog_.clear();
}

} // namespace birdstrike
