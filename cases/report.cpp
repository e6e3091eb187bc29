// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a report together: what the folder holds, the view, the template.
#include "cases/report.h"

#include "cases/report_balances.h"
#include "cases/report_charts.h"
#include "cases/report_tables.h"
#include "cases/share_folder.h"
#include "core/error.h"
#include "vtkio/atomic_file.h"
#include "vtkio/packed_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

std::string read_bytes(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string read_part(const std::string& name)
{
  const fs::path file = find_share_file("report/" + name);
  require(!file.empty(), "the share folder of this program has no report/" + name +
                             "; install it again, or name the folder in BIRDSTRIKE_SHARE");
  return read_bytes(file);
}

//! "by_pressure" -> "By pressure"
std::string caption(const fs::path& file)
{
  std::string name = file.stem().string();
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty())
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

bool is_png(const std::string& bytes)
{
  constexpr std::string_view start("\x89PNG\r\n\x1a\n"), end("IEND\xae\x42\x60\x82");
  return bytes.starts_with(start) && bytes.ends_with(end);
}

Json images(const std::vector<fs::path>& files, std::vector<std::string>& gaps)
{
  Json list = Json::array();
  for (const fs::path& file : files) {
    const std::string bytes = read_bytes(file);
    if (!is_png(bytes)) {
      gaps.push_back(fmt::format("figures/{} is damaged and left out; birdstrike render draws it again from "
                                 "the frames.",
                                 file.filename().string()));
      continue;
    }
    list.push_back(
        {{"caption", caption(file)},
         {"data", to_base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()})}});
  }
  return list;
}

void add_images(Json& page, const ReportFolder& run, const std::vector<std::string>& replaced,
                std::vector<std::string>& gaps)
{
  std::vector<fs::path> plots;
  for (const fs::path& plot : run.plots)
    if (std::find(replaced.begin(), replaced.end(), plot.stem().string()) == replaced.end())
      plots.push_back(plot);
  const auto add = [&](const std::string& name, const std::vector<fs::path>& files) {
    Json list = images(files, gaps);
    page["has_" + name] = !list.empty();
    page[name] = std::move(list);
  };
  add("plots", plots);
  add("pictures", run.pictures);
}

void add_view(Json& page, const ReportView& view, const std::string& script)
{
  if (view.data.empty() || script.empty())
    return;
  page["view"] = {{"frames", view.frames},
                  {"all_frames", view.all_frames},
                  {"some_frames", view.frames < view.all_frames},
                  {"particles", view.particles},
                  {"all_particles", view.all_particles},
                  {"thinned", view.particles < view.all_particles},
                  {"target", view.target}};
  page["view_data"] = view.data;
  page["view_script"] = script;
}

} // namespace

ReportResult write_report(const fs::path& folder, const fs::path& file, const ViewOptions& options)
{
  const ReportFolder run = read_report_folder(folder);
  const std::string text = read_part("page.mustache");
  ReportResult result;
  result.complete = run.complete;
  result.gaps = run.gaps;
  result.view = make_report_view(folder, options);
  for (const std::string& gap : result.view.gaps)
    result.gaps.push_back(without_folders(gap));

  Json page{{"title", folder.filename().string()}, {"complete", run.complete}, {"date", run.date}};
  page["style"] = read_part("page.css");
  page["page_script"] = read_part("page.js");
  add_case_table(page, run);
  add_summary_tables(page, run);
  const Json& version = at_path(run.summary, {"version"});
  page["version"] = version.is_string() ? version.get<std::string>() : "";
  page["writer"] = BIRDSTRIKE_VERSION;
  page["balances"] = report_balances(run);
  page["has_balances"] = !page["balances"].empty();
  std::vector<std::string> replaced;
  page["charts"] = report_charts(run, replaced);
  page["has_charts"] = !page["charts"].empty();
  add_images(page, run, replaced, result.gaps);

  const fs::path bundle = find_share_file("report/view.js");
  const std::string script = bundle.empty() ? std::string() : read_bytes(bundle);
  if (script.empty())
    result.gaps.emplace_back(
        "The view that can be turned is not in this page: the program was built without it. Install node "
        "and npm (Debian: nodejs npm), configure and build again, and write the report again.");
  result.turning = !script.empty() && !result.view.data.empty();
  add_view(page, result.view, script);
  result.view.data.clear();

  page["warnings"] = run.warnings;
  page["has_warnings"] = !run.warnings.empty();
  page["gaps"] = result.gaps;
  page["has_gaps"] = !result.gaps.empty();
  const std::string html = fill_template(text, page.dump(-1, ' ', false, Json::error_handler_t::replace));
  result.bytes = html.size();
  write_text_atomically(file, html);
  return result;
}

} // namespace birdstrike
