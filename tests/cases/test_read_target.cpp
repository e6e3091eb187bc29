// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/read_target.h"

#include "core/error.h"
#include "scratch.h"
#include "tests/geometry/shell_decks.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

const char* const vtu = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="7" NumberOfCells="3">
<PointData><DataArray type="UInt8" Name="node_set_set_1" format="ascii">1 1 1 0 0 0 0</DataArray></PointData>
<CellData><DataArray type="Int32" Name="part" format="ascii">1 2 2</DataArray>
<DataArray type="Float64" Name="thickness" format="ascii">2 1.5 1.5</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
.25 -10 0 .25 10 0 .25 30 1.5 .25 -10 20 .25 10 20 .25 30 21.5 .25 20 41</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 3 4 1 1 4 5 2 4 6 5</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4 8 11</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">9 9 5</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
)";

} // namespace

TEST_CASE("one mesh in every format is one target", "[read_target]")
{
  const scratch::Folder folder;
  auto texts = test::deck_texts();
  texts["mesh.vtu"] = vtu;
  texts["MESH.INP"] = texts["mesh.inp"];
  for (const auto& [name, text] : texts) {
    INFO(name);
    ShellImport import = read_target(folder.write(name, text), 1e-3);
    if (name.ends_with(".msh")) { // knows no thickness
      REQUIRE(import.mesh.parts.size() == 2);
      import.mesh.parts[0].thickness = 2e-3;
      import.mesh.parts[1].thickness = 1.5e-3;
    }
    CHECK(test::same_mesh(import.mesh, test::deck_mesh(), 1e-15));
    CHECK(import.warnings.empty());
  }
}

TEST_CASE("an unknown target format lists the known ones", "[read_target]")
{
  CHECK_THROWS_WITH(read_target("plate.xyz"),
                    Catch::Contains("plate.xyz' has the unknown format '.xyz'; known are .vtu, .vtp, .vtk, "
                                    ".msh, .inp, .bdf"));
  CHECK_THROWS_AS(read_target("plate"), InputError);
}
