// SPDX-License-Identifier: BSD-3-Clause
// The one loop over time: bird particles against a target.
#pragma once

#include "core/contact/initial_gap.h"
#include "core/gauges/history.h"
#include "core/gauges/ledger.h"
#include "core/gauges/permanent_set.h"
#include "core/gauges/target_history.h"
#include "core/gauges/transducer.h"
#include "core/particles/particles.h"
#include "core/settings.h"
#include "core/target.h"
#include "core/time_step.h"

#include <memory>
#include <optional>

namespace birdstrike {

class Simulation;

//! What wants to know how a run goes on. Both are called between steps, when all state is consistent.
struct Observer
{
  virtual ~Observer() = default;
  virtual void on_step(const Simulation&) {}  //!< after every step
  virtual void on_frame(const Simulation&) {} //!< at t = 0 and at every frame time, the end included
};

//! Seconds spent in the parts of a run.
struct Shares
{
  double particles = 0, shells = 0, contact = 0, gauges = 0, writing = 0, total = 0; //!< wall time [s]
};

class Simulation
{
public:
  //! \param particles    of the bird; none for a structure under loads alone
  //! \param deflections  nodes of a mesh target that histories follow
  //! \throw InputError if the settings are out of range, or a particle starts behind the plate or in touch with the target
  Simulation(Particles particles, Target target, const Settings& settings,
             std::vector<Transducer> transducers = {}, std::vector<DeflectionGauge> deflections = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;

  //! Integrate to settings.end_time. The same input gives the same bits with any number of threads.
  //! \throw RunError naming particle, place and time if a value is no longer finite or the time step vanishes
  void run(Observer& observer);

  const Settings& settings() const;
  const Particles&
  particles() const;               //!< rows in the order of the moment; particles().id tells which is which
  const RigidPlate* plate() const; //!< null where the target is none
  const MeshTarget* mesh_target() const;  //!< null where the target is none
  const ParticleContact* contact() const; //!< of a mesh target with a bird, else null
  const std::optional<InitialGap>&
  initial_gap() const;            //!< between bird and mesh target before the first step
  const History& history() const; //!< one row per step, and one at t = 0; columns in gauges/history_columns
  const History& transducer_history() const; //!< the same rows; see TransducerGauges
  const Ledger& ledger() const;              //!< mass, momentum, energy; now and at the start
  PermanentSet::Largest
  permanent_set() const; //!< of the target; zero where it is rigid, and before the run's last fifth
  const Shares& shares() const;

  double time() const;               //!< [s]
  const TimeStep& time_step() const; //!< the last one, and what limited it
  long steps() const;
  long list_rebuilds() const;
  double mean_neighbours() const; //!< within 2h at the last rebuild, the particle itself not counted
  std::optional<double> first_contact() const; //!< time at which the plate first felt a force [s]

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace birdstrike
