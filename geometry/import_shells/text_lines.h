// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, fields and numbers of text decks.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

//! A whole text file and its lines, without line ends and with tabs as blanks up to the next eighth column.
class TextLines
{
public:
  //! \throw InputError naming the file: missing, not a file, empty, not readable, or with bytes that no text
  //! has; \p binary_remedy then says how to write it as text
  //! \param kind  what the message calls it
  TextLines(const std::filesystem::path& file, const std::string& binary_remedy,
            const std::string& kind = "target file");

  std::size_t size() const { return lines_.size(); }
  const std::string& operator[](std::size_t row) const { return lines_[row]; } //!< row k is line k + 1

private:
  std::vector<std::string> lines_;
};

std::string_view trimmed(std::string_view text);
//! Without the quotes around it, if there are some.
std::string_view unquoted(std::string_view text);
std::string upper(std::string_view text);
//! Fields between separators, trimmed; one empty field for an empty text.
std::vector<std::string_view> split(std::string_view text, char separator);
//! Words between blanks.
std::vector<std::string_view> words(std::string_view text);
// The pieces point into the text, which has to outlive them.
template <class Text>
requires std::same_as<Text, std::string> std::vector<std::string_view> split(Text&&, char)
= delete;
template <class Text>
requires std::same_as<Text, std::string> std::vector<std::string_view> words(Text&&)
= delete;
//! Columns first to first + width of a line, trimmed; empty behind its end.
std::string_view columns(std::string_view line, std::size_t first, std::size_t width);

std::optional<std::int64_t> to_integer(std::string_view text);
//! Also Fortran's 1.5D+3 and Nastran's 1.5+3.
std::optional<double> to_real(std::string_view text);

//! "element 'abc'": how a message shows what it found, shortened and without control characters.
std::string shown(std::string_view text);

} // namespace birdstrike
