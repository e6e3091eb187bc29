// SPDX-License-Identifier: GPL-3.0-or-later
// What an Abaqus input file says about shells, before parts are placed.
#pragma once

#include "core/shells/shell_builder.h"

#include <filesystem>
#include <map>

namespace birdstrike::abaqus {

//! A number, or the name of another set; in an assembly of one instance.
struct Member
{
  std::int64_t first, last, step; //!< a single number has first = last
  std::string name;               //!< upper case; empty for numbers
  std::string instance;           //!< upper case; empty for the part's own
  std::size_t line;
};

struct Set
{
  std::string name; //!< as the file spells it first
  std::vector<Member> members;
};

using Sets = std::map<std::string, Set>; //!< by name in upper case

struct Node
{
  std::int64_t id;
  Vector3 place; //!< in units of the file
  std::size_t line;
};

struct Element
{
  std::int64_t id;
  std::array<std::int64_t, 4> corners;
  int corner_count;
  std::string set; //!< upper case; of its *ELEMENT card
  std::size_t line;
};

struct Section
{
  std::string set; //!< upper case
  double thickness = 0;
  std::size_t line = 0;
};

struct Part
{
  std::string name;
  std::vector<Node> nodes;
  std::vector<Element> elements;
  Sets node_sets, element_sets;
  std::vector<Section> sections;
};

struct Instance
{
  std::string name;                                        //!< as the file spells it
  std::string part;                                        //!< upper case
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity(); //!< in units of the file
  std::size_t line = 0;
};

struct Deck
{
  Part root;                         //!< outside all parts; holds the assembly's sets too
  std::map<std::string, Part> parts; //!< by name in upper case
  std::vector<Instance> instances;
};

//! \param builder  counts what is skipped, says what is wrong
Deck read_deck(const std::filesystem::path& file, ShellBuilder& builder);

//! Nodes, elements, parts and node sets of every instance, numbered anew where there are several.
void place_deck(const Deck& deck, ShellBuilder& builder);

} // namespace birdstrike::abaqus
