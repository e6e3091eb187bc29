// SPDX-License-Identifier: GPL-3.0-or-later
// What an Abaqus input file says about shells, card by card. Format: Abaqus keywords reference guide.
// Long, because all cards share the state of one reading; each has its own short section.
#include "geometry/import_shells/abaqus_deck.h"

#include "geometry/import_shells/text_lines.h"

#include <algorithm>
#include <numbers>

namespace birdstrike::abaqus {

namespace {

struct Kind
{
  int corners;
  int nodes;
};

//! Shells and rigid faces by TYPE.
const std::map<std::string, Kind> kinds = {
    {"S3", {3, 3}},     {"S3R", {3, 3}}, {"S3RS", {3, 3}}, {"S3T", {3, 3}},  {"STRI3", {3, 3}},
    {"R3D3", {3, 3}},   {"S4", {4, 4}},  {"S4R", {4, 4}},  {"S4RS", {4, 4}}, {"S4RSW", {4, 4}},
    {"S4R5", {4, 4}},   {"S4T", {4, 4}}, {"S4RT", {4, 4}}, {"R3D4", {4, 4}}, {"S6", {3, 6}},
    {"STRI65", {3, 6}}, {"S8", {4, 8}},  {"S8R", {4, 8}},  {"S8R5", {4, 8}}, {"S8RT", {4, 8}},
    {"S9R5", {4, 9}},
};

const char* const makers[] = {"NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM"};

class Reader
{
public:
  Reader(const std::filesystem::path& file, ShellBuilder& builder)
      : lines_(file, "export an Abaqus input file (.inp)"), builder_(builder)
  {
  }

  Deck read()
  {
    while (row_ < lines_.size()) {
      const std::string_view line = trimmed(lines_[row_++]);
      if (line.empty() || line.starts_with("**"))
        continue;
      if (line[0] == '*')
        start_card(line);
      else if (!data_)
        builder_.fail(row_, "text " + shown(line) + " stands before the first card; is this an Abaqus deck?");
      else
        (this->*data_)(line);
    }
    end_card();
    if (deck_.instances.empty())
      for (const auto& [key, part] : deck_.parts) {
        builder_.count("PART without an instance", 0, "placed as it is");
        deck_.instances.push_back({part.name, key});
      }
    return std::move(deck_);
  }

private:
  using Data = void (Reader::*)(std::string_view);

  bool has(const std::string& key) const { return parameters_.contains(key); }
  std::string value(const std::string& key) const
  {
    const auto at = parameters_.find(key);
    return at == parameters_.end() ? "" : at->second;
  }
  [[noreturn]] void fail(const std::string& text) const { builder_.fail(row_, text); }

  void start_card(std::string_view first)
  {
    end_card();
    line_ = row_;
    std::string text(first.substr(1));
    while (text.ends_with(',') && row_ < lines_.size() && !lines_[row_].starts_with('*'))
      text += lines_[row_++];
    const auto fields = split(text, ',');
    card_.clear();
    for (const std::string_view word : words(fields[0]))
      card_ += (card_.empty() ? "" : " ") + upper(word);
    parameters_.clear();
    for (std::size_t k = 1; k < fields.size(); ++k) {
      const std::size_t equal = fields[k].find('=');
      parameters_[upper(trimmed(fields[k].substr(0, equal)))] =
          equal == std::string_view::npos ? "" : std::string(unquoted(fields[k].substr(equal + 1)));
    }
    data_ = &Reader::ignore;
    open_card();
  }

  void open_card()
  {
    if (card_ == "INCLUDE" ||
        (has("INPUT") && (card_ == "NODE" || card_ == "ELEMENT" || card_ == "NSET" || card_ == "ELSET")))
      fail("*" + card_ + " refers to the file " + shown(value("INPUT")) +
           "; files within files are not read: paste its text here");
    for (const char* maker : makers)
      if (card_ == maker)
        fail("*" + card_ +
             " makes or moves nodes or elements, which is not supported; export a deck with every node "
             "and element written out");
    if (card_ == "NODE")
      open_nodes();
    else if (card_ == "ELEMENT")
      open_elements();
    else if (card_ == "NSET" || card_ == "ELSET")
      open_set();
    else if (card_ == "SHELL SECTION" || card_ == "SHELL GENERAL SECTION")
      open_section();
    else if (card_ == "PART")
      open_part();
    else if (card_ == "INSTANCE")
      open_instance();
    else if (card_ == "END PART" || card_ == "ASSEMBLY")
      part_ = &deck_.root;
    else if (card_ == "END INSTANCE")
      in_instance_ = false;
    else if (card_ != "HEADING" && card_ != "END ASSEMBLY")
      builder_.count("*" + card_, line_);
  }

  void open_part()
  {
    const auto [at, is_new] = deck_.parts.try_emplace(upper(named("NAME")));
    if (!is_new)
      fail("*PART " + shown(value("NAME")) + " is there a second time");
    part_ = &at->second;
    part_->name = value("NAME");
  }

  void end_card()
  {
    if (!numbers_.empty())
      fail("the last element of the *ELEMENT card in line " + std::to_string(line_) +
           " has too few nodes; the file may be cut short");
  }

  std::string named(const std::string& key) const
  {
    if (value(key).empty())
      fail("*" + card_ + " needs " + key + "=");
    return value(key);
  }

  void ignore(std::string_view) {}

  std::int64_t integer(std::string_view text, const char* what) const
  {
    const auto number = to_integer(text);
    if (!number)
      fail(std::string(what) + " " + shown(text) + " must be a whole number");
    return *number;
  }

  double real(std::string_view text, const char* what) const
  {
    const auto number = text.empty() ? 0.0 : to_real(text);
    if (!number)
      fail(std::string(what) + " " + shown(text) + " must be a number");
    return *number;
  }

  // Nodes.
  void open_nodes()
  {
    if (in_instance_)
      fail("*NODE stands inside *INSTANCE; define the mesh in its *PART");
    if (has("SYSTEM") && upper(value("SYSTEM")) != "R")
      fail("*NODE has SYSTEM=" + value("SYSTEM") + "; only rectangular coordinates (R) are read");
    data_ = &Reader::read_node;
  }
  void read_node(std::string_view line)
  {
    const auto fields = split(line, ',');
    if (fields.size() < 2)
      fail("a node needs its number and coordinates, separated by commas, not " + shown(line));
    Vector3 place = Vector3::Zero();
    for (std::size_t k = 1; k < std::min<std::size_t>(4, fields.size()); ++k)
      place[static_cast<Eigen::Index>(k) - 1] = real(fields[k], "a coordinate");
    const std::int64_t id = integer(fields[0], "a node's number");
    part_->nodes.push_back({id, place, row_});
    if (!value("NSET").empty())
      add_member(part_->node_sets, value("NSET"), {id, id, 1, "", "", row_});
  }

  // Elements.
  void open_elements()
  {
    if (in_instance_)
      fail("*ELEMENT stands inside *INSTANCE; define the mesh in its *PART");
    const auto kind = kinds.find(upper(named("TYPE")));
    kind_ = kind == kinds.end() ? Kind{0, 0} : kind->second;
    more_follows_ = false;
    data_ = kind == kinds.end() ? &Reader::skip_element : &Reader::read_element;
  }
  void skip_element(std::string_view line)
  {
    if (!more_follows_)
      builder_.count("*ELEMENT TYPE=" + upper(value("TYPE")), row_);
    more_follows_ = line.ends_with(',');
  }
  void read_element(std::string_view line)
  {
    auto fields = split(line, ',');
    if (fields.back().empty())
      fields.pop_back();
    if (numbers_.empty())
      element_line_ = row_;
    for (const std::string_view field : fields)
      numbers_.push_back(integer(field, "a number of an element"));
    const std::size_t needed = static_cast<std::size_t>(kind_.nodes) + 1;
    if (numbers_.size() < needed && line.ends_with(','))
      return;
    if (numbers_.size() != needed)
      fail("element " + std::to_string(numbers_[0]) + " of type " + value("TYPE") + " has " +
           std::to_string(numbers_.size() - 1) + " nodes; it must have " + std::to_string(kind_.nodes));
    Element element{numbers_[0], {}, kind_.corners, upper(value("ELSET")), element_line_};
    std::copy_n(numbers_.begin() + 1, kind_.corners, element.corners.begin());
    part_->elements.push_back(element);
    if (!value("ELSET").empty())
      add_member(part_->element_sets, value("ELSET"), {numbers_[0], numbers_[0], 1, "", "", element_line_});
    if (kind_.nodes > kind_.corners)
      builder_.count("*ELEMENT TYPE=" + upper(value("TYPE")), element_line_, "read with their corners only");
    numbers_.clear();
  }

  // Sets.
  void add_member(Sets& sets, const std::string& name, Member member)
  {
    Set& set = sets[upper(name)];
    if (set.name.empty())
      set.name = name;
    set.members.push_back(std::move(member));
  }
  void open_set()
  {
    named(card_);
    if (card_ == "NSET" && has("ELSET")) {
      builder_.count("*NSET of the nodes of an element set", line_);
      return;
    }
    data_ = &Reader::read_set;
  }
  void read_set(std::string_view line)
  {
    Sets& sets = card_ == "NSET" ? part_->node_sets : part_->element_sets;
    const std::string set = value(card_), instance = upper(value("INSTANCE"));
    auto fields = split(line, ',');
    if (fields.back().empty())
      fields.pop_back();
    if (has("GENERATE")) {
      if (fields.size() < 2 || fields.size() > 3)
        fail("GENERATE needs first, last and step, not " + shown(line));
      const std::int64_t first = integer(fields[0], "the first number"),
                         last = integer(fields[1], "the last number"),
                         step = fields.size() == 3 ? integer(fields[2], "the step") : 1;
      if (step < 1 || last < first)
        fail("GENERATE " + shown(line) + " does not ascend");
      add_member(sets, set, {first, last, step, "", instance, row_});
      return;
    }
    for (const std::string_view field : fields) {
      if (const auto id = to_integer(field)) {
        add_member(sets, set, {*id, *id, 1, "", instance, row_});
        continue;
      }
      const std::string name(unquoted(field));
      const std::size_t dot = name.rfind('.');
      const auto id =
          dot == std::string::npos ? std::nullopt : to_integer(std::string_view(name).substr(dot + 1));
      if (id) // instance.number
        add_member(sets, set, {*id, *id, 1, "", upper(name.substr(0, dot)), row_});
      else
        add_member(sets, set, {0, 0, 1, upper(name), instance, row_});
    }
  }

  // Sections.
  void open_section()
  {
    if (card_ == "SHELL GENERAL SECTION" && !has("MATERIAL") && !has("COMPOSITE")) {
      builder_.count("*SHELL GENERAL SECTION without MATERIAL", line_);
      return;
    }
    part_->sections.push_back({upper(named("ELSET")), 0, line_});
    if (has("COMPOSITE"))
      builder_.count("*" + card_ + ", COMPOSITE", line_, "read as one layer as thick as all plies");
    if (has("NODAL THICKNESS"))
      builder_.count("NODAL THICKNESS of *" + card_, line_, "not read; the section's own thickness holds");
    data_ = &Reader::read_section;
  }
  void read_section(std::string_view line)
  {
    Section& section = part_->sections.back();
    section.thickness += real(split(line, ',')[0], "a thickness");
    section.line = row_;
    if (!has("COMPOSITE"))
      data_ = &Reader::ignore;
  }

  // Instances.
  void open_instance()
  {
    Instance instance{named("NAME"), upper(named("PART"))};
    instance.line = line_;
    deck_.instances.push_back(instance);
    in_instance_ = true;
    turned_ = false;
    data_ = &Reader::read_place;
  }
  void read_place(std::string_view line)
  {
    const auto fields = split(line, ',');
    Eigen::Isometry3d& place = deck_.instances.back().place;
    const auto vector = [&](std::size_t first) {
      Vector3 v = Vector3::Zero();
      for (std::size_t k = first; k < std::min(first + 3, fields.size()); ++k)
        v[static_cast<Eigen::Index>(k - first)] = real(fields[k], "a coordinate");
      return v;
    };
    if (!turned_) {
      place.translation() = vector(0);
      turned_ = true; // the next line is the turn
      return;
    }
    if (fields.size() < 7 || (vector(3) - vector(0)).norm() == 0)
      fail("the turn of an instance needs two different points of its axis and an angle");
    // Shifted first, then turned about the axis.
    const Eigen::AngleAxisd turn(real(fields[6], "an angle") * std::numbers::pi / 180,
                                 (vector(3) - vector(0)).normalized());
    place = Eigen::Translation3d(vector(0)) * turn * Eigen::Translation3d(-vector(0)) * place;
    data_ = &Reader::ignore;
  }

  TextLines lines_;
  ShellBuilder& builder_;
  Deck deck_;
  Part* part_ = &deck_.root;
  std::size_t row_ = 0;  // of the next line, so the number of this one
  std::size_t line_ = 0; // of the card
  std::string card_;     // upper case, without *
  std::map<std::string, std::string> parameters_;
  Data data_ = nullptr;
  Kind kind_{0, 0};
  std::vector<std::int64_t> numbers_; // of the element so far
  std::size_t element_line_ = 0;
  bool more_follows_ = false, in_instance_ = false, turned_ = false;
};

} // namespace

Deck read_deck(const std::filesystem::path& file, ShellBuilder& builder)
{
  return Reader(file, builder).read();
}

} // namespace birdstrike::abaqus
