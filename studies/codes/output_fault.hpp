#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "studies/records/record.hpp"

namespace mpmvv::codes {

/// What is wrong with a code's output: the reason of its record, and whether it is the method that blew up.
struct OutputFault : std::runtime_error {
  OutputFault(records::Status what, const std::string& reason) : std::runtime_error(reason), status(what) {}

  records::Status status;
};

template <class... T>
[[noreturn]] void fail_output(fmt::format_string<T...> format, T&&... values) {
  throw OutputFault(records::Status::failed, fmt::format(format, std::forward<T>(values)...));
}

}  // namespace mpmvv::codes
