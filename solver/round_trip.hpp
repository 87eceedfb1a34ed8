#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solver/basis/bases.hpp"
#include "solver/kept_boxes.hpp"
#include "solver/sweep.hpp"

namespace mpmvv::solver {

template <int D>
class Mpm;

/// φ_i += Σ_p N_ip m_p Σ_j N_jp u_j: to the particles, and their momenta back to the nodes.
template <int D>
struct MapRoundTrip {
  const Particles<D>& particles;
  const std::vector<Packed<D>>& u;
  std::vector<Packed<D>>& product;

  auto& field() const { return product; }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto& nodes, const auto&) const {
    return (who.of(particles.m) * nodes.gather(u)).eval();
  }
};

/// SᵀM S of N §2.1 times fields of nodes: round trips to the particles and back, many by the same positions. Where
/// particles have domains their nodes are put together and kept for them.
template <int D>
class RoundTrip {
 public:
  using Field = std::vector<Packed<D>>;

  /// For at most so many by the same positions.
  RoundTrip(const Mpm<D>& s, int most) {
    std::visit(
        [&]<class B>(const B&) {
          if constexpr (B::width == ParticleWidth::domain)
            if (most > 1) boxes_.emplace(B::support, s.particles().size());
        },
        s.basis());
  }

  /// To be called before some calls of `map` by the same positions.
  void prepare(Mpm<D>& s) {
    if (!boxes_ || kept_after_ == s.moves()) return;
    kept_after_ = s.moves();
    boxes_->clear();
    s.template sweep<Adds::nothing>(KeepBoxes<D>{*boxes_});
  }

  bool uses_boxes() const { return boxes_ && boxes_->are_complete(); }

  /// φ_i += Σ_p N_ip m_p Σ_j N_jp u_j
  void map(Mpm<D>& s, const Field& u, Field& field) const {
    const MapRoundTrip<D> trip{s.particles(), u, field};
    if (!uses_boxes()) return s.sweep(node_loop(trip));
    std::visit(
        [&]<class B>(const B&) {
          if constexpr (B::width == ParticleWidth::domain) map_boxes<B::support + 1>(s, trip, field);
        },
        s.basis());
  }

 private:
  template <int W>
  void map_boxes(Mpm<D>& s, const MapRoundTrip<D>& trip, Field& field) const {
    s.for_slabs([&](std::size_t begin, std::size_t end) {
      for (; begin < end; begin += corner_block_size<D>)
        for_interleaved(static_cast<int>(std::min<std::size_t>(corner_block_size<D>, end - begin)), [&](int k) {
          const One<D> one{begin, k};
          const auto nodes = boxes_->template stencil<W>(one.particle(), s.grid());
          nodes.scatter(trip(one, nodes, boxes_), field);
        });
    });
  }

  std::optional<KeptBoxes<D>> boxes_;
  std::int64_t kept_after_ = -1;  ///< as many moves
};

}  // namespace mpmvv::solver
