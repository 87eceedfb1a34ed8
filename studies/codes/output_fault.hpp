#pragma once
#include <stdexcept>
#include <string>

#include "studies/records/record.hpp"

namespace mpmvv::codes {

/// What is wrong with a code's output: the reason of its record, and whether it is the method that blew up.
struct OutputFault : std::runtime_error {
  OutputFault(records::Status what, const std::string& reason) : std::runtime_error(reason), status(what) {}

  records::Status status;
};

}  // namespace mpmvv::codes
