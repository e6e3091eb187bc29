// SPDX-License-Identifier: GPL-3.0-or-later
// A case file, read and checked: everything that a run needs, in SI. Defaults are the ones written here and
// in core/settings.h; ranges and texts stand in keys.cpp.
#pragma once

#include "cases/law_case.h"
#include "core/settings.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace birdstrike {

struct PartCase
{
  std::string name;
  double porosity = 0;              //!< volume share of air [-]
  std::string eos = "impact-event"; //!< one of porous_law_names(), or the name of one of Case::laws
};

struct BirdCase
{
  std::string mesh;            //!< as written
  double mesh_unit = 1;        //!< length of one unit of the mesh file [m]
  double mass = 0;             //!< of the whole bird [kg]
  double spacing = 0;          //!< between particles [m]
  double velocity = 0;         //!< along +x [m/s]
  double gap = 0.01;           //!< between bird and target at the start [m]
  double smoothing = 1.25;     //!< h over spacing [-]
  double yaw = 0;              //!< turns the nose to the bird's left, about +z [rad]
  double pitch = 0;            //!< turns the nose up [rad]
  double roll = 0;             //!< turns the left wing up, about the flight axis [rad]
  std::vector<PartCase> parts; //!< in the order of the file
};

struct TargetCase
{
  std::array<double, 2> size{};      //!< along y and z [m]
  double thickness = 0;              //!< [m]
  std::array<int, 2> elements{1, 1}; //!< along y and z
  bool rigid = true;
};

struct Case
{
  std::string title, source;
  BirdCase bird;
  TargetCase target;
  Settings run;
  std::vector<LawCase> laws; //!< tables [eos.NAME], in the order of the file

  std::filesystem::path file;                 //!< where it was read
  std::map<std::string, std::string> written; //!< TOML text of each key that was given, by path
};

//! Read and check a case file.
//! \param file       path of a .toml file
//! \param overrides  "key=value" each, as --set takes them; value is TOML, or a bare text ("bird.spacing=2
//! mm") \throw InputError naming file, line and key: no such file, TOML syntax, unknown key (with the nearest
//! known
//!        one), missing key, missing, unknown or wrong unit, wrong kind of value, value out of range
Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

//! The case as TOML with every default filled in; read_case gives an equal case back.
std::string to_toml(const Case& parsed);

//! The bird's mesh: an absolute path, a path beside the case file, or a file of share/meshes, in this order.
//! \throw InputError naming every place that was looked at
std::filesystem::path find_mesh(const Case& parsed);

} // namespace birdstrike
