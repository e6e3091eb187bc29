// SPDX-License-Identifier: BSD-3-Clause
// What stays of a target's deflection once it has come to rest.
#pragma once

#include "core/mesh_target.h"

#include <vector>

namespace birdstrike {

//! Time mean of each node's displacement over the end of a run, sampled at every step.
class PermanentSet
{
public:
  //! Share of a run's time that the mean is taken over, as the filters do if nobody says otherwise.
  static constexpr double window = 0.2;

  //! \param end  of the run [s]
  explicit PermanentSet(double end) : from_((1 - window) * end) {}

  //! Take in the state of time \p time [s]; what lies before the window is passed over.
  void record(const MeshTarget& target, double time);

  struct Largest
  {
    double set = 0;       //!< length of the mean displacement [m]
    double amplitude = 0; //!< how far that node still swings about it [m]
  };

  //! Of the node with the largest set; fragments that no element of \p target holds any more do not count.
  Largest largest(const MeshTarget& target) const;

private:
  struct Node
  {
    Vector3 now = Vector3::Zero(), sum = Vector3::Zero(); // displacement [m]; its integral over time [m s]
    Vector3 low = Vector3::Zero(), high = Vector3::Zero();
  };
  double from_, first_ = 0, last_ = 0; // [s]
  std::vector<Node> nodes_;
};

} // namespace birdstrike
