#include "mms/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

/// W = (λ/2 D² + μ D) ε² for small strains ε in every direction. The coefficient of the next order is that of the
/// logarithmic law, λ/2 D² + μ/3 D, or less.
template <class Energy, std::size_t D>
void expect_hookes() {
  constexpr double lambda = 7, mu = 3, d = D;
  for (const double strain : {-1e-4, 1e-4})
    EXPECT_NEAR((stored<Energy, D>({lambda, mu}, 1 + strain)), (lambda / 2 * d * d + mu * d) * strain * strain,
                1.01 * (lambda / 2 * d * d + mu / 3 * d) * std::abs(strain * strain * strain))
        << D;
}

TYPED_TEST(Energies, SmallStrainsAreHookes) {
  expect_hookes<TypeParam, 1>();
  expect_hookes<TypeParam, 2>();
  expect_hookes<TypeParam, 3>();
}

}  // namespace mpmvv::energy_test
