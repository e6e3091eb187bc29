// SPDX-License-Identifier: GPL-3.0-or-later
// A small sound study of scratch.h's box.
#pragma once

#include <string>

namespace scratch {

inline const char* const box_study = R"(title = "boxes"
base = "case.toml"
collect = [
  { path = "peak_pressure.torso.value", name = "peak", unit = "MPa" },
  { path = "theory.torso.hugoniot_pressure", name = "plane shock", unit = "MPa" },
  { path = "impulse", name = "impulse", unit = "N s" },
]
[set]
bird.spacing = "25 mm"
run.end = "0.2 ms"
run.frames = 1
[[sweep]]
label = "speed"
key = "bird.velocity"
values = ["100 m/s", "200 m/s"]
[[sweep]]
label = "body"
set = [
  { label = "soft", bird.parts.torso.porosity = 0.4 },
  { label = "hard", "bird.parts.torso.porosity" = 0.1 },
]
[[plot]]
file = "peak.png"
x = "bird.velocity"
x_unit = "m/s"
y = "peak"
theory = "plane shock"
)";

//! The text with the first \p from replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  return at == std::string::npos ? "the test looks for what is not there: " + from
                                 : text.replace(at, from.size(), to);
}

} // namespace scratch
