#pragma once
#include <cstddef>
#include <string>

/// Numbers as every command prints them; "-" where there is none.
namespace mpmvv::cli {

std::string number_text(double value);           ///< four digits
std::string error_text(double value);            ///< four digits and a power of ten, so that columns compare
std::string order_text(double order);            ///< two decimals
std::string half_width_text(double half_width);  ///< "± 0.23", two digits
std::string duration_text(double seconds);       ///< "42 s", "3.1 min", "2.5 h"

/// "1 case", "2 cases"; `many` where that is not `one` with an s.
std::string count_text(std::size_t n, const std::string& one, const std::string& many = "");

}  // namespace mpmvv::cli
