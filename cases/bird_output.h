// SPDX-License-Identifier: GPL-3.0-or-later
// Where a bird goes: particles, surfaces, decks of other solvers, a picture, a report.
#pragma once

#include "cases/build_bird.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace birdstrike {

struct BirdOutput
{
  std::vector<std::filesystem::path> files; //!< kind by ending: particles, surface or deck
  std::vector<std::string> decks;           //!< also these, beside the first file: of deck_format_names()
  std::string units = "t-mm-s";             //!< of decks
  bool points_only = false;                 //!< .vtu and .vtp without cells
  std::filesystem::path snapshot;           //!< .png; empty: none
  std::filesystem::path report;             //!< .json; empty: none
};

void add_output_options(CLI::App& command, BirdOutput& output);

//! \throw InputError for an ending that nothing is written as, OutputError for a folder that is not there
void check_outputs(const BirdOutput& output);

//! The mesh of a case; empty for a shape. \throw InputError as read_bird_mesh
std::optional<BirdMesh> case_mesh(const Case& parsed, Log& log);

//! Fill if any output needs particles, and write all.
//! \throw InputError as build_bird, or where a shape has no surface to write; OutputError
void write_bird(const Case& parsed, const std::optional<BirdMesh>& mesh, const BirdOutput& output, Log& log);

} // namespace birdstrike
