#include "studies/problems/fields.hpp"

#include <fmt/format.h>

#include "studies/problems/setup.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::problems {

namespace {

constexpr double round_off = 1e-12;  ///< m; points of the surface may lie this far outside

template <int D>
std::vector<std::vector<double>> rows(const mms::Mat<D>& m) {
  std::vector<std::vector<double>> all(D);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) all[static_cast<std::size_t>(i)].push_back(m(i, j));
  return all;
}

}  // namespace

Fields fields_at(const Problem& problem, const cases::ProblemChoice& choice, const std::vector<double>& X, double t,
                 const std::string& where) {
  const auto evaluate = [&]<int D>(SetupFunction<D>) {
    const Setup<D> setup = make_setup<D>(problem, choice, 0);
    if (!setup.solution) refuse_without_solution(problem);
    const mms::ManufacturedSolution<D>& solution = *setup.solution;
    const mms::Vec<D> at = Eigen::Map<const mms::Vec<D>>(X.data());
    if (!std::visit([&at](const auto& body) { return contains(body, at, round_off); }, setup.body))
      throw support::UsageError(
          fmt::format("{} {} is outside the body ({})", where, fmt::join(X, ","),
                      std::visit([](const auto& body) { return description(body); }, setup.body)));
    const auto vector = [](const mms::Vec<D>& v) { return std::vector<double>(v.data(), v.data() + D); };
    return Fields{.u = vector(solution.u(at, t)),
                  .v = vector(solution.v(at, t)),
                  .a = vector(solution.a(at, t)),
                  .b = vector(solution.b(at, t)),
                  .F = rows<D>(solution.F(at, t)),
                  .P = rows<D>(solution.P(at, t))};
  };
  return std::visit(evaluate, problem.setup);
}

}  // namespace mpmvv::problems
