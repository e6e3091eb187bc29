// SPDX-License-Identifier: GPL-3.0-or-later
// A plane wave against the Rankine-Hugoniot state of its law.
#pragma once

#include "core/gauges/history.h"
#include "core/material/equation_of_state.h"

#include <nlohmann/json_fwd.hpp>

namespace birdstrike {

//! A column of particles on a rigid plate; the shock runs through its first part.
struct PlaneWave
{
  EquationOfState law;     //!< of the part next to the plate
  int layers = 0;          //!< of that part
  double spacing = 0;      //!< [m]
  double speed = 0;        //!< into the plate [m/s]
  double contact_time = 0; //!< when the gap is closed [s]
  double area = 0;         //!< of the plate [m2]
};

struct PlanarCheck
{
  double hugoniot_pressure = 0; //!< of the law [Pa]
  double shock_speed = 0;       //!< against the matter ahead [m/s]
  //! The plateau: from 15 layers shocked until the part is, or the run ends; layer n is shocked n spacing / u_s after
  //! contact.
  double plateau_begin = 0, plateau_end = 0; //!< [s]
  double plateau_mean = 0;                   //!< over time [Pa]
  double plateau_ripple = 0;                 //!< half of peak to peak over the mean [-]
  double overshoot =
      0; //!< largest plate pressure before 15 layers are shocked over the Hugoniot pressure [-]
};

//! From the plate's pressure at every step (contact_force_x of \p history). NaN where the run is too short.
//! \throw InputError as hugoniot
PlanarCheck check_plane_wave(const History& history, const PlaneWave& wave);

//! NaN becomes null.
nlohmann::ordered_json to_json(const PlanarCheck& check);

} // namespace birdstrike
