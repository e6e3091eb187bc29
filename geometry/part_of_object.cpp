// SPDX-License-Identifier: GPL-3.0-or-later
// The part that an object of a CAD file belongs to, by its name.
#include "geometry/part_of_object.h"

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
    Pattern{"trunk", "torso", false}, Pattern{"tail", "torso", true},     Pattern{"leg", "legs", true},
    Pattern{"foot", "legs", true},    Pattern{"feet", "legs", true},      Pattern{"tarsus", "legs", true},
};

// Words start after anything that is no letter, and at a capital after a small letter (LeftRib).
bool starts_word(std::string_view name, std::size_t at)
{
  if (at == 0)
    return true;
  const unsigned char before = name[at - 1], here = name[at];
  return !std::isalpha(before) || (std::islower(before) && std::isupper(here));
}

std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

//! Does all of \p name fit a pattern with * and ?
bool fits(std::string_view name, std::string_view pattern)
{
  std::size_t n = 0, p = 0, star = std::string_view::npos, retry = 0;
  while (n < name.size())
    if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n]) && pattern[p] != '*')
      ++n, ++p;
    else if (p < pattern.size() && pattern[p] == '*')
      star = p++, retry = n;
    else if (star != std::string_view::npos) // let the last star take one letter more
      p = star + 1, n = ++retry;
    else
      return false;
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::string known_words()
{
  std::string words;
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    words += (words.empty() ? "" : ", ") + std::string(patterns[i].word);
    if (i + 1 == patterns.size() || patterns[i + 1].part != patterns[i].part)
      words += " (" + std::string(patterns[i].part) + ")";
  }
  return words;
}

} // namespace

std::string part_of_object(const std::string& object_name, const std::vector<PartPattern>& own,
                           const std::vector<std::string>& parts)
{
  const std::string lower = lower_case(object_name);
  for (const PartPattern& p : own)
    if (fits(lower, lower_case(p.pattern)))
      return p.part;
  if (std::find(parts.begin(), parts.end(), object_name) != parts.end())
    return object_name;
  for (const Pattern& p : patterns)
    for (auto at = lower.find(p.word); at != std::string::npos; at = lower.find(p.word, at + 1))
      if (!p.at_start || starts_word(object_name, at))
        return std::string(p.part);
  std::string given;
  for (const PartPattern& p : own)
    given += (given.empty() ? "" : ", ") + p.pattern + " (" + p.part + ")";
  throw InputError("object '" + object_name +
                   "' of the mesh belongs to no known part of a bird; rename it so that it "
                   "contains one of " +
                   known_words() +
                   (given.empty()
                        ? ", or give its part a pattern for it (objects = [\"" + object_name + "\"])"
                        : ", or add a pattern for it to those given: " + given));
}

} // namespace birdstrike
