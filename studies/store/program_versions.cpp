#include "studies/store/program_versions.hpp"

#include <algorithm>

namespace mpmvv::store {

std::vector<Version> versions_of_program(const Database& database) {
  std::vector<Version> versions;
  database.each(
      "SELECT digest, git_commit, dirty, min(kept_at) AS first FROM provenance JOIN "
      "(SELECT provenance, kept_at FROM runs UNION ALL SELECT provenance, kept_at FROM studies) AS kept "
      "ON kept.provenance = provenance.id WHERE digest IN (SELECT digest FROM studies) "
      "GROUP BY digest, git_commit, dirty ORDER BY first, min(provenance.id)",
      {}, [&](const Row& row) {
        const std::string commit = row["git_commit"].text() + (row["dirty"].flag() ? "-dirty" : "");
        const auto known = std::ranges::find(versions, row["digest"].text(), &Version::digest);
        if (known == versions.end())
          versions.push_back({row["digest"].text(), {commit}, row["first"].text()});
        else
          known->commits.push_back(commit);
      });
  return versions;
}

}  // namespace mpmvv::store
