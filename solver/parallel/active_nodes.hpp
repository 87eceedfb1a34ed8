#pragma once
#include <algorithm>
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
  explicit ActiveNodes(std::size_t nodes) : nodes_(nodes), spans_(count_chunks(nodes)) {
    for (auto& spans : spans_) spans.reserve(std::min(nodes, chunk) / 2 + 1);
  }

  template <class HasMass>
  void find(ThreadPool& pool, const HasMass& has_mass) {
    for_chunks(pool, nodes_, [&](std::size_t begin, std::size_t end) {
      auto& spans = spans_[begin / chunk];
      spans.clear();
      for (std::size_t n = begin; n < end; ++n) {
        if (!has_mass(n)) continue;
        const std::size_t first = n;
        while (n < end && has_mass(n)) ++n;
        spans.emplace_back(first, n);
      }
    });
  }

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
  std::size_t nodes_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>>
      spans_;  ///< of each chunk its spans: first node, one past the last
};

}  // namespace mpmvv::solver
