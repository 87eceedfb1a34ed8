#include "studies/support/reason.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

namespace mpmvv::support {

namespace {

std::string reason_of_file(const std::filesystem::filesystem_error& error) {
  return fmt::format("cannot use '{}': {} (a path that is there and may be used)", error.path1().string(),
                     error.code().message());
}

std::string reason_of_system(const std::system_error& error) {
  if (error.code() == std::errc::resource_unavailable_try_again)
    return "no more threads or processes may be started (fewer threads or jobs, or a higher limit)";
  return fmt::format("the system refuses: {}", error.code().message());
}

template <class Error>
const Error* as(const std::exception& error) {
  return dynamic_cast<const Error*>(&error);
}

}  // namespace

std::string reason_of(const std::exception& error) {
  if (as<std::bad_alloc>(error) || as<std::length_error>(error))
    return "not enough memory (fewer cells, particles, threads or jobs)";
  if (const auto* of_file = as<std::filesystem::filesystem_error>(error)) return reason_of_file(*of_file);
  if (const auto* of_system = as<std::system_error>(error)) return reason_of_system(*of_system);
  const bool in_our_words =
      as<std::runtime_error>(error) || as<std::domain_error>(error) || as<std::invalid_argument>(error);
  if (in_our_words) return error.what();
  return fmt::format("a mistake in mpmvv itself: {} (please report it with the command)", error.what());
}

}  // namespace mpmvv::support
