// SPDX-License-Identifier: GPL-3.0-or-later
// A TOML file as a flat list of entries, each of which knows where it was written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace birdstrike {

//! A value of a case file; monostate for kinds that no key has (dates, nested lists, empty tables).
using Scalar = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct Entry
{
  std::vector<std::string> path; //!< {"bird", "spacing"}
  std::string place;             //!< "case.toml:12" or "--set"
  std::string found;             //!< the value as TOML text, for messages
  bool is_list = false;
  bool is_table = false;      //!< an empty table; values is empty
  std::vector<Scalar> values; //!< one, unless is_list
};

std::string join(const std::vector<std::string>& path); //!< "bird.spacing"
//! {"bird", "velocity"} of {"bird.velocity"}: dots within quotes part keys, too.
std::vector<std::string> split_path(const std::vector<std::string>& path);

//! \throw InputError naming the file: missing, unreadable, not TOML (with the line)
std::vector<Entry> read_entries(const std::filesystem::path& file);

//! One --set: "bird.spacing=2 mm", "run.frames=20", "target.plate.size=[\"1 m\", \"1 m\"]". What is not TOML
//! is taken as text. \throw InputError if there is no '=' or no key
Entry parse_override(const std::string& text);

//! Whether a file with these entries is a study (study.h) rather than a case.
bool is_study(const std::vector<Entry>& entries);

//! Whether it is a file of figures (montage_file.h).
bool is_figures(const std::vector<Entry>& entries);

//! Overrides replace entries of the same path, others are added.
void apply_override(std::vector<Entry>& entries, Entry override_entry);

} // namespace birdstrike
