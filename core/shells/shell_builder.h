// SPDX-License-Identifier: BSD-3-Clause
// A shell mesh put together from numbered nodes and elements, with the rules that every file format shares.
#pragma once

#include "core/shells/mesh.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace birdstrike {

//! What was read, and what a person should know about the reading.
struct ShellImport
{
  ShellMesh mesh;
  std::vector<std::string> warnings; //!< one line each, "CBUSH: 12 skipped (first in line 88)"
};

//! Collects nodes, elements, parts and node sets in any order; finish() joins them. Nothing is dropped without
//! a counted warning: a quad with two equal neighbouring corners becomes a triangle, nodes that no element
//! uses and parts without elements are left out and counted. Line numbers start at 1; 0 means that the format
//! has no lines.
class ShellBuilder
{
public:
  //! \param file  its name for messages \param unit  length of one unit of the file [m]
  //! \throw InputError unless the unit is positive
  ShellBuilder(std::string file, double unit);

  //! \throw InputError if the number was there before, or a coordinate is not finite
  void node(std::int64_t id, const Vector3& place, std::size_t line);
  //! \param corners  3 or 4 node numbers, which may come later \param part  any key, the name unless named
  //! \throw InputError if the number was there before
  void element(std::int64_t id, std::span<const std::int64_t> corners, const std::string& part,
               std::size_t line);
  void name_part(const std::string& part, const std::string& name);
  //! \param thickness  in units of the file \throw InputError if it is negative or not finite
  void set_thickness(const std::string& part, double thickness, std::size_t line);
  //! \param strict  false where the set may also mean something other than nodes: unknown ones are counted
  void node_in_set(const std::string& set, std::int64_t node, std::size_t line, bool strict = true);
  //! As node_in_set for all nodes from first to last that there are, in steps of \p step.
  void range_in_set(const std::string& set, std::int64_t first, std::int64_t last, std::int64_t step,
                    std::size_t line);

  //! Numbers are a multiple of \p stride (an instance) plus the number that messages show.
  void numbers_repeat_after(std::int64_t stride) { stride_ = stride; }
  //! One more of \p what for the warnings; \p outcome says what became of it.
  void count(const std::string& what, std::size_t line, const std::string& outcome = "skipped");
  std::string name() const { return "target file '" + file_ + "'"; }
  [[noreturn]] void fail(std::size_t line, const std::string& text) const;

  //! Parts come in the order in which elements first use them, points and elements in that of the file.
  //! \throw InputError naming file, line and element: a node that is missing, fewer than three different
  //! corners, no area, inverted corners; or no shell elements at all
  ShellImport finish() &&;

private:
  struct Element
  {
    std::int64_t id;
    std::array<std::int64_t, 4> corners;
    std::uint32_t part;
    std::size_t line;
  };
  struct Part
  {
    std::string key, name;
    double thickness = 0; // [m]
  };
  struct Member
  {
    std::int64_t first, last, step;
    std::size_t line;
    bool strict;
  };
  struct Count
  {
    std::string what, outcome;
    std::size_t number, line;
  };

  std::string shown(std::int64_t id) const { return std::to_string(stride_ ? id % stride_ : id); }
  std::uint32_t part_row(const std::string& key);
  ShellElement joined(const Element& element);
  void check_shape(const Element& element, const ShellElement& corners) const;
  void add_parts(ShellMesh& mesh) const;
  void add_sets(ShellMesh& mesh, const std::vector<std::int32_t>& new_row);

  std::string file_;
  double unit_;
  std::int64_t stride_ = 0;
  std::vector<Vector3> points_; // [m]
  std::vector<std::int64_t> node_ids_;
  std::unordered_map<std::int64_t, std::int32_t> node_row_;
  std::vector<Element> elements_;
  std::unordered_map<std::int64_t, std::size_t> element_line_;
  std::vector<Part> parts_;
  std::unordered_map<std::string, std::uint32_t> part_row_;
  std::map<std::string, std::vector<Member>> sets_;
  std::vector<Count> counts_;
  std::unordered_map<std::string, std::size_t> count_row_;
};

} // namespace birdstrike
