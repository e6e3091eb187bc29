// SPDX-License-Identifier: GPL-3.0-or-later
// The part that an object of a CAD file belongs to, by its name.
#include "geometry/fill.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace birdstrike {

namespace {

struct Pattern
{
  std::string_view word, part;
  bool at_start; //!< only where a word starts, for short patterns that hide in others ("distribution")
};

// The first that fits wins: a wing_bone is a bone, a body_wing a wing.
constexpr std::array patterns{
    Pattern{"bone", "bones", false},  Pattern{"spine", "bones", false},   Pattern{"keel", "bones", false},
    Pattern{"rib", "bones", true},    Pattern{"sternum", "bones", false}, Pattern{"skeleton", "bones", false},
    Pattern{"lung", "lungs", false},  Pattern{"wing", "wings", false},    Pattern{"head", "head", false},
    Pattern{"beak", "head", false},   Pattern{"bill", "head", false},     Pattern{"skull", "head", false},
    Pattern{"neck", "neck", false},   Pattern{"torso", "torso", false},   Pattern{"body", "torso", false},
    Pattern{"trunk", "torso", false}, Pattern{"leg", "bones", true},
};

// Words start after anything that is no letter, and at a capital after a small letter (LeftRib).
bool starts_word(std::string_view name, std::size_t at)
{
  if (at == 0)
    return true;
  const unsigned char before = name[at - 1], here = name[at];
  return !std::isalpha(before) || (std::islower(before) && std::isupper(here));
}

} // namespace

std::string part_of_object(const std::string& object_name)
{
  std::string lower = object_name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for (const Pattern& p : patterns)
    for (auto at = lower.find(p.word); at != std::string::npos; at = lower.find(p.word, at + 1))
      if (!p.at_start || starts_word(object_name, at))
        return std::string(p.part);
  throw InputError(
      "object '" + object_name +
      "' of the mesh belongs to no known part of a bird; rename it so that it contains head, beak, bill "
      "or skull (head), neck, torso, body or trunk (torso), wing (wings), bone, spine, keel, rib, sternum, "
      "skeleton or leg (bones), or lung (lungs)");
}

} // namespace birdstrike
