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

/// Reads the bytes of an array: the numbers of its header, then what is behind them.
class Headed {
 public:
  Headed(std::string_view bytes, const VtkPacking& packing) : left_(bytes), packing_(packing) {}

  std::size_t number() {
    return static_cast<std::size_t>(
        number_at(take(packing_.header_size).data(), {'u', packing_.header_size}, packing_.is_big_endian));
  }

  std::string_view take(std::size_t size) {
    if (size > left_.size()) fail("an array ends early");
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }

  std::size_t size() const { return left_.size(); }

  [[noreturn]] void fail(const char* what) const {
    throw support::UsageError(fmt::format("{} in {} (a whole VTK file)", what, packing_.file));
  }

 private:
  std::string_view left_;
  const VtkPacking& packing_;
};

/// Inflates a compressed array. Its header has the number of blocks, their size, the size of the last block if it
/// differs (else 0), and the compressed size of each block.
std::string inflated(Headed& data, const VtkPacking& packing) {
  constexpr std::size_t most_by_zlib = 1040;  // bytes that come from one compressed byte
  const std::size_t blocks = data.number(), size = data.number(), last = data.number();
  if (blocks > data.size() / packing.header_size) data.fail("an array ends early");
  std::string all;
  std::vector<std::size_t> packed;
  for (std::size_t k = 0; k < blocks; ++k) packed.push_back(data.number());
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::string_view block = data.take(packed[k]);
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

std::string from_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t group = 0;
  int digits = 0, padding = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const int digit = c == '=' ? 0 : base64_digit(c);
    if (digit < 0) break;
    padding += c == '=' ? 1 : 0;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    if (++digits < 4) continue;
    for (int k = 0; k < 3 - padding; ++k) bytes += static_cast<char>(group >> (16 - 8 * k) & 0xff);
    group = 0;
    digits = padding = 0;
  }
  return bytes;
}

std::string unpacked(std::string_view bytes, const VtkPacking& packing) {
  Headed data(bytes, packing);
  if (packing.is_compressed) return inflated(data, packing);
  return std::string(data.take(data.number()));
}

}  // namespace mpmvv::codes
