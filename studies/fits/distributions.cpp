#include "studies/fits/distributions.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace mpmvv::fits {

namespace {

/// Keeps Boost in doubles. Its functions of long doubles are initialized when the program starts, and that fails in
/// valgrind's arithmetic.
using InDoubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

double student_t_below(double degrees_of_freedom, double probability) {
  return boost::math::quantile(boost::math::students_t_distribution<double, InDoubles>(degrees_of_freedom),
                               probability);
}

}  // namespace

double student_t_95(double degrees_of_freedom) {
  return student_t_below(degrees_of_freedom, 0.975);
}

double student_t_99(double degrees_of_freedom) {
  return student_t_below(degrees_of_freedom, 0.995);
}

double fisher_f_above(double ratio, double upper_degrees, double lower_degrees) {
  const boost::math::fisher_f_distribution<double, InDoubles> distribution(upper_degrees, lower_degrees);
  return boost::math::cdf(boost::math::complement(distribution, ratio));
}

double at_most_heads(double k, double n) {
  return boost::math::cdf(boost::math::binomial_distribution<double, InDoubles>(n, 0.5), k);
}

}  // namespace mpmvv::fits
