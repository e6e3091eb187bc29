// SPDX-License-Identifier: BSD-3-Clause
// SeriesWriter and the readers, there and back, and what broken disks and files do.
#include "vtkio/series_reader.h"
#include "vtkio/series_writer.h"

#include "core/error.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/shells_to_vtk.h"
#include "vtkio/vtkBirdStrikeSeriesReader.h"
#include "vtkio/vtk_errors.h"

#include <catch2/catch.hpp>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <fstream>
#include <set>
#include <sstream>

using namespace birdstrike;
namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

void check_same(vtkFieldData& read, vtkFieldData& written)
{
  for (int k = 0; k < written.GetNumberOfArrays(); ++k) {
    vtkDataArray* expected = written.GetArray(k);
    if (!expected)
      continue;
    vtkDataArray* found = read.GetArray(expected->GetName());
    INFO(expected->GetName());
    REQUIRE(found);
    REQUIRE(found->GetDataType() == expected->GetDataType());
    REQUIRE(found->GetNumberOfComponents() == expected->GetNumberOfComponents());
    REQUIRE(found->GetNumberOfTuples() == expected->GetNumberOfTuples());
    for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
      for (int c = 0; c < expected->GetNumberOfComponents(); ++c)
        REQUIRE(found->GetComponent(i, c) == expected->GetComponent(i, c));
  }
}

void check_same(vtkUnstructuredGrid& read, vtkUnstructuredGrid& written)
{
  REQUIRE(read.GetNumberOfPoints() == written.GetNumberOfPoints());
  for (vtkIdType i = 0; i < written.GetNumberOfPoints(); ++i) {
    double p[3], q[3];
    read.GetPoint(i, p);
    written.GetPoint(i, q);
    REQUIRE((p[0] == q[0] && p[1] == q[1] && p[2] == q[2]));
  }
  REQUIRE(read.GetNumberOfCells() == written.GetNumberOfCells());
  check_same(*read.GetPointData(), *written.GetPointData());
  check_same(*read.GetCellData(), *written.GetCellData());
  check_same(*read.GetFieldData(), *written.GetFieldData());
}

std::string text_of(const fs::path& file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// Times without a short decimal form.
double time_of(int k) { return k * (1e-3 / 7) + (k > 0 ? 1e-19 : 0); }

RigidPlate plate_of(int k) // another one in every frame: equal ones share a file
{
  RigidPlate plate = made_plate();
  plate.force[0][0] += k;
  return plate;
}

void write_series(const fs::path& folder, int frames)
{
  SeriesWriter writer(folder);
  for (int k = 0; k < frames; ++k)
    writer.write_frame(time_of(k), *particles_to_vtk(made_bird(0.03, 0.2 * k), time_of(k)),
                       plate_to_vtk(plate_of(k), time_of(k)));
}

} // namespace

TEST_CASE("frames come back bit for bit, with exact times and names", "[series]")
{
  TemporaryFolder folder;
  write_series(folder.path, 4);
  const SeriesIndex index = read_series_index(folder.path / "run.pvd");
  REQUIRE(index.steps.size() == 4);
  for (int k = 0; k < 4; ++k) {
    const auto step = static_cast<std::size_t>(k);
    CHECK(index.steps[step].time == time_of(k));
    REQUIRE(index.steps[step].pieces.size() == 2);
    CHECK(index.steps[step].pieces[0].name == "bird");
    CHECK(index.steps[step].pieces[1].name == "target");
    const Frame frame = read_frame(index, step);
    check_same(*frame.bird, *particles_to_vtk(made_bird(0.03, 0.2 * k), time_of(k)));
    check_same(*frame.target, *plate_to_vtk(plate_of(k), time_of(k)));
    auto* names = vtkStringArray::SafeDownCast(frame.bird->GetFieldData()->GetAbstractArray("part_names"));
    REQUIRE(names);
    CHECK(names->GetValue(0) == "lungs");
  }
  CHECK(index.nearest(time_of(2) * 1.01) == 2);
  CHECK(index.nearest(1.0) == 3);
}

TEST_CASE("the series moves with its folder: the index has relative paths", "[series]")
{
  TemporaryFolder folder;
  write_series(folder.path / "a", 2);
  fs::rename(folder.path / "a", folder.path / "b");
  const SeriesIndex index = read_series_index(folder.path / "b" / "run.pvd");
  CHECK(read_frame(index, 1).bird->GetNumberOfPoints() > 0);
  CHECK(text_of(folder.path / "b" / "run.pvd").find(folder.path.string()) == std::string::npos);
}

TEST_CASE("after every frame the index lists exactly the frames on disk", "[series]")
{
  TemporaryFolder folder;
  SeriesWriter writer(folder.path);
  std::uintmax_t bytes = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    writer.write_frame(1e-3 * static_cast<double>(k), *particles_to_vtk(made_bird(0.03), 0)); // no target
    const SeriesIndex index = read_series_index(writer.path());
    REQUIRE(index.steps.size() == k + 1);
    REQUIRE(index.steps[k].pieces.size() == 1);
    bytes += fs::file_size(index.steps[k].pieces[0].file);
    CHECK(writer.frames() == k + 1);
    CHECK(writer.bytes() == bytes);
    CHECK_FALSE(read_frame(index, k).target);
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder.path))
    CHECK(entry.path().extension() != ".tmp");
}

TEST_CASE("very many frames are listed some together, and all at the end", "[series]")
{
  TemporaryFolder folder;
  SeriesOptions few;
  few.fields = {"pressure"};
  constexpr std::size_t written = 2104;
  std::size_t behind = 0;
  {
    SeriesWriter writer(folder.path, few);
    const auto bird = particles_to_vtk(made_bird(0.1), 0);
    for (std::size_t k = 1; k <= written; ++k) {
      writer.write_frame(1e-6 * static_cast<double>(k), *bird);
      if (k < 990 || (k > 1010 && k < written - 10))
        continue;
      const std::size_t listed = read_series_index(writer.path()).steps.size();
      CHECK(listed <= k);
      CHECK(listed + k / 1000 >= k);
      if (k <= 1000)
        CHECK(listed == k);
      behind += listed < k;
    }
    REQUIRE(read_series_index(writer.path()).steps.size() < written); // else the rest would be no test
  }
  CHECK(behind > 5);
  CHECK(read_series_index(folder.path / "run.pvd").steps.size() == written);
}

TEST_CASE("what is discarded leaves no series", "[series]")
{
  TemporaryFolder folder;
  SeriesOptions both;
  both.packed = true;
  {
    SeriesWriter writer(folder.path, both);
    writer.write_frame(0, *particles_to_vtk(made_bird(0.05), 0));
    writer.discard();
  }
  CHECK_FALSE(fs::exists(folder.path / "run.pvd"));
  CHECK_FALSE(fs::exists(folder.path / "run.bss"));
  CHECK(fs::is_empty(folder.path / "frames"));
}

TEST_CASE("a run killed while it writes leaves a series that opens", "[series]")
{
  TemporaryFolder folder;
  write_series(folder.path, 2);
  // What a kill leaves: the next frame half written, its target not begun.
  std::ofstream(folder.path / "frames" / "bird_0002.vtu.tmp") << "<VTKFile type=\"Unstr";
  const SeriesIndex index = read_series_index(folder.path / "run.pvd");
  REQUIRE(index.steps.size() == 2);
  CHECK(read_frame(index, 1).target);

  SECTION("and the next run clears it away")
  {
    const std::set<std::string> mine{"notes.txt", "bird_of_mine.vtu", "bird_.vtu", "target_1b.vtu"};
    for (const std::string& name : mine)
      std::ofstream(folder.path / "frames" / name) << "mine";
    SeriesWriter next(folder.path);
    CHECK_FALSE(fs::exists(folder.path / "run.pvd"));
    std::set<std::string> left;
    for (const auto& entry : fs::directory_iterator(folder.path / "frames"))
      left.insert(entry.path().filename().string());
    CHECK(left == mine);
  }
}

TEST_CASE("frames written in the background are the same files, and their errors are not lost", "[series]")
{
  TemporaryFolder folder;
  SeriesOptions behind;
  behind.background = behind.packed = true;
  SeriesOptions at_once = behind;
  at_once.background = false;
  const auto write = [&](const fs::path& place, const SeriesOptions& options) {
    SeriesWriter writer(place, options);
    for (int k = 0; k < 5; ++k) {
      auto bird = made_bird(0.03);
      bird.pressure[0] = 1e6 * k;
      writer.write_frame(1e-3 * k, *particles_to_vtk(bird, 1e-3 * k), plate_to_vtk(made_plate(), 1e-3 * k));
    }
    writer.finish();
    CHECK(writer.frames() == 5);
    return writer.bytes();
  };
  CHECK(write(folder.path / "a", behind) == write(folder.path / "b", at_once));
  for (const char* file : {"run.pvd", "run.bss", "frames/bird_0004.vtu", "frames/target_0000.vtu"})
    CHECK(text_of(folder.path / "a" / file) == text_of(folder.path / "b" / file));

  const auto bird = particles_to_vtk(made_bird(0.04), 0);
  for (const bool at_end : {false, true}) {
    SeriesWriter writer(folder.path / "run", behind);
    fs::remove_all(folder.path / "run");
    writer.write_frame(0, *bird);
    if (at_end)
      CHECK_THROWS_WITH(writer.finish(), Contains("bird_0000.vtu"));
    else
      CHECK_THROWS_WITH(writer.write_frame(1e-3, *bird), Contains("bird_0000.vtu"));
    CHECK(writer.frames() == 0);
  }
}

TEST_CASE("a folder that cannot be made or written is named", "[series]")
{
  TemporaryFolder folder;
  std::ofstream(folder.path / "file") << "x";
  CHECK_THROWS_AS(SeriesWriter(folder.path / "file"), OutputError);
  CHECK_THROWS_WITH(SeriesWriter(folder.path / "file"), Contains((folder.path / "file").string()));

  // The folder disappears while the run goes on; works as root too, unlike taking away permissions.
  SeriesWriter writer(folder.path / "run");
  fs::remove_all(folder.path / "run");
  const auto bird = particles_to_vtk(made_bird(0.04), 0);
  CHECK_THROWS_AS(writer.write_frame(0, *bird), OutputError);
  CHECK_THROWS_WITH(writer.write_frame(0, *bird), Contains("bird_0000.vtu") && Contains("No such file"));
  CHECK(writer.frames() == 0);
}

TEST_CASE("a full disk is an error, and nothing half-written stays", "[series]")
{
  if (!fs::exists("/dev/full"))
    return;
  TemporaryFolder folder;
  SeriesWriter writer(folder.path);
  fs::create_symlink("/dev/full", folder.path / "frames" / "bird_0000.vtu.tmp");
  const auto bird = particles_to_vtk(made_bird(0.03), 0);
  CHECK_THROWS_AS(writer.write_frame(0, *bird), OutputError);
  CHECK_FALSE(fs::exists(folder.path / "frames" / "bird_0000.vtu"));
  CHECK_FALSE(fs::exists(writer.path()));
}

TEST_CASE("broken series are named with what is wrong", "[series]")
{
  TemporaryFolder folder;
  const fs::path pvd = folder.path / "x.pvd";
  const auto index_of = [&](const std::string& text) {
    std::ofstream(pvd) << text;
    return read_series_index(pvd);
  };
  CHECK_THROWS_AS(read_series_index(folder.path / "none.pvd"), InputError);
  CHECK_THROWS_WITH(read_series_index(folder.path / "none.pvd"),
                    Contains("none.pvd") && Contains("no such file"));
  CHECK_THROWS_WITH(read_series_index(folder.path), Contains("neither run.pvd nor run.bss"));
  CHECK_THROWS_WITH(index_of(""), Contains("x.pvd") && Contains("not a ParaView series"));
  CHECK_THROWS_WITH(index_of("time,pressure\n0,1\n"), Contains("not a ParaView series"));
  CHECK_THROWS_WITH(index_of("<VTKFile type=\"Collection\"><Collection><DataSet timest"),
                    Contains("not a ParaView series"));
  CHECK_THROWS_WITH(index_of("<VTKFile type=\"UnstructuredGrid\"/>"), Contains("no Collection"));
  CHECK_THROWS_WITH(index_of("<VTKFile type=\"Collection\"><Collection/></VTKFile>"),
                    Contains("lists no frames"));
  CHECK_THROWS_WITH(
      index_of("<VTKFile><Collection><DataSet timestep=\"soon\" file=\"a.vtu\"/></Collection></VTKFile>"),
      Contains("timestep=\"soon\""));
  CHECK_THROWS_WITH(index_of("<VTKFile><Collection><DataSet timestep=\"1\"/></Collection></VTKFile>"),
                    Contains("names no file"));
}

TEST_CASE("a truncated, garbage or missing frame is named", "[series]")
{
  TemporaryFolder folder;
  write_series(folder.path, 1);
  const SeriesIndex index = read_series_index(folder.path / "run.pvd");
  const fs::path frame = index.steps[0].pieces[0].file;
  const auto size = fs::file_size(frame);
  for (const double share : {0.9, 0.5, 0.1}) {
    fs::resize_file(frame, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
    INFO(share);
    CHECK_THROWS_AS(read_frame(index, 0), InputError);
    CHECK_THROWS_WITH(read_frame(index, 0), Contains("bird_0000.vtu") && Contains("damaged"));
  }
  std::ofstream(frame) << "not XML at all";
  CHECK_THROWS_WITH(read_frame(index, 0), Contains("damaged"));
  fs::remove(frame);
  CHECK_THROWS_WITH(read_frame(index, 0), Contains("no such file"));
  CHECK_THROWS_WITH(read_frame(index, 5), Contains("1 frames") && Contains("number 5"));
}

TEST_CASE("the pipeline reader publishes the times and gives named blocks", "[series][pipeline]")
{
  TemporaryFolder folder;
  write_series(folder.path, 3);
  auto reader = vtkSmartPointer<vtkBirdStrikeSeriesReader>::New();
  reader->SetFileName((folder.path / "run.pvd").string());
  reader->UpdateInformation();
  vtkInformation& info = *reader->GetOutputInformation(0);
  REQUIRE(info.Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) == 3);
  for (int k = 0; k < 3; ++k)
    CHECK(info.Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[k] == time_of(k));
  CHECK(info.Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE())[1] == time_of(2));

  reader->UpdateTimeStep(time_of(1));
  vtkMultiBlockDataSet& blocks = *reader->GetOutput();
  REQUIRE(blocks.GetNumberOfBlocks() == 2);
  CHECK(blocks.GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()) == std::string("bird"));
  CHECK(blocks.GetMetaData(1u)->Get(vtkCompositeDataSet::NAME()) == std::string("target"));
  CHECK(blocks.GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) == time_of(1));
  check_same(*vtkUnstructuredGrid::SafeDownCast(blocks.GetBlock(0)),
             *particles_to_vtk(made_bird(0.03, 0.2), time_of(1)));
}

TEST_CASE("the pipeline reader reports broken files as VTK errors", "[series][pipeline]")
{
  TemporaryFolder folder;
  write_series(folder.path, 2);
  auto errors = vtkSmartPointer<VtkErrors>::New();
  auto reader = vtkSmartPointer<vtkBirdStrikeSeriesReader>::New();
  errors->watch(*reader);
  SECTION("missing series")
  {
    reader->SetFileName((folder.path / "none.pvd").string());
    reader->Update();
    CHECK_THAT(errors->first(), Contains("no such file"));
  }
  SECTION("truncated frame")
  {
    fs::resize_file(folder.path / "frames" / "bird_0001.vtu", 1000);
    reader->SetFileName((folder.path / "run.pvd").string());
    reader->UpdateInformation();
    reader->UpdateTimeStep(time_of(1));
    CHECK_THAT(errors->first(), Contains("bird_0001.vtu") && Contains("damaged"));
    CHECK(reader->GetOutput()->GetNumberOfBlocks() == 0);
  }
}
