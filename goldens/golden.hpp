#pragma once
#include <filesystem>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "studies/records/record.hpp"

namespace mpmvv::goldens {

/// The usual bands. A golden with a wider one must say why.
inline constexpr double order_band = 0.15;  ///< absolute, either side
inline constexpr double error_band = 0.10;  ///< relative; for check values too
inline constexpr double limit_band = 0.05;  ///< relative

/// The largest number that a golden may state, so that nothing computed from it overflows.
inline constexpr double largest_number = 1e100;

/// How much wider than the reviewed one the interval of an order may become. Starting the particles in another order or
/// at another place on the grid widens it by up to a tenth.
inline constexpr double interval_margin = 1.5;

/// The largest half-width that a golden may state for the interval of an order, unless its band is wider still:
/// beyond that an order is too uncertain to be worth a golden.
inline constexpr double widest_interval = 1;

/// The fitted order of a series in a norm, over `window` where one is given (docs/measuring.md, "Bands of goldens").
/// It fails
///   - when its whole interval lies outside the band, or the order more than 1 above it,
///   - when the run at the finest level is not ok,
///   - when the fit has fewer points than `points`, or, where that is 0, than the window has,
///   - when the error at the finest level has grown by more than the band of errors, whatever the order.
/// It is inconclusive
///   - without `window` where the study fits several,
///   - without a run at the finest level or at an end of the window, or with fewer than three points,
///   - when it lies outside the band and its interval reaches in,
///   - when half of its interval is wider than the whole band and than `interval_margin` times the reviewed half,
///   - when segment orders in a window that was asymptotic scatter by more than twice `asymptotic_spread`.
struct OrderGolden {
  std::string series, norm;
  double expected = 0, lower = 0, upper = 0;
  std::vector<double> window = {};  ///< two swept values, or empty
  int points = 0;
  bool asymptotic = false;
  double interval = 0;              ///< reviewed half-width; given where, with its margin, it exceeds the band
  std::vector<double> finest = {};  ///< a swept value and the error there, or empty
};

/// The error of a series in a norm at one swept value.
struct ErrorGolden {
  std::string series, norm;
  double at = 0, expected = 0, band = 0;
};

/// The stability limit of a series.
struct LimitGolden {
  std::string series;
  double expected = 0, band = 0;
};

/// A named number of a check. `at_most` and `at_least` leave the other side open.
struct ValueGolden {
  std::string name;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// Whether the run at one swept value is stable.
struct StatusGolden {
  std::string series;
  double at = 0;
  records::Status expected = records::Status::ok;
};

/// One reviewed expectation of a study.
struct Golden {
  std::string study;
  std::string where;  ///< FILE:LINE
  std::variant<OrderGolden, ErrorGolden, LimitGolden, ValueGolden, StatusGolden> expectation;
  bool reviewed = true;  ///< else it cannot pass
};

/// The norms that a golden may have: those of runs, and the `y` of a check's curves.
std::vector<std::string> golden_norms();

/// What is judged, in words: "order of 'linear' in l2". Goldens of one study differ in it.
std::string subject(const Golden& golden);

/// What must hold, in words: "2 in [1.85, 2.15]".
std::string expected_text(const Golden& golden);

/// Whether a directory has a *.toml file.
bool has_goldens(const std::filesystem::path& directory);

/// UsageError where there is no such directory.
void require_directory(const std::filesystem::path& directory);

/// All goldens of a directory's *.toml files, by file name. UsageError when there is none, when two judge the same
/// thing, and on every mistake in a file (with FILE:LINE).
std::vector<Golden> read_goldens(const std::filesystem::path& directory);

/// The goldens of one file's text; `file` stands for it in messages.
std::vector<Golden> parse_goldens(const std::string& text, const std::string& file);

}  // namespace mpmvv::goldens
