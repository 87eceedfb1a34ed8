#pragma once
#include <string>
#include <string_view>

namespace mpmvv::codes {

/// How VTK's XML files pack the bytes of their arrays.
struct VtkPacking {
  bool is_big_endian = false;
  std::size_t header_size = 4;  ///< bytes of a number in the header of an array
  bool is_compressed = false;   ///< whether arrays are compressed by zlib, in blocks
  std::string file;             ///< for messages
};

enum class VtkEncoding { raw, base64 };

/// Returns the content of the array at the beginning of `packed`, without its header and uncompressed. What is behind
/// the array is not read. In base64 blanks are skipped, and several pieces, each padded, may follow each other. Throws
/// UsageError if the array ends early or is damaged.
std::string unpacked(std::string_view packed, VtkEncoding encoding, const VtkPacking& packing);

}  // namespace mpmvv::codes
