// SPDX-License-Identifier: GPL-3.0-or-later
// CalculiX (www.calculix.de) beside our shells: a clamped square plate under a pulse of pressure.
#pragma once

#include "core/material/linear_hardening.h"

#include <optional>
#include <string>
#include <vector>

namespace birdstrike::samples {

//! A quarter of a square plate: clamped outer edges, symmetric inner ones. Pressure from above rises from 0 over
//! \p rise and falls to 0 as long; both end on steps, so that implicit steps get its impulse right.
struct PulsedPlate
{
  double half_side = 0.15, thickness = 0.005; //!< [m]
  double young = 72e9, poisson = 0.33, density = 2700;
  std::optional<LinearHardening> hardening;
  double pressure, rise; //!< [Pa], [s]
  double end;            //!< [s]

  //! Place of a grid line, u in 0 ... 1, closer together towards the clamped edge where a hinge of plastic bending forms.
  double line(double u) const;
};

struct PlateHistory
{
  std::vector<double> time, deflection; //!< of the middle, along the pressure [s], [m]
};

//! Run ccx on elements x elements x layers bricks of 20 nodes (C3D20R), implicit dynamics with large displacements.
//! \param name  of the folder for its files, below the build's
//! \throw std::runtime_error if ccx is not there, fails, or takes more than 15 minutes
PlateHistory run_calculix(const PulsedPlate& plate, int elements, int layers, double step,
                          const std::string& name);

//! Run our shells on elements x elements quadrilaterals.
//! \param hourglass_share  gets the largest hourglass over internal energy once the pulse is over
PlateHistory run_shells(const PulsedPlate& plate, int elements, int points, bool triangles,
                        double& hourglass_share);

} // namespace birdstrike::samples
