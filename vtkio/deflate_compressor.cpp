// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/deflate_compressor.h"

#include <libdeflate.h>
#include <vtkObjectFactory.h>
#include <vtkZLibDataCompressor.h>

#include <memory>
#include <new>

namespace birdstrike {
namespace {

//! Without vtkTypeMacro: files name the class that is to read them, and that is vtkZLibDataCompressor.
class DeflateCompressor : public vtkZLibDataCompressor
{
public:
  static DeflateCompressor* New() { VTK_STANDARD_NEW_BODY(DeflateCompressor); }

  std::size_t GetMaximumCompressionSpace(std::size_t size) override
  {
    return libdeflate_zlib_compress_bound(compressor_.get(), size);
  }

protected:
  DeflateCompressor()
  {
    if (!compressor_)
      throw std::bad_alloc();
  }
  std::size_t CompressBuffer(const unsigned char* data, std::size_t size, unsigned char* compressed,
                             std::size_t space) override
  {
    return libdeflate_zlib_compress(compressor_.get(), data, size, compressed,
                                    space); // 0 is an error to both
  }

private:
  static constexpr int level =
      1; // higher ones save 4 % of a frame of particles and take up to three times as long
  std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor_{
      libdeflate_alloc_compressor(level), libdeflate_free_compressor};
};

} // namespace

vtkSmartPointer<vtkDataCompressor> make_deflate_compressor()
{
  return vtkSmartPointer<DeflateCompressor>::New();
}

} // namespace birdstrike
