// SPDX-License-Identifier: GPL-3.0-or-later
// A file of figures: each a montage of one case, at given times and from given sides.
#include "cases/montage_file.h"

#include "cases/quantity.h"
#include "cases/render_texts.h"
#include "cases/share_folder.h"
#include "cases/strict_table.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

double time_of(const StrictTable& table, const std::string& key, const std::string& text)
{
  try {
    return parse_quantity(text, Dimension::time);
  } catch (const InputError& error) {
    table.fail(key, error.what());
  }
}

//! A text given to a reader whose message begins with an option: the key and its place stand before it.
template <class Read>
void read_text(StrictTable& table, const std::string& key, Read read)
{
  const std::string text = table.text(key);
  if (text.empty())
    return;
  try {
    read(text);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", table.place(key), error.what()));
  }
}

MontageFigure read_figure(StrictTable& table)
{
  MontageFigure figure;
  figure.place = table.place();
  figure.number = table.needed("number", "the number of the figure, for example \"7.2\",");
  if (figure.number.find_first_not_of("0123456789.abcdefghijklmnopqrstuvwxyz-") != std::string::npos)
    table.fail("number",
               "digits, points, hyphens and small letters are allowed: it becomes part of a file name");
  figure.title = table.text("title");
  const std::string base = table.needed("case", "a case file, or a name of the catalogue,");
  std::error_code ignored;
  const fs::path beside = fs::path(table.file()).parent_path() / base;
  try {
    figure.base = fs::is_regular_file(beside, ignored) ? beside : find_case(base);
  } catch (const InputError& error) {
    table.fail("case", error.what());
  }
  if (const std::string contact = table.text("contact"); !contact.empty())
    figure.contact = time_of(table, "contact", contact);
  for (const std::string& time : table.texts("times"))
    figure.times.push_back(time_of(table, "times", time));
  if (figure.times.size() < 2 || figure.times.size() > 26)
    table.fail("times", "a montage has 2 to 26 pictures: that many times are needed");
  figure.scenes = table.texts("scene");
  if (figure.scenes.size() == 1 || figure.scenes.empty())
    figure.scenes.assign(figure.times.size(), figure.scenes.empty() ? "side" : figure.scenes.front());
  if (figure.scenes.size() != figure.times.size())
    table.fail("scene",
               fmt::format("one scene, or one for each of the {} times, is needed", figure.times.size()));
  for (const std::string& scene : figure.scenes)
    try {
      scene_options(scene, {});
    } catch (const InputError& error) {
      table.fail("scene", error.what());
    }
  if (const toml::node* columns = table.find("columns")) {
    figure.columns = columns->value<int>().value_or(0);
    if (figure.columns < 1 || figure.columns > 26)
      table.fail("columns", "a whole number, 1 to 26, is needed");
  }
  SnapshotOptions& look = figure.look;
  if (const std::string colour = table.text("colour_by"); !colour.empty())
    look.colour_by = colour;
  look.target_field = table.text("target_colour");
  read_text(table, "range",
            [&](const std::string& text) { look.range = parse_range(text, "range", look.colour_by); });
  read_text(table, "target_range", [&](const std::string& text) {
    look.target_range = parse_range(text, "target_range", look.target_field);
  });
  read_text(table, "cut_plane", [&](const std::string& text) { look.plane = parse_plane(text); });
  read_text(table, "fit", [&](const std::string& text) { figure.fit = fit_from_name(text); });
  if (const toml::node* target = table.find("target")) {
    if (!target->is_boolean())
      table.fail("target", "true or false is needed");
    figure.target = target->as_boolean()->get();
  }
  table.finish();
  return figure;
}

} // namespace

MontageFile read_montages(const fs::path& file)
{
  const toml::table document = parse_toml(file, "figures");
  StrictTable table(document, file.string(), "", 0);
  MontageFile montages;
  montages.file = file;
  if (const toml::node* set = table.find("set")) {
    if (!set->is_table())
      table.fail("set", "a table of keys is needed, [set]");
    montages.set = entries_of(*set->as_table(), file.string());
  }
  for (StrictTable& figure : table.tables("figure")) {
    montages.figures.push_back(read_figure(figure));
    for (std::size_t k = 0; k + 1 < montages.figures.size(); ++k)
      require(montages.figures[k].number != montages.figures.back().number,
              fmt::format("{}: a second figure {}", montages.figures.back().place,
                          montages.figures.back().number));
  }
  table.finish();
  require(!montages.figures.empty(),
          fmt::format("{}: there is no figure: tables with the title [[figure]] are needed", file.string()));
  return montages;
}

fs::path montages_of_dissertation()
{
  const fs::path folder = catalogue_folder();
  require(!folder.empty(), "the catalogue of cases was not found; name the file of the figures");
  return folder / "dissertation" / "montages.toml";
}

} // namespace birdstrike
