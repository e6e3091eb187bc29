// SPDX-License-Identifier: GPL-3.0-or-later
// The repair of one part in words.
#include "geometry/repair/describe.h"

#include "geometry/repair/repair.h"

#include <cmath>
#include <cstdio>

namespace birdstrike {

namespace {

std::string number(double value, const char* unit)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.3g %s", value, unit);
  return text;
}

std::string size_text(const SurfaceReport& r)
{
  const Vector3 size = r.upper - r.lower;
  return length_text(size.x()) + " x " + length_text(size.y()) + " x " + length_text(size.z());
}

std::string faults(const SurfaceReport& r)
{
  std::string text;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0)
      text += (text.empty() ? "" : ", ") + count_text(count, one, many);
  };
  add(r.doubled_points, "double point", "double points");
  add(r.degenerate_faces, "face without area", "faces without area");
  add(r.duplicate_faces, "doubled face", "doubled faces");
  add(r.open_edges, "open edge", "open edges");
  add(r.t_junctions, "T-junction", "T-junctions");
  add(r.crowded_edges, "edge with more than two faces", "edges with more than two faces");
  add(r.mixed_edges, "edge between faces wound opposite ways", "edges between faces wound opposite ways");
  if (r.self_intersections > 0) {
    text += text.empty() ? "" : ", ";
    text += r.more_self_intersections ? "at least " : "";
    text += count_text(r.self_intersections, "pair of faces that cut each other",
                       "pairs of faces that cut each other");
  }
  return !text.empty()  ? text
         : r.oriented   ? "sound"
         : r.volume < 0 ? "inside out"
                        : "a piece is inside out, or looks outwards inside another";
}

} // namespace

std::string length_text(double length)
{
  const double size = std::abs(length);
  return size == 0     ? "0"
         : size < 1e-3 ? number(length * 1e6, "um")
         : size < 1    ? number(length * 1e3, "mm")
         : size < 1000 ? number(length, "m")
                       : number(length / 1000, "km");
}

std::string count_text(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string describe(const PartRepair& repair)
{
  const SurfaceReport &before = repair.before, &after = repair.after;
  std::string text = "part '" + before.name + "': " + count_text(before.triangles, "triangle", "triangles") +
                     ", " + count_text(before.components, "piece", "pieces") + ", " + size_text(before) +
                     ": " + faults(before) + "\n";
  for (const std::string& action : repair.actions)
    text += "  " + action + "\n";
  for (const std::string& note : repair.notes)
    text += "  " + note + "\n";
  if (!repair.actions.empty()) {
    text += "  now " + count_text(after.triangles, "triangle", "triangles") + ", closed, volume " +
            number(after.volume * 1e6, "cm3");
    if (before.volume != 0)
      text += " (was " + number(before.volume * 1e6, "cm3") + ")";
    text += repair.largest_move > 0 ? "; the surface moved by at most " + length_text(repair.largest_move) +
                                          ", " + length_text(repair.mean_move) + " on average\n"
                                    : "; the surface stayed where it was\n";
  }
  return text;
}

} // namespace birdstrike
