// SPDX-License-Identifier: BSD-3-Clause
// A packed series on disk.
#include "PackedFile.h"

#include "PackedGrid.h"

#include "vtkCallbackCommand.h"
#include "vtkUnstructuredGrid.h"
#include "vtkZLibDataCompressor.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace {

constexpr char Magic[] = "BIRDSTRIKE PACK2";
constexpr std::size_t MagicSize = 16;
constexpr std::size_t KeyEvery = 64;       // frames: a jump in time reads at most so many
constexpr std::uint64_t MostPacked = 1100; // zlib packs no tighter than 1032 to 1
constexpr std::size_t VersionAt = 15;      // in Magic
constexpr int Level = 4;                   // of zlib: the planes of small steps gain nothing from more

struct Header
{
  std::uint64_t RawSize, Size;
  double Time;
  std::uint64_t Key;
  std::uint64_t Checksum; // of what stands before it
};

// FNV-1a, 64 bits (Fowler, Noll, Vo).
std::uint64_t ChecksumOf(const Header& header)
{
  std::array<unsigned char, offsetof(Header, Checksum)> bytes;
  std::memcpy(bytes.data(), &header, bytes.size());
  std::uint64_t sum = 14695981039346656037u;
  for (const unsigned char byte : bytes)
    sum = (sum ^ byte) * 1099511628211u;
  return sum;
}

std::string SystemReason() { return errno != 0 ? std::strerror(errno) : "the disk refused"; }

// What it has to say is said by exceptions.
vtkSmartPointer<vtkZLibDataCompressor> QuietZlib()
{
  auto zlib = vtkSmartPointer<vtkZLibDataCompressor>::New();
  zlib->SetCompressionLevel(Level);
  auto silence = vtkSmartPointer<vtkCallbackCommand>::New();
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  zlib->AddObserver(vtkCommand::ErrorEvent, silence);
  return zlib;
}

std::vector<unsigned char> Pack(const std::vector<unsigned char>& raw)
{
  const auto zlib = QuietZlib();
  std::vector<unsigned char> packed(zlib->GetMaximumCompressionSpace(raw.size()));
  const std::size_t size = zlib->Compress(raw.data(), raw.size(), packed.data(), packed.size());
  if (size == 0)
    throw std::runtime_error("zlib failed");
  packed.resize(size);
  return packed;
}

} // namespace

PackedWriter::PackedWriter(std::string file, double accuracy) : Name(std::move(file)), Accuracy(accuracy)
{
  errno = 0;
  this->File = std::fopen(this->Name.c_str(), "wb");
  if (!this->File || std::fwrite(Magic, 1, MagicSize, this->File) != MagicSize ||
      std::fflush(this->File) != 0)
    throw std::runtime_error(SystemReason());
  this->Size = MagicSize;
}

PackedWriter::~PackedWriter()
{
  if (this->File)
    std::fclose(this->File);
}

void PackedWriter::Write(double time, const std::vector<NamedGrid>& pieces)
{
  PackedState now;
  now.Time = time;
  for (const auto& [name, grid] : pieces)
    now.Pieces.push_back(PieceFromGrid(name, grid));
  std::vector<unsigned char> raw;
  const bool key = this->Frames % KeyEvery == 0;
  if (this->Frames == 0) {
    raw = WriteFirstFrame(now);
    this->First = this->Last = std::move(now);
  } else {
    if (key) { // from the first frame's values, but with the largest magnitudes of all
      PackedState start = this->First;
      for (std::size_t p = 0; p < start.Pieces.size(); ++p)
        for (std::size_t k = 0; k < start.Pieces[p].Arrays.size(); ++k)
          start.Pieces[p].Arrays[k].Scale = this->Last.Pieces[p].Arrays[k].Scale;
      this->Last = std::move(start);
    }
    raw = WriteFrame(now, this->Last, this->Accuracy, key);
  }
  const std::vector<unsigned char> packed = Pack(raw);
  Header header{raw.size(), packed.size(), time, key ? 1u : 0u, 0};
  header.Checksum = ChecksumOf(header);
  errno = 0;
  if (std::fwrite(&header, 1, sizeof header, this->File) != sizeof header ||
      std::fwrite(packed.data(), 1, packed.size(), this->File) != packed.size() ||
      std::fflush(this->File) != 0)
    throw std::runtime_error(SystemReason());
  this->Size += sizeof header + packed.size();
  ++this->Frames;
}

PackedFile::PackedFile(std::string file) : Name(std::move(file)), In(this->Name, std::ios::binary)
{
  if (!this->In)
    throw std::runtime_error("it cannot be opened: " + SystemReason());
  std::array<char, MagicSize> magic{};
  this->In.read(magic.data(), magic.size());
  if (!this->In || std::memcmp(magic.data(), Magic, VersionAt) != 0)
    throw std::runtime_error("it is not a packed series of BirdStrike");
  if (magic[VersionAt] != Magic[VersionAt])
    throw std::runtime_error(std::string("it is a packed series of form ") + magic[VersionAt] +
                             ", and this version reads form " + Magic[VersionAt] +
                             "; write it anew with the version that wrote it, or run again");
  this->In.seekg(0, std::ios::end);
  const auto end = static_cast<std::uint64_t>(this->In.tellg());
  std::uint64_t place = MagicSize;
  bool damaged = false;
  while (place + sizeof(Header) <= end) {
    Header header{};
    this->In.seekg(static_cast<std::streamoff>(place));
    this->In.read(reinterpret_cast<char*>(&header), sizeof header);
    const std::uint64_t data = place + sizeof header;
    const bool rises = this->FrameTimes.empty() || header.Time > this->FrameTimes.back();
    damaged = !this->In || header.Checksum != ChecksumOf(header) || !rises ||
              header.RawSize / MostPacked > header.Size;
    if (damaged || header.Size > end - data)
      break; // damaged, or cut short: what follows cannot be trusted
    this->Entries.push_back({data, header.RawSize, header.Size, header.Key == 1});
    this->FrameTimes.push_back(header.Time);
    place = data + header.Size;
  }
  const std::string rest = std::to_string(end - place) + " bytes";
  if (this->Entries.empty())
    throw std::runtime_error(damaged ? "its first frame is damaged"
                                     : "it has no whole frame: the run that wrote it ended before its first");
  if (place < end) {
    std::ostringstream text;
    text << this->Name << ": " << this->FrameTimes.size() << " frames, up to " << this->FrameTimes.back()
         << " s, are whole; "
         << (damaged ? "the file is damaged after them, and its last " + rest + " cannot be read"
                     : "the next is being written, or the run was ended while it wrote it: there are " +
                           rest + " of it");
    this->Rest = text.str();
  }
  this->First = ReadFirstFrame(this->Unpack(0));
  this->State = this->First;
}

std::vector<unsigned char> PackedFile::Unpack(std::size_t frame)
{
  const Entry& entry = this->Entries[frame];
  std::vector<unsigned char> packed(entry.Size), raw(entry.RawSize);
  this->In.clear();
  this->In.seekg(static_cast<std::streamoff>(entry.Offset));
  this->In.read(reinterpret_cast<char*>(packed.data()), static_cast<std::streamsize>(packed.size()));
  const auto zlib = QuietZlib();
  if (!this->In || zlib->Uncompress(packed.data(), packed.size(), raw.data(), raw.size()) != raw.size())
    throw std::runtime_error("frame " + std::to_string(frame) + " is damaged");
  return raw;
}

std::vector<NamedGrid> PackedFile::Read(std::size_t frame)
{
  if (frame >= this->Entries.size())
    throw std::runtime_error("it has no frame " + std::to_string(frame));
  std::size_t key = frame;
  while (key > 0 && !this->Entries[key].Key)
    --key;
  const bool ahead = this->At <= frame && this->At >= key;
  std::size_t from = ahead ? this->At + 1 : key;
  try {
    for (; from <= frame; ++from) {
      if (this->Entries[from].Key)
        this->State = this->First;
      if (from > 0)
        ReadFrame(this->Unpack(from), this->State);
      this->At = from;
    }
    std::vector<NamedGrid> pieces;
    for (const PackedPiece& piece : this->State.Pieces)
      pieces.emplace_back(piece.Name, GridFromPiece(piece));
    return pieces;
  } catch (const std::exception&) { // half a state must not be built upon
    this->State = this->First;
    this->At = 0;
    throw;
  }
}
