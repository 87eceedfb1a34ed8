#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>

#include "solver/basis/bases.hpp"

/// Tests that every basis has to pass, with its word in their names. Where the type of the basis does not matter they
/// compile once, and not for each of them:
///   class Suite : public WithEachBasis {};
///   INSTANTIATE_TEST_SUITE_P(, Suite, every_basis(), word_in_name);
namespace mpmvv::solver {

inline auto every_basis() {
  return []<std::size_t... k>(std::index_sequence<k...>) {
    return ::testing::Values(AnyBasis(std::in_place_index<k>)...);
  }
  (std::make_index_sequence<std::variant_size_v<AnyBasis>>{});
}

/// How GoogleTest shows one, instead of its bytes.
template <Basis B>
void PrintTo(const B&, std::ostream* out) {
  *out << B::word;
}

inline std::string word_in_name(const ::testing::TestParamInfo<AnyBasis>& info) {
  std::string word(std::visit([]<class B>(const B&) { return B::word; }, info.param));
  std::replace(word.begin(), word.end(), '-', '_');
  return word;
}

class WithEachBasis : public ::testing::TestWithParam<AnyBasis> {
 protected:
  const AnyBasis& basis = GetParam();
  const bool has_open_knots = ghosts_of(basis) == 0;
};

}  // namespace mpmvv::solver
