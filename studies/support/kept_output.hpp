#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace mpmvv::support {

/// Collects a program's output in bounded memory: of more than twice `half` bytes it keeps the first and the last
/// `half`.
class KeptOutput {
 public:
  explicit KeptOutput(std::size_t half) : half_(half) {}

  void append(std::string_view text) {
    const std::size_t fits = std::min(text.size(), half_ - first_.size());
    first_ += text.substr(0, fits);
    last_ += text.substr(fits);
    if (last_.size() > 2 * half_) drop_all_but(half_);
  }

  /// All of it, or both parts with a line between them that says how much is left out.
  std::string text() {
    if (last_.size() > half_) drop_all_but(half_);
    if (left_out_ == 0) return first_ + last_;
    return fmt::format("{}\n[{} bytes left out]\n{}", first_, left_out_, last_);
  }

 private:
  void drop_all_but(std::size_t kept) {
    left_out_ += last_.size() - kept;
    last_.erase(0, last_.size() - kept);
  }

  std::size_t half_, left_out_ = 0;
  std::string first_, last_;
};

}  // namespace mpmvv::support
