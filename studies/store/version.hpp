#pragma once
#include <string>
#include <vector>

namespace mpmvv::store {

/// One state of the sources that decide a result, of which a store holds studies.
struct Version {
  std::string digest;
  std::vector<std::string>
      commits;  ///< one at least, whose builds had this digest, the first one first; "-dirty" behind those that were
  std::string time;  ///< of its first result, ISO 8601, UTC
};

/// "c0ffee123456 (digest 00ff12ab34cd)": the first commit; as short as people write it.
std::string label(const Version& version);

/// The version that a prefix of a commit or of a digest names. One that is given in full comes before those that only
/// begin so. UsageError that names the versions there are when there is none or more than one.
const Version& find_version(const std::vector<Version>& versions, const std::string& prefix);

}  // namespace mpmvv::store
