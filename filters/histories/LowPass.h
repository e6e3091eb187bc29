// SPDX-License-Identifier: BSD-3-Clause
// A single-pole low pass, as behind a pressure transducer.
#pragma once

#include <vector>

/**
 * The signal behind y' = (x - y) / tau, tau = RiseTime / ln 9, with the 10 to 90 % rise time \p riseTime [s], exact for
 * values on straight lines between their \p times [s]. It begins at rest, with the first value
 * that is a number, so that a part of a series has no false rise at its start; a later NaN counts as 0. A rise time of 0
 * gives the values back.
 */
std::vector<double> LowPass(const std::vector<double>& times, const std::vector<double>& values,
                            double riseTime);
