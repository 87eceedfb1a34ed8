#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "studies/fits/observed_order.hpp"
#include "studies/fits/window.hpp"
#include "studies/fits/work_precision.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::claims {

/// The step size that goes with a swept value: h = 1/x for a sweep over `cells` or `ppc`, else x.
double step_size(double x, const std::string& sweep);

/// That of a run: in a sweep over `cfl` its Courant number, as steps divide the end time, and not the one asked for.
/// That of a check's curve is not known, nor of a code with a step of its own; they have the swept value.
double step_size(const records::Point& point, const std::string& sweep);

/// Whether swept values are step sizes, or numbers of cells or particles, so that an order has a meaning over them.
bool has_step_size(const std::string& sweep);

/// Whether the swept value `a` means a finer grid, a smaller step, more particles, a higher order or a deeper wall
/// than `b`.
bool is_finer(double a, double b, const std::string& sweep);

/// Where an extrapolation over the swept values ends: "h = 0", "1/ppc = 0", "dt = 0".
std::string extrapolated_to(const std::string& sweep);

/// What has the smallest step size of a sweep: "finest grid", "largest ppc", "smallest dt".
std::string finest_level(const std::string& sweep);

/// The points that a fit takes: "4", or "2 of 5" where its window has more.
std::string points_text(const records::Series& series, const fits::ObservedOrder& order);

/// Whether the point's error lies within a few times of a floor, so that it says nothing about an order. The error made
/// by the rounding of a code's output (`output_floor`) adds in squares: an RMS error of 3 times it is off by 6 %. That
/// of a solution which is not exact for the body's law (`solution_floor`) may add in full: 10 times it is off by 11 %.
bool is_near_floor(const records::Point& point, const std::string& norm);

/// The swept values in the window whose errors are that near to a floor, and to which: "32, 64 (within 3 times ...)";
/// empty without any. Only errors of displacements have floors.
std::string left_out(const records::Series& series, const std::string& norm,
                     const fits::Window& window = {-INFINITY, INFINITY});

/// The points of a series in one norm, with their step sizes. Points that are not sound, or near a floor, have a NaN
/// for the error.
std::vector<fits::ErrorSample> samples_of(const records::Series& series, const std::string& norm,
                                          const std::string& sweep);

/// As `samples_of`, with every replicate as a sample of its own.
std::vector<fits::ErrorSample> replicate_samples_of(const records::Series& series, const std::string& norm,
                                                    const std::string& sweep);

/// The sound points of a series whose cost was measured, in their own order.
std::vector<fits::WorkPoint> work_points(const records::Series& series, const std::string& norm);

/// Half the range of a point's times over their mean; 0 where its cost was not measured.
double half_spread(const records::Point& point);

}  // namespace mpmvv::claims
