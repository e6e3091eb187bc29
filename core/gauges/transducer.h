// SPDX-License-Identifier: BSD-3-Clause
// Virtual pressure transducers: round faces let into a plate, as on a test rig.
#pragma once

#include "core/gauges/history.h"
#include "core/particles/sph_rates.h"

#include <string>
#include <vector>

namespace birdstrike {

struct Transducer
{
  std::string name;
  double y = 0, z = 0;  //!< centre of the face on the plate [m]
  double diameter = 0;  //!< of the face [m]
  double rise_time = 0; //!< 10-90 % of the single-pole low pass behind it; 0 for none [s]
};

//! Share of a disc of radius \p footprint that lies on a disc of radius \p face whose centre is \p distance away [-].
//! Over faces that tile the plane the shares of one disc add up to 1.
double face_share(double distance, double face, double footprint);

//! Radius of the disc over which the force of one particle on the plate is spread [m]: 1.117 spacings. The Fourier
//! transform of that disc is zero at the wave number of the lattice (second zero of the Bessel function J1), so that an
//! undisturbed lattice presses evenly, wherever the face lies.
double footprint_radius(double spacing);

//! State of a single-pole low pass y' = (p - y) / tau, tau = rise_time / ln 9, after \p duration [s], exact for a p that
//! goes from \p from to \p to in a straight line.
double low_pass(double state, double from, double to, double duration, double rise_time);

//! Samples the faces at every step.
class TransducerGauges
{
public:
  //! \throw InputError naming the transducer unless diameters are positive and rise times not negative
  TransducerGauges(std::vector<Transducer> transducers, double spacing);

  //! Append the pressures of this moment: the plate's forces on the particles, by their shares on the face, over the
  //! face's area. What throw_back() throws back at the plate is an impulse between two moments and is not in it.
  void record(const Particles& particles, const Rates& rates, double time);

  //! Columns time, then <name>_raw and <name>_filtered of each; no column at all without a transducer.
  const History& history() const { return history_; }

private:
  std::vector<Transducer> transducers_;
  double footprint_;
  History history_;
  std::vector<double> force_;
};

} // namespace birdstrike
