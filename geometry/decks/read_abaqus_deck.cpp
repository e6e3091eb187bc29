// SPDX-License-Identifier: GPL-3.0-or-later
// Particles from an Abaqus input file without parts and assembly.
#include "geometry/decks/deck_builder.h"

namespace birdstrike {

namespace {

class Reader
{
public:
  Reader(const std::filesystem::path& file, const TextLines& lines, const std::string& units)
      : lines_(lines), builder_(file, lines, DeckFormat::abaqus, units)
  {
  }

  DeckBird read()
  {
    while (row_ < lines_.size()) {
      const std::string& text = lines_[row_++];
      if (!text.starts_with('*') || text.starts_with("**"))
        continue;
      take(split(text, ','));
    }
    join();
    return builder_.finish();
  }

private:
  struct Section
  {
    std::string material;
    double length; // characteristic
    std::size_t line;
  };
  struct Element
  {
    std::int64_t node;
    std::size_t line;
  };
  //! The next data line.
  bool next(std::string_view& line)
  {
    while (row_ < lines_.size() && lines_[row_].starts_with("**"))
      ++row_;
    if (row_ >= lines_.size() || lines_[row_].starts_with('*'))
      return false;
    line = lines_[row_++];
    return true;
  }
  //! What stands behind NAME= among the parameters, as written.
  static std::string parameter(const std::vector<std::string_view>& keyword, std::string_view name)
  {
    for (const std::string_view field : keyword)
      if (const std::size_t equal = field.find('=');
          equal != std::string_view::npos && upper(trimmed(field.substr(0, equal))) == name)
        return std::string(unquoted(field.substr(equal + 1)));
    return {};
  }

  void take(const std::vector<std::string_view>& keyword)
  {
    const std::string name = upper(keyword[0]);
    if (name == "*NODE")
      nodes(parameter(keyword, "NSET"));
    else if (name == "*ELEMENT" && upper(parameter(keyword, "TYPE")) == "PC3D")
      elements(parameter(keyword, "ELSET"));
    else if (name == "*ELSET")
      union_of_sets(parameter(keyword, "ELSET"));
    else if (name == "*SOLID SECTION")
      section(parameter(keyword, "ELSET"), parameter(keyword, "MATERIAL"));
    else if (name == "*MATERIAL")
      material_ = upper(parameter(keyword, "NAME"));
    else if (name == "*DENSITY")
      density();
    else if (name == "*INITIAL CONDITIONS" && upper(parameter(keyword, "TYPE")) == "VELOCITY")
      velocity();
    else if (name == "*INSTANCE" || name == "*INCLUDE")
      builder_.fail(row_, name + " is not followed; write a flat input file, without assembly");
  }

  void nodes(const std::string& set)
  {
    for (std::string_view line; next(line);) {
      const auto f = split(line, ',');
      builder_.check(f.size() >= 4, row_, "a node needs a number and three coordinates");
      const std::int64_t id = builder_.integer(f[0], row_, "the number of a node");
      builder_.add_node(id,
                        {builder_.real(f[1], row_, "a coordinate"), builder_.real(f[2], row_, "a coordinate"),
                         builder_.real(f[3], row_, "a coordinate")},
                        row_);
      if (!set.empty())
        node_sets_[upper(set)].push_back(id);
    }
  }

  void elements(const std::string& set)
  {
    builder_.check(!set.empty(), row_, "*ELEMENT of particles has no ELSET, which would say their part");
    if (elements_.find(upper(set)) == elements_.end())
      names_.push_back(set);
    for (std::string_view line; next(line);) {
      const auto f = split(line, ',');
      builder_.check(f.size() >= 2, row_, "a particle needs a number and a node");
      elements_[upper(set)].push_back({builder_.integer(f[1], row_, "the node of a particle"), row_});
    }
  }

  void union_of_sets(const std::string& set)
  {
    for (std::string_view line; next(line);)
      for (const std::string_view member : split(line, ','))
        if (!member.empty() && !to_integer(member))
          part_of_set_[upper(member)] = set;
  }

  void section(const std::string& set, const std::string& material)
  {
    std::string_view line;
    const std::size_t at = row_;
    const double length =
        next(line) ? builder_.real_or_zero(split(line, ',')[0], row_, "the characteristic length") : 0;
    sections_[upper(set)] = {upper(material), length, at};
  }

  void density()
  {
    std::string_view line;
    builder_.check(next(line), row_, "*DENSITY ends before its line");
    density_[material_] = builder_.real(split(line, ',')[0], row_, "the density");
  }

  void velocity()
  {
    for (std::string_view line; next(line);) {
      const auto f = split(line, ',');
      builder_.check(f.size() >= 3, row_, "an initial velocity needs a set or node, a direction and a value");
      const std::int64_t axis = builder_.integer(f[1], row_, "the direction");
      if (axis < 1 || axis > 3)
        continue; // a rotation
      velocities_[upper(f[0])][static_cast<Eigen::Index>(axis - 1)] = builder_.real(f[2], row_, "a velocity");
    }
  }

  void join()
  {
    // The parts are the sets that the sections' sets belong to, in the order in which they come.
    std::map<std::string, std::int64_t> number;
    for (const std::string& set : names_) {
      const auto above = part_of_set_.find(upper(set));
      const std::string part = above == part_of_set_.end() ? set : above->second;
      const std::int64_t id =
          number.emplace(upper(part), static_cast<std::int64_t>(number.size()) + 1).first->second;
      const auto section = sections_.find(upper(set));
      const std::size_t line = elements_[upper(set)].empty() ? 0 : elements_[upper(set)].front().line;
      builder_.check(section != sections_.end(), line,
                     "the particles of set " + set + " have no *SOLID SECTION");
      const auto rho = density_.find(section->second.material);
      builder_.check(rho != density_.end(), section->second.line,
                     "the material of set " + set + " has no *DENSITY");
      builder_.check(section->second.length > 0, section->second.line,
                     "the *SOLID SECTION of set " + set +
                         " has no characteristic length, from which the mass follows");
      const double side = 2 * section->second.length, mass = rho->second * side * side * side;
      builder_.parts[id] = {part, rho->second, 0};
      for (const Element& element : elements_[upper(set)])
        builder_.add_particle(element.node, id, mass, element.line);
    }
    for (const auto& [target, value] : velocities_) {
      if (const auto node = to_integer(target)) {
        builder_.node_velocity[*node] = value;
      } else {
        const auto set = node_sets_.find(target);
        builder_.check(set != node_sets_.end(), 0,
                       "the initial velocity of node set " + target + " has no nodes");
        for (const std::int64_t node : set->second)
          builder_.node_velocity[node] = value;
      }
    }
  }

  struct ZeroVector : Vector3
  {
    ZeroVector() : Vector3(Vector3::Zero()) {}
  };

  const TextLines& lines_;
  DeckBuilder builder_;
  std::size_t row_ = 0;
  std::vector<std::string> names_; //!< of the sets of particles, as written; all other names in capitals
  std::map<std::string, std::vector<Element>> elements_;
  std::map<std::string, std::string> part_of_set_;
  std::map<std::string, Section> sections_;
  std::map<std::string, std::vector<std::int64_t>> node_sets_;
  std::map<std::string, double> density_;
  std::string material_;
  std::map<std::string, ZeroVector> velocities_;
};

} // namespace

DeckBird read_abaqus_deck(const std::filesystem::path& file, const TextLines& lines, const std::string& units)
{
  return Reader(file, lines, units).read();
}

} // namespace birdstrike
