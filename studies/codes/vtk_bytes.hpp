#pragma once
#include <string>
#include <string_view>

namespace mpmvv::codes {

/// How VTK's XML files pack the bytes of their arrays.
struct VtkPacking {
  bool is_big_endian = false;
  std::size_t header_size = 4;  ///< bytes of a number in headers
  bool is_compressed = false;   ///< by zlib, in blocks
  std::string file;             ///< for messages
};

/// The bytes of base64; blanks are skipped. Several pieces, each padded, may follow each other. What is none ends it.
std::string from_base64(std::string_view text);

/// The content of the array that begins there: behind its header, unpacked. UsageError where it ends early or is
/// damaged.
std::string unpacked(std::string_view bytes, const VtkPacking& packing);

}  // namespace mpmvv::codes
