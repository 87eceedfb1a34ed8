#include "studies/store/store.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/store/code_versions.hpp"
#include "studies/store/program_versions.hpp"
#include "studies/store/run_rows.hpp"
#include "studies/store/schema.hpp"
#include "studies/store/seal.hpp"
#include "studies/store/study_rows.hpp"
#include "studies/support/csv.hpp"
#include "studies/support/error.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::store {

using cases::Case;
using records::Status;

using Kind = Transaction::Kind;

struct Store::Impl {
  mutable Database database;  ///< mutable for the reading transactions of const members, which change nothing
};

namespace {

std::vector<std::string> texts_of(const Values& values) {
  std::vector<std::string> texts;
  for (const Value& value : values) texts.push_back(value.to_string());
  return texts;
}

/// Leaves of a study the series that the code ran, and the claims whose criteria name one of these. Where it ran all of
/// them, all criteria are on it.
records::StudyResult only_of_code(records::StudyResult study, const std::string& code) {
  const auto others =
      std::erase_if(study.series, [&](const records::Series& s) { return !s.code || s.code->name != code; });
  study.values.clear();
  if (others > 0)
    std::erase_if(study.parts, [&](const records::ClaimPart& p) { return !records::speaks_of(p, study.series); });
  std::erase_if(study.claims, [&](const std::string& claim) {
    return std::ranges::find(study.parts, claim, &records::ClaimPart::claim) == study.parts.end();
  });
  return study;
}

/// How many versions of the study there are; UsageError when there is none.
std::size_t require_versions(const Database& database, const std::string& study) {
  const auto versions = static_cast<std::size_t>(
      database.scalar("SELECT count(*) FROM studies NOT INDEXED WHERE name = ?", {study}).integer());
  if (versions > 0) return versions;
  std::vector<std::string> names;
  database.each("SELECT DISTINCT name FROM studies ORDER BY name", {},
                [&](const Row& row) { names.push_back(row["name"].text()); });
  throw support::UsageError(fmt::format("unknown study '{}' in results store '{}' (known: {})", study,
                                        database.file().string(), support::listed(names)));
}

}  // namespace

void Store::require_study(const std::filesystem::path& file, const std::string& study) {
  require_versions(open_older_store(file), study);
}

Store::Store(const std::filesystem::path& file, Mode mode)
    : impl_(std::make_unique<Impl>(Impl{open_store(file, mode)})) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

void Store::wait_with(const std::function<bool(double)>& patience) {
  impl_->database.wait_with(patience);
}

std::optional<records::Record> Store::find(const Case& c, const std::string& digest) const {
  return find_run(impl_->database, c, digest);
}

std::optional<double> Store::last_seconds(const Case& c) const {
  std::optional<double> seconds;
  impl_->database.each(
      "SELECT wall_seconds * coalesce(threads, 1) AS seconds FROM runs "
      "WHERE case_text = ? AND status <> 'failed' AND wall_seconds IS NOT NULL ORDER BY kept_at DESC LIMIT 1",
      {cases::canonical_text(c)}, [&](const Row& row) { seconds = row["seconds"].real(); });
  return seconds;
}

StepCosts Store::step_costs() const {
  StepCosts costs;
  impl_->database.each(
      "SELECT problem, basis, integrator, velocity_update, "
      "sum(wall_seconds * coalesce(threads, 1)) / sum(particles * steps / coalesce(images, 1.0)) AS cost FROM runs "
      "WHERE status = 'ok' AND wall_seconds IS NOT NULL AND steps > 0 GROUP BY problem, basis, integrator, "
      "velocity_update",
      {}, [&](const Row& row) {
        costs[{row["problem"].text(), row["basis"].text(), row["integrator"].text(), row["velocity_update"].text()}] =
            row["cost"].real();
      });
  return costs;
}

void Store::keep(std::span<const records::Record> records, const Provenance& p) {
  Transaction transaction(impl_->database, Kind::write);
  for (const records::Record& r : records) insert_run(impl_->database, r, p);
  transaction.commit();
}

void Store::keep_study(const records::StudyResult& s, const std::vector<std::vector<Case>>& cases,
                       const Provenance& p) {
  StoredStudy study{.result = s, .cases = {}, .codes = code_lines(s.series), .provenance = p};
  for (const std::vector<Case>& of_series : cases) {
    std::vector<std::string>& texts = study.cases.emplace_back();
    for (const Case& c : of_series) texts.push_back(cases::canonical_text(c));
  }
  Transaction transaction(impl_->database, Kind::write);
  replace_study(impl_->database, study);
  transaction.commit();
}

std::vector<records::StudyResult> Store::studies(const std::string& digest) const {
  Transaction one_state(impl_->database, Kind::read);
  std::vector<records::StudyResult> results;
  for (StoredStudy& study : load_studies(impl_->database, digest)) results.push_back(std::move(study.result));
  return results;
}

std::vector<std::string> Store::codes() const {
  return codes_in(impl_->database);
}

std::vector<records::StudyResult> Store::studies_of_code(const std::string& code, const Version& version) const {
  Transaction one_state(impl_->database, Kind::read);
  std::vector<records::StudyResult> results;
  for (StoredStudy& study : load_studies_of_code(impl_->database, code_line(code, version)))
    results.push_back(only_of_code(std::move(study.result), code));
  return results;
}

std::vector<records::ClaimText> Store::statements(const std::string& digest) const {
  std::vector<records::ClaimText> texts;
  impl_->database.each(
      fmt::format(
          "SELECT claim, statement, source, place, stated_in FROM study_claims JOIN studies ON studies.id = study "
          "WHERE digest = ? AND stated_in = name AND {} ORDER BY name, ordinal",
          is_newest),
      {digest}, [&](const Row& row) {
        texts.push_back({row["claim"].text(), row["statement"].text(), row["source"].text(), row["place"].text(),
                         row["stated_in"].text()});
      });
  return texts;
}

std::vector<CodeSeries> Store::code_series(const std::string& digest) const {
  std::vector<CodeSeries> all;
  impl_->database.each(
      fmt::format(
          "SELECT studies.name AS study_name, kept_at, codes, series.* FROM series JOIN studies ON studies.id = "
          "series.study WHERE digest = ? AND code IS NOT NULL AND {} ORDER BY studies.name, ordinal",
          is_newest),
      {digest}, [&](const Row& row) {
        all.push_back({row["study_name"].text(), row["name"].text(), *other_code(row), row["kept_at"].text()});
        records::OtherCode& code = all.back().code;
        if (!row["codes"].null()) code.digest = digest_in(row["codes"].text(), code);
      });
  return all;
}

std::vector<Version> Store::versions() const {
  return versions_of_program(impl_->database);
}

std::vector<Version> Store::versions_of_code(const std::string& code) const {
  auto versions = store::versions_of_code(impl_->database, code);
  if (versions.empty())
    throw support::UsageError(fmt::format("no study of code '{}' in results store '{}' (of other codes: {})", code,
                                          impl_->database.file().string(), support::listed(codes())));
  return versions;
}

std::optional<Provenance> Store::study_provenance(const std::string& study, const std::string& digest) const {
  std::optional<Provenance> found;
  impl_->database.each(
      "SELECT * FROM studies JOIN provenance ON provenance.id = studies.provenance "
      "WHERE studies.name = ? AND studies.digest = ? ORDER BY kept_at, studies.id",
      {study, digest}, [&](const Row& row) { found = read_provenance(row); });
  return found;
}

std::string Store::study_text(const std::string& study, const std::string& digest) const {
  require_versions(impl_->database, study);
  std::string text;
  impl_->database.each(
      "SELECT id, text FROM studies NOT INDEXED WHERE name = ? ORDER BY digest = ? DESC, kept_at DESC, id DESC LIMIT 1",
      {study, digest}, [&](const Row& row) {
        require_intact(impl_->database, Sealed::study, row["id"]);
        text = row["text"].text();
      });
  return text;
}

Contents Store::contents() const {
  const Database& database = impl_->database;
  Transaction one_state(impl_->database, Kind::read);
  std::map<std::string, std::int64_t> with_status;
  database.each("SELECT status, count(*) AS records FROM runs GROUP BY status", {},
                [&](const Row& row) { with_status[row["status"].text()] = row["records"].integer(); });
  Contents contents{.schema = database.scalar("PRAGMA user_version").integer(),
                    .bytes = database.bytes(),
                    .studies = database.scalar("SELECT count(*) FROM studies").integer(),
                    .records = 0,
                    .ok = with_status[to_string(Status::ok)],
                    .unstable = with_status[to_string(Status::unstable)],
                    .failed = with_status[to_string(Status::failed)],
                    .programs = {},
                    .codes = {}};
  for (const auto& [status, records] : with_status) contents.records += records;
  database.each(
      "SELECT digest, git_commit, dirty, sum(records) AS records, max(kept_at) AS last FROM provenance JOIN "
      "(SELECT provenance, kept_at, 1 AS records FROM runs UNION ALL SELECT provenance, kept_at, 0 FROM studies) AS "
      "kept "
      "ON kept.provenance = provenance.id GROUP BY digest, git_commit, dirty ORDER BY last DESC",
      {}, [&](const Row& row) {
        contents.programs.push_back({row["digest"].text(), row["git_commit"].text(), row["dirty"].flag(),
                                     row["records"].integer(), row["last"].text()});
      });
  for (const std::string& code : codes_in(database))
    contents.codes.push_back({code, store::versions_of_code(database, code)});
  return contents;
}

std::vector<std::string> Store::check() const {
  std::vector<std::string> faults;
  try {
    impl_->database.each("PRAGMA integrity_check", {}, [&](const Row& row) {
      if (const std::string& text = row.values().front().text(); text != "ok") faults.push_back(text);
    });
    impl_->database.each("PRAGMA foreign_key_check", {}, [&](const Row& row) {
      const std::string which = row["rowid"].null() ? "a row" : "row " + row["rowid"].to_string();
      faults.push_back(fmt::format("{} of table {} refers to a missing row of table {}", which, row["table"].text(),
                                   row["parent"].text()));
    });
    for (std::string& broken : broken_seals(impl_->database)) faults.push_back(std::move(broken));
  } catch (const support::UsageError& e) {
    faults.emplace_back(e.what());
  }
  return faults;
}

std::size_t Store::forget(const std::string& study) {
  Transaction transaction(impl_->database, Kind::write);
  const std::size_t versions = require_versions(impl_->database, study);
  impl_->database.change("DELETE FROM studies WHERE name = ?", {study});
  transaction.commit();
  return versions;
}

std::string Store::export_csv() const {
  const std::string runs =
      "SELECT runs.*, git_commit, dirty, compiler, flags, build_type, cpu FROM runs JOIN provenance "
      "ON provenance.id = runs.provenance ORDER BY runs.id";
  std::string csv = support::csv_line(impl_->database.columns(runs));
  impl_->database.each(runs, {}, [&](const Row& row) {
    require_intact(impl_->database, Sealed::run, row["id"]);
    csv += support::csv_line(texts_of(row.values()));
  });
  return csv;
}

}  // namespace mpmvv::store
