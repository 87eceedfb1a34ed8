#include "mms/jet.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/differentiation/autodiff.hpp>

namespace mpmvv::mms {
namespace {

namespace boost_ad = boost::math::differentiation;

/// Every function and operator, at x and y.
struct Expressions {
  template <class T>
  auto operator()(const T& x, const T& y) const {
    using std::atan, std::cos, std::cosh, std::exp, std::log, std::pow, std::sin, std::sinh, std::sqrt, std::tan,
        std::tanh;
    T all = x;
    all += y * y;
    all -= 2.0 * x;
    all *= y + 1.0;
    all /= 3.0 - x;
    return std::array<T, 18>{+x + y,     x - y,      x * y,       x / y,       1.5 / x - 0.5, -x * 2.0,
                             all,        exp(x * y), log(x + y),  sqrt(x * y), pow(x, 2.5),   sin(x + 2.0 * y),
                             cos(x - y), tan(x * y), atan(x / y), sinh(x),     cosh(x * y),   tanh(x - 3.0 * y)};
  }
};

/// Value, gradient and Hessian are those of Boost's automatic differentiation.
TEST(Jet, EqualsBoost) {
  for (const auto& [x, y] : {std::pair{0.3, 0.7}, {1.1, 0.2}, {0.8, 1.4}}) {
    const auto jets = Expressions()(Jet<2>::variable(x, 0), Jet<2>::variable(y, 1));
    using Boost = boost_ad::autodiff_fvar<double, 2, 2>;
    const auto expected =
        Expressions()(Boost(boost_ad::make_fvar<double, 2>(x)), Boost(boost_ad::make_fvar<double, 0, 2>(y)));
    for (std::size_t k = 0; k < jets.size(); ++k) {
      const auto check = [&, k = k](double actual, std::size_t m, std::size_t n) {
        const auto value = static_cast<double>(expected[k].derivative(m, n));
        EXPECT_NEAR(actual, value, 1e-14 * (1 + std::abs(value))) << "expression " << k << ", " << m << ", " << n;
      };
      check(jets[k].value(), 0, 0);
      check(jets[k].gradient()[0], 1, 0);
      check(jets[k].gradient()[1], 0, 1);
      check(jets[k].hessian()(0, 0), 2, 0);
      check(jets[k].hessian()(0, 1), 1, 1);
      check(jets[k].hessian()(1, 0), 1, 1);
      check(jets[k].hessian()(1, 1), 0, 2);
    }
  }
}

TEST(Jet, SquaresAtZero) {
  const Jet<1> square = pow(Jet<1>::variable(0, 0), 2);
  EXPECT_EQ(square.value(), 0);
  EXPECT_EQ(square.gradient()[0], 0);
  EXPECT_EQ(square.hessian()(0, 0), 2);
}

}  // namespace
}  // namespace mpmvv::mms
