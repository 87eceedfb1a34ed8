#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/parallel/thread_pool.hpp"

namespace mpmvv::solver {

/// The nodes that have mass, as runs along the storage: all that a step has to visit. They are found and visited by all
/// threads where there are many.
class ActiveNodes {
 public:
  explicit ActiveNodes(std::size_t nodes) : nodes_(nodes), runs_(count_chunks(nodes)) {
    for (auto& runs : runs_) runs.reserve(std::min(nodes, chunk) / 2 + 1);
  }

  template <class HasMass>
  void find(ThreadPool& pool, const HasMass& has_mass) {
    for_chunks(pool, nodes_, [&](std::size_t begin, std::size_t end) {
      auto& runs = runs_[begin / chunk];
      runs.clear();
      for (std::size_t n = begin; n < end; ++n) {
        if (!has_mass(n)) continue;
        const std::size_t first = n;
        while (n < end && has_mass(n)) ++n;
        runs.emplace_back(first, n);
      }
    });
  }

  /// Calls visit(n) for each.
  template <class Visit>
  void visit(ThreadPool& pool, const Visit& visit) const {
    visit_runs(pool, [visit](std::size_t first, std::size_t end) {
      for (std::size_t n = first; n < end; ++n) visit(n);
    });
  }

  /// Calls visit(first, end) for each run of them.
  template <class Visit>
  void visit_runs(ThreadPool& pool, const Visit& visit) const {
    pool.run(static_cast<int>(runs_.size()), [&](int task) {
      for (const auto& [first, end] : runs_[static_cast<std::size_t>(task)]) visit(first, end);
    });
  }

 private:
  std::size_t nodes_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> runs_;  ///< of each chunk: the first, past the last
};

}  // namespace mpmvv::solver
