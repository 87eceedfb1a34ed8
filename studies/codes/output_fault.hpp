#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "studies/records/record.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

/// A fault of a code's output: the reason for its record, and its status, `unstable` if the motion blew up, else
/// `failed`.
struct OutputFault : std::runtime_error {
  OutputFault(records::Status what, const std::string& reason)
      : std::runtime_error(support::without_nul(reason)), status(what) {}

  records::Status status;
};

template <class... T>
[[noreturn]] void fail_output(fmt::format_string<T...> format, T&&... values) {
  throw OutputFault(records::Status::failed, fmt::format(format, std::forward<T>(values)...));
}

}  // namespace mpmvv::codes
