// SPDX-License-Identifier: GPL-3.0-or-later
// Cases with targets, and the messages of those that are wrong.
#pragma once

#include "core/error.h"
#include "scratch.h"

#include "cases/case.h"

#include <functional>

namespace target_cases {

//! A small bird of one part; a target is to follow.
inline const char* const bird = R"(title = "test"
[bird]
shape = "sphere"
mass = "0.06 kg"
spacing = "8 mm"
velocity = "120 m/s"
[bird.parts]
body = { porosity = 0.1 }
[run]
end = "0.3 ms"
frames = 3
)";

inline const char* const plate = R"([target]
plate = { size = ["0.2 m", "0.3 m"], thickness = "2 mm", elements = [4, 6] }
)";

//! A plate that bends.
inline std::string soft_plate(const std::string& more = "")
{
  return std::string(plate) + "rigid = false\nmaterial = \"al-2024-t3\"\n" + more;
}

//! Any other shape; \p table is the rest of [target].
inline std::string shape(const std::string& name, const std::string& table = "")
{
  return "[target]\nshape = \"" + name + "\"\n" + table;
}

inline birdstrike::Case read(const scratch::Folder& folder, const std::string& target)
{
  return birdstrike::read_case(folder.write("case.toml", bird + target));
}

//! What \p action throws as InputError, without the folder's name; "" if it does not.
inline std::string complaint(const scratch::Folder& folder, const std::function<void()>& action)
{
  try {
    action();
  } catch (const birdstrike::InputError& error) {
    std::string message = error.what();
    const std::string prefix = folder.path.string() + "/";
    for (std::size_t at; (at = message.find(prefix)) != std::string::npos;)
      message.erase(at, prefix.size());
    return message;
  }
  return "";
}

} // namespace target_cases
