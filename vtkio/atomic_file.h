// SPDX-License-Identifier: BSD-3-Clause
// Files that are either whole or not there.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace birdstrike {

//! Make a folder and those above it. \throw OutputError naming it and the reason
void make_folder(const std::filesystem::path& folder);

//! Call write with a temporary name beside \p file, then rename what it wrote to \p file.
//! \param write  gets the temporary name; returns what went wrong, empty if nothing did
//! \throw OutputError naming \p file and the reason; the temporary file is then removed
void write_atomically(const std::filesystem::path& file,
                      const std::function<std::string(const std::filesystem::path&)>& write);

//! The same for a text that is already there.
void write_text_atomically(const std::filesystem::path& file, const std::string& text);

} // namespace birdstrike
