// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/complete_target.h"

#include "cases/column.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace birdstrike {

std::vector<std::string> support_kinds()
{
  return {"clamped", "simply-supported", "symmetry-x", "symmetry-y", "symmetry-z"};
}

std::array<bool, 6> held_components(const std::string& fix)
{
  if (fix == "clamped")
    return {true, true, true, true, true, true};
  if (fix == "simply-supported")
    return {true, true, true, false, false, false};
  if (fix.starts_with("symmetry-") && fix.size() == 10 && fix.back() >= 'x' && fix.back() <= 'z') {
    const auto normal = static_cast<std::size_t>(fix.back() - 'x');
    std::array<bool, 6> held{false, false, false, true, true, true};
    held[normal] = true;
    held[3 + normal] = false;
    return held;
  }
  static constexpr std::array<std::string_view, 6> names{"x", "y", "z", "rx", "ry", "rz"};
  std::array<bool, 6> held{};
  std::istringstream words(fix);
  bool any = false;
  for (std::string word; words >> word; any = true) {
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) {
      any = false;
      break;
    }
    held[static_cast<std::size_t>(found - names.begin())] = true;
  }
  if (!any)
    throw InputError(
        fmt::format("one of {}, or components out of x y z rx ry rz is needed, for example \"x z ry\"",
                    fmt::join(support_kinds(), ", ")));
  return held;
}

namespace {

//! Their names become titles in histories.csv.
void check_deflections(const Case& parsed)
{
  for (const DeflectionCase& row : parsed.deflections)
    if (row.name.find_first_of(",\"\n\r") != std::string::npos)
      throw InputError(
          fmt::format("{}: deflections.{}: the name must do for a title in histories.csv: no comma, "
                      "quote or line break",
                      parsed.file.string(), row.name));
}

void check_supports(const Case& parsed)
{
  const std::string file = parsed.file.string();
  for (const SupportCase& support : parsed.target.supports) {
    const std::string place = fmt::format("{}: target.supports.{}", file, support.name);
    const bool low = !std::isnan(support.low[0]), high = !std::isnan(support.high[0]);
    if (support.nodes.empty() && !low && !high)
      throw InputError(
          place +
          ": which nodes? Give nodes, the name of a node set, or the box low, high; where nothing holds the "
          "target, target.free = true");
    if (low != high)
      throw InputError(place + ": a box needs both corners, low and high");
    for (std::size_t k = 0; low && k < 3; ++k)
      if (support.low[k] > support.high[k])
        throw InputError(fmt::format("{}: low = {:g} m lies above high = {:g} m along {}", place,
                                     support.low[k], support.high[k], "xyz"[k]));
    try {
      held_components(support.fix);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}.fix = \"{}\": {}", place, support.fix, error.what()));
    }
  }
}

} // namespace

void complete_target(Case& parsed, bool contact_given)
{
  TargetCase& target = parsed.target;
  const std::string file = parsed.file.string();
  if (is_column(parsed))
    return;
  if (!contact_given && (target.shape != "plate" || !target.rigid))
    target.contact = "penalty";
  if (target.rigid)
    return;
  if (target.material.empty() &&
      std::none_of(target.parts.begin(), target.parts.end(),
                   [](const TargetPartCase& part) { return !part.material.empty(); }))
    throw InputError(
        fmt::format("{}: target.material is missing: a target that is not rigid needs one, for example "
                    "\"al-2024-t3\"",
                    file));
  if (target.spin != 0 && target.spin_axis == std::array<double, 3>{})
    throw InputError(fmt::format("{}: target.spin_axis = [0, 0, 0] is no direction", file));
  if (target.free && !target.supports.empty())
    throw InputError(
        fmt::format("{}: target.supports.{} holds a target that target.free = true lets go; leave one "
                    "of them out",
                    file, target.supports.front().name));
  if (target.free && target.spin != 0)
    throw InputError(
        fmt::format("{}: target.spin: a free target has no centrifugal pre-stress in balance; give it "
                    "target.supports instead of target.free",
                    file));
  if (!target.free && target.supports.empty()) {
    const auto clamp = [&target](const char* set) {
      SupportCase& row = target.supports.emplace_back();
      row.name = row.nodes = set;
    };
    if (target.shape == "plate" || target.shape == "windshield")
      clamp("edges");
    else if (target.shape == "leading-edge")
      clamp("spar"), clamp("ribs");
    else if (target.shape == "blade")
      clamp("root");
    else
      throw InputError(fmt::format(
          "{}: target.supports is missing: say what holds the mesh, for example supports.rim = {{ nodes = "
          "\"boundary\" }} under [target], or free = true if nothing does",
          file));
  }
  check_supports(parsed);
  check_deflections(parsed);
}

} // namespace birdstrike
