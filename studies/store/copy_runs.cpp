#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "studies/store/run_rows.hpp"
#include "studies/store/seal.hpp"

namespace mpmvv::store {

namespace {

/// A copy of a `provenance` row that stays valid after its query.
class ProvenanceRow {
 public:
  ProvenanceRow(const Database& database, std::int64_t id) {
    database.each("SELECT * FROM provenance WHERE id = ?", {id},
                  [&](const Row& row) { names_ = row.names(), values_ = row.values(); });
  }

  Row row() const { return {names_, values_}; }

 private:
  std::vector<std::string> names_;
  Values values_;
};

/// The provenance of runs: its row in the store they come from, and its row in the store they go to.
struct Origin {
  ProvenanceRow there, here;
};

/// Copies runs with one statement each: the seal is computed beforehand, so that no second statement has to set it.
class RunCopier {
 public:
  RunCopier(const Database& from, Database& to) : from_(from), to_(to) {
    from.each("SELECT *, '' AS kept_at FROM provenance", {}, [&](const Row& row) {
      const std::int64_t there = row["id"].integer();
      origins_.emplace(there, Origin{{from, there}, {to, provenance_id(to, read_provenance(row))}});
    });
    last_id_ = to.scalar("SELECT coalesce(max(id), 0) FROM runs").integer();
  }

  std::int64_t copy(const Row& there) {
    if (columns_.empty()) find_columns(there.names());
    const Origin& origin = origin_of(there);
    Values values = there.values();
    values[id_] = last_id_ + 1;
    const Row provenance = origin.here.row();
    values[provenance_] = provenance["id"];
    values[seal_] = seal_of_run(Row(there.names(), values), provenance);
    if (to_.change(statement_, values) == 1) {
      ++last_id_;
      return 1;
    }
    return replace_failed(there, origin);
  }

 private:
  void find_columns(const std::vector<std::string>& names) {
    columns_ = names;
    const auto place_of = [&](const char* name) {
      return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    id_ = place_of("id"), provenance_ = place_of("provenance"), seal_ = place_of("seal");
    statement_ = fmt::format("INSERT INTO runs ({}) VALUES ({}) ON CONFLICT (case_text, digest) DO NOTHING",
                             fmt::join(names, ", "), fmt::join(std::vector<char>(names.size(), '?'), ", "));
  }

  /// The origin of a run; throws unless the run is intact.
  const Origin& origin_of(const Row& there) const {
    const auto origin = origins_.find(there["provenance"].integer());
    if (origin == origins_.end() ||
        there["seal"].held() != Value(seal_of_run(there, origin->second.there.row())).held())
      require_intact(from_, Sealed::run, there["id"]);
    return origins_.at(there["provenance"].integer());
  }

  /// For a run whose key is in the store already. Replaces a run that failed by one that was carried out, or by a
  /// failure of the case where the run there failed for another reason: that says more. Returns 1 when it replaced the
  /// run, else 0.
  std::int64_t replace_failed(const Row& there, const Origin& origin) {
    const Value says_more = to_.scalar(
        "SELECT status = 'failed' AND (? <> 'failed' OR (? IS 'case' AND failure IS NOT 'case')) FROM runs "
        "WHERE case_text = ? AND digest = ?",
        {there["status"], there["failure"], there["case_text"], there["digest"]});
    if (says_more.integer() == 0) return 0;
    Columns columns{{"provenance", origin.here.row()["id"]}};
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (i != id_ && i != provenance_ && i != seal_) columns.emplace_back(columns_[i], there.values()[i]);
    return insert_run_row(to_, columns, there["case_text"], there["digest"]);
  }

  const Database& from_;
  Database& to_;
  std::map<std::int64_t, Origin> origins_;  ///< by the id in `from`
  std::int64_t last_id_ = 0;
  std::vector<std::string> columns_;
  std::size_t id_ = 0, provenance_ = 0, seal_ = 0;  ///< their places among the columns
  std::string statement_;
};

}  // namespace

std::int64_t copy_runs(const Database& from, Database& to) {
  RunCopier copier(from, to);
  std::int64_t copied = 0;
  from.each("SELECT * FROM runs ORDER BY id", {}, [&](const Row& row) { copied += copier.copy(row); });
  return copied;
}

}  // namespace mpmvv::store
