#pragma once
#include <span>

#include "studies/fits/observed_order.hpp"

namespace mpmvv::fits {

/// What true replicates say of the line log e = log C + p log h: several samples at each h, from runs that differ in
/// what should not matter (where the body lies on the grid, say). Over the samples of the window:
///   scatter       standard deviation s of log e within the levels, with n - m degrees of freedom (n samples, m levels)
///   lack_of_fit   probability that levels whose scatter is s lie as far from the line as these do, or farther, by
///                 Fisher's F of their mean square about the line (m - 2) over s²: small means that the line is no law
///                 of the means (two orders mixed, an asymptotic range not reached), however small its residuals are
///   half_width    of p, 95 %, from that scatter: t(n - m) s / sqrt(Σ (log h - mean)²); where the lack of fit is under
///                 5 % from the levels' mean square about the line instead, with t(m - 2): the scatter alone would then
///                 give many digits to a slope that does not exist
/// NaN where degrees of freedom are missing, and nothing at all where a sample is not above 0: it has no logarithm, and
/// the scatter of the others says too little. Levels with the same number of samples each have the same slope as their
/// geometric means.
ReplicateFit fit_replicates(std::span<const ErrorSample> samples, double from, double to);

/// The mean of replicates at one level: the geometric one where all are positive, so that a fit to the logarithms of
/// means equals one to all values. With Student's 95 % interval of the mean of so many; NaN of one value.
struct ReplicateMean {
  double value = not_measured, lower = not_measured, upper = not_measured;
};
ReplicateMean mean_of_replicates(std::span<const double> values);

}  // namespace mpmvv::fits
