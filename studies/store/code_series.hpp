#pragma once
#include <string>

namespace mpmvv::store {

/// A series of a study that another code ran.
struct CodeSeries {
  std::string study, series;
  std::string code, version, variant, force_form;
  std::string kept_at;  ///< of the study, ISO 8601, UTC
};

}  // namespace mpmvv::store
