// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike cases: the catalogue, a case's text, and the manual of keys.
#include "cases/commands.h"
#include "cases/keys.h"
#include "cases/share_folder.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <utility>

namespace birdstrike {

void add_cases_command(CLI::App& program)
{
  struct Options
  {
    std::string show;
    bool keys = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("cases", "List the catalogue of cases and studies");
  CLI::Option* show = command->add_option("--show", options->show, "Print the case or study of that name");
  command->add_flag("--keys", options->keys, "List every key of a case file: kind, range, default, meaning")
      ->excludes(show);
  command->callback([options] {
    if (options->keys) {
      std::cout << keys_manual();
    } else if (!options->show.empty()) {
      std::ifstream file(find_case(options->show));
      std::cout << file.rdbuf();
    } else {
      const std::vector<CatalogueEntry> entries = catalogue();
      require(!entries.empty(),
              "the catalogue is not found; set BIRDSTRIKE_SHARE to the project's share folder");
      for (const bool study : {false, true}) {
        const char* title =
            study ? "\nStudies, for birdstrike study NAME:\n" : "Cases, for birdstrike run NAME:\n";
        for (const CatalogueEntry& entry : entries)
          if (entry.study == study)
            std::cout << std::exchange(title, "")
                      << fmt::format("{:<38} {}\n{:<38} {}\n", entry.name, entry.title, "",
                                     entry.file.string());
      }
    }
  });
}

} // namespace birdstrike
