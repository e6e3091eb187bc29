// SPDX-License-Identifier: GPL-3.0-or-later
// Nastran bulk data as cards, whatever the form of their fields. Format: MSC Nastran quick reference guide,
// "Format of bulk data entries".
#include "geometry/import_shells/nastran_cards.h"

#include "core/error.h"

#include <algorithm>

namespace birdstrike::nastran {

namespace {

struct Line
{
  std::string name; //!< first field, as it stands
  std::vector<std::string_view> fields;
  std::string_view mark; //!< tenth field
  bool large = false;
};

Line taken_apart(std::string_view text)
{
  Line line;
  std::vector<std::string_view> all;
  const bool free = text.find(',') != std::string_view::npos;
  if (free)
    all = split(text, ',');
  line.name = free ? std::string(all[0]) : std::string(columns(text, 0, 8));
  line.large = line.name.ends_with('*') || line.name.starts_with('*');
  const std::size_t count = line.large ? 4 : 8, width = line.large ? 16 : 8;
  if (free) {
    for (std::size_t k = 1; k < all.size() && k <= count; ++k)
      line.fields.push_back(all[k]);
    if (all.size() > count + 1)
      line.mark = all[count + 1];
  } else {
    for (std::size_t k = 0; k < count; ++k)
      line.fields.push_back(columns(text, 8 + k * width, width));
    line.mark = columns(text, 72, 8);
  }
  return line;
}

//! A mark without its + or *, which may differ between the two lines.
std::string bare(std::string_view mark)
{
  mark = trimmed(mark);
  if (!mark.empty() && (mark[0] == '+' || mark[0] == '*'))
    mark.remove_prefix(1);
  return upper(trimmed(mark));
}

} // namespace

std::size_t for_cards(const TextLines& lines, std::size_t first, const std::string& file,
                      const std::function<void(const Card&)>& take)
{
  Card card;
  std::string mark;
  const auto finish = [&] {
    if (!card.name.empty())
      take(card);
    card = Card();
  };
  for (std::size_t row = first; row < lines.size(); ++row) {
    std::string_view text = lines[row];
    text = text.substr(0, text.find('$')); // comments may follow the fields
    if (trimmed(text).empty())
      continue;
    const Line line = taken_apart(text);
    const auto where = [&] { return "target file '" + file + "', line " + std::to_string(row + 1) + ": "; };

    if (line.name.empty() || line.name[0] == '+' || line.name[0] == '*') {
      require(!card.name.empty(),
              where() + "a continuation line follows no card; give it back its first line");
      require(line.name.empty() || mark.empty() || bare(line.name).empty() || bare(line.name) == mark,
              where() + "continuation " + shown(line.name) + " does not follow its card, which ends with " +
                  shown(mark) + "; put the lines of each card one below the other");
      // Short lines leave the rest of their fields blank; two lines of large fields make one of small ones.
      const std::size_t whole = line.large ? 4 : 8;
      card.fields.resize((card.fields.size() + whole - 1) / whole * whole);
    } else {
      finish();
      if (upper(line.name).starts_with("ENDDATA"))
        return lines.size() - row - 1;
      card.name = upper(line.name);
      if (line.large)
        card.name = trimmed(std::string_view(card.name).substr(0, card.name.size() - 1));
      card.line = row + 1;
    }
    card.last_line = row + 1;
    for (const std::string_view field : line.fields)
      card.fields.emplace_back(field);
    mark = bare(line.mark);
  }
  finish();
  return 0;
}

} // namespace birdstrike::nastran
