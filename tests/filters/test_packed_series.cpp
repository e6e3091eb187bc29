// SPDX-License-Identifier: BSD-3-Clause
// Packed series: there and back within what was promised, from any frame, and what cuts and damage do.
#include "filters/series/PackedFile.h"
#include "filters/series/vtkPackedSeriesReader.h"

#include "tests/filters/made_cloud.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/shells_to_vtk.h"
#include "vtkio/thin_grid.h"

#include <catch2/catch.hpp>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <random>

using namespace birdstrike;
namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

constexpr double interval = 2e-6; // between frames [s]

vtkSmartPointer<vtkUnstructuredGrid> bird_at(int frame)
{
  Particles bird = made_bird(0.03);
  for (std::size_t i = 0; i < bird.size(); ++i) {
    const double t = frame * interval, phase = 40 * bird.y[i] + 2e4 * t;
    bird.x[i] += bird.vx[i] * t;
    bird.vx[i] *= 1 - 0.3 * std::sin(phase) * t / 1e-4;
    bird.pressure[i] *= 1 + 0.5 * std::cos(phase);
    bird.energy[i] += 100 * frame * std::sin(phase);
  }
  return particles_to_vtk(bird, frame * interval);
}

vtkSmartPointer<vtkUnstructuredGrid> target_at(int frame)
{
  RigidPlate plate = made_plate();
  for (auto& force : plate.force)
    force *= 1 + 0.1 * frame;
  return plate_to_vtk(plate, frame * interval);
}

std::vector<NamedGrid> state_at(int frame)
{
  return {{"bird", bird_at(frame)}, {"target", target_at(frame)}};
}

std::string write(const fs::path& folder, int frames, double accuracy,
                  const std::function<std::vector<NamedGrid>(int)>& state = state_at)
{
  const std::string file = folder / "run.bss";
  PackedWriter writer(file, accuracy);
  for (int k = 0; k < frames; ++k)
    writer.Write(k * interval, state(k));
  CHECK(writer.Bytes() == fs::file_size(file));
  return file;
}

std::vector<double> values_of(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      values.push_back(array->GetComponent(i, c));
  return values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

//! All arrays and points, by name.
std::map<std::string, std::vector<double>> all_values(vtkUnstructuredGrid* grid)
{
  std::map<std::string, std::vector<double>> all;
  all["points"] = values_of(grid->GetPoints()->GetData());
  all["connectivity"] = values_of(grid->GetCells()->GetConnectivityArray());
  all["offsets"] = values_of(grid->GetCells()->GetOffsetsArray());
  all["cell types"] = values_of(reinterpret_cast<vtkDataArray*>(grid->GetCellTypesArray()));
  const std::pair<const char*, vtkFieldData*> places[] = {
      {"point ", grid->GetPointData()}, {"cell ", grid->GetCellData()}, {"field ", grid->GetFieldData()}};
  for (const auto& [place, data] : places)
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
      if (vtkDataArray* array = data->GetArray(k))
        all[std::string(place) + array->GetName()] = values_of(array);
  return all;
}

std::string text_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("a packed frame is as near as it was asked to be, over many frames and key frames", "[packed]")
{
  TemporaryFolder folder;
  const double accuracy = GENERATE(1e-3, 1e-5);
  constexpr int frames = 150; // over two key frames after the first
  PackedFile file(write(folder.path, frames, accuracy));
  REQUIRE(file.Times().size() == frames);
  std::map<std::string, double> magnitude; // so far
  for (int k = 0; k < frames; ++k) {
    CHECK(file.Times()[static_cast<std::size_t>(k)] == k * interval);
    const auto read = file.Read(static_cast<std::size_t>(k)), written = state_at(k);
    REQUIRE(read.size() == 2);
    for (std::size_t piece = 0; piece < 2; ++piece) {
      REQUIRE(read[piece].first == written[piece].first);
      const auto found = all_values(read[piece].second), expected = all_values(written[piece].second);
      REQUIRE(found.size() == expected.size());
      for (const auto& [name, values] : expected) {
        INFO("frame " << k << ", " << read[piece].first << ", " << name);
        REQUIRE(found.contains(name));
        double& largest = magnitude[written[piece].first + name];
        for (const double value : values)
          largest = std::max(largest, std::abs(value));
        const double reference = name == "points" ? 0.03 : largest;
        REQUIRE(largest_difference(found.at(name), values) <= accuracy * reference * (1 + 1e-9));
      }
      for (const char* exact : {"point part", "point id", "point mass", "point smoothing_length",
                                "connectivity", "offsets", "cell types", "field spacing", "field TimeValue"})
        if (expected.contains(exact))
          REQUIRE(found.at(exact) == expected.at(exact));
    }
  }
  const auto last = file.Read(frames - 1);
  auto* names = vtkStringArray::SafeDownCast(last[0].second->GetFieldData()->GetAbstractArray("part_names"));
  REQUIRE(names);
  CHECK(names->GetValue(4) == "torso");
}

TEST_CASE("the rounding of single precision is within the accuracy, too", "[packed]")
{
  TemporaryFolder folder;
  const double accuracy = GENERATE(1e-6, 3e-7, 1e-7, 1e-8);
  SeriesOptions single;
  single.single_precision = true;
  const auto state = [&](int frame) {
    return std::vector<NamedGrid>{{"bird", thin_grid(*bird_at(frame), single)}};
  };
  PackedFile file(write(folder.path, 10, accuracy, state));
  std::map<std::string, double> magnitude; // so far
  for (int k = 0; k < 10; ++k) {
    const auto found = all_values(file.Read(static_cast<std::size_t>(k))[0].second);
    for (const auto& [name, values] : all_values(state(k)[0].second)) {
      for (const double value : values)
        magnitude[name] = std::max(magnitude[name], std::abs(value));
      INFO("accuracy " << accuracy << ", frame " << k << ", " << name);
      const double reference = name == "points" ? 0.03 : magnitude[name];
      CHECK(largest_difference(found.at(name), values) <= accuracy * reference * (1 + 1e-9));
    }
  }
}

TEST_CASE("accuracy 0 keeps every bit", "[packed]")
{
  TemporaryFolder folder;
  PackedFile file(write(folder.path, 5, 0));
  for (int k = 0; k < 5; ++k)
    for (std::size_t piece = 0; piece < 2; ++piece)
      CHECK(all_values(file.Read(static_cast<std::size_t>(k))[piece].second) ==
            all_values(state_at(k)[piece].second));
}

TEST_CASE("with accuracy 0 a zero keeps its sign", "[packed]")
{
  TemporaryFolder folder;
  const auto state = [](int frame) {
    auto bird = bird_at(0);
    bird->GetPointData()->GetArray("pressure")->SetComponent(2, 0, frame == 1 ? -0.0 : 0.0);
    return std::vector<NamedGrid>{{"bird", bird}};
  };
  PackedFile file(write(folder.path, 3, 0, state));
  for (int k = 0; k < 3; ++k)
    CHECK(std::signbit(file.Read(static_cast<std::size_t>(k))[0]
                           .second->GetPointData()
                           ->GetArray("pressure")
                           ->GetComponent(2, 0)) == (k == 1));
}

TEST_CASE("frames read in any order are those read one after the other", "[packed]")
{
  TemporaryFolder folder;
  constexpr std::size_t frames = 140;
  const std::string name = write(folder.path, frames, 1e-4);
  PackedFile in_order(name), at_random(name);
  std::vector<std::map<std::string, std::vector<double>>> expected;
  for (std::size_t k = 0; k < frames; ++k)
    expected.push_back(all_values(in_order.Read(k)[0].second));
  std::mt19937 random(7);
  for (int trial = 0; trial < 40; ++trial) {
    const std::size_t k = random() % frames;
    INFO(k);
    CHECK(all_values(at_random.Read(k)[0].second) == expected[k]);
  }
  CHECK_THROWS_WITH(at_random.Read(frames), Contains("no frame 140"));
}

TEST_CASE("what does not change costs nothing", "[packed]")
{
  TemporaryFolder folder;
  const auto still = [](int) { return state_at(3); };
  const auto one = fs::file_size(write(folder.path, 1, 1e-4, still));
  const auto ten = fs::file_size(write(folder.path, 11, 1e-4, still));
  CHECK((ten - one) / 10 < 100); // bytes a frame, of some 100,000
}

TEST_CASE("values that are not finite come back as they are, those of other particles too", "[packed]")
{
  TemporaryFolder folder;
  const auto broken = [](int frame) {
    auto state = state_at(frame);
    vtkDataArray* pressure = state[0].second->GetPointData()->GetArray("pressure");
    if (frame % 2 == 1) {
      pressure->SetComponent(3, 0, std::numeric_limits<double>::quiet_NaN());
      pressure->SetComponent(4, 0, std::numeric_limits<double>::infinity());
    }
    return state;
  };
  PackedFile file(write(folder.path, 4, 1e-3, broken));
  for (int k = 0; k < 4; ++k) {
    const auto read =
        values_of(file.Read(static_cast<std::size_t>(k))[0].second->GetPointData()->GetArray("pressure"));
    const auto written = values_of(broken(k)[0].second->GetPointData()->GetArray("pressure"));
    for (std::size_t i = 0; i < read.size(); ++i) {
      if (k % 2 == 1 && i == 3)
        CHECK(std::isnan(read[i]));
      else if (k % 2 == 1 && i == 4)
        CHECK(read[i] == std::numeric_limits<double>::infinity());
      else
        REQUIRE(std::abs(read[i] - written[i]) <= 1e-3 * 60e6);
    }
  }
}

TEST_CASE("a file that is cut anywhere opens with its whole frames", "[packed]")
{
  TemporaryFolder folder;
  const std::string name = write(folder.path, 4, 1e-3);
  std::vector<std::size_t> ends; // of each frame
  for (int frames = 1; frames <= 4; ++frames) {
    fs::create_directory(folder.path / std::to_string(frames));
    ends.push_back(fs::file_size(write(folder.path / std::to_string(frames), frames, 1e-3)));
  }
  const std::string whole = text_of(name);
  REQUIRE(ends.back() == whole.size());
  const std::string cut = folder.path / "cut.bss";
  const std::size_t step = whole.size() / 97;
  std::vector<std::size_t> sizes{0, 5, 16, 17, 40, ends[0] - 1, ends[0], ends[0] + 1, ends[2] - 1, ends[2]};
  for (std::size_t size = step; size < whole.size(); size += step)
    sizes.push_back(size);
  for (const std::size_t size : sizes) {
    INFO(size << " of " << whole.size() << " bytes");
    std::ofstream(cut, std::ios::binary) << whole.substr(0, size);
    const auto frames = static_cast<std::size_t>(
        std::count_if(ends.begin(), ends.end(), [size](std::size_t end) { return end <= size; }));
    if (frames == 0) {
      CHECK_THROWS_WITH(PackedFile(cut), Contains(size < 16 ? "not a packed series" : "no whole frame"));
      continue;
    }
    PackedFile file(cut);
    REQUIRE(file.Times().size() == frames);
    CHECK(file.Complaint().empty() == (size == ends[frames - 1]));
    CHECK(
        (size == ends[frames - 1] || file.Complaint().find("ended while it wrote it") != std::string::npos));
    CHECK(file.Read(frames - 1)[0].second->GetNumberOfPoints() == bird_at(0)->GetNumberOfPoints());
  }
}

TEST_CASE("damage is always told of, and what is still given is right", "[packed]")
{
  TemporaryFolder folder;
  const std::string whole = text_of(write(folder.path, 3, 1e-3));
  PackedFile sound(folder.path / "run.bss");
  std::vector<std::map<std::string, std::vector<double>>> expected;
  for (std::size_t k = 0; k < 3; ++k)
    expected.push_back(all_values(sound.Read(k)[0].second));
  const std::string name = folder.path / "damaged.bss";
  std::mt19937 random(11);
  int silent = 0;
  for (int trial = 0; trial < 200; ++trial) {
    INFO("trial " << trial);
    std::string damaged = whole;
    const std::size_t region = trial % 3 == 0 ? 64 : damaged.size(); // the first header, too
    for (int k = 0; k < 1 + trial % 4; ++k)
      damaged[random() % region] = static_cast<char>(random());
    std::ofstream(name, std::ios::binary) << damaged;
    bool told = false;
    std::size_t right = 0;
    try {
      PackedFile file(name);
      told = !file.Complaint().empty();
      for (std::size_t k = 0; k < file.Times().size(); ++k) {
        const auto read = all_values(file.Read(k)[0].second);
        CHECK(read == expected[k]);
        ++right;
      }
    } catch (const std::runtime_error& error) {
      told = !std::string(error.what()).empty();
    }
    // A few bits of zlib's own, as the level that it packed with, mean nothing: then all frames are there and right.
    CHECK((told || right == 3));
    silent += !told;
  }
  CHECK(silent < 20); // else nothing was damaged
}

TEST_CASE("a change anywhere in a header is told of", "[packed]")
{
  TemporaryFolder folder;
  const std::string whole = text_of(write(folder.path, 3, 1e-3));
  fs::create_directory(folder.path / "one");
  const std::size_t second = fs::file_size(write(folder.path / "one", 1, 1e-3)); // where its header begins
  const std::string name = folder.path / "damaged.bss";
  for (std::size_t at = 0; at < 40; ++at)
    for (const char bit : {1, 64}) {
      INFO("byte " << at << " of the second header");
      std::string damaged = whole;
      damaged[second + at] = static_cast<char>(damaged[second + at] ^ bit);
      std::ofstream(name, std::ios::binary) << damaged;
      PackedFile file(name);
      CHECK(file.Times().size() == 1);
      CHECK_THAT(file.Complaint(), Contains("damaged after them"));
    }
}

TEST_CASE("sums over the cells are as exact as single values", "[packed]")
{
  // Impulses of a plate: a few cells have nearly all, many have little; all that grows step by step, by less than what
  // a share of the largest would show.
  TemporaryFolder folder;
  const double accuracy = GENERATE(1e-3, 1e-4);
  const auto state = [](int frame) {
    auto target = target_at(0);
    auto* impulse = target->GetCellData()->GetArray("contact_impulse");
    for (vtkIdType c = 0; c < impulse->GetNumberOfTuples(); ++c)
      for (int k = 0; k < 3; ++k)
        impulse->SetComponent(c, k, frame * (c % 50 == 0 ? 1.0 : 3e-5 * (1 + c % 7)) * (k == 0 ? 1 : -0.1));
    return std::vector<NamedGrid>{{"target", target}};
  };
  PackedFile file(write(folder.path, 100, accuracy, state));
  for (int frame = 0; frame < 100; ++frame) {
    const auto sums = [](vtkUnstructuredGrid* grid) {
      std::array<double, 4> sum{}; // the last of magnitudes
      const auto values = values_of(grid->GetCellData()->GetArray("contact_impulse"));
      for (std::size_t i = 0; i < values.size(); ++i)
        sum[i % 3] += values[i], sum[3] += std::abs(values[i]);
      return sum;
    };
    const auto read = sums(file.Read(static_cast<std::size_t>(frame))[0].second),
               written = sums(state(frame)[0].second);
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(std::abs(read[k] - written[k]) <= accuracy * written[3]);
  }
}

TEST_CASE("damage between frames is told of: what follows it is not shown", "[packed]")
{
  TemporaryFolder folder;
  const std::string name = write(folder.path, 4, 1e-3);
  fs::create_directory(folder.path / "two");
  const std::size_t end = fs::file_size(write(folder.path / "two", 2, 1e-3));
  std::string damaged = text_of(name);
  damaged[end + 15] = 0x7f; // of the third frame's size
  std::ofstream(name, std::ios::binary) << damaged;
  PackedFile file(name);
  CHECK(file.Times().size() == 2);
  CHECK_THAT(file.Complaint(), Contains(name) && Contains(": 2 frames") && Contains("damaged"));

  vtkNew<vtkPackedSeriesReader> reader;
  Messages messages;
  messages.watch(*reader);
  reader->SetFileName(name.c_str());
  reader->UpdateInformation();
  CHECK_THAT(messages.text(), Contains("damaged"));
}

TEST_CASE("whole numbers that a double does not hold are refused", "[packed]")
{
  TemporaryFolder folder;
  PackedWriter writer(folder.path / "run.bss", 0);
  vtkNew<vtkTypeInt64Array> tags;
  tags->SetName("tag");
  for (vtkIdType i = 0; i < bird_at(0)->GetNumberOfPoints(); ++i)
    tags->InsertNextValue((1LL << 53) - 1);
  const auto bird = bird_at(0);
  bird->GetPointData()->AddArray(tags);
  CHECK_NOTHROW(writer.Write(0, {{"bird", bird}}));
  tags->SetValue(3, (1LL << 53) + 1);
  CHECK_THROWS_WITH(writer.Write(1, {{"bird", bird}}), Contains("\"tag\"") && Contains("2^53"));
}

TEST_CASE("a state of another shape cannot join a packed series", "[packed]")
{
  TemporaryFolder folder;
  PackedWriter writer(folder.path / "run.bss", 1e-3);
  writer.Write(0, state_at(0));
  CHECK_THROWS_WITH(writer.Write(1e-6, {{"bird", bird_at(1)}}), Contains("1 pieces, and were 2"));
  const auto finer = particles_to_vtk(made_bird(0.025), 0);
  CHECK_THROWS_WITH(writer.Write(1e-6, {{"bird", finer}, {"target", target_at(1)}}), Contains("other cells"));
  CHECK_THROWS_WITH(PackedWriter(folder.path / "none" / "run.bss", 1e-3), Contains("No such file"));
}

TEST_CASE("the reader sees a series that has grown", "[packed]")
{
  TemporaryFolder folder;
  const std::string name = write(folder.path, 2, 1e-4);
  vtkNew<vtkPackedSeriesReader> reader;
  reader->SetFileName(name.c_str());
  reader->UpdateInformation();
  REQUIRE(reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) == 2);
  write(folder.path, 5, 1e-4);
  reader->Modified();
  reader->UpdateInformation();
  CHECK(reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) == 5);
}

TEST_CASE("the reader of packed series gives blocks by name at the times asked for", "[packed]")
{
  TemporaryFolder folder;
  const std::string name = write(folder.path, 6, 1e-4);
  vtkNew<vtkPackedSeriesReader> reader;
  reader->SetFileName(name.c_str());
  CHECK(vtkPackedSeriesReader::CanReadFile(name.c_str()));
  CHECK_FALSE(vtkPackedSeriesReader::CanReadFile("/dev/null"));
  reader->UpdateInformation();
  vtkInformation* out = reader->GetOutputInformation(0);
  REQUIRE(out->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) == 6);
  reader->UpdateTimeStep(4.1 * interval);
  auto* blocks = reader->GetOutput();
  REQUIRE(blocks->GetNumberOfBlocks() == 2);
  CHECK(std::string(blocks->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME())) == "target");
  CHECK(blocks->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) == 4 * interval);
  CHECK(values_of(
            vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0))->GetFieldData()->GetArray("TimeValue")) ==
        std::vector<double>{4 * interval});
}
