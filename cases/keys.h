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
using Slot = std::variant<double*, int*, bool*, std::string*, std::array<double, 2>*, std::array<int, 2>*,
                          ViscosityKind*>;

//! Allowed values of a number or a quantity, in SI.
struct Range
{
  std::optional<double> low, high;
  bool low_open = false; //!< low itself is not allowed
};

struct Key
{
  std::string_view path; //!< "bird.spacing"; a '*' stands for the name of a part, or of a law in "eos.*.c0"
  Dimension dimension;   //!< of numbers; Dimension::number for everything else
  std::string_view unit; //!< in which defaults are shown
  bool required;
  Range range;
  std::string_view text;
  Slot (*slot)(Case& parsed, std::size_t row); //!< row of bird.parts or of laws, for paths with '*'
  std::vector<std::string> (*choices)() = nullptr;
  bool or_law = false; //!< besides the choices, the name of any table [eos.NAME]; read_case checks that
};

//! All keys, in the order in which a case file is written.
std::span<const Key> case_keys();

//! The row for a path as written in a case file, or null.
const Key* find_key(const std::vector<std::string>& path);

//! Known path with the smallest edit distance from \p path; "" if nothing is near.
std::string nearest_key(const std::vector<std::string>& path);

//! "a length", "a list of 2 integers", ... for messages and the manual.
std::string kind_of(const Key& key);

//! "> 0 m", "0 ... 0.9", "" ; in SI
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
