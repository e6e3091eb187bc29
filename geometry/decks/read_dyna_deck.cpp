// SPDX-License-Identifier: GPL-3.0-or-later
// Particles from an LS-DYNA keyword deck, standard columns or commas.
#include "geometry/decks/deck_builder.h"

#include <algorithm>
#include <initializer_list>

namespace birdstrike {

namespace {

class Reader
{
public:
  Reader(const std::filesystem::path& file, const TextLines& lines, const std::string& units)
      : lines_(lines), builder_(file, lines, DeckFormat::dyna, units)
  {
  }

  DeckBird read()
  {
    while (row_ < lines_.size()) {
      const std::string& text = lines_[row_++];
      if (!text.starts_with('*'))
        continue;
      const std::string keyword = upper(words(text)[0]);
      if (keyword == "*END")
        break;
      take(keyword, upper(text));
    }
    join();
    return builder_.finish();
  }

private:
  struct Generation
  {
    std::int64_t target, kind; // 1 part set, 2 part
    Vector3 velocity;
    std::size_t line;
  };

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
  std::string_view line_of(const std::string& keyword)
  {
    std::string_view line;
    builder_.check(next(line), row_, keyword + " ends before its card; the file may be cut short");
    return line;
  }
  static std::vector<std::string_view> fields(std::string_view line,
                                              std::initializer_list<std::size_t> widths)
  {
    std::vector<std::string_view> found;
    if (line.find(',') != std::string_view::npos) {
      found = split(line, ',');
    } else {
      std::size_t at = 0;
      for (const std::size_t width : widths) {
        found.push_back(columns(line, at, width));
        at += width;
      }
    }
    found.resize(std::max(found.size(), widths.size()));
    return found;
  }
  static std::vector<std::string_view> tens(std::string_view line)
  {
    return fields(line, {10, 10, 10, 10, 10, 10, 10, 10});
  }
  Vector3 vector(const std::vector<std::string_view>& f, std::size_t first, const char* what) const
  {
    return {builder_.real_or_zero(f[first], row_, what), builder_.real_or_zero(f[first + 1], row_, what),
            builder_.real_or_zero(f[first + 2], row_, what)};
  }

  void take(const std::string& keyword, const std::string& whole)
  {
    if (keyword == "*KEYWORD") {
      builder_.check(whole.find("LONG=Y") == std::string::npos && whole.find("LONG=K") == std::string::npos,
                     row_, "the deck is in the long format; write it in the standard one");
    } else if (keyword.starts_with("*INCLUDE") || keyword.starts_with("*NODE_TRANSFORM")) {
      builder_.fail(row_, keyword + " is not followed; export the bird as one deck");
    } else if (keyword == "*NODE") {
      nodes();
    } else if (keyword == "*ELEMENT_SPH") {
      elements();
    } else if (keyword.starts_with("*ELEMENT_SPH")) {
      builder_.fail(row_, keyword + " is not understood; write masses with *ELEMENT_SPH");
    } else if (keyword == "*PART") {
      part();
    } else if (keyword.starts_with("*MAT_") && !keyword.starts_with("*MAT_ADD")) {
      material(keyword);
    } else if (keyword == "*SET_PART_LIST") {
      part_set();
    } else if (keyword == "*INITIAL_VELOCITY_GENERATION") {
      generation();
    } else if (keyword == "*INITIAL_VELOCITY_NODE") {
      for (std::string_view line; next(line);) {
        const auto f = tens(line);
        builder_.node_velocity[builder_.integer(f[0], row_, "the node")] = vector(f, 1, "a velocity");
      }
    }
  }

  void nodes()
  {
    for (std::string_view line; next(line);) {
      if (trimmed(line).empty())
        continue;
      const auto f = fields(line, {8, 16, 16, 16});
      builder_.add_node(builder_.integer(f[0], row_, "the number of a node"), vector(f, 1, "a coordinate"),
                        row_);
    }
  }

  void elements()
  {
    for (std::string_view line; next(line);) {
      if (trimmed(line).empty())
        continue;
      const auto f = fields(line, {8, 8, 16, 10});
      builder_.check(
          builder_.real_or_zero(f[3], row_, "the last node") == 0, row_,
          "particles from one node to another in one card are not understood; write each with its mass");
      const double mass = builder_.real(f[2], row_, "a mass");
      elements_.push_back({builder_.integer(f[0], row_, "the number of a particle"),
                           builder_.integer(f[1], row_, "the part of a particle"), mass, row_});
    }
  }

  void part()
  {
    for (std::string_view title; next(title);) {
      const std::string name(trimmed(title));
      const auto f = tens(line_of("*PART"));
      const std::int64_t id = builder_.integer(f[0], row_, "the number of a part");
      builder_.parts[id].name = name;
      material_of_part_[id] =
          trimmed(f[2]).empty() ? 0 : builder_.integer(f[2], row_, "the material of a part");
    }
  }

  void material(const std::string& keyword)
  {
    std::string_view line;
    if (keyword.ends_with("_TITLE"))
      next(line);
    if (!next(line))
      return;
    const auto f = tens(line);
    // Materials that are not for particles may have other cards; only what can be read counts.
    const auto id = to_integer(f[0]);
    const auto density = to_real(f[1]);
    if (id && density)
      density_[*id] = *density;
  }

  void part_set()
  {
    const std::int64_t id = builder_.integer(tens(line_of("*SET_PART_LIST"))[0], row_, "the number of a set");
    for (std::string_view line; next(line);)
      for (const std::string_view field : tens(line))
        if (!field.empty() && field != "0")
          part_sets_[id].push_back(builder_.integer(field, row_, "a part of a set"));
  }

  void generation()
  {
    const auto f = tens(line_of("*INITIAL_VELOCITY_GENERATION"));
    builder_.check(builder_.real_or_zero(f[2], row_, "the rotation") == 0, row_,
                   "an initial rotation is not understood");
    const std::int64_t target = trimmed(f[0]).empty() ? 0 : builder_.integer(f[0], row_, "the set");
    const std::int64_t kind = trimmed(f[1]).empty() ? 1 : builder_.integer(f[1], row_, "the kind of set");
    builder_.check(kind == 1 || kind == 2, row_, "velocities are read for parts and sets of parts only");
    generations_.push_back({target, kind, vector(f, 3, "a velocity"), row_});
  }

  void join()
  {
    for (const auto& [id, material] : material_of_part_)
      if (const auto found = density_.find(material); found != density_.end())
        builder_.parts[id].density = found->second;
    for (const Generation& g : generations_) {
      if (g.target == 0)
        builder_.velocity = g.velocity;
      else if (g.kind == 2)
        builder_.part_velocity[g.target] = g.velocity;
      else
        for (const std::int64_t part : part_sets_[g.target])
          builder_.part_velocity[part] = g.velocity;
    }
    for (const Element& e : elements_) {
      double mass = e.mass;
      if (mass < 0) { // a volume
        const double density = builder_.parts[e.part].density;
        builder_.check(density > 0, e.line,
                       "the particle has a volume (a negative mass), but its part no density");
        mass *= -density;
      }
      builder_.check(mass > 0, e.line, "particle " + std::to_string(e.id) + " has no mass");
      builder_.add_particle(e.id, e.part, mass, e.line);
    }
  }

  struct Element
  {
    std::int64_t id, part;
    double mass;
    std::size_t line;
  };

  const TextLines& lines_;
  DeckBuilder builder_;
  std::size_t row_ = 0;
  std::vector<Element> elements_;
  std::map<std::int64_t, std::int64_t> material_of_part_;
  std::map<std::int64_t, double> density_;
  std::map<std::int64_t, std::vector<std::int64_t>> part_sets_;
  std::vector<Generation> generations_;
};

} // namespace

DeckBird read_dyna_deck(const std::filesystem::path& file, const TextLines& lines, const std::string& units)
{
  return Reader(file, lines, units).read();
}

} // namespace birdstrike
