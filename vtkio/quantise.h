// SPDX-License-Identifier: BSD-3-Clause
// Numbers as small whole numbers, for files that people send around.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike {

//! Nearest of the 2^16 evenly spaced values of [low, high]; what lies outside is moved to its nearer end, a NaN to low. The
//! error is at most (high - low) / 65535 / 2 inside. All 0 if high <= low.
std::uint16_t to_16_bits(double value, double low, double high);

//! The same with 2^8 values: at most (high - low) / 255 / 2 off inside.
std::uint8_t to_8_bits(double value, double low, double high);

//! The value that such a number stands for.
double from_16_bits(std::uint16_t number, double low, double high);
double from_8_bits(std::uint8_t number, double low, double high);

//! Range that colours should span: lowest finite value to the value that of those above the lowest only \p share exceed, so
//! that a few outliers do not make all others look the same. {0, 0} without any. \param values  in any order
std::array<double, 2> range_without_outliers(std::vector<float> values, double share);

} // namespace birdstrike
