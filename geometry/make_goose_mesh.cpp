// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the goose of geometry/anatomy.h as a mesh file: make_goose_mesh share/meshes/goose.glb
#include "core/error.h"
#include "geometry/anatomy.h"
#include "geometry/check.h"
#include "geometry/fill.h"
#include "geometry/measure.h"
#include "geometry/part_of_object.h"
#include "geometry/write_glb.h"

#include <cstdio>

int main(int argc, char** argv)
{
  using namespace birdstrike;
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_goose_mesh FILE.glb\n");
    return 2;
  }
  try {
    const SurfaceMesh goose = make_goose();
    std::vector<std::string> part_of;
    for (const SurfaceReport& r : require_solids(goose, argv[1])) {
      part_of.push_back(part_of_object(r.name));
      std::printf("%-10s %6zu triangles, %zu pieces, %8.1f ml\n", r.name.c_str(), r.triangles, r.components,
                  1e6 * r.volume);
    }
    write_glb(goose, argv[1]);

    const Box box = bounding_box(goose);
    std::printf("length %.3f m, span %.3f m, height %.3f m\n", box.upper.x() - box.lower.x(),
                box.upper.y() - box.lower.y(), box.upper.z() - box.lower.z());
    for (double spacing : {0.005, 0.006, 0.007, 0.008}) {
      const Fill fill = fill_lattice(goose, part_of, spacing);
      double mass = 0;
      std::printf("spacing %.0f mm: %zu particles;", 1e3 * spacing, fill.seeds.size());
      for (const FilledPart& p : fill.parts) {
        mass += p.mesh_volume * nominal_density(p.name);
        std::printf(" %s %zu (%+.1f %% of volume)", p.name.c_str(), p.particles,
                    100 * (double(p.particles) * spacing * spacing * spacing / p.mesh_volume - 1));
      }
      std::printf("; mass by the mesh %.3f kg\n", mass);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_goose_mesh: %s\n", error.what());
    return 1;
  }
  return 0;
}
