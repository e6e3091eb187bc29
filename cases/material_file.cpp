// SPDX-License-Identifier: GPL-3.0-or-later
// From TOML tables to a ShellMaterial.
#include "cases/material_file.h"

#include "cases/edit_distance.h"
#include "cases/quantity.h"
#include "cases/share_folder.h"
#include "cases/strict_table.h"
#include "core/error.h"
#include "core/material/johnson_cook.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! A table that knows quantities and remembers which were given.
class QuantityTable
{
public:
  QuantityTable(StrictTable table, std::string name, std::vector<std::string>& given)
      : table_(std::move(table)), name_(std::move(name)), given_(&given)
  {
  }
  StrictTable& table() { return table_; }

  std::optional<double> optional(const std::string& key, Dimension dimension)
  {
    const toml::node* node = table_.find(key);
    if (!node)
      return {};
    given_->push_back(name_.empty() ? key : name_ + "." + key);
    return value_of(*node, key, dimension);
  }
  double needed(const std::string& key, Dimension dimension)
  {
    const std::optional<double> value = optional(key, dimension);
    if (!value)
      throw InputError(fmt::format("{}: {}{}{} is missing: a {} is needed", table_.place(), name_,
                                   name_.empty() ? "" : ".", key, dimension_name(dimension)));
    return *value;
  }
  std::vector<double> list(const std::string& key, Dimension dimension)
  {
    const toml::node* node = table_.find(key);
    const toml::array* values = node ? node->as_array() : nullptr;
    if (!values)
      throw InputError(fmt::format("{}: {}.{}: a list is needed, one {} a row", table_.place(key), name_, key,
                                   dimension_name(dimension)));
    given_->push_back(name_ + "." + key);
    std::vector<double> numbers;
    for (const toml::node& one : *values)
      numbers.push_back(value_of(one, key, dimension));
    return numbers;
  }

private:
  double value_of(const toml::node& node, const std::string& key, Dimension dimension) const
  {
    if (dimension == Dimension::number) {
      const std::optional<double> number = node.value<double>();
      if (!node.is_number() || !std::isfinite(*number))
        table_.fail(key, "a number without unit is needed");
      return *number;
    }
    const toml::value<std::string>* text = node.as_string();
    try {
      return parse_quantity(text ? text->get() : "1", dimension);
    } catch (const InputError& error) {
      table_.fail(key, error.what());
    }
  }

  StrictTable table_;
  std::string name_;
  std::vector<std::string>* given_;
};

//! A law by name and what reads its keys.
struct Kind
{
  std::string_view name;
  std::function<void(QuantityTable&, ShellMaterial&)> read;
};

constexpr auto number = Dimension::number;
constexpr auto pressure = Dimension::pressure;

const std::vector<Kind> plasticity_kinds{
    {"linear",
     [](QuantityTable& t, ShellMaterial& m) {
       const double yield = t.needed("yield", pressure);
       const auto plastic = t.optional("plastic_modulus", pressure),
                  tangent = t.optional("tangent_modulus", pressure);
       if (plastic && tangent)
         t.table().fail("tangent_modulus", "either plastic_modulus or tangent_modulus, not both");
       m.hardening =
           LinearHardening{yield, tangent ? plastic_modulus(m.young, *tangent) : plastic.value_or(0)};
     }},
    {"table",
     [](QuantityTable& t, ShellMaterial& m) {
       m.hardening = TabulatedHardening(t.list("plastic_strain", number), t.list("stress", pressure));
     }},
    {"johnson-cook",
     [](QuantityTable& t, ShellMaterial& m) {
       JohnsonCook law{t.needed("A", pressure), t.needed("B", pressure), t.needed("n", number)};
       law.C = t.optional("C", number).value_or(0);
       if (law.C != 0)
         law.reference_rate = t.needed("reference_rate", Dimension::rate);
       else
         t.optional("reference_rate", Dimension::rate);
       law.m = t.optional("m", number).value_or(0);
       set_strength(m, law);
     }},
};
const std::vector<Kind> rate_kinds{
    {"cowper-symonds",
     [](QuantityTable& t, ShellMaterial& m) {
       m.rate = CowperSymonds{t.needed("C", Dimension::rate), t.needed("p", number)};
     }},
    {"logarithmic",
     [](QuantityTable& t, ShellMaterial& m) {
       m.rate = LogarithmicRate{t.needed("p", number), t.needed("D", Dimension::rate)};
     }},
};
const std::vector<Kind> failure_kinds{
    {"plastic-strain",
     [](QuantityTable& t, ShellMaterial& m) { m.failure = PlasticStrainLimit{t.needed("limit", number)}; }},
    {"johnson-cook",
     [](QuantityTable& t, ShellMaterial& m) {
       JohnsonCookDamage law{t.needed("D1", number), t.needed("D2", number), t.needed("D3", number),
                             t.optional("D4", number).value_or(0), t.optional("D5", number).value_or(0)};
       law.reference_rate = t.optional("reference_rate", Dimension::rate).value_or(1);
       if (law.D4 != 0 && !t.table().table().contains("reference_rate"))
         t.table().fail("D4", "reference_rate is missing, the rate from which D4 counts");
       if (law.D5 != 0 && m.heat.melting == 0)
         t.table().fail("D5", "heat.melting is missing, without which temperature has no meaning");
       m.failure = law;
     }},
};

void read_heat(QuantityTable& t, ShellMaterial& m)
{
  m.heat.specific_heat = t.needed("specific_heat", Dimension::specific_heat);
  m.heat.share = t.optional("share", number).value_or(m.heat.share);
  m.heat.room = t.optional("room", Dimension::temperature).value_or(m.heat.room);
  m.heat.start = t.optional("start", Dimension::temperature).value_or(m.heat.room);
  m.heat.melting = t.optional("melting", Dimension::temperature).value_or(0);
  t.table().finish();
}

//! The table of a key, if it is there.
std::optional<QuantityTable> table_in(StrictTable& top, const std::string& key,
                                      std::vector<std::string>& given)
{
  const toml::node* node = top.find(key);
  if (!node)
    return {};
  if (!node->is_table())
    top.fail(key, fmt::format("a table is needed, with the title [{}]", key));
  return QuantityTable(
      StrictTable(*node->as_table(), top.file(), key, static_cast<int>(node->source().begin.line)), key,
      given);
}

void read_law(std::optional<QuantityTable> table, const std::vector<Kind>& kinds, ShellMaterial& material)
{
  if (!table)
    return;
  std::vector<std::string> names;
  for (const Kind& kind : kinds)
    names.emplace_back(kind.name);
  const std::string choices = fmt::format("one of \"{}\"", fmt::join(names, "\", \""));
  const std::string law = table->table().needed("law", choices);
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == law; });
  if (kind == kinds.end())
    table->table().fail("law", choices + " is needed");
  try {
    kind->read(*table, material);
  } catch (const InputError& error) {
    const std::string message = error.what(); // of a law's own check: it knows no place
    throw InputError(message.starts_with(table->table().file()) ? message
                                                                : table->table().place() + ": " + message);
  }
  table->table().finish();
}

MaterialSource read_source(StrictTable table, const std::vector<std::string>& given)
{
  MaterialSource source{table.texts("keys"), table.needed("confidence", "one of \"F\", \"S\", \"M\""),
                        table.needed("text", "where the numbers stand")};
  if (source.confidence != "F" && source.confidence != "S" && source.confidence != "M")
    table.fail("confidence", "one of \"F\", \"S\", \"M\" is needed");
  for (const std::string& key : source.keys)
    if (std::find(given.begin(), given.end(), key) == given.end()) {
      const std::string nearest = nearest_name(key, given);
      throw InputError(fmt::format("{}: source.keys: the file has no {}{}", table.place("keys"), key,
                                   nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    }
  table.finish();
  return source;
}

} // namespace

MaterialFile read_material_file(const fs::path& file)
{
  const toml::table root = parse_toml(file, "material");
  MaterialFile read;
  ShellMaterial& material = read.material;
  QuantityTable top(StrictTable(root, file.string(), "", 0), "", read.keys);
  material.name = top.table().needed("name", "what the material is called in the log");
  material.density = top.needed("density", Dimension::density);
  material.young = top.needed("young", pressure);
  material.poisson = top.needed("poisson", number);
  if (auto heat = table_in(top.table(), "heat", read.keys))
    read_heat(*heat, material);
  auto plasticity = table_in(top.table(), "plasticity", read.keys),
       rate = table_in(top.table(), "rate", read.keys), failure = table_in(top.table(), "failure", read.keys);
  for (const char* dependent : {"rate", "failure"})
    if (!plasticity && top.table().table().contains(dependent))
      throw InputError(
          fmt::format("{}: [{}] has no meaning without [plasticity]: an elastic material neither yields nor "
                      "fails",
                      top.table().place(dependent), dependent));
  read_law(std::move(plasticity), plasticity_kinds, material);
  if (rate && std::holds_alternative<PowerHardening>(material.hardening))
    throw InputError(
        fmt::format("{}: [rate] has no meaning beside the law \"johnson-cook\", which has its own C",
                    top.table().place("rate")));
  read_law(std::move(rate), rate_kinds, material);
  read_law(std::move(failure), failure_kinds, material);
  for (StrictTable& source : top.table().tables("source"))
    read.sources.push_back(read_source(std::move(source), read.keys));
  top.table().finish();
  try {
    material.check();
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
  return read;
}

std::vector<std::string> material_names()
{
  std::vector<std::string> names;
  std::error_code ignored;
  const fs::path folder = share_folder() / "materials";
  if (fs::is_directory(folder, ignored))
    for (const fs::directory_entry& item : fs::directory_iterator(folder))
      if (item.path().extension() == ".toml")
        names.push_back(item.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_material(const std::string& name, const fs::path& beside)
{
  std::error_code ignored;
  if (const fs::path path = beside / name; fs::is_regular_file(path, ignored)) // absolute: the name itself
    return path;
  const std::vector<std::string> names = material_names();
  if (std::find(names.begin(), names.end(), name) != names.end())
    return share_folder() / "materials" / (name + ".toml");
  const std::string nearest = nearest_name(name, names);
  throw InputError(fmt::format("no such material, nor a file of it in {}: {}; known are {}{}",
                               beside.empty() ? "this folder" : beside.string(), name,
                               names.empty() ? "none, as the share folder is not found"
                                             : fmt::format("{}", fmt::join(names, ", ")),
                               nearest.empty() ? "" : "; did you mean " + nearest + "?"));
}

} // namespace birdstrike
