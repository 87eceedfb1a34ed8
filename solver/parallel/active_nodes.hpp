#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/parallel/thread_pool.hpp"

namespace mpmvv::solver {

/// The nodes that have mass, kept as spans along the storage. They are all that a step has to visit. The threads share
/// the search for them and the visits, chunk by chunk.
class ActiveNodes {
 public:
  explicit ActiveNodes(std::size_t nodes) : contained_(nodes), spans_(count_chunks(nodes)) {
    for (auto& spans : spans_) spans.reserve(std::min(nodes, chunk) / 2 + 1);
  }

  /// Finds the nodes n for which has_mass(n) holds, and calls lose(n) for those that were among them and are no more.
  /// Returns whether they are others than before.
  template <class HasMass, class Lose>
  bool find(ThreadPool& pool, const HasMass& has_mass, const Lose& lose) {
    std::atomic<bool> others{false};
    for_chunks(pool, contained_.size(), [this, has_mass, lose, &others](std::size_t begin, std::size_t end) {
      bool is_other = false;
      for (std::size_t first = begin; first < end; first += at_once) {
        std::uint8_t* const had = &contained_[first];
        std::array<std::uint8_t, at_once> has;
        const std::size_t count = std::min(at_once, end - first);
        for (std::size_t k = 0; k < count; ++k) has[k] = has_mass(first + k);
        if (std::equal(had, had + count, has.data())) continue;
        is_other = true;
        for (std::size_t k = 0; k < count; ++k)
          if (had[k] > has[k]) lose(first + k);
        std::copy_n(has.data(), count, had);
      }
      if (!is_other) return;
      others = true;
      find_spans(begin, end);
    });
    return others;
  }

  bool contain(std::size_t n) const { return contained_[n] != 0; }

  /// Calls visit(n) for each node with mass.
  template <class Visit>
  void visit(ThreadPool& pool, const Visit& visit) const {
    visit_spans(pool, [visit](std::size_t first, std::size_t end) {
      for (std::size_t n = first; n < end; ++n) visit(n);
    });
  }

  /// Calls visit(first, end) for each span of nodes with mass; `end` is one past the last of them.
  template <class Visit>
  void visit_spans(ThreadPool& pool, const Visit& visit) const {
    pool.run(static_cast<int>(spans_.size()), [&](int task) {
      for (const auto& [first, end] : spans_[static_cast<std::size_t>(task)]) visit(first, end);
    });
  }

 private:
  static constexpr std::size_t at_once = 64;  ///< nodes that are compared together with what they were

  void find_spans(std::size_t begin, std::size_t end) {
    auto& spans = spans_[begin / chunk];
    spans.clear();
    for (std::size_t n = begin; n < end; ++n) {
      if (!contained_[n]) continue;
      const std::size_t first = n;
      while (n < end && contained_[n]) ++n;
      spans.emplace_back(first, n);
    }
  }

  std::vector<std::uint8_t> contained_;  ///< for each node whether it has mass; several threads write, so no bits
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>>
      spans_;  ///< of each chunk its spans: first node, one past the last
};

}  // namespace mpmvv::solver
