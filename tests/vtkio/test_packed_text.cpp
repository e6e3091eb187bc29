// SPDX-License-Identifier: BSD-3-Clause
// Packed texts: published base 64, and streams that VTK's own tools unpack to the numbers.
#include "vtkio/packed_text.h"

#include <catch2/catch.hpp>
#include <vtkBase64Utilities.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <random>
#include <vector>

using namespace birdstrike;

namespace {

std::string of_text(const std::string& text)
{
  return to_base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::vector<std::uint8_t> unpacked(const std::string& text, std::size_t size)
{
  std::vector<unsigned char> small(text.size());
  const std::size_t length = vtkBase64Utilities::DecodeSafely(
      reinterpret_cast<const unsigned char*>(text.data()), text.size(), small.data(), small.size());
  std::vector<std::uint8_t> bytes(size);
  vtkNew<vtkZLibDataCompressor> zlib;
  REQUIRE(zlib->Uncompress(small.data(), length, bytes.data(), size) == size);
  return bytes;
}

} // namespace

TEST_CASE("base 64 is that of RFC 4648, section 10", "[vtkio][report]")
{
  CHECK(of_text("").empty());
  CHECK(of_text("f") == "Zg==");
  CHECK(of_text("fo") == "Zm8=");
  CHECK(of_text("foo") == "Zm9v");
  CHECK(of_text("foobar") == "Zm9vYmFy");
}

TEST_CASE("numbers are packed as differences, lowest bytes first", "[vtkio][report]")
{
  const std::vector<std::uint16_t> numbers{1, 65535, 260, 3}; // two rows of two
  CHECK(unpacked(packed(std::span(numbers), 2), 8) ==
        std::vector<std::uint8_t>{1, 255, 3, 4, 0, 255, 1, 0}); // 260 - 1 = 0x0103, 3 - 65535 = 4
  CHECK(unpacked(packed(std::span(numbers), 0), 8) == std::vector<std::uint8_t>{1, 255, 4, 3, 0, 255, 1, 0});
  const std::vector<std::uint32_t> wide{0x01020304};
  CHECK(unpacked(packed(std::span(wide), 0), 4) == std::vector<std::uint8_t>{4, 3, 2, 1});
  const std::vector<std::uint8_t> narrow{5, 9, 7, 9};
  CHECK(unpacked(packed(std::span(narrow), 2), 4) == std::vector<std::uint8_t>{5, 9, 2, 0});
}

TEST_CASE("what stands still takes hardly any room", "[vtkio][report]")
{
  constexpr int row = 40000; // more than zlib looks back
  std::mt19937 random(1);
  std::vector<std::uint16_t> frames(row);
  for (std::uint16_t& place : frames)
    place = static_cast<std::uint16_t>(random());
  for (int frame = 1; frame < 5; ++frame)
    for (int i = 0; i < row; ++i)
      frames.push_back(frames[static_cast<std::size_t>(i)]);
  const std::size_t once = 4 * 2 * row / 3; // base 64 of what cannot be made smaller
  CHECK(packed(std::span(frames), row).size() < 1.02 * once);
  CHECK(packed(std::span(frames), 0).size() > 4 * once);
}
