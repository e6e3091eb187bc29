// SPDX-License-Identifier: GPL-3.0-or-later
// Case files: from entries to values, by the table of keys.
#include "cases/case.h"

#include "cases/bird_form.h"
#include "cases/case_entries.h"
#include "cases/column.h"
#include "cases/complete_target.h"
#include "cases/keys.h"
#include "cases/shape_parts_case.h"
#include "core/error.h"
#include "core/material/porous_bird.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace birdstrike {
namespace {

//! Of a bird for which nobody says how fine it shall be.
constexpr int usual_particles = 20000;

//! Puts one entry's value where its key says.
class Assignment
{
public:
  Assignment(const Entry& entry, const Key& key) : entry_(entry), key_(key) {}

  void operator()(double* slot) const { *slot = real(single()); }
  void operator()(int* slot) const { *slot = integer(single()); }
  void operator()(std::array<double, 2>* slot) const
  {
    list_of(2);
    *slot = {real(entry_.values[0]), real(entry_.values[1])};
  }
  void operator()(std::array<double, 3>* slot) const
  {
    list_of(3);
    *slot = {real(entry_.values[0]), real(entry_.values[1]), real(entry_.values[2])};
  }
  void operator()(std::array<int, 2>* slot) const
  {
    list_of(2);
    *slot = {integer(entry_.values[0]), integer(entry_.values[1])};
  }
  void operator()(bool* slot) const
  {
    const bool* value = std::get_if<bool>(&single());
    if (!value)
      fail(kind_of(key_) + " is needed");
    *slot = *value;
  }
  void operator()(std::string* slot) const { *slot = text(); }
  void operator()(std::vector<std::string>* slot) const
  {
    slot->clear();
    for (const Scalar& value : entry_.values)
      if (const auto* one = std::get_if<std::string>(&value))
        slot->push_back(*one);
      else
        fail(kind_of(key_) + " is needed");
    for (const std::string& one : *slot)
      if (key_.choices)
        check_choice(one);
  }
  void operator()(ViscosityKind* slot) const { *slot = viscosity_kind(text()); }

private:
  [[noreturn]] void fail(const std::string& problem) const
  {
    throw InputError(fmt::format("{}: {} = {}: {}", entry_.place, join(entry_.path), entry_.found, problem));
  }

  const Scalar& single() const
  {
    if (entry_.is_list || entry_.values.size() != 1)
      fail(kind_of(key_) + " is needed");
    return entry_.values.front();
  }

  void list_of(std::size_t count) const
  {
    if (!entry_.is_list || entry_.values.size() != count)
      fail(kind_of(key_) + " is needed");
  }

  void check_range(double value) const
  {
    const Range& range = key_.range;
    const bool low = !range.low || value > *range.low || (value == *range.low && !range.low_open);
    if (!low || (range.high && value > *range.high))
      fail(fmt::format("allowed is {}", describe(range, key_.dimension)));
  }

  double real(const Scalar& scalar) const
  {
    double value = 0;
    const std::string* written = std::get_if<std::string>(&scalar);
    if (key_.dimension == Dimension::number) {
      if (const auto* whole = std::get_if<std::int64_t>(&scalar))
        value = static_cast<double>(*whole);
      else if (const auto* fraction = std::get_if<double>(&scalar))
        value = *fraction;
      else
        fail("a number without unit and quotes is needed, for example 1.25");
      if (!(value - value == 0))
        fail("a finite number is needed");
    } else {
      if (const auto named = written && key_.by_name ? key_.by_name(*written) : std::nullopt)
        return *named;
      try {
        // A bare number lacks its unit: let the same place complain about it as for "6".
        value = parse_quantity(written ? *written : entry_.is_list ? "1" : entry_.found, key_.dimension);
      } catch (const InputError& error) {
        fail(error.what());
      }
    }
    check_range(value);
    return value;
  }

  int integer(const Scalar& scalar) const
  {
    const auto* value = std::get_if<std::int64_t>(&scalar);
    if (!value)
      fail(kind_of(key_) + " is needed");
    check_range(static_cast<double>(*value));
    if (*value != static_cast<int>(*value))
      fail(fmt::format("allowed is at most {} in size", std::numeric_limits<int>::max()));
    return static_cast<int>(*value);
  }

  std::string text() const
  {
    const Scalar& scalar = single();
    const std::string* value = std::get_if<std::string>(&scalar);
    std::string result;
    if (value)
      result = *value;
    else if (entry_.place == "--set") // --set title=7: the shell eats quotes, a text is meant
      result = entry_.found;
    else
      fail(kind_of(key_) + " is needed");
    if (key_.choices && !key_.or_law)
      check_choice(result);
    return result;
  }

  void check_choice(const std::string& chosen) const
  {
    const std::vector<std::string> choices = key_.choices();
    if (std::find(choices.begin(), choices.end(), chosen) == choices.end())
      fail(kind_of(key_) + " is needed");
  }

  const Entry& entry_;
  const Key& key_;
};

[[noreturn]] void unknown_key(const Entry& entry)
{
  const std::string path = join(entry.path);
  for (const Key& key : case_keys())
    if (named(key, entry.path).starts_with(path + "."))
      throw InputError(fmt::format("{}: {} = {}: this is a table of keys, for example {}", entry.place, path,
                                   entry.found, named(key, entry.path)));
  const std::string nearest = nearest_key(entry.path);
  throw InputError(fmt::format("{}: unknown key {}; {}", entry.place, path,
                               nearest.empty() ? "`birdstrike cases --keys` lists the known ones"
                                               : fmt::format("did you mean {}?", nearest)));
}

//! "[run]" with nothing below it: the keys that it lacks are complained about one by one.
bool is_empty_section(const Entry& entry)
{
  const std::string prefix = join(entry.path) + ".";
  return entry.is_table && std::any_of(case_keys().begin(), case_keys().end(),
                                       [&](const Key& key) { return key.path.starts_with(prefix); });
}

//! Where the paths with '*' and those without are given, all required ones have to be.
//! \param within  only keys whose path starts so
void require_keys(const Case& parsed, const std::set<std::string>& given, const std::string& file,
                  std::string_view within)
{
  for (const Key& key : case_keys()) {
    if (!key.required || !key.path.starts_with(within) || (key.only && !key.only->holds(parsed)) ||
        (key.unless && key.unless->holds(parsed)))
      continue;
    std::vector<std::string> paths{std::string(key.path)};
    if (const std::size_t star = key.path.find('*'); star != std::string_view::npos) {
      paths.clear();
      for (const std::string& name : names_for(parsed, key))
        paths.push_back(std::string(key.path.substr(0, star)) + name +
                        std::string(key.path.substr(star + 1)));
    }
    for (const std::string& path : paths)
      if (!given.contains(path))
        throw InputError(
            fmt::format("{}: {} is missing: {} is needed ({})", file, path, kind_of(key), key.text));
  }
}

std::string place_of(const std::map<std::string, std::string>& places, const std::string& path,
                     const std::string& file)
{
  const auto found = places.find(path);
  return found == places.end() ? file : found->second;
}

//! Stand beside the parts' own numbers, as max_pressure_all and theory.hugoniot_pressure do.
constexpr std::array<std::string_view, 5> taken_names{"all", "hugoniot_pressure", "stagnation_bernoulli",
                                                      "stagnation_standing_shock",
                                                      "compliant_target_pressure"};

//! Names of laws exist and are nobody else's, and every part has the porosity that its law needs.
//! \param places  of the keys that were given
void check_part_laws(const Case& parsed, const std::map<std::string, std::string>& places,
                     const std::string& file)
{
  const Key& eos = *find_key({"bird", "parts", "*", "eos"});
  const Key& porosity = *find_key({"bird", "parts", "*", "porosity"});
  const std::vector<std::string> porous = eos.choices();
  for (const LawCase& law : parsed.laws)
    if (std::find(porous.begin(), porous.end(), law.name) != porous.end())
      throw InputError(fmt::format("{}: eos.{}: this name is taken by a law of porous flesh; choose another",
                                   law.place, law.name));
  for (const PartCase& part : parsed.bird.parts) {
    const std::string path = "bird.parts." + part.name;
    require(
        std::find(taken_names.begin(), taken_names.end(), part.name) == taken_names.end(),
        fmt::format("{}: {}: \"{}\" is the name of a number in histories.csv and summary.json, which a part "
                    "of that name would replace; call the part otherwise",
                    file, path, part.name));
    const bool by_density = places.contains(path + ".density");
    if (by_density && places.contains(path + ".porosity") && part.porosity != 0)
      throw InputError(
          fmt::format("{}: {}.density and .porosity are both given: one says the other; leave one out",
                      places.at(path + ".density"), path));
    if (std::any_of(parsed.laws.begin(), parsed.laws.end(),
                    [&](const LawCase& law) { return law.name == part.eos; }))
    {
      if (part.porosity != 0)
        throw InputError(fmt::format("{}: {}.porosity = {}: the law \"{}\" has none; leave the porosity out",
                                     place_of(places, path + ".porosity", file), path, part.porosity,
                                     part.eos));
    } else if (std::find(porous.begin(), porous.end(), part.eos) == porous.end()) {
      std::string own;
      for (const LawCase& law : parsed.laws)
        own += fmt::format(", \"{}\"", law.name);
      throw InputError(fmt::format("{}: {}.eos = {}: {} is needed{}", place_of(places, path + ".eos", file),
                                   path, toml_string(part.eos), kind_of(eos),
                                   own.empty() ? "; the case has none" : "; the case has " + own.substr(2)));
    } else if (by_density) {
      const double densest = porous_density(porosity.range.low.value_or(0)),
                   lightest = porous_density(porosity.range.high.value_or(1));
      if (part.density < lightest || part.density > densest)
        throw InputError(fmt::format(
            "{}: {}.density = {:g} kg/m3: the law \"{}\" is one of water with air, from {:.1f} to "
            "{:.0f} kg/m3; another density needs an own law [eos.NAME]",
            places.at(path + ".density"), path, part.density, part.eos, lightest, densest));
    } else if (!places.contains(path + ".porosity")) {
      throw InputError(fmt::format("{}: {}.porosity is missing: {} is needed ({})", file, path,
                                   kind_of(porosity), porosity.text));
    }
  }
}

std::string bird_of(const Case& parsed)
{
  for (const auto& [key, value] : {std::pair{"shape", &parsed.bird.shape}, {"species", &parsed.bird.species}})
    if (!value->empty())
      return fmt::format("bird.{} = {}", key, toml_string(*value));
  return fmt::format("bird.mesh = {}", toml_string(parsed.bird.mesh));
}

std::string target_of(const Case& parsed)
{
  return fmt::format("target.shape = {} and target.rigid = {}", toml_string(parsed.target.shape),
                     parsed.target.rigid);
}

//! What of a case decides whether a key has a meaning; empty if the key's condition says it.
std::string facts_for(const Case& parsed, const std::string& table)
{
  if (table == "run" || table == "series")
    return "";
  if (table == "bird" || is_column(parsed))
    return bird_of(parsed);
  return table == "transducers" ? bird_of(parsed) + ", " + target_of(parsed) : target_of(parsed);
}

//! Nobody should think that a key does something where it does not.
void refuse_idle_keys(const Case& parsed, const std::vector<Entry>& entries)
{
  for (const Entry& entry : entries)
    if (const Key* key = find_key(entry.path); key && key->only && !key->only->holds(parsed)) {
      const std::string facts = facts_for(parsed, entry.path.front());
      throw InputError(fmt::format("{}: {} = {}: this key is only for {}{}", entry.place, join(entry.path),
                                   entry.found, key->only->text,
                                   facts.empty() ? "; leave it out" : ", and this case has " + facts));
    }
}

void check_bird(Case& parsed, const std::set<std::string>& given, const std::string& file)
{
  BirdCase& bird = parsed.bird;
  const std::pair<const char*, const std::string*> sources[] = {
      {"mesh", &bird.mesh}, {"shape", &bird.shape}, {"species", &bird.species}};
  for (const auto& [key, value] : sources)
    for (const auto& [other, besides] : sources)
      if (value < besides && !value->empty() && !besides->empty())
        throw InputError(
            fmt::format("{}: both bird.{} = {} and bird.{} = {} are given: exactly one of them is needed",
                        file, key, toml_string(*value), other, toml_string(*besides)));
  if (!bird.species.empty() && !given.contains("bird.mass"))
    bird.mass = species_mass(bird.species);
  if (bird.shape == "sphere" && !given.contains("bird.length_over_diameter"))
    bird.length_over_diameter = 1;
}

//! Parts and transducers, once all keys are known.
void check_tables(const Case& parsed, const std::string& file)
{
  const BirdCase& bird = parsed.bird;
  if (bird.parts.empty() && bird.species.empty())
    throw InputError(
        fmt::format("{}: bird.parts is missing: every part of the {} needs its porosity, for example "
                    "torso = {{ porosity = 0.6 }} under [bird.parts]",
                    file, bird.mesh.empty() ? "bird" : "mesh"));
  if (!bird.shape.empty() && !is_column(parsed))
    check_shape_parts(parsed);
  for (const TransducerCase& one : parsed.transducers) {
    const std::string place = fmt::format("{}: transducers.{}", file, one.name);
    if (one.name.find_first_of(",\"\n\r") != std::string::npos)
      throw InputError(place +
                       ": the name must do for a title in transducers.csv: no comma, quote or line break");
    if (one.steady_from >= one.steady_to)
      throw InputError(fmt::format("{}.steady_from = {} must be below steady_to = {}", place, one.steady_from,
                                   one.steady_to));
    for (int k = 0; k < 2; ++k)
      if (std::abs(one.centre[k]) + 0.5 * one.diameter > 0.5 * parsed.target.size[k])
        throw InputError(
            fmt::format("{}: its face reaches to {:g} m {}, beyond the plate, which ends at {:g} m; "
                        "move the transducer or enlarge target.plate.size",
                        place, std::abs(one.centre[k]) + 0.5 * one.diameter, k == 0 ? "sideways" : "upwards",
                        0.5 * parsed.target.size[k]));
  }
}

//! The keys that entries give, and where each was written.
struct Given
{
  std::set<std::string> keys;
  std::map<std::string, std::string> places;
};

//! Puts all entries where they belong.
Given assign(const std::vector<Entry>& entries, Case& parsed)
{
  Given result;
  for (const Entry& entry : entries) {
    if (entry.is_table && make_empty_row(parsed, entry.path))
      continue;
    if (is_empty_section(entry))
      continue;
    const Key* key = find_key(entry.path);
    if (!key)
      unknown_key(entry);
    if (entry.is_table)
      throw InputError(fmt::format("{}: {} is an empty table: {} is needed", entry.place, join(entry.path),
                                   kind_of(*key)));
    const std::size_t row = row_for(parsed, *key, entry.path);
    if (key->path.starts_with("eos.") && parsed.laws[row].place.empty())
      parsed.laws[row].place = entry.place;
    std::visit(Assignment(entry, *key), key->slot(parsed, row));
    result.keys.insert(join(entry.path));
    result.places[join(entry.path)] = entry.place;
    if (key->dimension != Dimension::number)
      parsed.written[join(entry.path)] = entry.found;
  }
  return result;
}

//! An override of one of these takes the place of the other.
constexpr std::array<const char*, 3> rivals[] = {{"bird", "spacing", "particles"},
                                                 {"run", "frames", "interval"}};

void override_all(std::vector<Entry>& entries, const std::vector<Entry>& overrides)
{
  for (const Entry& entry : overrides) {
    for (const auto& [table, one, other] : rivals)
      for (const auto& [given, gone] : {std::pair{one, other}, {other, one}})
        if (entry.path == std::vector<std::string>{table, given})
          std::erase_if(entries, [&, lost = std::vector<std::string>{table, gone}](const Entry& e) {
            return e.path == lost && !std::any_of(overrides.begin(), overrides.end(),
                                                  [&](const Entry& o) { return o.path == e.path; });
          });
    apply_override(entries, entry);
  }
}

} // namespace

std::optional<double> usual_porosity(std::string_view part)
{
  static constexpr std::pair<std::string_view, double> usual[] = {
      {"head", 0.3},  {"neck", 0.3},  {"torso", 0.6}, {"wings", 0.7},
      {"bones", 0.2}, {"lungs", 0.8}, {"legs", 0.2}};
  for (const auto& [name, porosity] : usual)
    if (name == part)
      return porosity;
  return std::nullopt;
}

std::vector<std::string> exact_names() { return {"mass", "density", "particle-mass"}; }

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  std::vector<Entry> entries;
  for (const std::string& text : overrides)
    entries.push_back(parse_override(text));
  return read_case_with(file, entries);
}

Case read_case_with(const std::filesystem::path& file, const std::vector<Entry>& overrides)
{
  std::vector<Entry> entries = read_entries(file);
  if (is_study(entries))
    throw InputError(
        fmt::format("{0}: this is a study, a set of runs: `birdstrike study {0}` runs it", file.string()));
  override_all(entries, overrides);

  Case parsed;
  parsed.file = file;
  const auto [given, places] = assign(entries, parsed);
  require_keys(parsed, given, file.string(), "");
  check_bird(parsed, given, file.string());
  refuse_idle_keys(parsed, entries);
  check_part_laws(parsed, places, file.string());
  // Each kind of viscosity has its own constants, where the case gives none.
  const Viscosity usual = usual_viscosity(parsed.run.viscosity.kind);
  if (!given.contains("run.viscosity_linear"))
    parsed.run.viscosity.linear = usual.linear;
  if (!given.contains("run.viscosity_quadratic"))
    parsed.run.viscosity.quadratic = usual.quadratic;
  complete_target(parsed, given.contains("target.contact"));
  check_tables(parsed, file.string());
  if (is_column(parsed))
    complete_column(parsed, given.contains("run.end"));
  return parsed;
}

Case bird_alone(const std::vector<Entry>& overrides, const std::string& name,
                const std::filesystem::path& file)
{
  Case parsed;
  parsed.file = file;
  parsed.alone = true;
  std::vector<Entry> entries = file.empty() ? std::vector<Entry>() : read_entries(file);
  override_all(entries, overrides);
  for (const Entry& entry : entries)
    if (const std::string& table = entry.path.front();
        table != "bird" && table != "eos" && table != "title" && table != "source")
      throw InputError(fmt::format("{}: {} = {}: a bird without a target has only the keys bird.* and eos.*",
                                   entry.place, join(entry.path), entry.found));
  auto [given, places] = assign(entries, parsed);
  BirdCase& bird = parsed.bird;
  bird.velocity = given.contains("bird.velocity") ? bird.velocity : 0;
  given.insert("bird.velocity");
  if (!given.contains("bird.spacing") && !given.contains("bird.particles")) {
    bird.particles = usual_particles;
    given.insert("bird.particles");
  }
  if (!given.contains("bird.mass") && !given.contains("bird.exact") && bird.species.empty())
    bird.exact = "density";
  require_keys(parsed, given, name, "bird.");
  check_bird(parsed, given, name);
  refuse_idle_keys(parsed, entries);
  for (PartCase& part : parsed.bird.parts) // the usual porosity of a part that only got patterns
    if (const auto usual = usual_porosity(part.name);
        usual && !places.contains("bird.parts." + part.name + ".porosity") && std::isnan(part.density) &&
        part.eos == PartCase().eos)
    {
      part.porosity = *usual;
      places["bird.parts." + part.name + ".porosity"] = name;
    }
  check_part_laws(parsed, places, name);
  if (!bird.shape.empty() && bird.parts.empty())
    throw InputError(
        fmt::format("{}: bird.parts is missing: every part of the bird needs its porosity, for example "
                    "torso = {{ porosity = 0.6 }} under [bird.parts]",
                    name));
  if (!bird.shape.empty() && !is_column(parsed))
    check_shape_parts(parsed);
  return parsed;
}

} // namespace birdstrike
