// SPDX-License-Identifier: GPL-3.0-or-later
// From toml++ to entries. Brings toml++ along: for the few sources that read TOML tables.
#pragma once

#include "cases/case_entries.h"

#include <toml++/toml.h>

namespace birdstrike {

//! \param kind  "case" or "study", for messages
//! \throw InputError naming the file: missing, a folder, not TOML (with the line)
toml::table parse_toml(const std::filesystem::path& file, const std::string& kind);

//! All that stands in a table and the tables below it, in the order of the file.
std::vector<Entry> entries_of(const toml::table& table, const std::string& file);

//! \param place  "case.toml:12"
Entry to_entry(const toml::node& node, std::vector<std::string> path, std::string place);

} // namespace birdstrike
