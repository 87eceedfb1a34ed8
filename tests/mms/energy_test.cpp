#include "mms/energy.hpp"

#include <gtest/gtest.h>

namespace mpmvv::energy_test {

using mms::Matrix;

template <class Energy, std::size_t D>
double stored(const Energy& energy, double stretch) {
  Matrix<double, D> F{};
  for (std::size_t d = 0; d < D; ++d) F[d][d] = stretch;
  return energy(F);
}

template <class Energy>
class Energies : public testing::Test {};
using All = testing::Types<mms::NeoHookeanLogEnergy, mms::NeoHookeanSquareEnergy>;
TYPED_TEST_SUITE(Energies, All);

TYPED_TEST(Energies, WithoutStrainNothingIsStored) {
  const TypeParam energy{7, 3};
  EXPECT_DOUBLE_EQ((stored<TypeParam, 1>(energy, 1)), 0);
  EXPECT_DOUBLE_EQ((stored<TypeParam, 2>(energy, 1)), 0);
  EXPECT_DOUBLE_EQ((stored<TypeParam, 3>(energy, 1)), 0);
}

/// W = (λ/2 D² + μ D) ε² for small strains ε in every direction.
TYPED_TEST(Energies, SmallStrainsAreHookes) {
  constexpr double e = 1e-4;
  const TypeParam energy{7, 3};
  for (const double strain : {-e, e}) {
    EXPECT_NEAR((stored<TypeParam, 1>(energy, 1 + strain)), (3.5 * 1 + 3) * e * e, 30 * e * e * e);
    EXPECT_NEAR((stored<TypeParam, 2>(energy, 1 + strain)), (3.5 * 4 + 6) * e * e, 60 * e * e * e);
    EXPECT_NEAR((stored<TypeParam, 3>(energy, 1 + strain)), (3.5 * 9 + 9) * e * e, 90 * e * e * e);
  }
}

}  // namespace mpmvv::energy_test
