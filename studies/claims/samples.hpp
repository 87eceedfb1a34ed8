#pragma once
#include <string>
#include <vector>

#include "studies/fits/observed_order.hpp"
#include "studies/fits/work_precision.hpp"
#include "studies/records/result.hpp"

namespace mpmvv {

/// The usable points of a series in one norm, with their step sizes: h = 1/x for a sweep over `cells`, else x.
std::vector<ErrorSample> samples_of(const Series& series, const std::string& norm, const std::string& sweep);

/// As `samples_of`, with every replicate as a sample of its own.
std::vector<ErrorSample> replicate_samples_of(const Series& series, const std::string& norm, const std::string& sweep);

/// The sound points of a series whose cost was measured, in their own order.
std::vector<WorkPoint> work_points(const Series& series, const std::string& norm);

}  // namespace mpmvv
