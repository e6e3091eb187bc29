// SPDX-License-Identifier: GPL-3.0-or-later
// A run as one page that any browser opens from disk, without a network.
#pragma once

#include "cases/report_view.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct ReportResult
{
  std::uintmax_t bytes = 0;      //!< of the page
  ReportView view;               //!< without its data
  bool complete = false;         //!< the run was
  bool turning = false;          //!< the page has the view in three dimensions
  std::vector<std::string> gaps; //!< what the page lacks, and how to get it; a sentence each
};

//! Write the page. Whatever the folder lacks is a marked gap of the page and in the result.
//! \param folder  of one run; summary.json may be missing (a run that was stopped)
//! \throw InputError if it is not the folder of a run, or the share folder with the template is not found
//! \throw OutputError if the page cannot be written
ReportResult write_report(const std::filesystem::path& folder, const std::filesystem::path& page,
                          const ViewOptions& options);

//! A template of share/report, filled in: {{name}} is escaped for HTML, {{{name}}} is not; {{#name}} ... {{/name}} stands
//! for each row of a list, or once for true (https://mustache.github.io).
//! \throw InputError if the template is broken
std::string fill_template(const std::string& text, const std::string& json);

} // namespace birdstrike
