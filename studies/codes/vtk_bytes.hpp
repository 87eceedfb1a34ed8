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

/// Decodes base64 and skips blanks. Several pieces, each padded, may follow each other. Any other character ends the
/// text.
std::string from_base64(std::string_view text);

/// Returns the content of the array that begins with the first of the bytes, without its header and uncompressed.
/// Throws UsageError if it ends early or is damaged.
std::string unpacked(std::string_view bytes, const VtkPacking& packing);

}  // namespace mpmvv::codes
