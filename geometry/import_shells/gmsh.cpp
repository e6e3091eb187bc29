// SPDX-License-Identifier: GPL-3.0-or-later
// Shells from Gmsh meshes. Format: Gmsh reference manual, "MSH file format" and "MSH file format version 2".
// Long, because the two versions share their words, groups and errors.
#include "geometry/import_shells/gmsh.h"

#include "core/error.h"
#include "geometry/import_shells/text_lines.h"

#include <cstdlib>
#include <fstream>
#include <map>

namespace birdstrike {

namespace {

struct Kind
{
  int dimension;
  int corners;
  int nodes;
  const char* name;
};

//! By Gmsh's element type.
const std::map<std::int64_t, Kind> kinds = {
    {1, {1, 2, 2, "line"}},
    {2, {2, 3, 3, "triangle"}},
    {3, {2, 4, 4, "quad"}},
    {4, {3, 4, 4, "tetrahedron"}},
    {5, {3, 8, 8, "hexahedron"}},
    {6, {3, 6, 6, "prism"}},
    {7, {3, 5, 5, "pyramid"}},
    {8, {1, 2, 3, "3-node line"}},
    {9, {2, 3, 6, "6-node triangle"}},
    {10, {2, 4, 9, "9-node quad"}},
    {11, {3, 4, 10, "10-node tetrahedron"}},
    {12, {3, 8, 27, "27-node hexahedron"}},
    {13, {3, 6, 18, "18-node prism"}},
    {14, {3, 5, 14, "14-node pyramid"}},
    {15, {0, 1, 1, "point"}},
    {16, {2, 4, 8, "8-node quad"}},
    {17, {3, 8, 20, "20-node hexahedron"}},
    {18, {3, 6, 15, "15-node prism"}},
    {19, {3, 5, 13, "13-node pyramid"}},
    {20, {2, 3, 9, "9-node triangle"}},
    {21, {2, 3, 10, "10-node triangle"}},
    {26, {1, 2, 4, "4-node line"}},
    {36, {2, 4, 16, "16-node quad"}},
};

constexpr const char* as_text = "export it as text (Mesh.Binary = 0, or gmsh without -bin)";

using Key = std::pair<int, std::int64_t>; // dimension and tag

//! Words one after the other, whatever the lines.
class Reader
{
public:
  Reader(const std::filesystem::path& file, double unit)
      : builder_(file.string(), unit), lines_(file, as_text)
  {
  }

  ShellImport read()
  {
    read_format();
    while (row_ < lines_.size()) {
      const std::string name(trimmed(lines_[row_++]));
      if (name.empty())
        continue;
      if (name[0] != '$')
        builder_.fail(row_, "text " + shown(name) + " stands outside all sections");
      section_ = name.substr(1);
      section_line_ = row_;
      if (section_ == "PhysicalNames")
        read_names();
      else if (section_ == "Entities")
        read_entities();
      else if (section_ == "Nodes")
        version_4_ ? read_nodes_4() : read_nodes_2();
      else if (section_ == "Elements")
        version_4_ ? read_elements_4() : read_elements_2();
      else {
        if (section_ != "Comments")
          builder_.count("section " + section_, row_);
        while (row_ < lines_.size() && trimmed(lines_[row_]) != "$End" + section_)
          ++row_;
      }
      end_section();
    }
    return std::move(builder_).finish();
  }

private:
  void read_format()
  {
    while (row_ < lines_.size() && trimmed(lines_[row_]) != "$MeshFormat")
      ++row_;
    if (row_ + 1 >= lines_.size())
      builder_.fail(0, "this is no Gmsh mesh: $MeshFormat is missing");
    row_ += 1;
    const auto fields = words(lines_[row_]);
    const auto version = fields.size() == 3 ? to_real(fields[0]) : std::nullopt;
    if (!version)
      builder_.fail(row_ + 1, "the mesh format " + shown(lines_[row_]) + " is not 'version 0 size'");
    if (fields[1] != "0")
      builder_.fail(row_ + 1, std::string("the mesh is binary; ") + as_text);
    version_4_ = *version >= 4;
    if (!(*version >= 2 && *version < 3) && !(*version > 4.05 && *version < 5))
      builder_.fail(row_ + 1, "mesh format " + shown(fields[0]) +
                                  " is not read; export format 4.1 or 2.2 (gmsh -format msh41 or msh22)");
    section_ = "MeshFormat";
    section_line_ = row_++;
    end_section();
  }

  [[noreturn]] void cut_short()
  {
    builder_.fail(section_line_, "section $" + section_ +
                                     " does not end or holds fewer rows than it says; the file may be cut "
                                     "short: export it again");
  }

  std::string_view word()
  {
    while (at_ >= words_.size()) {
      if (row_ >= lines_.size() || trimmed(lines_[row_]).starts_with('$'))
        cut_short();
      words_ = words(lines_[row_++]);
      at_ = 0;
    }
    return words_[at_++];
  }

  std::int64_t integer(const char* what)
  {
    const std::string_view text = word();
    const auto value = to_integer(text);
    if (!value)
      builder_.fail(row_, std::string(what) + " " + shown(text) + " must be a whole number");
    return *value;
  }

  double real(const char* what)
  {
    const std::string_view text = word();
    const auto value = to_real(text);
    if (!value)
      builder_.fail(row_, std::string(what) + " " + shown(text) + " must be a number");
    return *value;
  }

  void end_section()
  {
    while (row_ < lines_.size() && trimmed(lines_[row_]).empty())
      ++row_;
    if (at_ < words_.size() || (row_ < lines_.size() && trimmed(lines_[row_])[0] != '$'))
      builder_.fail(at_ < words_.size() ? row_ : row_ + 1,
                    "section $" + section_ + " holds more than it says, or a word too many");
    if (row_ >= lines_.size() || trimmed(lines_[row_]) != "$End" + section_)
      cut_short();
    ++row_;
    words_.clear();
    at_ = 0;
  }

  void read_names()
  {
    const std::int64_t number = integer("the number of names");
    for (std::int64_t k = 0; k < number; ++k) {
      const int dimension = static_cast<int>(integer("the dimension of a physical name"));
      const std::int64_t tag = integer("the tag of a physical name");
      // Names may hold blanks: the rest of the line.
      const std::string& line = lines_[row_ - 1];
      const std::size_t quote = line.find('"');
      names_[{dimension, tag}] =
          quote == std::string::npos ? std::string(word()) : std::string(unquoted(line.substr(quote)));
      words_.clear();
      at_ = 0;
    }
  }

  void read_entities()
  {
    std::int64_t numbers[4];
    for (std::int64_t& n : numbers)
      n = integer("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t k = 0; k < numbers[dimension]; ++k) {
        const std::int64_t tag = integer("the tag of an entity");
        for (int c = 0; c < (dimension ? 6 : 3); ++c)
          real("a bound of an entity");
        const std::int64_t groups = integer("the number of physical tags");
        for (std::int64_t g = 0; g < groups; ++g)
          physical_[{dimension, tag}].push_back(
              std::abs(integer("a physical tag"))); // negative: turned round
        for (std::int64_t b = dimension ? integer("the number of bounding entities") : 0; b > 0; --b)
          integer("a bounding entity");
      }
  }

  Vector3 place()
  {
    const double x = real("a coordinate"), y = real("a coordinate");
    return {x, y, real("a coordinate")};
  }

  void read_nodes_2()
  {
    const std::int64_t number = integer("the number of nodes");
    for (std::int64_t k = 0; k < number; ++k) {
      const std::int64_t id = integer("a node's number");
      const Vector3 at = place();
      builder_.node(id, at, row_);
    }
  }

  void read_nodes_4()
  {
    const std::int64_t blocks = integer("the number of node blocks");
    for (int k = 0; k < 3; ++k)
      integer("the number of nodes");
    for (std::int64_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = integer("the dimension of an entity");
      integer("the tag of an entity");
      const bool parametric = integer("the parametric flag") != 0;
      const std::int64_t number = integer("the number of nodes of a block");
      std::vector<std::pair<std::int64_t, std::size_t>>
          ids; // grows as read: a wrong number asks for no memory
      for (std::int64_t k = 0; k < number; ++k) {
        const std::int64_t id = integer("a node's number");
        ids.emplace_back(id, row_);
      }
      for (const auto& [id, line] : ids) {
        builder_.node(id, place(), line);
        for (std::int64_t k = 0; parametric && k < dimension; ++k)
          real("a parametric coordinate");
      }
    }
  }

  const Kind& kind(std::int64_t type)
  {
    const auto at = kinds.find(type);
    if (at == kinds.end())
      builder_.fail(row_, "element type " + std::to_string(type) +
                              " is not known; export a mesh of triangles and quads of the first order");
    return at->second;
  }

  //! \param group  physical tag, 0 if none
  void add(std::int64_t id, const Kind& kind, std::int64_t group, std::int64_t entity, std::size_t line)
  {
    std::vector<std::int64_t> nodes;
    for (int k = 0; k < kind.nodes; ++k)
      nodes.push_back(integer("a node of an element"));
    const auto name = names_.find({kind.dimension, group});
    if (kind.dimension == 2) {
      const std::string part = (group ? "part_" : "surface_") + std::to_string(group ? group : entity);
      builder_.element(id, std::span(nodes).first(static_cast<std::size_t>(kind.corners)), part, line);
      if (group && name != names_.end())
        builder_.name_part(part, name->second);
      if (kind.nodes > kind.corners)
        builder_.count(kind.name, line, "read with their corners only");
    } else if (kind.dimension < 2 && group) {
      const std::string set = name != names_.end() ? name->second : "set_" + std::to_string(group);
      for (int k = 0; k < kind.corners; ++k) // nodes in the middle are no corners of shells
        builder_.node_in_set(set, nodes[k], line);
    } else
      builder_.count(kind.name, line);
  }

  void read_elements_2()
  {
    const std::int64_t number = integer("the number of elements");
    for (std::int64_t k = 0; k < number; ++k) {
      const std::int64_t id = integer("an element's number");
      const std::size_t line = row_;
      const Kind& type = kind(integer("an element's type"));
      const std::int64_t tags = integer("the number of tags");
      std::int64_t group = 0, entity = 0;
      for (std::int64_t t = 0; t < tags; ++t) {
        const std::int64_t tag = integer("a tag");
        if (t < 2) // partitions follow
          (t == 0 ? group : entity) = std::abs(tag);
      }
      add(id, type, group, entity, line);
    }
  }

  void read_elements_4()
  {
    const std::int64_t blocks = integer("the number of element blocks");
    for (int k = 0; k < 3; ++k)
      integer("the number of elements");
    for (std::int64_t b = 0; b < blocks; ++b) {
      integer("the dimension of an entity");
      const std::int64_t entity = integer("the tag of an entity");
      const Kind& type = kind(integer("an element's type"));
      const std::int64_t number = integer("the number of elements of a block");
      const auto groups = physical_.find({type.dimension, entity});
      const std::int64_t group = groups == physical_.end() || groups->second.empty() ? 0 : groups->second[0];
      for (std::int64_t k = 0; k < number; ++k) {
        const std::int64_t id = integer("an element's number");
        if (group && groups->second.size() > 1)
          builder_.count("elements in several physical groups", row_, "given to the first group");
        add(id, type, group, entity, row_);
      }
    }
  }

  ShellBuilder builder_;
  TextLines lines_;
  bool version_4_ = false;
  std::size_t row_ = 0; // of the next line, so the number of the line that words_ came from
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
  std::string section_;
  std::size_t section_line_ = 0;
  std::map<Key, std::string> names_;
  std::map<Key, std::vector<std::int64_t>> physical_;
};

//! Binary meshes are told apart by their header, before anything asks for text.
void refuse_binary(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string title, format;
  if (std::getline(in, title) && std::getline(in, format) && trimmed(title) == "$MeshFormat") {
    const auto fields = words(format);
    require(fields.size() < 2 || fields[1] == "0",
            "target file '" + file.string() + "' is a binary Gmsh mesh; " + as_text);
  }
}

} // namespace

ShellImport read_gmsh(const std::filesystem::path& file, double unit)
{
  refuse_binary(file);
  return Reader(file, unit).read();
}

} // namespace birdstrike
