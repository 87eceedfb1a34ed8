#include "tests/solver/stencils.hpp"

#include <algorithm>

/// Compiled once, and not for each test: all blocks of all bases.
namespace mpmvv::solver {

std::vector<Setting> settings(const AnyBasis& basis, double least_width) {
  std::vector<Setting> all;
  const auto add = [&]<class B>(B own, double width) {
    if constexpr (requires { own.smoothing_length; }) {
      own.smoothing_length = width;
      all.push_back({own, 1});
    } else if constexpr (B::width == ParticleWidth::domain) {
      all.insert(all.end(), {{own, 2 * std::max(width, 0.1)}, {own, std::max(width, 0.1), true}});
    } else if constexpr (B::width != ParticleWidth::none) {
      all.push_back({own, width});
    }
  };
  for (const double width : {least_width, 0.1, 0.25, 1.0 / 3, 0.5, 0.75, 0.999999, 1.0})
    std::visit([&](const auto& own) { add(own, width); }, basis);
  if (all.empty()) all.push_back({basis, 1});
  return all;
}

template <int D>
std::vector<Weight<D>> weights_of_one(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid,
                                      Fault& found) {
  AnyBlock<D> any = make_block<D>(basis, 0);
  common<D>(any).begin = 0;
  common<D>(any).count = 1;
  found = evaluate<D>(basis, particles, grid, true, any);
  std::vector<Weight<D>> all;
  const auto add = [&](std::ptrdiff_t n, double N, const Vec<D>& dN) {
    EXPECT_GE(n, 0);
    EXPECT_LT(n, static_cast<std::ptrdiff_t>(grid.size()));
    all.push_back({static_cast<std::size_t>(n), N, dN});
  };
  std::visit([&](const auto& block) { for_nodes(block, particles, grid, add); }, any);
  return all;
}

template <int D>
std::vector<Reached<D>> reached(const Setting& setting, const Grid<D>& grid, const Vec<D>& x, Fault* fault) {
  Particles<D> particles;
  particles.resize(1);
  particles.x[0] = x;
  particles.l = {Vec<D>::Constant(setting.width)};
  particles.R = {setting.width * domain_shape<D>(setting.sheared)};
  Fault found;
  const auto position = std::visit([]<class B>(const B&) { return &B::position; }, setting.basis);
  std::vector<Reached<D>> all;
  for (const auto& [n, N, dN] : weights_of_one(setting.basis, particles, grid, found)) {
    Reached<D> node{grid.index(n), grid.lower(), N, dN};
    for (std::size_t d = 0; d < D; ++d)
      node.x[static_cast<int>(d)] += grid.h() * position(node.node[d], grid.cells()[d]);
    all.push_back(node);
  }
  if (fault)
    *fault = found;
  else
    EXPECT_EQ(found, Fault::none) << "at " << x.transpose();
  return all;
}

template std::vector<Weight<1>> weights_of_one(const AnyBasis&, const Particles<1>&, const Grid<1>&, Fault&);
template std::vector<Weight<2>> weights_of_one(const AnyBasis&, const Particles<2>&, const Grid<2>&, Fault&);
template std::vector<Weight<3>> weights_of_one(const AnyBasis&, const Particles<3>&, const Grid<3>&, Fault&);
template std::vector<Reached<1>> reached(const Setting&, const Grid<1>&, const Vec<1>&, Fault*);
template std::vector<Reached<2>> reached(const Setting&, const Grid<2>&, const Vec<2>&, Fault*);
template std::vector<Reached<3>> reached(const Setting&, const Grid<3>&, const Vec<3>&, Fault*);

}  // namespace mpmvv::solver
