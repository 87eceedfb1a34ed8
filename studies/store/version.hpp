#pragma once
#include <string>
#include <vector>

namespace mpmvv::store {

/// One state of the sources that decide a result, of which a store holds studies; or of another code.
struct Version {
  std::string digest;
  std::vector<std::string> commits;  ///< one at least, whose builds had this digest, the first one first; "-dirty"
                                     ///< behind those that were; of another code, the version that it says of itself
  std::string time;                  ///< of its first result, ISO 8601, UTC; of another code, of its last study
};

/// As short as people write it: the first letters of a hash, which tell it from others, and whether the tree was dirty.
/// What another code says of its version stays as it is, unless it is a hash, too.
std::string in_short(const std::string& commit);

/// "c0ffee123456 (digest 00ff12ab34cd)": the first commit.
std::string label(const Version& version);

/// The version that a prefix of a commit or of a digest names. One that is given in full comes before those that only
/// begin so. UsageError that names the versions there are when there is none or more than one.
const Version& find_version(const std::vector<Version>& versions, const std::string& prefix);

}  // namespace mpmvv::store
