// SPDX-License-Identifier: BSD-3-Clause
// Arrays of whole numbers as text that a page can hold.
#include "vtkio/packed_text.h"

#include "core/error.h"

#include <vtkBase64Utilities.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <vector>

namespace birdstrike {
namespace {

template <class Whole>
std::string pack(std::span<const Whole> numbers, std::size_t row)
{
  std::vector<std::uint8_t> bytes(numbers.size() * sizeof(Whole));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Whole before = row > 0 && i >= row ? numbers[i - row] : Whole(0);
    const auto difference = static_cast<Whole>(numbers[i] - before);
    for (std::size_t b = 0; b < sizeof(Whole); ++b)
      bytes[b * numbers.size() + i] = static_cast<std::uint8_t>(difference >> (8 * b));
  }
  vtkNew<vtkZLibDataCompressor> zlib;
  zlib->SetCompressionLevel(9);
  std::vector<std::uint8_t> small(zlib->GetMaximumCompressionSpace(bytes.size()));
  const std::size_t length = zlib->Compress(bytes.data(), bytes.size(), small.data(), small.size());
  if (length == 0)
    throw RunError("zlib could not compress " + std::to_string(bytes.size()) + " bytes");
  return to_base64({small.data(), length});
}

} // namespace

std::string to_base64(std::span<const std::uint8_t> bytes)
{
  if (bytes.empty())
    return {};
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  const std::size_t length = vtkBase64Utilities::Encode(bytes.data(), bytes.size(),
                                                        reinterpret_cast<unsigned char*>(text.data()), 0);
  text.resize(length);
  return text;
}

std::string packed(std::span<const std::uint8_t> numbers, std::size_t row) { return pack(numbers, row); }
std::string packed(std::span<const std::uint16_t> numbers, std::size_t row) { return pack(numbers, row); }
std::string packed(std::span<const std::uint32_t> numbers, std::size_t row) { return pack(numbers, row); }

} // namespace birdstrike
