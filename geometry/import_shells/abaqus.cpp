// SPDX-License-Identifier: GPL-3.0-or-later
// Shells from Abaqus input files: parts are placed as their instances say.
#include "geometry/import_shells/abaqus.h"

#include "geometry/import_shells/abaqus_deck.h"
#include "geometry/import_shells/text_lines.h"

#include <algorithm>

namespace birdstrike {

namespace abaqus {

namespace {

// Numbers of one instance follow those of the one before at this distance.
constexpr std::int64_t stride = std::int64_t(1) << 36;

//! Calls take(first, last, step, line) for the numbers of a set, sets within it included.
template <class Take>
void for_members(const Sets& sets, const std::string& name, std::size_t line, const ShellBuilder& builder,
                 const Take& take, int depth = 0)
{
  const auto at = sets.find(name);
  if (at == sets.end())
    builder.fail(line, "set " + shown(name) + " is not in the file");
  if (depth > 20)
    builder.fail(line, "set " + shown(name) + " holds itself");
  for (const Member& m : at->second.members)
    if (m.name.empty())
      take(m);
    else
      for_members(sets, m.name, m.line, builder, take, depth + 1);
}

class Placer
{
public:
  Placer(const Deck& deck, ShellBuilder& builder) : deck_(deck), builder_(builder) {}

  void place()
  {
    const bool root_has_mesh = !deck_.root.nodes.empty();
    several_ = deck_.instances.size() + (root_has_mesh && !deck_.root.elements.empty()) > 1;
    std::int64_t offset = 0;
    builder_.numbers_repeat_after(stride);
    add(deck_.root, Eigen::Isometry3d::Identity(), "", offset); // an assembly may have nodes of its own
    for (const Instance& instance : deck_.instances) {
      offset += stride;
      const auto part = deck_.parts.find(instance.part);
      if (part == deck_.parts.end())
        builder_.fail(instance.line, "instance " + shown(instance.name) + " is of part " +
                                         shown(instance.part) + ", which is not in the file");
      offsets_[upper(instance.name)] = offset;
      add(part->second, instance.place, several_ ? instance.name + "." : "", offset);
      add_node_sets(part->second.node_sets, several_ ? instance.name + "." : "", offset);
    }
    add_node_sets(deck_.root.node_sets, "", 0);
    for (const auto& [name, part] : deck_.parts)
      if (std::none_of(deck_.instances.begin(), deck_.instances.end(),
                       [&](const Instance& i) { return i.part == name; }))
        builder_.count("PART without an instance", 0, "left out");
  }

private:
  void add(const Part& part, const Eigen::Isometry3d& place, const std::string& prefix, std::int64_t offset)
  {
    for (const Node& node : part.nodes)
      builder_.node(offset + checked(node.id, node.line), place * node.place, node.line);

    std::map<std::string, const Section*> section_of_set;
    std::map<std::int64_t, const Section*> single;
    std::vector<Span> ranges;
    for (const Section& section : part.sections) {
      section_of_set[section.set] = &section;
      if (!part.element_sets.contains(section.set))
        builder_.count("*SHELL SECTION of a set without elements", section.line, "left out");
      else
        for_members(part.element_sets, section.set, section.line, builder_, [&](const Member& m) {
          if (m.first == m.last)
            single[m.first] = &section;
          else
            ranges.push_back({m.first, m.last, m.step, &section});
        });
    }

    for (const Element& element : part.elements) {
      const Section* section = nullptr;
      if (const auto at = section_of_set.find(element.set); at != section_of_set.end())
        section = at->second;
      else if (const auto by_number = single.find(element.id); by_number != single.end())
        section = by_number->second;
      else
        for (const Span& r : ranges)
          if (element.id >= r.first && element.id <= r.last && (element.id - r.first) % r.step == 0)
            section = r.section;
      const std::string set = section ? section->set : element.set;
      const std::string key = prefix + set;
      std::array<std::int64_t, 4> corners;
      for (int k = 0; k < element.corner_count; ++k)
        corners[k] = offset + checked(element.corners[k], element.line);
      builder_.element(offset + checked(element.id, element.line),
                       std::span(corners).first(static_cast<std::size_t>(element.corner_count)), key,
                       element.line);
      const auto spelled = part.element_sets.find(set);
      builder_.name_part(key, prefix + (set.empty()                          ? part.name
                                        : spelled == part.element_sets.end() ? set
                                                                             : spelled->second.name));
      if (section)
        builder_.set_thickness(key, section->thickness, section->line);
    }
  }

  std::int64_t checked(std::int64_t id, std::size_t line) const
  {
    if (id < 1 || id >= stride)
      builder_.fail(line, "the number " + std::to_string(id) + " must be positive and below " +
                              std::to_string(stride));
    return id;
  }

  void add_node_sets(const Sets& sets, const std::string& prefix, std::int64_t offset)
  {
    for (const auto& [key, set] : sets)
      for_members(sets, key, 0, builder_, [&, name = prefix + set.name](const Member& m) {
        std::int64_t from = offset;
        if (!m.instance.empty()) {
          const auto at = offsets_.find(m.instance);
          if (at == offsets_.end())
            builder_.fail(m.line, "node set " + shown(name) + " is of instance " + shown(m.instance) +
                                      ", which is not in the file");
          from = at->second;
        }
        checked(m.first, m.line);
        checked(m.last, m.line);
        if (m.first == m.last)
          builder_.node_in_set(name, from + m.first, m.line);
        else
          builder_.range_in_set(name, from + m.first, from + m.last, m.step, m.line);
      });
  }

  struct Span
  {
    std::int64_t first, last, step;
    const Section* section;
  };
  const Deck& deck_;
  ShellBuilder& builder_;
  bool several_ = false;
  std::map<std::string, std::int64_t> offsets_;
};

} // namespace

void place_deck(const Deck& deck, ShellBuilder& builder) { Placer(deck, builder).place(); }

} // namespace abaqus

ShellImport read_abaqus(const std::filesystem::path& file, double unit)
{
  ShellBuilder builder(file.string(), unit);
  abaqus::place_deck(abaqus::read_deck(file, builder), builder);
  return std::move(builder).finish();
}

} // namespace birdstrike
