#include "studies/codes/start_state.hpp"

#include <algorithm>
#include <cmath>

#include "studies/runs/prepared_case.hpp"

namespace mpmvv::codes {

namespace {

constexpr Tensor identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
constexpr double round_off = 1e-14;

template <int D>
Point point(const solver::Vec<D>& of_dimension) {
  Point all{};
  std::copy_n(of_dimension.data(), D, all.begin());
  return all;
}

template <int D>
Tensor tensor(const solver::Mat<D>& of_dimension) {
  Tensor all = identity;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) all[static_cast<std::size_t>(3 * i + j)] = of_dimension(i, j);
  return all;
}

template <int D>
StartState state_of(const runs::PreparedCase<D>& prepared) {
  const auto& particles = prepared.scene.particles;
  StartState state;
  state.dimension = D;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    state.id.push_back(particles.id[p] + std::int64_t{1});
    state.X.push_back(point<D>(prepared.X[particles.id[p]]));
    state.x.push_back(point<D>(particles.x[p]));
    state.v.push_back(point<D>(particles.v[p]));
    state.m.push_back(particles.m[p]);
    state.V.push_back(particles.V0[p]);
    state.F.push_back(tensor<D>(particles.F[p]));
  }
  return state;
}

}  // namespace

StartState start_state(const cases::Case& c) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  const auto prepared = [&]<int D>(problems::SetupFunction<D>) {
    return state_of(runs::prepare_case<D>(c, problem, 1));
  };
  StartState state = std::visit(prepared, problem.setup);
  if (is_at_rest(state, problem.wave_speed(c.problem.parameters))) state.v.assign(state.size(), Point{});
  return state;
}

bool is_at_rest(const StartState& state, double wave_speed) {
  const auto rests = [most = round_off * wave_speed](double v) { return std::abs(v) <= most; };
  return std::ranges::all_of(state.v, [&](const Point& v) { return std::ranges::all_of(v, rests); });
}

bool is_undeformed(const StartState& state) {
  const auto equal = [](double one, double other) { return std::abs(one - other) <= round_off; };
  return std::ranges::all_of(state.F, [&](const Tensor& F) { return std::ranges::equal(F, identity, equal); });
}

}  // namespace mpmvv::codes
