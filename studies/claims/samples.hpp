#pragma once
#include <string>
#include <vector>

#include "studies/fits/observed_order.hpp"
#include "studies/fits/work_precision.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::claims {

/// The step size that goes with a swept value: h = 1/x for a sweep over `cells`, else x.
double step_size(double x, const std::string& sweep);

/// Errors below this times what the rounding of a code's output makes (`output_floor`) say nothing of an order.
inline constexpr double least_over_floor = 3;

/// The swept values whose errors are that near to the floor; errors of displacements alone have one.
std::vector<double> left_out(const records::Series& series, const std::string& norm);

/// The usable points of a series in one norm, with their step sizes; without those near the floor.
std::vector<fits::ErrorSample> samples_of(const records::Series& series, const std::string& norm,
                                          const std::string& sweep);

/// As `samples_of`, with every replicate as a sample of its own.
std::vector<fits::ErrorSample> replicate_samples_of(const records::Series& series, const std::string& norm,
                                                    const std::string& sweep);

/// The sound points of a series whose cost was measured, in their own order.
std::vector<fits::WorkPoint> work_points(const records::Series& series, const std::string& norm);

}  // namespace mpmvv::claims
