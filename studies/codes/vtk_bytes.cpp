#include "studies/codes/vtk_bytes.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <vector>

#include "studies/codes/binary_number.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

namespace {

/// Returns the six bits of a character of base64; -1 for any other character.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

/// Decodes a text of base64 piece by piece. Any other character than its own and blanks ends it.
class Base64 {
 public:
  explicit Base64(std::string_view text) : left_(text) {}

  /// Returns the next bytes, fewer where the text ends.
  std::string take(std::size_t size) {
    while (decoded_.size() < size && decode_group()) continue;
    std::string taken = decoded_.substr(0, size);
    decoded_.erase(0, size);
    return taken;
  }

 private:
  /// Decodes four characters, to three bytes or, where they are padded, fewer; false where the text ends.
  bool decode_group() {
    std::uint32_t group = 0;
    for (int digits = 0, padding = 0; !left_.empty(); left_.remove_prefix(1)) {
      const char c = left_.front();
      if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
      const int digit = c == '=' ? 0 : base64_digit(c);
      if (digit < 0) return false;
      padding += c == '=' ? 1 : 0;
      group = group << 6 | static_cast<std::uint32_t>(digit);
      if (++digits < 4) continue;
      for (int k = 0; k < 3 - padding; ++k) decoded_ += static_cast<char>(group >> (16 - 8 * k) & 0xff);
      left_.remove_prefix(1);
      return true;
    }
    return false;
  }

  std::string_view left_;
  std::string decoded_;
};

/// Reads the bytes of an array: the numbers of its header, then what is behind them.
class Headed {
 public:
  Headed(std::string_view packed, VtkEncoding encoding, const VtkPacking& packing)
      : left_(packed), text_(packed), encoding_(encoding), packing_(packing) {}

  std::size_t number() {
    return static_cast<std::size_t>(
        number_at(take(packing_.header_size).data(), {'u', packing_.header_size}, packing_.is_big_endian));
  }

  std::string take(std::size_t size) {
    std::string taken = encoding_ == VtkEncoding::base64 ? text_.take(size) : std::string(left_.substr(0, size));
    if (taken.size() < size) fail("an array ends early");
    if (encoding_ == VtkEncoding::raw) left_.remove_prefix(size);
    return taken;
  }

  [[noreturn]] void fail(const char* what) const {
    throw support::UsageError(fmt::format("{} in {} (a whole VTK file)", what, packing_.file));
  }

 private:
  std::string_view left_;  ///< of raw bytes
  Base64 text_;
  VtkEncoding encoding_;
  const VtkPacking& packing_;
};

/// Inflates a compressed array. Its header has the number of blocks, their size, the size of the last block if it
/// differs (else 0), and the compressed size of each block.
std::string inflated(Headed& data) {
  constexpr std::size_t most_by_zlib = 1040;  // bytes that come from one compressed byte
  const std::size_t blocks = data.number(), size = data.number(), last = data.number();
  std::string all;
  std::vector<std::size_t> packed;
  for (std::size_t k = 0; k < blocks; ++k) packed.push_back(data.number());
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::string block = data.take(packed[k]);
    const std::size_t wanted = k + 1 == blocks && last > 0 ? last : size;
    if (wanted / most_by_zlib > block.size()) data.fail("a compressed block is damaged");
    std::string plain(wanted, '\0');
    uLongf got = wanted;
    const int result = uncompress(reinterpret_cast<Bytef*>(plain.data()), &got,
                                  reinterpret_cast<const Bytef*>(block.data()), block.size());
    if (result != Z_OK || got != wanted) data.fail("a compressed block is damaged");
    all += plain;
  }
  return all;
}

}  // namespace

std::string unpacked(std::string_view packed, VtkEncoding encoding, const VtkPacking& packing) {
  Headed data(packed, encoding, packing);
  if (packing.is_compressed) return inflated(data);
  return data.take(data.number());
}

}  // namespace mpmvv::codes
