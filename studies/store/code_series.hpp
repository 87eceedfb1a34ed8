#pragma once
#include <string>

#include "studies/records/result.hpp"

namespace mpmvv::store {

/// A series of a study that another code ran.
struct CodeSeries {
  std::string study, series;
  records::OtherCode code;
  std::string kept_at;  ///< when the study was kept, ISO 8601, UTC
};

}  // namespace mpmvv::store
