#include "solver/basis/bases.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>

#include "studies/checks/basis_function.hpp"
#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"

namespace mpmvv::checks {

namespace {

using namespace solver;

/// Returns ∫ f over [a, b], exact for piecewise polynomials of degree <= 13 whose pieces join at multiples of 1/2
/// between -4 and 4.
template <class F>
double integral(const F& f, double a, double b) {
  std::vector<double> joints{a, b};
  for (int k = -8; k <= 8; ++k)
    if (const double joint = k * 0.5; joint > a && joint < b) joints.push_back(joint);
  std::sort(joints.begin(), joints.end());
  double sum = 0;
  for (std::size_t k = 0; k + 1 < joints.size(); ++k)
    sum += boost::math::quadrature::gauss<double, 7>::integrate(f, joints[k], joints[k + 1]);
  return sum;
}

/// Returns the largest |f * b - g| over [-2.5, 2.5], which contains all supports, S (19), (31). Here * is convolution,
/// and b is the box of width l and integral one.
template <class F, class G>
double convolution_misfit(const F& f, const G& g, double l) {
  double worst = 0;
  for (const double x : linspace(-2.5, 2.5, 997))
    keep_larger(worst, std::abs(integral(f, x - l / 2, x + l / 2) / l - g(x)));
  return worst;
}

double box(double x) {
  return std::abs(x) < 0.5 ? 1 : 0;
}

template <class A, class B>
double largest_difference(const A& a, const B& b) {
  double worst = 0;
  for (const double x : linspace(-2.5, 2.5, 5000)) keep_larger(worst, std::abs(a(x) - b(x)));
  return worst;
}

template <class B>
auto weight_of(const B& basis) {
  return [function = BasisFunction<B>(basis)](double x) { return function.weight(x); };
}

}  // namespace

/// Measures claim S-basis, S §4.1: every basis is made by convolving boxes, so that uGIMP is a family from linear to
/// quadratic.
CheckResult check_bases() {
  CheckResult result;
  const auto linear = weight_of(Linear{});
  const auto quadratic = weight_of(BSpline2{});
  const auto cubic = weight_of(BSpline3{});
  result.add("linear_convolution", convolution_misfit(box, linear, 1),
             "largest misfit of box*box and the linear basis");
  result.add("quadratic_convolution", convolution_misfit(linear, quadratic, 1),
             "largest misfit of linear*box and bspline2");
  result.add("cubic_convolution", convolution_misfit(quadratic, cubic, 1),
             "largest misfit of bspline2*box and bspline3");
  double worst = 0;
  for (const double l : {0.01, 0.1, 0.25, 0.5, 0.75, 1.0})
    keep_larger(worst, convolution_misfit(linear, weight_of(UGimp{l}), l));
  result.add("gimp_convolution", worst, "largest misfit of linear*box(l) and ugimp, l from h/100 to h");

  const BasisFunction<UGimp> widest(UGimp{1});
  const BasisFunction<BSpline2> spline;
  result.add("widest_weight", largest_difference(weight_of(UGimp{1}), quadratic),
             "largest difference of the weights of ugimp with l = h and of bspline2");
  result.add(
      "widest_gradient",
      largest_difference([&](double x) { return widest.gradient(x); }, [&](double x) { return spline.gradient(x); }),
      "largest difference of their gradients");
  worst = 0;
  for (double l = 0.1; l > 1e-9; l /= 10) keep_larger(worst, largest_difference(weight_of(UGimp{l}), linear) / (l / 4));
  result.add("narrowest_weight", worst,
             "difference of the weights of ugimp and of the linear basis over l/4, l from h/10 to 1e-9 h");
  return result;
}

}  // namespace mpmvv::checks
