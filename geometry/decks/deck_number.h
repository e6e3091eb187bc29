// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in the columns of a deck, with as many digits as fit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace birdstrike {

//! \p value right-aligned in \p width >= 10 columns, with a decimal point and the most digits that fit. The first column
//! stays blank if that changes the number by no more than 1e-6 (10 columns) or 1e-9 (more) of it.
//!
//! Whatever the sign, and the exponent of up to two digits, 10 columns hold at least 4 significant digits, 16 hold 10 (12
//! or more for a number from 0.01 to 1e6), and 20 hold 14.
std::string real_field(double value, std::size_t width);

//! \throw InputError if it does not fit
std::string integer_field(std::int64_t value, std::size_t width);

//! The shortest text that reads back to the same bits, with a decimal point: for decks whose fields have no width.
std::string free_real(double value);

//! To so many significant digits, for numbers of which nobody wants more.
double rounded(double value, int digits);
inline std::string rounded_real(double value, int digits = 4) { return free_real(rounded(value, digits)); }

} // namespace birdstrike
