// SPDX-License-Identifier: BSD-3-Clause
// Particles as a file of their own, for ParaView, spreadsheets and other people's programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct Particles;

std::vector<std::string> particle_formats(); //!< ".vtu", ".vtp", ".csv"

struct WriteOptions
{
  bool cells = true; //!< a vertex cell for each particle, which ParaView wants to draw them; not in .csv
};

//! Row k is the particle with id k. The VTK formats hold the arrays of particles_to_vtk. A .csv has one line a particle
//! below the titles "id", "part" (its name), "x[m]", "y[m]", "z[m]", and the quantities of core/fields.h with their units,
//! "mass[kg]", "density[kg/m3]", "velocity_x[m/s]" and so on; numbers read back to the same bits.
//! \throw InputError naming the file if its extension is none of particle_formats()
//! \throw OutputError naming the file and the reason; nothing half-written is left
void write_particles(const Particles& particles, const std::filesystem::path& file,
                     const WriteOptions& options = {});

} // namespace birdstrike
