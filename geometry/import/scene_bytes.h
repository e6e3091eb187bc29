// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as bytes, to travel from the process that read it.
#pragma once

#include "geometry/import/raw_scene.h"

#include <string>
#include <string_view>

namespace birdstrike {

//! Bytes that decode_scene takes back. Only for this machine and this build: no conversion of number formats.
std::string encode_scene(const RawScene& scene);

//! Bytes without their sum, with the right one at the end: for tests that change what is before it.
std::string signed_bytes(std::string bytes);

//! The scene again, after every length, index and coordinate was looked at.
//! \throw InputError saying what is wrong: the bytes come from a reader that a damaged file may have driven mad
RawScene decode_scene(std::string_view bytes);

} // namespace birdstrike
