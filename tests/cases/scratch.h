// SPDX-License-Identifier: GPL-3.0-or-later
// A folder to try things in, and the program run there as a user would.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace scratch {

//! A new folder that goes away with its owner.
struct Folder
{
  fs::path path;

  Folder()
  {
    std::string name = (fs::temp_directory_path() / "birdstrike-test-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw std::runtime_error("no temporary folder");
    path = name;
  }
  ~Folder()
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path write(const std::string& name, const std::string& text) const
  {
    fs::create_directories((path / name).parent_path());
    std::ofstream(path / name) << text;
    return path / name;
  }
};

inline std::string read(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Outcome
{
  int status;         //!< exit status, or -1 if it did not exit by itself
  std::string output; //!< screen and errors
};

//! Runs a command line of the shell in a folder.
inline Outcome shell(const fs::path& folder, const std::string& command)
{
  Outcome outcome{-1, ""};
  FILE* pipe = popen(("cd '" + folder.string() + "' && ( " + command + " ) 2>&1").c_str(), "r");
  if (!pipe)
    return outcome;
  std::array<char, 4096> buffer;
  for (std::size_t got; (got = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    outcome.output.append(buffer.data(), got);
  const int status = pclose(pipe);
  if (WIFEXITED(status))
    outcome.status = WEXITSTATUS(status);
  return outcome;
}

inline Outcome program(const fs::path& folder, const std::string& arguments)
{
  return shell(folder, std::string("'") + BIRDSTRIKE_PROGRAM + "' " + arguments);
}

//! The program, killed as soon as \p awaited is there; without it after a minute.
inline Outcome killed_program(const fs::path& folder, const std::string& arguments,
                              const std::string& awaited)
{
  return shell(folder, std::string("'") + BIRDSTRIKE_PROGRAM + "' " + arguments +
                           " & run=$!; for k in $(seq 600); do [ -f " + awaited +
                           " ] && break; sleep 0.1; done; kill -KILL $run; wait $run");
}

//! A closed box as an OBJ object; \p faces below 6 leaves it open, first_point counts the file's points.
inline std::string box(const std::string& name, double x, double y, double z, int faces = 6,
                       int first_point = 1)
{
  std::string text = "o " + name + "\n";
  for (int k = 0; k < 8; ++k)
    text += "v " + std::to_string(k & 1 ? x : -x) + " " + std::to_string(k & 2 ? y : -y) + " " +
            std::to_string(k & 4 ? z : -z) + "\n";
  constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                               {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (int f = 0; f < faces; ++f)
    for (const int corner : {1, 2}) {
      text += "f " + std::to_string(quads[f][0] + first_point) + " " +
              std::to_string(quads[f][corner] + first_point) + " " +
              std::to_string(quads[f][corner + 1] + first_point) + "\n";
    }
  return text;
}

//! A small sound case: a box of gelatine on a plate, over in a second.
inline const char* const box_case = R"(title = "box"
[bird]
mesh = "box.obj"
mass = "1.2 kg"
spacing = "10 mm"
velocity = "100 m/s"
[bird.parts]
torso = { porosity = 0.4 }
[target]
plate = { size = ["0.5 m", "0.4 m"], thickness = "5 mm", elements = [10, 8] }
[run]
end = "0.4 ms"
frames = 4
)";

} // namespace scratch
