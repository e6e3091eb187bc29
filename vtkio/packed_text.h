// SPDX-License-Identifier: BSD-3-Clause
// Arrays of whole numbers as text that a page can hold: differences, compressed, in base 64.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace birdstrike {

//! Base 64 (RFC 4648, with padding) of any bytes.
std::string to_base64(std::span<const std::uint8_t> bytes);

//! The numbers as differences to those one row before, modulo 2^8, 2^16 or 2^32 (the first row as it is); then the lowest
//! byte of all of them, then the next one of all ...; then a zlib stream (RFC 1950); then base 64. What moves little from
//! row to row becomes small. \param row  numbers in a row, 0 for no differences
std::string packed(std::span<const std::uint8_t> numbers, std::size_t row);
std::string packed(std::span<const std::uint16_t> numbers, std::size_t row);
std::string packed(std::span<const std::uint32_t> numbers, std::size_t row);

} // namespace birdstrike
