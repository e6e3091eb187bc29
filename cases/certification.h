// SPDX-License-Identifier: GPL-3.0-or-later
// Masses of the birds that airworthiness rules ask for, by the rule's name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

//! One row of share/rules/certification.toml.
struct CertificationRule
{
  std::vector<std::string> names; //!< the first is the usual one
  double mass = 0;                //!< of one bird [kg]
  std::string mass_text;          //!< as the rule puts it, "8 lb"
  std::string speed, applies;     //!< in words
  std::string confidence;         //!< F: found at the source; S: secondary source only
  std::string source;             //!< where it was read
};

//! All rules. \throw InputError naming file, line and key if the file is missing or wrong
std::vector<CertificationRule> read_certification_rules(const std::filesystem::path& file);
//! The same of share/rules/certification.toml, read once.
const std::vector<CertificationRule>& certification_rules();

//! Mass that a rule asks for [kg], for example of "CS 25.631"; capitals and blanks do not matter. Empty if
//! that is the name of no rule.
std::optional<double> certification_mass(std::string_view name);

//! One line a rule for help and messages: "14 CFR 25.631: 8 lb, empennage of transport aeroplanes".
std::vector<std::string> certification_names();

} // namespace birdstrike
