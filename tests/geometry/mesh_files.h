// SPDX-License-Identifier: GPL-3.0-or-later
// Small writers of every mesh format that the importer reads, for tests and for the seeds of the fuzzer.
#pragma once

#include "geometry/surface_mesh.h"

#include <string>
#include <vector>

namespace birdstrike::test {

//! The bytes of a file; coordinates are written as they are.
std::string obj_bytes(const SurfaceMesh& mesh, char keyword = 'g', bool materials = false);
std::string stl_text(const SurfaceMesh& mesh);
std::string stl_bytes(const SurfaceMesh& mesh, const std::string& header = "binary");
enum class PlyKind
{
  text,
  little_endian,
  big_endian
};
std::string ply_bytes(const SurfaceMesh& mesh, PlyKind kind = PlyKind::text);
std::string off_bytes(const SurfaceMesh& mesh);
//! Positions in a data URI; \p generator as the asset's, \p nodes replaces the JSON of the nodes ("" for one a part).
std::string gltf_bytes(const SurfaceMesh& mesh, const std::string& generator = "test",
                       const std::string& nodes = "", const std::string& roots = "");
std::string dae_bytes(const SurfaceMesh& mesh, const std::string& asset = "");
//! A zip archive, not compressed. \p unit "" for none.
std::string mf3_bytes(const SurfaceMesh& mesh, const std::string& unit = "meter");

struct SampleFile
{
  std::string name; //!< "sample.obj": the stem and the format's usual extension
  std::string bytes;
};
//! The same mesh in every format.
std::vector<SampleFile> sample_files(const SurfaceMesh& mesh);

//! A bird of 1.5 m span in metres: torso, head with bill, tail, and two wings, all closed.
SurfaceMesh small_bird();

} // namespace birdstrike::test
