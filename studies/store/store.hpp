#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "studies/records/record.hpp"
#include "studies/records/result.hpp"
#include "studies/store/code_series.hpp"
#include "studies/store/contents.hpp"
#include "studies/store/provenance.hpp"
#include "studies/store/version.hpp"

namespace mpmvv::store {

/// Seconds on one core per particle and step, by problem and method (`cases::method_of`).
using StepCosts = std::map<std::array<std::string, 4>, double>;

/// The results store: one SQLite file. Two processes may write it at once. Every message is a UsageError with
/// the file's name: not a store, another application's, a newer schema, read-only, disk full, absent.
///
/// A record's key is (canonical text of the case, digest). NaN and infinity are kept as NULL and come back as NaN;
/// an infinite value of a check comes back as it is. Runs and studies are kept under a seal: reading one that is not as
/// it was written throws a UsageError. One store object serves one thread at a time.
class Store {
 public:
  enum class Mode { create_or_write, write, read };

  Store(const std::filesystem::path& file, Mode mode);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;

  /// Changes how long to wait for another process that locks the store: ten seconds without a patience, which is asked
  /// with the seconds that a wait has lasted whether to wait on.
  void wait_with(const std::function<bool(double)>& patience);

  /// The record of this case made by this digest, if it is there.
  std::optional<records::Record> find(const cases::Case& c, const std::string& digest) const;

  /// Seconds on one core that the last run of this case took, whatever the digest: its time, by the threads that shared
  /// it. None when there was no run.
  std::optional<double> last_seconds(const cases::Case& c) const;

  /// Averages over all sound runs, whatever the digest. They include the preparation of the runs.
  StepCosts step_costs() const;

  /// Keeps finished records in one transaction: a killed run loses nothing that was kept. Keeping the same key again
  /// (two processes) is no error; the first one stays, unless it has `failed` or was timed. A failed run gives way to
  /// one that was carried out and to a later failure; only a failure of the case does not give way to one of the
  /// machine. A sound run gives way to one that was timed, and a timed one also to one that is not sound any more,
  /// unless the machine failed it.
  void keep(std::span<const records::Record> records, const Provenance& p);
  void keep(const records::Record& r, const Provenance& p) { keep({&r, 1}, p); }

  /// Replaces what the store holds of this study for this digest and these versions of other codes, in one transaction.
  /// Points that are runs are linked by their case; `cases[s][k]` is the case of series s, point k (empty for checks).
  /// Their records must have been kept; the points come back with all that was measured in the run, and with what they
  /// have beyond it.
  void keep_study(const records::StudyResult& s, const std::vector<std::vector<cases::Case>>& cases,
                  const Provenance& p);

  /// Studies of this digest by name, in name order. Empty when there is none. Of a study that several versions of
  /// another code ran, the one kept last.
  std::vector<records::StudyResult> studies(const std::string& digest) const;

  /// The codes that ran some of the studies, in alphabetical order.
  std::vector<std::string> codes() const;

  /// What the studies, without trials, say about this version of a code, in name order: the series that it ran, and the
  /// claims that these judge, also the parts of which nothing could be measured.
  std::vector<records::StudyResult> studies_of_code(const std::string& code, const Version& version) const;

  /// The series of studies of this digest that other codes ran, in the order of the studies.
  std::vector<CodeSeries> code_series(const std::string& digest) const;

  /// What the studies of this digest say of the claims that they state.
  std::vector<records::ClaimText> statements(const std::string& digest) const;

  /// The versions that studies were kept of, by the time of their first result.
  std::vector<Version> versions() const;

  /// The versions of another code, by the time of their last study. The last one is the one that is judged. UsageError,
  /// with the codes that there are, when this one ran no study.
  std::vector<Version> versions_of_code(const std::string& code) const;

  /// Provenance of the study's last keeping; nullopt when absent.
  std::optional<Provenance> study_provenance(const std::string& study, const std::string& digest) const;

  /// The text of a study as this digest kept it or, where it did not, as it was kept last. UsageError when there is
  /// none.
  std::string study_text(const std::string& study, const std::string& digest) const;

  Contents contents() const;

  /// For `db check`: integrity_check, foreign_key_check and all seals; what is wrong, empty when sound.
  std::vector<std::string> check() const;

  /// Copies into the store `file`, which is made when absent, every record and study of the others that it lacks;
  /// returns the number of records copied. All or nothing: a merge that fails or is killed changes nothing but an older
  /// schema, and leaves no new file but an empty one. Of records with the same key the first one stays, unless it
  /// failed and the other one was carried out, or failed of the case while the first one did not.
  static std::int64_t merge(const std::filesystem::path& file, std::span<const std::filesystem::path> others);
  static std::int64_t merge(const std::filesystem::path& file, const std::filesystem::path& other) {
    return merge(file, {&other, 1});
  }

  /// UsageError unless the store, which may have an older schema, has the study. It writes nothing.
  static void require_study(const std::filesystem::path& file, const std::string& study);

  /// Removes the study in all its versions and returns their number. The runs stay, as they belong to their cases.
  /// UsageError when there is none.
  std::size_t forget(const std::string& study);

  /// What `prune` removed.
  struct Pruned {
    std::vector<Version> versions = {};  ///< by the time of their first result
    std::int64_t studies = 0, records = 0;
    std::int64_t bytes = 0;            ///< by which the file is smaller
    std::string why_not_smaller = {};  ///< where its free space could not be given back
  };

  /// Keeps the `newest` versions that have studies of their own, and that of the running program. Of all others it
  /// removes these studies, and then every run of our own solver that no study refers to: also that of a study which
  /// such a version runs at this time. What other codes ran stays. All or nothing; the deletion takes as much free
  /// space as goes, and giving it back as much as stays.
  static Pruned prune(const std::filesystem::path& file, std::size_t newest, const std::string& running_digest);

  /// All records as CSV (17 digits, NaN empty), with digest and commit.
  std::string export_csv() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// UsageError unless a store is in this place or can be made there.
void require_place(const std::filesystem::path& file);

}  // namespace mpmvv::store
