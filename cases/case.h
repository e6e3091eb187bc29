// SPDX-License-Identifier: GPL-3.0-or-later
// A case file, read and checked: everything that a run needs, in SI. Defaults are the ones written here and
// in core/settings.h; ranges and texts stand in keys.cpp.
#pragma once

#include "cases/law_case.h"
#include "cases/series_form.h"
#include "cases/target_case.h"
#include "core/settings.h"
#include "geometry/shape_parts.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike {

struct PartCase
{
  std::string name;
  double porosity = 0;  //!< volume share of air [-]
  double density = NAN; //!< of the material, in place of the porosity or the law's own; NaN: theirs [kg/m3]
  std::vector<std::string> objects =
      {}; //!< patterns of the mesh's objects that belong to it, besides the known words
  std::string eos = "impact-event"; //!< one of porous_law_names(), or the name of one of Case::laws
  int layers = 60;                  //!< of a column [-]
  double share = NAN;               //!< of a mixture's particles; NaN: this part is none of a mixture [-]
  std::string place = "";           //!< in a shape: one of place_names(), or empty: its only part
};

struct BirdCase
{
  std::string mesh;    //!< file or folder as written; this, shape or species is given, the others are empty
  std::string shape;   //!< of bird_shape_names()
  std::string species; //!< of species_names()
  std::string neck = "out";                     //!< of neck_names(), of a species
  std::string wings = "spread";                 //!< of wing_names(), of a species
  bool legs = false;                            //!< of a species
  double mesh_unit = NAN;                       //!< length of one unit of the mesh file; NaN: find it [m]
  std::string nose, up;                         //!< axes of the mesh file, "+x" ... "-z"; empty: find them
  bool strict = false;                          //!< refuse a mesh that needs repair
  double thickness = NAN;                       //!< of surfaces without any; NaN: two spacings [m]
  double mass = 0;                              //!< of the whole bird [kg]
  std::string exact = "mass";                   //!< of exact_names()
  double spacing = 0;                           //!< between particles; 0: by their number [m]
  int particles = 0;                            //!< wanted number; 0: by their spacing
  std::string lattice = "cubic";                //!< of lattice_names(), of a mesh or species
  bool relax = false;                           //!< let particles settle against the surfaces
  double velocity = 0;                          //!< along flight_direction [m/s]
  double gap = 0.01;                            //!< between bird and target at the start [m]
  double smoothing = 1.28;                      //!< h over spacing; counts squeezed lattices to 1e-4 [-]
  double length_over_diameter = 2;              //!< of a shape [-]
  int columns = 6;                              //!< of a column: cells sideways, each way
  int seed = 1;                                 //!< of the pseudo-random numbers of a mixture
  RibSizes ribs;                                //!< of the part whose place is "ribs"
  CoreSizes core;                               //!< of the part whose place is "core"
  double impact_angle = 0.5 * std::numbers::pi; //!< between flight path and plate [rad]
  std::array<double, 2> offset{};               //!< y and z where its path meets the plane x = 0 [m]
  double yaw = 0;                               //!< turns the nose to the bird's left, about +z [rad]
  double pitch = 0;                             //!< turns the nose up [rad]
  double roll = 0;                              //!< turns the left wing up, about the flight axis [rad]
  std::vector<PartCase> parts;                  //!< in the order of the file
};

struct TransducerCase
{
  std::string name;
  std::array<double, 2> centre{};            //!< y and z on the plate [m]
  double diameter = 0;                       //!< [m]
  double rise_time = 0;                      //!< 10-90 %; 0 for no filter [s]
  double steady_from = 0.4, steady_to = 0.7; //!< window after first contact, in squash-up times [-]
};

struct Case
{
  std::string title, source;
  BirdCase bird;
  TargetCase target;
  std::vector<TransducerCase> transducers; //!< in the order of the file
  std::vector<DeflectionCase> deflections; //!< points whose displacement histories follow
  Settings run;
  double frame_interval = NAN;   //!< between states, in place of run.frames; NaN: by their number [s]
  double contact_interval = NAN; //!< between more states around the first contact; NaN: none [s]
  double contact_window = 2e-4;  //!< after the first contact, in which they lie [s]
  SeriesForm series;
  std::vector<LawCase> laws; //!< tables [eos.NAME], in the order of the file

  bool alone = false;                         //!< made by bird_alone
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

struct Entry;

//! The same with overrides that know where they were written, for messages.
Case read_case_with(const std::filesystem::path& file, const std::vector<Entry>& overrides);

//! A bird without a target, from keys of bird and eos alone, those of a file and others that replace them. By itself it has 20,000 particles and
//! the mass that its materials give; its parts may be left to usual_parts.
//! \param name  of the bird, for messages
//! \throw InputError as read_case
Case bird_alone(const std::vector<Entry>& overrides, const std::string& name,
                const std::filesystem::path& file = {});

//! Porosity of dissertation 8.3.1 for head, neck, torso, wings, bones and lungs, and for legs that of bones.
std::optional<double> usual_porosity(std::string_view part);

//! The case as TOML with every default filled in; read_case gives an equal case back. Files beside the case are named by
//! their whole path.
std::string to_toml(const Case& parsed);

//! What of a bird is met exactly: "mass" (one factor on the densities of all parts), "density" (the mass is what comes
//! out), "particle-mass" (one factor on the masses of the particles alone, as in dissertation 8.3.3).
std::vector<std::string> exact_names();

//! Names for bird.shape: those of shape_names() and "column".
std::vector<std::string> bird_shape_names();

//! A stack of layers in a box that repeats sideways, for plane waves; see column.h.
bool is_column(const Case& parsed);

//! The bird's mesh: an absolute path, a path beside the case file, or a file of share/meshes, in this order.
//! \throw InputError naming every place that was looked at
std::filesystem::path find_mesh(const Case& parsed);

//! The law of a part at the density that its material has by itself: natural_law of law_case.h.
EquationOfState natural_law(const Case& parsed, const PartCase& part);
//! Volume share of air in a part's material, by its porosity or its density; 0 for a law that knows none [-].
double porosity_of(const Case& parsed, const PartCase& part);

} // namespace birdstrike
