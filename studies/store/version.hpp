#pragma once
#include <string>
#include <vector>

namespace mpmvv::store {

/// One state of the sources that decide a result, of which a store holds studies; or of another code.
struct Version {
  std::string digest;
  /// At least one: the commits whose builds had this digest, the first one first, with "-dirty" behind those of a
  /// changed tree. Of another code: the version that it says of itself.
  std::vector<std::string> commits;
  std::string time;  ///< of its first result, ISO 8601, UTC; of another code, of its last study
};

/// As short as people write it: the first letters of a hash, which tell it from others, and whether the tree was dirty.
/// What another code says of its version stays as it is, unless it is a hash, too.
std::string in_short(const std::string& commit);

/// "c0ffee123456 (digest 00ff12ab34cd)": the first commit.
std::string label(const Version& version);

/// The version that a prefix of a commit or of a digest names. A version named in full is preferred to those that only
/// begin so. UsageError, with the versions that there are, when none or more than one fits.
const Version& find_version(const std::vector<Version>& versions, const std::string& prefix,
                            const std::string& code = "mpmvv");

}  // namespace mpmvv::store
