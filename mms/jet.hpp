#pragma once
#include <Eigen/Core>
#include <cmath>

namespace mpmvv::mms {

/// A number with its gradient and Hessian with respect to N variables: automatic differentiation, forward, to second
/// order. Everything follows from the chain rule below and the product rule.
template <int N>
class Jet {
 public:
  using Gradient = Eigen::Matrix<double, N, 1>;
  using Hessian = Eigen::Matrix<double, N, N>;

  Jet(double constant = 0) : value_(constant), gradient_(Gradient::Zero()), hessian_(Hessian::Zero()) {}
  Jet(double value, const Gradient& gradient, const Hessian& hessian)
      : value_(value), gradient_(gradient), hessian_(hessian) {}
  static Jet variable(double value, int k) { return {value, Gradient::Unit(k), Hessian::Zero()}; }

  double value() const { return value_; }
  const Gradient& gradient() const { return gradient_; }
  const Hessian& hessian() const { return hessian_; }

  /// f of this number, from f and its first two derivatives there.
  Jet chain(double f, double df, double d2f) const {
    return {f, df * gradient_, df * hessian_ + d2f * gradient_ * gradient_.transpose()};
  }

  friend Jet operator+(const Jet& a) { return a; }
  friend Jet operator-(const Jet& a) { return {-a.value_, -a.gradient_, -a.hessian_}; }
  friend Jet operator+(const Jet& a, const Jet& b) {
    return {a.value_ + b.value_, a.gradient_ + b.gradient_, a.hessian_ + b.hessian_};
  }
  friend Jet operator-(const Jet& a, const Jet& b) {
    return {a.value_ - b.value_, a.gradient_ - b.gradient_, a.hessian_ - b.hessian_};
  }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.value_ * b.value_, a.value_ * b.gradient_ + b.value_ * a.gradient_,
            a.value_ * b.hessian_ + b.value_ * a.hessian_ + a.gradient_ * b.gradient_.transpose() +
                b.gradient_ * a.gradient_.transpose()};
  }
  friend Jet operator/(const Jet& a, const Jet& b) {
    const double inverse = 1 / b.value_;
    return a * b.chain(inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
  }

  friend Jet operator+(const Jet& a, double b) { return {a.value_ + b, a.gradient_, a.hessian_}; }
  friend Jet operator-(const Jet& a, double b) { return {a.value_ - b, a.gradient_, a.hessian_}; }
  friend Jet operator*(const Jet& a, double b) { return {a.value_ * b, a.gradient_ * b, a.hessian_ * b}; }
  friend Jet operator/(const Jet& a, double b) { return a * (1 / b); }
  friend Jet operator+(double a, const Jet& b) { return b + a; }
  friend Jet operator-(double a, const Jet& b) { return -b + a; }
  friend Jet operator*(double a, const Jet& b) { return b * a; }
  friend Jet operator/(double a, const Jet& b) { return Jet(a) / b; }

  Jet& operator+=(const Jet& b) { return *this = *this + b; }
  Jet& operator-=(const Jet& b) { return *this = *this - b; }
  Jet& operator*=(const Jet& b) { return *this = *this * b; }
  Jet& operator/=(const Jet& b) { return *this = *this / b; }

 private:
  double value_;
  Gradient gradient_;
  Hessian hessian_;
};

template <int N>
Jet<N> exp(const Jet<N>& x) {
  const double e = std::exp(x.value());
  return x.chain(e, e, e);
}
template <int N>
Jet<N> log(const Jet<N>& x) {
  const double inverse = 1 / x.value();
  return x.chain(std::log(x.value()), inverse, -inverse * inverse);
}
template <int N>
Jet<N> sqrt(const Jet<N>& x) {
  const double root = std::sqrt(x.value());
  return x.chain(root, 0.5 / root, -0.25 / (root * x.value()));
}
template <int N>
Jet<N> pow(const Jet<N>& x, double p) {
  const double v = x.value();
  return x.chain(std::pow(v, p), p * std::pow(v, p - 1), p * (p - 1) * std::pow(v, p - 2));
}
template <int N>
Jet<N> sin(const Jet<N>& x) {
  const double s = std::sin(x.value()), c = std::cos(x.value());
  return x.chain(s, c, -s);
}
template <int N>
Jet<N> cos(const Jet<N>& x) {
  const double s = std::sin(x.value()), c = std::cos(x.value());
  return x.chain(c, -s, -c);
}
template <int N>
Jet<N> tan(const Jet<N>& x) {
  const double t = std::tan(x.value()), slope = 1 + t * t;
  return x.chain(t, slope, 2 * t * slope);
}
template <int N>
Jet<N> atan(const Jet<N>& x) {
  const double slope = 1 / (1 + x.value() * x.value());
  return x.chain(std::atan(x.value()), slope, -2 * x.value() * slope * slope);
}
template <int N>
Jet<N> sinh(const Jet<N>& x) {
  const double s = std::sinh(x.value()), c = std::cosh(x.value());
  return x.chain(s, c, s);
}
template <int N>
Jet<N> cosh(const Jet<N>& x) {
  const double s = std::sinh(x.value()), c = std::cosh(x.value());
  return x.chain(c, s, c);
}
template <int N>
Jet<N> tanh(const Jet<N>& x) {
  const double t = std::tanh(x.value()), slope = 1 - t * t;
  return x.chain(t, slope, -2 * t * slope);
}

}  // namespace mpmvv::mms
