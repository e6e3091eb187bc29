// SPDX-License-Identifier: GPL-3.0-or-later
// The progress bar.
#include "cases/progress.h"

#include "core/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sys/ioctl.h>
#include <unistd.h>

namespace birdstrike {
namespace {

std::string clock_text(double seconds)
{
  const long whole = static_cast<long>(seconds + 0.5);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

int terminal_width()
{
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

} // namespace

Progress::Progress(Log& log) : log_(log), terminal_(!log.quiet() && isatty(STDOUT_FILENO)) {}

std::string Progress::line(const Simulation& simulation) const
{
  const double done = simulation.time() / simulation.settings().end_time;
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = done > 0 ? elapsed * (1 - done) / done : 0;
  return fmt::format("{:3.0f} %  {:.3f} of {:.3f} ms  {} steps  dt {:.2f} us ({})  {} left", 100 * done,
                     1e3 * simulation.time(), 1e3 * simulation.settings().end_time, simulation.steps(),
                     1e6 * simulation.time_step().size, simulation.time_step().limit, clock_text(left));
}

void Progress::update(const Simulation& simulation)
{
  // The small addition keeps rounding of the end time from hiding the last tenth.
  const double done = simulation.time() / simulation.settings().end_time;
  if (const int tenths = static_cast<int>(10 * done + 1e-9); tenths > tenths_) {
    tenths_ = tenths;
    terminal_ ? log_.file_only(line(simulation)) : log_.info(line(simulation));
  }
  if (!terminal_ || (Clock::now() - last_ < std::chrono::milliseconds(100) && done < 1))
    return;
  last_ = Clock::now();
  drawn_ = true;
  // A line that wraps could not be drawn over: the bar gives way first, then the end of the text.
  const int room = terminal_width() - 1;
  const std::string text = line(simulation);
  const int width = std::min(24, room - static_cast<int>(text.size()) - 3);
  std::string drawn = text.substr(0, static_cast<std::size_t>(room));
  if (width >= 4) {
    const int full = std::clamp(static_cast<int>(width * done + 0.5), 0, width);
    drawn = fmt::format("[{}{}] {}", std::string(full, '#'), std::string(width - full, '.'), text);
  }
  std::fprintf(stdout, "\r%s\033[K", drawn.c_str());
  std::fflush(stdout);
}

void Progress::finish()
{
  if (drawn_)
    std::fputc('\n', stdout);
  std::fflush(stdout);
  drawn_ = false;
}

} // namespace birdstrike
