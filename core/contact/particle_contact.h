// SPDX-License-Identifier: BSD-3-Clause
// Particles against both faces of shells and of rigid bodies of any shape.
//
// A particle that is nearer to the midsurface than the contact distance is pushed away along the line to the nearest point
// of it (contact_stiffness.h), straight up inside an element and radially at a free edge; at folds and borders touches.h
// tells how many elements share the push. Its opposite acts on the nodes of the element, shared by the weights that make
// the nearest point from them. So force and counterforce are equal and in one line: momentum and, but for friction, angular
// momentum pass from one to the other without loss. The force is the slope of the stored energy, so what goes in comes
// out, as long as elements keep their thickness and folds their angle.
//
// Which face a particle is on is where it is; one that has gone through the midsurface in one step is found from the motion
// of both (passage.h), and until it is back it is pushed to the side that it came from. Elements that are gone are not
// there, so particles pass through holes. That is no leak; all other passages are counted.
//
// Friction is Coulomb's: mu times the normal force, against the slip v, times v / sqrt(v^2 + v0^2) so that it is defined at
// rest. It acts at the particle's middle, as there is no spin to take up its lever of one contact distance.
#pragma once

#include "core/contact/contact_stiffness.h"
#include "core/contact/footprint.h"
#include "core/contact/initial_gap.h"
#include "core/contact/search.h"
#include "core/contact/touches.h"

namespace birdstrike {

struct ContactSettings
{
  double impact_speed = 0;    //!< of the bird, normal to the target: sets the stiffness [m/s]
  double friction = 0;        //!< Coulomb's coefficient mu [-]
  double friction_speed = 1;  //!< v0, slip at which friction has reached 0.7 of its value [m/s]
  double stiffness_scale = 1; //!< on the derived stiffness [-]
  bool mirror =
      false; //!< the surface also mirrors the flow (mirror_planes.h), and the springs are what stops those that come
             //!< nearer than a quarter of a spacing all the same
};

//! A force between a particle and the surface that something else than the springs makes.
struct SurfaceForce
{
  std::int32_t element;
  std::array<double, 4> weight; //!< of its nodes [-]
  Vector3 force;                //!< on the particle [N]
  double pressing;              //!< part of it normal to the element, from the wall positive [N]
  double stiffness;             //!< that the nodes feel [N/m]
  double damping = 0;           //!< the same, of a force that grows with velocity [N s/m]
};

struct ContactEnergy
{
  double stored = 0;   //!< in the springs now [J]
  double friction = 0; //!< heat so far [J]
  double released = 0; //!< was stored between particles and elements when those eroded, so far [J]
};

class ParticleContact
{
public:
  //! \throw InputError if a setting is out of range, the surface has no element, or a law cannot stop matter of that speed
  ParticleContact(const Particles& particles, const ContactSurface& surface, const ContactSettings& settings);

  //! The rows of the particles have been sorted: new row k was row order[k].
  void reorder(const std::vector<std::int32_t>& order);

  //! Forces at this moment.
  //! \param vx,vy,vz    velocities of the particles now, N entries each [m/s]
  //! \param duration    time since the last call [s]: what impulses and heat grow by, with the mean of the force then and
  //!                    now, as two half kicks do
  //! \param fx,fy,fz    out: force on the particles, N entries each [N]
  //! \param node_force  force on the nodes is added, one entry a node [N]
  //! \param loads       out: sized to the elements at the first call
  //! \param others      taken from nodes and elements like the springs' own
  void evaluate(const Particles& particles, const std::vector<double>& vx, const std::vector<double>& vy,
                const std::vector<double>& vz, const ContactSurface& surface, double duration,
                std::vector<double>& fx, std::vector<double>& fy, std::vector<double>& fz,
                std::vector<Vector3>& node_force, ElementLoads& loads,
                std::span<const SurfaceForce> others = {});

  //! Largest step at which the contact alone is stable, and at which nothing runs deep into the surface before it is felt
  //! [s]. The first is 2 / omega with omega^2 <= max(k / m) + max(sum N k / M) over particles and nodes (the contacts'
  //! stiffness matrix is bounded by twice its diagonal, split between the sides in the best ratio), the stiffness taken
  //! where the particles will have been stopped. Bodies with limits dt_1 ... dt_n that act on the same masses are stable
  //! together below (sum dt_i^-2)^(-1/2). Infinity where no particle moves towards anything.
  double stable_step() const { return stable_step_; }

  const ContactEnergy& energy() const { return energy_; }
  const Vector3& force_on_target() const { return force_on_target_; } //!< [N]
  long touching() const { return touching_; }                         //!< particles that feel a force now
  //! Particles that have gone through a surface other than through a hole so far, with those that are being driven back.
  long leaked() const;
  long tests() const { return tests_; } //!< pairs of particle and element looked at in the last call
  long builds() const { return bins_.builds(); }

private:
  //! What a run of consecutive particles finds; the runs are added in their order.
  struct Found
  {
    std::vector<SurfaceForce> contacts;
    double stored, released, slip_power, per_mass, step;
    long touching, leaked, tests;
  };
  struct Moment; // what evaluate was given

  ContactSettings settings_;
  double spacing_;
  std::vector<double> modulus_; // of the parts [Pa]
  ElementBins bins_;
  Footprint footprint_;

  // Of the particles, N rows.
  std::vector<Vector3> last_position_;     // [m]
  std::vector<std::int32_t> last_element_; // that pushed most, -1 without one
  std::vector<std::int32_t>
      passed_; // element whose midsurface it has gone through and is pushed back by, or -1
  std::vector<double> last_energy_; // stored [J]

  std::vector<Vector3> last_node_;                        // positions of the nodes [m]
  std::vector<double> node_stiffness_, node_damping_;     // [N/m], [N s/m]
  double node_moved_ = 0, node_speed_ = 0, thickest_ = 0; // [m], [m/s], [m]
  std::vector<Found> found_;
  bool begun_ = false;

  ContactEnergy energy_;
  double slip_power_ = 0; // [W]
  Vector3 force_on_target_ = Vector3::Zero();
  double stable_step_;
  long touching_ = 0, leaked_ = 0, tests_ = 0;

  void follow_nodes(const ContactSurface& surface);
  std::int32_t nearest_box(const Vector3& p, double range, const ContactSurface& surface) const;
  void look_at(std::size_t row, const Moment& now, Found& found);
  void push(std::size_t row, const Moment& now, std::span<Touch> touches, Found& found);
  void look_ahead(std::size_t row, const Moment& now, const Touch& nearest, Found& found);
  void add_up(const Moment& now, double duration, std::vector<Vector3>& node_force, ElementLoads& loads,
              std::span<const SurfaceForce> others);
  double reach(double thickness) const; // contact distance of the springs [m]
};

} // namespace birdstrike
