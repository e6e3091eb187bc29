// SPDX-License-Identifier: GPL-3.0-or-later
// Shells from LS-DYNA keyword decks. Format: LS-DYNA keyword user's manual, volume I.
// Long, because all keywords share the state of one reading; each has its own short section.
#include "geometry/import_shells/dyna.h"

#include "geometry/import_shells/text_lines.h"

#include <algorithm>
#include <map>

namespace birdstrike {

namespace {

struct Section
{
  double thickness;
  std::size_t line;
};

struct Part
{
  std::string title;
  std::int64_t section;
  std::size_t line;
};

class Reader
{
public:
  Reader(const std::filesystem::path& file, double unit)
      : builder_(file.string(), unit), lines_(file, "export a keyword deck as text")
  {
  }

  ShellImport read()
  {
    bool is_deck = false;
    while (row_ < lines_.size()) {
      const std::string& line = lines_[row_++];
      if (!line.starts_with('*'))
        continue; // what a skipped keyword leaves; before *KEYWORD anything may stand
      line_ = row_;
      const std::string text = upper(line);
      keyword_ = std::string(words(text)[0].substr(1));
      if (keyword_ == "END")
        break;
      is_deck = true;
      take_keyword(text);
    }
    if (!is_deck)
      builder_.fail(0, "this is no LS-DYNA deck: no line starts with a keyword (*NODE)");
    join_parts();
    return std::move(builder_).finish();
  }

private:
  // Lines and fields.

  //! The next line of the keyword that is no comment.
  bool next(std::string_view& line)
  {
    while (row_ < lines_.size() && lines_[row_].starts_with('$'))
      ++row_;
    if (row_ >= lines_.size() || lines_[row_].starts_with('*'))
      return false;
    line = lines_[row_++];
    return true;
  }

  std::string_view line_or_fail(const char* what)
  {
    std::string_view line;
    if (!next(line))
      builder_.fail(line_, "*" + keyword_ + " ends before its " + what + "; the file may be cut short");
    return line;
  }

  //! Fields of a line: as wide as given, or between commas.
  std::vector<std::string_view> fields(std::string_view line, std::initializer_list<std::size_t> widths) const
  {
    std::vector<std::string_view> found;
    if (line.find(',') != std::string_view::npos) {
      found = split(line, ',');
      found.resize(std::max(found.size(), widths.size()));
    } else {
      std::size_t at = 0;
      for (const std::size_t width : widths) {
        found.push_back(columns(line, at, width));
        at += width;
      }
    }
    for (const std::string_view field : found)
      if (field.find('&') != std::string_view::npos)
        builder_.fail(row_, "field " + shown(field) + " of *" + keyword_ +
                                " refers to a parameter; put its value in");
    return found;
  }

  std::int64_t integer(std::string_view text, const char* what) const
  {
    if (text.empty())
      return 0;
    const auto number = to_integer(text);
    if (!number)
      builder_.fail(row_, "*" + keyword_ + ": " + what + " " + shown(text) + " must be a whole number");
    return *number;
  }

  double real(std::string_view text, const char* what) const
  {
    const auto number = text.empty() ? 0.0 : to_real(text);
    if (!number)
      builder_.fail(row_, "*" + keyword_ + ": " + what + " " + shown(text) + " must be a number");
    return *number;
  }

  // Keywords.

  void take_keyword(const std::string& line)
  {
    const bool is_long = line.find("LONG=") != std::string::npos && line.find("LONG=S") == std::string::npos;
    if ((keyword_.starts_with("KEYWORD") && (is_long || line.find("I10=Y") != std::string::npos)) ||
        keyword_.ends_with('+') || keyword_.ends_with('%'))
      builder_.fail(line_, shown(line) + " asks for the long format or fields of ten, which are not read; "
                                         "write the deck in the standard "
                                         "format, or with commas");
    if (keyword_.ends_with('-'))
      keyword_.pop_back();
    if (keyword_.starts_with("INCLUDE"))
      builder_.fail(line_,
                    "*" + keyword_ +
                        " refers to another file; files within files are not read: paste its text here");
    const bool titled = keyword_.ends_with("_TITLE");
    const std::string name = titled ? keyword_.substr(0, keyword_.size() - 6) : keyword_;
    if (name == "NODE")
      take_nodes();
    else if (name == "ELEMENT_SHELL" || name.starts_with("ELEMENT_SHELL_"))
      take_elements(name.substr(std::min<std::size_t>(name.size(), 14)));
    else if (name == "PART" || name.starts_with("PART_CONTACT") || name.starts_with("PART_INERTIA"))
      take_parts();
    else if (name == "SECTION_SHELL")
      take_sections(titled);
    else if (name == "SET_NODE" || name == "SET_NODE_LIST" || name == "SET_NODE_LIST_GENERATE" ||
             name == "SET_NODE_COLUMN")
      take_set(titled, name);
    else if (name.starts_with("ELEMENT_"))
      skip_elements();
    else if (name != "KEYWORD" && name != "TITLE")
      builder_.count("*" + keyword_, line_);
  }

  void take_nodes()
  {
    for (std::string_view line; next(line);) {
      const auto f = fields(line, {8, 16, 16, 16});
      if (f[0].empty())
        builder_.fail(row_, "*NODE without a number");
      const double x = real(f[1], "a coordinate"), y = real(f[2], "a coordinate");
      builder_.node(integer(f[0], "a node's number"), {x, y, real(f[3], "a coordinate")}, row_);
    }
  }

  //! \param options  behind ELEMENT_SHELL_
  void take_elements(const std::string& options)
  {
    int thickness_lines = 0, other_lines = 0;
    for (const std::string_view option : split(options, '_'))
      if (option == "THICKNESS" || option == "BETA" || option == "MCID")
        thickness_lines = 1; // one line for all three
      else if (option == "OFFSET")
        other_lines = 1;
      else if (!option.empty())
        builder_.fail(line_, "*" + keyword_ + " has the option " + shown(option) +
                                 ", which is not read; export *ELEMENT_SHELL without it");
    for (std::string_view line; next(line);) {
      const auto f = fields(line, {8, 8, 8, 8, 8, 8, 8, 8, 8, 8});
      const std::size_t at = row_;
      const std::int64_t id = integer(f[0], "an element's number"), part = integer(f[1], "a part's number");
      if (f[0].empty())
        builder_.fail(at, "*ELEMENT_SHELL without a number");
      std::vector<std::int64_t> corners;
      for (std::size_t k = 2; k < 6; ++k)
        corners.push_back(integer(f[k], "a node"));
      if (corners[3] == 0)
        corners.pop_back();
      bool higher = false;
      for (std::size_t k = 6; k < std::min<std::size_t>(10, f.size()); ++k)
        higher |= integer(f[k], "a node") != 0;
      builder_.element(id, corners, "part_" + std::to_string(part), at);
      if (higher)
        builder_.count("*ELEMENT_SHELL of 8 nodes", at, "read with their corners only");
      // With middle nodes the thickness takes two lines.
      for (int k = 0; k < thickness_lines * (higher ? 2 : 1) + other_lines; ++k)
        line_or_fail("option lines");
      if (thickness_lines + other_lines)
        builder_.count("options of *" + keyword_, at, "not read; the section's thickness holds");
    }
  }

  //! Counts lines: how many an element takes is not known for all kinds.
  void skip_elements()
  {
    for (std::string_view line; next(line);)
      builder_.count("*" + keyword_ + " (lines)", row_);
  }

  void take_parts()
  {
    const bool plain = keyword_ == "PART";
    for (std::string_view line; next(line);) {
      const std::string title(trimmed(line));
      const auto f = fields(line_or_fail("numbers"), {10, 10});
      const std::int64_t id = integer(f[0], "a part's number");
      if (id < 1)
        builder_.fail(row_, "*PART " + shown(title) + " needs a positive number");
      if (!parts_.emplace(id, Part{title, integer(f[1], "a section's number"), row_}).second)
        builder_.fail(row_, "part " + std::to_string(id) + " is there a second time");
      if (keyword_.starts_with("PART_CONTACT"))
        line_or_fail("contact line");
      else if (!plain)
        return; // of the others, only one stands under a keyword
    }
  }

  void take_sections(bool titled)
  {
    for (;;) {
      std::string_view line;
      if (!next(line))
        return;
      if (titled)
        line = line_or_fail("first line");
      const auto f = fields(line, {10, 10, 10, 10, 10, 10, 10, 10});
      const std::int64_t id = integer(f[0], "a section's number");
      const auto layers = static_cast<std::int64_t>(real(f[3], "the number of layers"));
      const bool layered = integer(f[6], "ICOMP") != 0;
      const auto t = fields(line_or_fail("thickness"), {10, 10, 10, 10});
      const double thickness = real(t[0], "the thickness");
      for (std::size_t k = 1; k < 4; ++k)
        if (const double other = real(t[k], "the thickness"); other != 0 && other != thickness)
          builder_.count("T2 to T4 of *SECTION_SHELL", row_, "not read; T1 holds everywhere");
      if (!sections_.emplace(id, Section{thickness, row_}).second)
        builder_.fail(row_, "section " + std::to_string(id) + " is there a second time");
      for (std::int64_t k = 0; layered && k < layers; k += 8)
        line_or_fail("layer angles");
    }
  }

  void take_set(bool titled, const std::string& name)
  {
    const std::string title = titled ? std::string(trimmed(line_or_fail("title"))) : "";
    const auto first = fields(line_or_fail("number"), {10});
    const std::string set =
        title.empty() ? "set_" + std::to_string(integer(first[0], "a set's number")) : title;
    const bool ranges = name.ends_with("GENERATE");
    for (std::string_view line; next(line);) {
      const auto f = fields(line, {10, 10, 10, 10, 10, 10, 10, 10});
      if (name == "SET_NODE_COLUMN") {
        builder_.node_in_set(set, integer(f[0], "a node"), row_);
        continue;
      }
      for (std::size_t k = 0; k < f.size(); k += ranges ? 2 : 1) {
        const std::int64_t node = integer(f[k], "a node");
        if (ranges && node && k + 1 < f.size())
          builder_.range_in_set(set, node, integer(f[k + 1], "a node"), 1, row_);
        else if (node)
          builder_.node_in_set(set, node, row_);
      }
    }
  }

  void join_parts()
  {
    for (const auto& [id, part] : parts_) {
      const std::string key = "part_" + std::to_string(id);
      builder_.name_part(key, part.title);
      // A section may be one of solids, which is no concern here.
      if (const auto section = sections_.find(part.section); section != sections_.end())
        builder_.set_thickness(key, section->second.thickness, section->second.line);
    }
  }

  ShellBuilder builder_;
  TextLines lines_;
  std::size_t row_ = 0;  // of the next line, so the number of this one
  std::size_t line_ = 0; // of the keyword
  std::string keyword_;  // upper case, without *
  std::map<std::int64_t, Part> parts_;
  std::map<std::int64_t, Section> sections_;
};

} // namespace

ShellImport read_dyna(const std::filesystem::path& file, double unit) { return Reader(file, unit).read(); }

} // namespace birdstrike
