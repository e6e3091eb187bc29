// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, fields and numbers of text decks.
#include "geometry/import_shells/text_lines.h"

#include "core/error.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

namespace birdstrike {

namespace {

constexpr std::string_view blanks = " \t\r\n\f\v";

bool is_blank(char c) { return blanks.find(c) != std::string_view::npos; }

std::string with_tabs_filled(std::string_view line)
{
  std::string filled;
  for (const char c : line)
    if (c == '\t')
      filled.append(8 - filled.size() % 8, ' ');
    else
      filled += c;
  return filled;
}

} // namespace

TextLines::TextLines(const std::filesystem::path& file, const std::string& binary_remedy,
                     const std::string& kind)
{
  const std::string name = kind + " '" + file.string() + "'";
  std::error_code error;
  require(std::filesystem::exists(file, error), name + " does not exist; check the path");
  require(std::filesystem::is_regular_file(file, error), name + " is not a file");
  std::ifstream in(file, std::ios::binary);
  require(in.good(), name + " cannot be opened; check its permissions");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  require(!text.empty(), name + " is empty");
  const auto control = std::find_if(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 32 && !is_blank(c) && c != '\x1a'; // DOS ends texts with ^Z
  });
  require(control == text.end(), name + " is not text (binary data after " +
                                     std::to_string(control - text.begin()) + " bytes); " + binary_remedy);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line(text.data() + at, end - at);
    while (!line.empty() && (is_blank(line.back()) || line.back() == '\x1a'))
      line.remove_suffix(1);
    lines_.push_back(with_tabs_filled(line));
    at = end + 1;
  }
}

std::string_view trimmed(std::string_view text)
{
  while (!text.empty() && is_blank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

std::string_view unquoted(std::string_view text)
{
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front())
    text = text.substr(1, text.size() - 2);
  return text;
}

std::string upper(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = text.find(separator);
    fields.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos)
      return fields;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> words(std::string_view text)
{
  std::vector<std::string_view> found;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    found.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return found;
}

std::string_view columns(std::string_view line, std::size_t first, std::size_t width)
{
  return first < line.size() ? trimmed(line.substr(first, width)) : std::string_view();
}

std::optional<std::int64_t> to_integer(std::string_view text)
{
  text = trimmed(text);
  if (text.size() > 1 && text.front() == '+' && text[1] != '-')
    text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

std::optional<double> to_real(std::string_view text)
{
  std::string number(trimmed(text));
  for (char& c : number)
    if (c == 'd' || c == 'D')
      c = 'e';
  // A sign inside the number that follows no e starts an exponent.
  for (std::size_t k = 1; k < number.size(); ++k)
    if ((number[k] == '+' || number[k] == '-') &&
        (std::isdigit(static_cast<unsigned char>(number[k - 1])) || number[k - 1] == '.'))
    {
      number.insert(k, "e");
      break;
    }
  std::string_view rest = number;
  if (rest.size() > 1 && rest.front() == '+' && rest[1] != '-')
    rest.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc() || end != rest.data() + rest.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string shown(std::string_view text)
{
  std::string result = "'";
  for (const char c : trimmed(text).substr(0, 40))
    result += static_cast<unsigned char>(c) < 32 ? '?' : c;
  return result + (trimmed(text).size() > 40 ? "...'" : "'");
}

} // namespace birdstrike
