// SPDX-License-Identifier: BSD-3-Clause
// Static equilibrium by kinetic damping, in pseudo-time of the explicit step.
#include "core/error.h"
#include "core/shells/shells.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace birdstrike {

//! Force on the free components of the nodes over that on all of them and that of the loads.
double Shells::out_of_balance() const
{
  double free = 0, all = 0;
  std::vector<std::array<bool, 3>> fixed(position.size(), {false, false, false});
  for (const Held& held : held_)
    fixed[static_cast<std::size_t>(held.node)] = held.moves;
  for (std::size_t n = 0; n < position.size(); ++n)
    for (int k = 0; k < 3; ++k) {
      const double f = force_[n][k] * force_[n][k];
      all += external_[n][k] * external_[n][k];
      if (fixed[n][static_cast<std::size_t>(k)])
        all += f;
      else
        free += f;
    }
  return all > 0 ? std::sqrt(free / all) : 0;
}

long Shells::relax(double time, double tolerance, long most)
{
  const auto stop = [&] {
    for (std::size_t n = 0; n < position.size(); ++n)
      velocity[n] = spin[n] = Vector3::Zero();
  };
  rotating_frame_ = true;
  stop();
  evaluate(0, time);
  long steps = 0;
  double before = 0, balance = out_of_balance();
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (const Vector3& point : mesh_.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const auto runs_away = [&] { // farther than it is large: nothing holds it up
    for (std::size_t n = 0; n < position.size(); ++n)
      if (!((position[n] - mesh_.points[n]).norm() < (high - low).norm()))
        return true;
    return false;
  };
  for (; balance > tolerance && steps < most; ++steps) {
    if (steps % 1000 == 999 && runs_away())
      throw RunError("the target does not come to rest: it has moved farther than it is large; its supports "
                     "do not hold it "
                     "against the load");
    const double dt = stable_step_;
    kick(0.5 * dt);
    drift(dt);
    evaluate(dt, time);
    kick(0.5 * dt);
    const double now = kinetic_energy();
    if (now < before) {
      stop();
      balance = out_of_balance();
      before = 0;
    } else {
      before = now;
    }
  }
  rotating_frame_ = false;
  std::fill(external_.begin(), external_.end(), Vector3::Zero()); // the centrifugal load is gone
  if (balance > tolerance) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "the target has not come to rest: after %ld steps the forces are out of balance by %.3g, "
                  "allowed is %.3g",
                  steps, balance, tolerance);
    throw RunError(text);
  }
  stop();
  if (settings_.spin)
    for (std::size_t n = 0; n < position.size(); ++n) {
      velocity[n] = steady_velocity(position[n]);
      spin[n] = settings_.spin->velocity;
    }
  evaluate(0, time);
  damped_ = external_work_ = 0;
  support_impulse_ = external_impulse_ = Vector3::Zero();
  return steps;
}

} // namespace birdstrike
