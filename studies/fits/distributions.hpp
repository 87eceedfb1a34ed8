#pragma once

/// The distributions that fits and the gate ask for: in one file, as Boost's take seconds to compile.
namespace mpmvv::fits {

/// The t that a Student-t variable exceeds in absolute value with a probability of 5 %.
double student_t_95(double degrees_of_freedom);

/// The same with a probability of 1 %.
double student_t_99(double degrees_of_freedom);

/// The probability that a Fisher F variable with these degrees of freedom is above `ratio`.
double fisher_f_above(double ratio, double upper_degrees, double lower_degrees);

/// The probability of at most k heads in n throws of a fair coin.
double at_most_heads(double k, double n);

}  // namespace mpmvv::fits
