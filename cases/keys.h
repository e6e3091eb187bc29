// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of every key of a case file: its path, kind, range, default and meaning. Reading, checking,
// echoing and `birdstrike cases --keys` all work from it. To add a key: a member in Case, a row in keys.cpp.
#pragma once

#include "cases/case.h"
#include "cases/quantity.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace birdstrike {

//! Where a key's value lives in a Case; the type of the pointer is the type of the key.
using Slot = std::variant<double*, int*, bool*, std::string*, std::array<double, 2>*, std::array<double, 3>*,
                          std::array<int, 2>*, std::vector<std::string>*, ViscosityKind*>;

//! Allowed values of a number or a quantity, in SI.
struct Range
{
  std::optional<double> low, high;
  bool low_open = false; //!< low itself is not allowed
};

//! Cases for which something about a key holds.
struct Condition
{
  std::string_view text; //!< after "with" or "for"
  bool (*holds)(const Case& parsed);
};

struct Key
{
  std::string_view path; //!< "bird.spacing"; a '*' stands for the name of a part, a transducer or a law
  Dimension dimension;   //!< of numbers; Dimension::number for everything else
  std::string_view unit; //!< in which defaults are shown
  bool required;
  Range range;
  std::string_view text;
  Slot (*slot)(Case& parsed, std::size_t row); //!< row: of the table with names, for paths with '*'
  std::vector<std::string> (*choices)() = nullptr;
  const Condition* only = nullptr;   //!< elsewhere the key has no meaning and is refused
  const Condition* unless = nullptr; //!< a required key may be left out there
  std::optional<double> (*by_name)(std::string_view text) =
      nullptr;         //!< a value that a name stands for, besides numbers
  bool or_law = false; //!< besides the choices, the name of any table [eos.NAME]; read_case checks that
};

//! "limited", "pairwise", "switched" or "dissertation", the bulk term of 5.58.
std::string_view name_of(ViscosityKind kind);
//! \param name  one of those; anything else is a mistake of the caller
ViscosityKind viscosity_kind(std::string_view name);

//! All keys, in the order in which a case file is written.
std::span<const Key> case_keys();

//! What the '*' of a key may stand for in a case, in the order of the file: its parts or its transducers. Empty for a key
//! without '*'.
std::vector<std::string> names_for(const Case& parsed, const Key& key);

//! Row of what the '*' of a path stands for, made at its first mention; 0 for a key without '*'.
std::size_t row_for(Case& parsed, const Key& key, const std::vector<std::string>& path);

//! Is this a named row with nothing in it, such as "[bird.parts.torso]"? Makes the row.
bool make_empty_row(Case& parsed, const std::vector<std::string>& path);

//! The key's path with '*' replaced by what stands there in \p path, or by "<name>".
std::string named(const Key& key, const std::vector<std::string>& path);

//! The row for a path as written in a case file, or null.
const Key* find_key(const std::vector<std::string>& path);

//! Known path with the smallest edit distance from \p path; "" if nothing is near.
std::string nearest_key(const std::vector<std::string>& path);

//! "a length", "a list of 2 integers", ... for messages and the manual.
std::string kind_of(const Key& key);

//! "> 0 m", "0 ... 0.9", "" ; in SI, angles in degrees
std::string describe(const Range& range, Dimension dimension);

//! Was the value of a key without default not given: a NaN, or an empty text?
bool is_empty(const Slot& slot);

//! The value in a slot as TOML text: "6 mm" with quotes, 1.25, true, ["1.8 m", "1.2 m"].
std::string to_toml(const Slot& slot, const Key& key);

//! A TOML string with its quotes and escapes.
std::string toml_string(std::string_view text);

//! `birdstrike cases --keys`: one line a key.
std::string keys_manual();

} // namespace birdstrike
