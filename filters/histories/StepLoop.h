// SPDX-License-Identifier: BSD-3-Clause
// What filters that loop over time steps have in common: which steps, what is shown, whether to stop.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

class vtkAlgorithm;

//! Keeps the times from \p start to \p end, both included (and a little more: written times are rounded).
//! \return why none is left, for a message; empty if there are some. None left keeps the first one.
std::string LimitTimes(std::vector<double>& times, double start, double end);

//! Progress "time step 3 of 100, 0.00015 s" and its share, after step \p step (from 0) of \p steps.
void ShowStep(vtkAlgorithm& filter, std::size_t step, std::size_t steps, double time);

//! Whether somebody wants the filter to stop, by VTK 9.1's flag or the newer check that also looks upstream.
bool Stopped(vtkAlgorithm& filter);
