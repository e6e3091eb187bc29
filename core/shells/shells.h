// SPDX-License-Identifier: BSD-3-Clause
// A shell structure in motion: nodes, elements, and what one explicit step (5.13, 5.14) does to them.
#pragma once

#include "core/material/shell_material.h"
#include "core/shells/hourglass.h"
#include "core/shells/loads.h"
#include "core/shells/mesh.h"
#include "core/shells/supports.h"

#include <optional>
#include <vector>

namespace birdstrike {

//! What the elements of one part are.
struct ShellSection
{
  ShellMaterial material;
  double thickness = 0; //!< at the start [m]
  int points = 5;       //!< through the thickness, 2 to 10
};

struct ShellSettings
{
  bool warping = true;     //!< terms for elements that are not flat
  double hourglass = 0.05; //!< coefficient of hourglass.h; 0 for none [-]
  double drilling =
      0.1; //!< stiffness of the tie between the nodes' spin about the normal and the surface's, over G; without
           //!< it a curved shell twists too easily [-]
  double courant = 0.9;     //!< k of 3.27 [-]
  double damping = 0;       //!< alpha: deceleration over velocity [1/s]
  double stiff_damping = 0; //!< beta: stress over stress rate [s]
  double failed_share =
      1; //!< of the points through the thickness; an element with so many failed is eroded [-]
  std::optional<SteadySpin> spin;
};

//! Where the energy of a structure is [J].
struct ShellEnergy
{
  double kinetic = 0;
  double internal = 0;  //!< work of the stresses in elements that stand, plastic work included
  double plastic = 0;   //!< work of plastic flow, in eroded elements too
  double hourglass = 0; //!< work against hourglass motion
  double damped = 0;    //!< taken by damping
  double eroded = 0;    //!< internal and hourglass energy of eroded elements
  double external = 0;  //!< work of loads and moving supports, contact not counted; not a part of total()

  double total() const { return kinetic + internal + hourglass + damped + eroded; }
};

class Shells
{
public:
  //! \param sections  one a part of the mesh
  //! \throw InputError naming element, node or part: a corner that is not there, an element without area or turned over
  //!        itself, a thickness, density or modulus that is not positive, 2 to 10 points, a node that nothing holds up
  Shells(ShellMesh mesh, std::vector<ShellSection> sections, std::vector<Support> supports = {},
         ShellLoads loads = {}, const ShellSettings& settings = {});

  // One step of length dt is kick(dt / 2); drift(dt); evaluate(dt, time at the end); contact forces; kick(dt / 2).

  //! Velocities and spins by the forces of the moment, over \p dt [s].
  void kick(double dt);
  //! Positions by velocities.
  void drift(double dt);
  //! Stresses from the motion over the last \p dt, which may be 0 at the start; then all forces but those of contact.
  //! \throw RunError naming element and place if a number is no longer finite or an element has turned over
  void evaluate(double dt, double time);
  //! Add forces of contact [N], a row a node, after evaluate.
  void add_contact(const std::vector<Vector3>& force);

  //! Add velocity [m/s] to all nodes; a spin as of settings.spin comes by itself.
  void launch(const Vector3& velocity);

  double stable_step() const { return stable_step_; } //!< by 3.27 at the last evaluate [s]

  // Nodes.
  std::vector<Vector3> position;                                  //!< [m]
  std::vector<Vector3> velocity;                                  //!< [m/s]
  std::vector<Vector3> spin;                                      //!< [rad/s]
  const std::vector<double>& mass() const { return mass_; }       //!< 5.17 [kg]
  const std::vector<double>& inertia() const { return inertia_; } //!< of rotation, about any axis [kg m2]
  const std::vector<Vector3>& force() const
  {
    return force_;
  } //!< of stresses, loads, damping and contact [N]

  // Elements.
  std::vector<double> thickness; //!< [m]
  std::vector<ShellPoint>
      points; //!< element k has points_of(k) of them from row first_point(k) on, inner side first
  std::vector<std::uint8_t> gone; //!< eroded

  const ShellMesh& mesh() const { return mesh_; }
  const std::vector<ShellSection>& sections() const { return sections_; }
  const ShellSection& section_of(std::size_t element) const { return sections_[mesh_.part_of(element)]; }
  const ShellSettings& settings() const { return settings_; }
  std::size_t first_point(std::size_t element) const { return first_point_[element]; }
  std::size_t eroded() const { return eroded_; } //!< number of elements gone

  double total_mass() const; //!< [kg]
  Vector3 momentum() const;  //!< [kg m/s]
  Vector3 support_impulse() const
  {
    return support_impulse_;
  } //!< of the supports on the structure so far [N s]
  Vector3 external_impulse() const { return external_impulse_; } //!< of the loads [N s]
  ShellEnergy energy() const;

  //! Come to rest under the loads of time \p time, with kinetic damping: whenever the kinetic energy has passed a maximum
  //! all motion is stopped (P. A. Cundall, 1976). With a spin, under its centrifugal load in the rotating frame. Ends with
  //! zero velocity, or that of the spin.
  //! \param tolerance  largest out-of-balance force over the largest force, of one node
  //! \return number of steps
  //! \throw RunError if that is not reached within \p most steps
  long relax(double time, double tolerance = 1e-4, long most = 2000000);

private:
  struct Element
  {
    HourglassForces hourglass;
    double drill = 0;          //!< force of settings.drilling [N/m]
    double closure = 0;        //!< of a triangle [N]
    double area0 = 0;          //!< at the start [m2]
    double internal = 0;       //!< [J]
    double plastic = 0;        //!< share of it [J]
    double hourglass_work = 0; //!< [J]
    double damped = 0;         //!< by stiff_damping [J]
    double mass_ratio = 1;     //!< of a mean corner to the lightest [-]
    double step0 = 0;          //!< stable step at the start [s]
  };
  struct Corner
  {
    Vector3 force, moment;
  };

  ShellMesh mesh_;
  std::vector<ShellSection> sections_;
  ShellLoads loads_;
  ShellSettings settings_;

  std::vector<double> mass_, inertia_;
  struct Held
  {
    std::int32_t node;
    std::array<bool, 3> moves, turns;
  };
  std::vector<Held> held_; //!< one a node
  std::vector<Vector3> force_, moment_, external_;
  std::vector<std::int32_t> corner_begin_, corner_of_; //!< rows of corners_ that belong to a node

  std::vector<Element> elements_;
  std::vector<Corner> corners_; //!< four an element
  std::vector<double> element_step_;
  std::vector<std::size_t> first_point_;
  std::vector<std::vector<double>> heights_,
      weights_; //!< of the points of a part, in half thicknesses and thicknesses

  double stable_step_ = 0;
  std::size_t eroded_ = 0;
  double damped_ = 0, external_work_ = 0;
  Vector3 support_impulse_ = Vector3::Zero(), external_impulse_ = Vector3::Zero();
  bool rotating_frame_ = false; //!< while relaxing

  void check() const;
  void lump_masses();
  void join_corners();
  void evaluate_element(std::size_t element, double dt);
  void report_broken(std::size_t element, double time) const;
  void apply_loads(double time);
  void gather_support(const std::vector<Support>& supports);
  Vector3 steady_velocity(const Vector3& place) const;
  void hold_velocities();
  double kinetic_energy() const;
  double out_of_balance() const;
};

} // namespace birdstrike
