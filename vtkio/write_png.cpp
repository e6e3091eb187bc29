// SPDX-License-Identifier: BSD-3-Clause
// An image on disk.
#include "vtkio/write_png.h"

#include "vtkio/atomic_file.h"
#include "vtkio/vtk_errors.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkPNGWriter.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace birdstrike {

namespace {

void append(std::string& bytes, std::uint32_t number)
{
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>((number >> shift) & 255);
}

//! The checksum of a PNG's chunks (annex D of the PNG specification).
std::uint32_t checksum(const std::string& bytes)
{
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = crc & 1 ? 0xedb88320 ^ (crc >> 1) : crc >> 1;
  }
  return crc ^ 0xffffffff;
}

//! VTK's writer leaves the size in print out: the chunk pHYs says it, behind the header. What went wrong, or "".
std::string add_resolution(const std::filesystem::path& png, double dots_per_inch)
{
  constexpr std::size_t header = 8 + 25; // signature and IHDR
  std::ifstream in(png, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in || bytes.size() < header)
    return "it could not be read back";
  const auto dots_per_metre = static_cast<std::uint32_t>(std::lround(dots_per_inch / 0.0254));
  std::string chunk = "pHYs";
  append(chunk, dots_per_metre);
  append(chunk, dots_per_metre);
  chunk += '\1'; // the unit is the metre
  std::string whole;
  append(whole, static_cast<std::uint32_t>(chunk.size() - 4));
  whole += chunk;
  append(whole, checksum(chunk));
  bytes.insert(header, whole);
  errno = 0;
  std::ofstream out(png, std::ios::binary);
  out << bytes;
  out.close();
  return out ? "" : errno != 0 ? std::strerror(errno) : "the disk refused";
}

} // namespace

void write_png(vtkImageData& image, const std::filesystem::path& file, double dots_per_inch)
{
  if (file.has_parent_path())
    make_folder(file.parent_path());
  write_atomically(file, [&](const std::filesystem::path& temporary) -> std::string {
    auto errors = vtkSmartPointer<VtkErrors>::New();
    auto writer = vtkSmartPointer<vtkPNGWriter>::New();
    errors->watch(*writer);
    writer->SetFileName(temporary.string().c_str());
    writer->SetInputData(&image);
    errno = 0;
    writer->Write();
    if (!errors->any() && writer->GetErrorCode() == vtkErrorCode::NoError)
      return dots_per_inch > 0 ? add_resolution(temporary, dots_per_inch) : "";
    if (errno != 0)
      return std::strerror(errno);
    return errors->any() ? errors->first() : vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
  });
}

} // namespace birdstrike
