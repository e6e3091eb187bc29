// SPDX-License-Identifier: GPL-3.0-or-later
// What the first byte of an input of the fuzzer chooses.
#pragma once

#include <array>

namespace birdstrike {

//! A file of that extension; or bytes that go straight into our own code, where coverage is seen: a scene as it comes
//! from the reader's process, triangles made of the bytes, a 3MF read without a process of its own.
inline constexpr std::array fuzz_formats{".obj",
                                         ".stl",
                                         ".ply",
                                         ".off",
                                         ".gltf",
                                         ".glb",
                                         ".dae",
                                         ".3mf",
                                         "scene bytes",
                                         "triangles",
                                         "3mf in this process"};

} // namespace birdstrike
