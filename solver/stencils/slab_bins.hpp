#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/stencils/block.hpp"

namespace mpmvv::solver {

/// Whether visits by packs pay, measured: one costs about as much as so many visits to a particle by itself, and so does
/// bringing the sums of a group to its nodes.
constexpr bool packs_pay(int groups, int packs, int count) {
  return lanes == 4 ? 5 * (packs + groups) <= 3 * count : 2 * (packs + groups) <= count;
}

/// The particles of a slab by the nodes that they reach: a bin for each first node, and in it packs of particles. From
/// step to step only those change their bins that reach other nodes than before; they are not moved in memory.
class SlabBins {
 public:
  /// Makes room for so many particles whose first nodes are those from `lowest` to before `end`, and takes none.
  void clear(int lowest, int end, std::size_t particles) {
    lowest_ = lowest;
    head_.assign(static_cast<std::size_t>(end - lowest), none);
    const std::size_t most = particles / lanes + std::min(head_.size(), particles);
    packs_.resize(most);
    moves_.reserve(particles);
    for (std::size_t k = 0; k < most; ++k) packs_[k].next = k + 1 < most ? static_cast<int>(k) + 1 : none;
    free_ = most > 0 ? 0 : none;
  }

  void add(std::uint32_t particle, int first) {
    int& head = head_[static_cast<std::size_t>(first - lowest_)];
    if (head == none || pack(head).filled == lanes) {
      const int fresh = free_;
      free_ = pack(fresh).next;
      pack(fresh).particle.fill(particle);
      pack(fresh).filled = 0;
      pack(fresh).next = head;
      head = fresh;
    }
    LanePack& own = pack(head);
    own.particle[static_cast<std::size_t>(own.filled++)] = particle;
  }

  /// Puts every particle into the bin of its first node; find_first(block, first) finds those at a block's places.
  template <int D, class FindFirst>
  void update(const FindFirst& find_first) {
    PackList<D> block;
    int first[block_size<D>];
    moves_.clear();
    for (Place at; find(at);) {
      std::array<Place, PackList<D>::most_packs> places;
      for (block.packs = 0; find(at) && block.packs < block.most_packs; at.pack = pack(at.pack).next) {
        places[static_cast<std::size_t>(block.packs)] = at;
        copy(pack(at.pack), block);
      }
      find_first(block, first);
      for (int k = 0; k < block.packs; ++k) take_out_moved(places[static_cast<std::size_t>(k)], &first[k * lanes]);
    }
    for (const Move& move : moves_) add(move.particle, move.first);
  }

  /// How far a visit to all packs has come.
  struct Place {
    std::size_t bin = 0;
    int pack = begin;
  };

  /// Takes the next packs, `most` places of them, or where packs do not pay, that many particles one after the other.
  /// False when there are none left.
  template <int D>
  bool take(Place& at, int most, PackList<D>& block) const {
    const Place start = at;
    int count = 0;
    block.packs = block.groups = 0;
    for (std::size_t bin = none_yet; find(at) && block.packs < most / lanes; at.pack = pack(at.pack).next) {
      if (bin != at.bin) block.group[block.groups++] = block.packs;
      bin = at.bin;
      copy(pack(at.pack), block);
      count += pack(at.pack).filled;
    }
    block.group[block.groups] = block.packs;
    block.is_grouped = packs_pay(block.groups, block.packs, count);
    if (!block.is_grouped) {
      at = start;
      take_one_by_one(at, most, block);
    }
    return block.packs > 0;
  }

 private:
  static constexpr int none = -1, begin = -2;
  static constexpr std::size_t none_yet = static_cast<std::size_t>(-1);

  struct LanePack {
    std::array<std::uint32_t, static_cast<std::size_t>(lanes)> particle;
    int filled;  ///< the first so many; only a bin's first pack may have less than all
    int next;    ///< of the bin
  };
  struct Move {
    std::uint32_t particle;
    int first;
  };

  LanePack& pack(int k) { return packs_[static_cast<std::size_t>(k)]; }
  const LanePack& pack(int k) const { return packs_[static_cast<std::size_t>(k)]; }

  /// As the next pack of a block.
  template <int D>
  static void copy(const LanePack& own, PackList<D>& block) {
    std::copy(own.particle.begin(), own.particle.end(), &block.particle[block.packs * lanes]);
    block.filled[block.packs++] = own.filled;
  }

  /// Takes those out of a pack whose first nodes are not the bin's: the last particle of the bin takes the place of each.
  /// Called for one pack of a bin after the other, so that this one stays.
  void take_out_moved(const Place& from, const int* first) {
    LanePack& own = pack(from.pack);
    const int node = lowest_ + static_cast<int>(from.bin);
    unsigned moved = 0;
    for (int lane = 0; lane < lanes; ++lane) moved |= static_cast<unsigned>(first[lane] != node) << lane;
    moved &= (1U << own.filled) - 1;
    for (int lane = lanes - 1; moved != 0; --lane) {
      if ((moved >> lane & 1) == 0) continue;
      moved ^= 1U << lane;
      auto& particle = own.particle[static_cast<std::size_t>(lane)];
      moves_.push_back({particle, first[lane]});
      particle = take_last(head_[from.bin]);
    }
  }

  std::uint32_t take_last(int& head) {
    LanePack& last = pack(head);
    const std::uint32_t particle = last.particle[static_cast<std::size_t>(--last.filled)];
    if (last.filled == 0) {
      const int emptied = head;
      head = last.next;
      last.next = free_;
      free_ = emptied;
    }
    return particle;
  }

  /// Goes to the next bin with particles where one is at its end.
  bool find(Place& at) const {
    if (at.pack == begin) at.pack = head_.empty() ? none : head_[0];
    while (at.pack == none && at.bin + 1 < head_.size()) at.pack = head_[++at.bin];
    return at.pack != none;
  }

  template <int D>
  void take_one_by_one(Place& at, int most, PackList<D>& block) const {
    int count = 0;
    for (; find(at) && count + pack(at.pack).filled <= most; at.pack = pack(at.pack).next)
      for (int lane = 0; lane < pack(at.pack).filled; ++lane)
        block.particle[count++] = pack(at.pack).particle[static_cast<std::size_t>(lane)];
    block.packs = (count + lanes - 1) / lanes;
    for (int k = 0; k < block.packs; ++k) block.filled[k] = std::min(lanes, count - k * lanes);
    std::fill(&block.particle[count], &block.particle[0] + block.places(), count > 0 ? block.particle[count - 1] : 0);
  }

  int lowest_ = 0;
  std::vector<int> head_;  ///< the first pack of each bin
  std::vector<LanePack> packs_;
  int free_ = none;  ///< the first of those in no bin
  std::vector<Move> moves_;
};

}  // namespace mpmvv::solver
