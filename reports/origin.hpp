#pragma once
#include <map>
#include <string>
#include <vector>

#include "studies/store/provenance.hpp"

namespace mpmvv::reports {

using Provenances = std::map<std::string, store::Provenance>;  ///< by study

/// Where results come from.
struct Origin {
  store::Provenance provenance;  ///< with the time of the newest study
  std::size_t studies = 0;       ///< how many come from there
};

/// The provenances that differ in more than their times, newest first.
std::vector<Origin> origins_of(const Provenances& provenances);

/// "1 study", "2 studies".
std::string studies_text(std::size_t count);

/// "8be1f2c-dirty, 77aa001"; empty where there are none.
std::string versions_text(const std::vector<Origin>& origins);

}  // namespace mpmvv::reports
