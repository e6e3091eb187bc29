// SPDX-License-Identifier: GPL-3.0-or-later
// What names and shapes of objects tell of a bird's directions.
#include "geometry/import/axis_evidence.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>

namespace birdstrike {

namespace {

//! The words of a name in small letters: "LeftWing.001", "wing_L" -> left wing 001, wing l.
std::vector<std::string> words_of(const std::string& name)
{
  std::vector<std::string> words;
  bool in_word = false, was_small = false;
  for (const char sign : name) {
    const auto c = static_cast<unsigned char>(sign);
    if (!std::isalpha(c)) {
      in_word = was_small = false;
      continue;
    }
    if (!in_word || (was_small && std::isupper(c)))
      words.emplace_back();
    words.back() += char(std::tolower(c));
    in_word = true;
    was_small = std::islower(c);
  }
  return words;
}

//! Whether a word is, or a long word contains, one of the list.
bool names(const std::string& name, std::initializer_list<const char*> list)
{
  for (const std::string& word : words_of(name))
    for (const std::string key : list)
      if (word == key || (key.size() > 3 && word.find(key) != std::string::npos))
        return true;
  return false;
}

struct Group
{
  SurfaceMesh parts, rest;
  std::string first;
};
template <class Belongs>
Group group(const SurfaceMesh& all, Belongs belongs)
{
  Group group;
  for (const SurfacePart& part : all) {
    if (belongs(part.name) && group.parts.empty())
      group.first = "'" + part.name + "'";
    (belongs(part.name) ? group.parts : group.rest).push_back(part);
  }
  return group;
}

//! From one to the other, unless either is empty or both have the same middle.
std::optional<Vector3> from_to(const SurfaceMesh& from, const SurfaceMesh& to)
{
  const SurfaceSamples a = sample_surface(from), b = sample_surface(to);
  if (a.points.empty() || b.points.empty())
    return {};
  const Vector3 way = b.centre - a.centre;
  double spread = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    spread += a.weights[i] * (a.points[i] - a.centre).squaredNorm();
  if (way.squaredNorm() < 0.01 * spread)
    return {};
  return way.normalized();
}

} // namespace

AxisEvidence find_evidence(const SurfaceMesh& parts)
{
  AxisEvidence evidence;
  // Without wings, which may be swept any way.
  const Group body = group(parts, [](const auto& name) {
    return !names(name, {"wing", "wings", "feather"});
  });
  const Group front = group(body.parts, [](const auto& name) {
    return names(name, {"head", "beak", "bill", "skull", "neck"});
  });
  evidence.nose = from_to(front.rest, front.parts);
  evidence.nose_source = front.first;
  if (!evidence.nose) {
    const Group back = group(body.parts, [](const auto& name) { return names(name, {"tail", "rump"}); });
    evidence.nose = from_to(back.parts, back.rest);
    evidence.nose_source = "the far end from " + back.first;
  }
  const Group left = group(parts, [](const auto& name) { return names(name, {"left", "l"}); });
  const Group right = group(left.rest, [](const auto& name) { return names(name, {"right", "r"}); });
  evidence.left = from_to(right.parts, left.parts);
  const Group legs = group(body.parts, [](const auto& name) {
    return names(name, {"leg", "legs", "foot", "feet", "toe", "toes", "tarsus"});
  });
  evidence.down = from_to(legs.rest, legs.parts);
  return evidence;
}

double narrow_end(const SurfaceSamples& samples, const Vector3& along, const Vector3& left)
{
  constexpr double end_share = 0.15, much = 1.5;
  double low = INFINITY, high = -INFINITY;
  for (const Vector3& p : samples.points) {
    low = std::min(low, p.dot(along));
    high = std::max(high, p.dot(along));
  }
  double back = 0, front = 0; // half widths
  for (const Vector3& p : samples.points) {
    const double place = (p.dot(along) - low) / (high - low),
                 width = std::abs((p - samples.centre).dot(left));
    if (place < end_share)
      back = std::max(back, width);
    if (place > 1 - end_share)
      front = std::max(front, width);
  }
  return back > much * front ? 1 : front > much * back ? -1 : 0;
}

double wing_side(const SurfaceSamples& samples, const Vector3& high, const Vector3& left)
{
  constexpr double tip_share = 0.5, body_share = 0.15, clear = 0.05;
  double reach = 0, low = INFINITY, top = -INFINITY;
  for (const Vector3& p : samples.points)
    reach = std::max(reach, std::abs((p - samples.centre).dot(left)));
  double tips = 0, tips_weight = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const double width = std::abs((samples.points[i] - samples.centre).dot(left)),
                 height = samples.points[i].dot(high);
    if (width > tip_share * reach) {
      tips += samples.weights[i] * height;
      tips_weight += samples.weights[i];
    } else if (width < body_share * reach) {
      low = std::min(low, height);
      top = std::max(top, height);
    }
  }
  if (tips_weight <= 0 || !(top > low))
    return 0;
  const double above = (tips / tips_weight - 0.5 * (low + top)) / (top - low);
  return above > clear ? 1 : above < -clear ? -1 : 0;
}

} // namespace birdstrike
