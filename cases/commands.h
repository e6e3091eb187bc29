// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of the program. Each adds its options to the command line and does its work when it is
// chosen; failures leave as InputError, RunError or OutputError.
#pragma once

namespace CLI {
class App;
}

namespace birdstrike {

void add_run_command(CLI::App& program);
void add_study_command(CLI::App& program);
void add_bird_command(CLI::App& program);
void add_histories_command(CLI::App& program);
void add_render_command(CLI::App& program);
void add_series_command(CLI::App& program);
void add_figures_command(CLI::App& program);
void add_plot_command(CLI::App& program);
void add_report_command(CLI::App& program);
void add_cases_command(CLI::App& program);
void add_theory_command(CLI::App& program);

} // namespace birdstrike
