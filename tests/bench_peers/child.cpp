// SPDX-License-Identifier: GPL-3.0-or-later
#include "child.h"

#include "core/error.h"

#include <array>
#include <cstdio>
#include <sstream>

#include <sys/wait.h>

namespace birdstrike::peers {

namespace {

std::string quoted(const std::string& text)
{
  std::string shell = "'";
  for (const char c : text)
    shell += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return shell + "'";
}

} // namespace

Finished run_program(const std::vector<std::string>& arguments, int threads)
{
  std::string command = "exec env OMP_NUM_THREADS=" + std::to_string(threads);
  for (const std::string& argument : arguments)
    command += " " + quoted(argument);
  command += " 2>&1 </dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe)
    throw RunError("cannot start " + arguments.front());
  Finished finished{0, ""};
  std::array<char, 4096> buffer;
  for (std::size_t read; (read = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    finished.output.append(buffer.data(), read);
  const int status = pclose(pipe);
  finished.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return finished;
}

std::string last_line(const std::string& output)
{
  std::istringstream lines(output);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      last = line;
  return last;
}

} // namespace birdstrike::peers
