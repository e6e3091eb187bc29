// SPDX-License-Identifier: GPL-3.0-or-later
// Shells from Nastran bulk data. Cards: MSC Nastran quick reference guide.
#include "geometry/import_shells/nastran.h"

#include "geometry/import_shells/nastran_cards.h"

#include <algorithm>
#include <map>

namespace birdstrike {

namespace {

using nastran::Card;

struct Kind
{
  std::size_t corners;
  std::size_t nodes;
};

const std::map<std::string, Kind> kinds = {{"CQUAD4", {4, 4}}, {"CQUADR", {4, 4}}, {"CQUAD8", {4, 8}},
                                           {"CTRIA3", {3, 3}}, {"CTRIAR", {3, 3}}, {"CTRIA6", {3, 6}}};

class Reader
{
public:
  Reader(const std::filesystem::path& file, double unit)
      : builder_(file.string(), unit), file_(file.string()), lines_(file, "export text bulk data (.bdf)")
  {
  }

  ShellImport read()
  {
    const std::size_t first = read_case_control();
    const std::size_t behind = nastran::for_cards(lines_, first, file_, [&](const Card& c) { take(c); });
    for (std::size_t k = 0; k < behind; ++k)
      if (!lines_[lines_.size() - behind + k].empty())
        builder_.count("lines behind ENDDATA", lines_.size() - behind + k + 1);
    return std::move(builder_).finish();
  }

private:
  //! \return the row behind BEGIN BULK; 0 if the file is bulk data alone
  std::size_t read_case_control()
  {
    std::size_t bulk = 0;
    for (std::size_t row = 0; row < lines_.size() && !bulk; ++row) {
      const auto found = words(lines_[row]);
      if (found.size() >= 2 && upper(found[0]) == "BEGIN" && upper(found[1]).starts_with("BULK"))
        bulk = row + 1;
    }
    for (std::size_t row = 0; row + 1 < bulk; ++row) {
      const std::string text = upper(trimmed(lines_[row]));
      const std::size_t equal = text.find('='), line = row + 1;
      const auto start = words(std::string_view(text).substr(0, equal));
      if (text.starts_with("INCLUDE"))
        refuse_include(line);
      if (equal == std::string::npos || start.size() != 2 || start[0] != "SET" || !to_integer(start[1]))
        continue;
      std::string list = text.substr(equal + 1);
      while (list.ends_with(',') && row + 2 < bulk)
        list += upper(trimmed(lines_[++row]));
      std::replace(list.begin(), list.end(), ',', ' ');
      std::vector<std::string> items;
      for (const std::string_view word : words(list))
        items.emplace_back(word);
      if (items.size() == 1 && items[0] == "ALL")
        continue;
      add_items("set_" + std::string(start[1]), items, 0, line, false);
    }
    return bulk;
  }

  [[noreturn]] void refuse_include(std::size_t line) const
  {
    builder_.fail(line,
                  "INCLUDE refers to another file; files within files are not read: paste its text here");
  }

  std::int64_t integer(const Card& card, std::size_t field, const char* what) const
  {
    const auto number = to_integer(card[field]);
    if (!number)
      builder_.fail(card.line,
                    card.name + ": " + what + " " + shown(card[field]) + " must be a whole number");
    return *number;
  }

  //! A blank field is zero.
  double real(const Card& card, std::size_t field, const char* what) const
  {
    const auto number = card[field].empty() ? 0.0 : to_real(card[field]);
    if (!number)
      builder_.fail(card.line, card.name + ": " + what + " " + shown(card[field]) + " must be a number");
    return *number;
  }

  void take(const Card& card)
  {
    if (card.name == "GRID")
      take_grid(card);
    else if (const auto kind = kinds.find(card.name); kind != kinds.end())
      take_element(card, kind->second);
    else if (card.name == "PSHELL")
      builder_.set_thickness(part(integer(card, 0, "the property's number")), real(card, 2, "the thickness"),
                             card.line);
    else if (card.name == "PCOMP")
      take_plies(card);
    else if (card.name == "SPC1")
      add_items("spc_" + card[0], card.fields, 2, card.line, true);
    else if (card.name == "SPC") {
      for (std::size_t k = 1; k < 7; k += 3)
        if (!card[k].empty())
          builder_.node_in_set("spc_" + card[0], integer(card, k, "a node"), card.line);
    } else if (card.name == "SET1")
      add_items("set_" + card[0], card.fields, 1, card.line, false);
    else if (card.name == "SET3" && upper(card[1]) == "GRID")
      add_items("set_" + card[0], card.fields, 2, card.line, true);
    else if (card.name == "GRDSET" && !card[1].empty() && card[1] != "0")
      builder_.fail(card.line, "GRDSET puts all nodes into coordinate system " + shown(card[1]) + basic_only);
    else if (card.name.starts_with("INCLUDE"))
      refuse_include(card.line);
    else
      builder_.count(card.name.size() > 8 ? "line that is no card" : card.name, card.line);
  }

  void take_grid(const Card& card)
  {
    const std::int64_t id = integer(card, 0, "a node's number");
    if (!card[1].empty() && card[1] != "0")
      builder_.fail(card.line,
                    "GRID " + card[0] + " stands in coordinate system " + shown(card[1]) + basic_only);
    builder_.node(
        id, {real(card, 2, "a coordinate"), real(card, 3, "a coordinate"), real(card, 4, "a coordinate")},
        card.line);
  }

  void take_element(const Card& card, const Kind& kind)
  {
    const std::int64_t id = integer(card, 0, "an element's number");
    const std::int64_t property = card[1].empty() ? id : integer(card, 1, "the property's number");
    std::vector<std::int64_t> corners;
    for (std::size_t k = 0; k < kind.corners; ++k)
      corners.push_back(integer(card, 2 + k, "a node"));
    builder_.element(id, corners, part(property), card.line);
    if (kind.nodes > kind.corners)
      builder_.count(card.name, card.line, "read with their corners only");
    // ZOFFS stands in field 6 of CTRIA3, 7 of CQUAD4, 9 of CTRIA6, 15 of CQUAD8; T1 in field 10 of all.
    const std::size_t offset = kind.nodes == 8 ? 15 : kind.nodes == 6 ? 9 : kind.nodes + 3;
    constexpr std::size_t corner_thickness = 10;
    if (real(card, offset, "the offset") != 0)
      builder_.count("offset of " + card.name, card.line, "not read; the nodes are on the middle surface");
    for (std::size_t k = 0; k < kind.corners; ++k)
      if (!card[corner_thickness + k].empty()) {
        builder_.count("thickness at corners of " + card.name, card.line, "not read; the property's holds");
        break;
      }
  }

  //! Four fields a ply from field 8 on: material, thickness (blank: as before), angle, output.
  void take_plies(const Card& card)
  {
    double sum = 0, last = 0;
    for (std::size_t k = 8; k < card.fields.size(); k += 4) {
      if (card[k].empty() && card[k + 1].empty() && card[k + 2].empty())
        continue;
      last = card[k + 1].empty() ? last : real(card, k + 1, "the thickness of a ply");
      sum += last;
    }
    const bool mirrored = upper(card[7]).starts_with("SYM");
    builder_.set_thickness(part(integer(card, 0, "the property's number")), mirrored ? 2 * sum : sum,
                           card.line);
    builder_.count("PCOMP", card.line, "read as one layer as thick as all plies");
  }

  //! Numbers, and "a THRU b". \param strict  every single number has to be a node
  template <class Items>
  void add_items(const std::string& set, const Items& items, std::size_t first, std::size_t line, bool strict)
  {
    const auto number = [&](std::size_t k) {
      const auto value = k < items.size() ? to_integer(items[k]) : std::nullopt;
      if (!value)
        builder_.fail(line, "a number of " + set + " is " + shown(k < items.size() ? items[k] : "") +
                                "; it must be whole, or THRU between two whole ones");
      return *value;
    };
    for (std::size_t k = first; k < items.size(); ++k) {
      if (items[k].empty())
        continue;
      if (k + 1 < items.size() && upper(items[k + 1]) == "THRU") {
        builder_.range_in_set(set, number(k), number(k + 2), 1, line);
        k += 2;
      } else
        builder_.node_in_set(set, number(k), line, strict);
    }
  }

  static std::string part(std::int64_t property) { return "part_" + std::to_string(property); }

  static constexpr const char* basic_only =
      "; only the basic one (blank or 0) is read: export the mesh in basic coordinates";
  ShellBuilder builder_;
  std::string file_;
  TextLines lines_;
};

} // namespace

ShellImport read_nastran(const std::filesystem::path& file, double unit) { return Reader(file, unit).read(); }

} // namespace birdstrike
