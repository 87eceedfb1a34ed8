#include "studies/store/mutant_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "studies/store/run_rows.hpp"
#include "studies/store/seal.hpp"

namespace mpmvv::store {

namespace {

void insert_trial(Database& database, std::int64_t mutant, const Trial& trial) {
  database.insert("mutant_trials", {{"mutant", mutant},
                                    {"stage", to_string(trial.stage)},
                                    {"caught", trial.caught},
                                    {"caught_by", fmt::format("{}", fmt::join(trial.by, "\n"))},
                                    {"seconds", trial.seconds}});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<Trial> load_trials(const Database& database, std::int64_t mutant) {
  std::vector<Trial> trials;
  database.each("SELECT * FROM mutant_trials WHERE mutant = ? ORDER BY rowid", {mutant}, [&](const Row& row) {
    trials.push_back({gate_stage_from(row["stage"].text()), row["caught"].flag(), lines_of(row["caught_by"].text()),
                      row["seconds"].real()});
  });
  return trials;
}

bool has_mutant(const Database& database, const std::string& digest, const Mutant& mutant) {
  return database
             .scalar("SELECT count(*) FROM mutants WHERE name = ? AND digest = ? AND gate = ?",
                     {mutant.name, digest, mutant.gate})
             .integer() > 0;
}

}  // namespace

void insert_mutant(Database& database, const StoredMutant& stored) {
  const auto& [mutant, provenance] = stored;
  database.change("DELETE FROM mutants WHERE name = ? AND digest = ? AND gate = ?",
                  {mutant.name, provenance.digest, mutant.gate});
  database.insert("mutants", {{"name", mutant.name},
                              {"digest", provenance.digest},
                              {"provenance", provenance_id(database, provenance)},
                              {"kept_at", provenance.time},
                              {"gate", mutant.gate},
                              {"kind", to_string(mutant.kind)},
                              {"what", mutant.what},
                              {"file", mutant.file},
                              {"line", mutant.line},
                              {"before_edit", mutant.before},
                              {"after_edit", mutant.after},
                              {"builds", mutant.builds}});
  const std::int64_t id = database.last_row_id();
  for (const Trial& trial : mutant.trials) insert_trial(database, id, trial);
  seal(database, Sealed::mutant, id);
}

std::vector<StoredMutant> load_mutants(const Database& database, const std::string& digest) {
  std::vector<StoredMutant> mutants;
  database.each(
      "SELECT mutants.*, provenance.git_commit, dirty, compiler, flags, build_type, cpu FROM mutants NOT INDEXED "
      "JOIN provenance ON provenance.id = mutants.provenance WHERE mutants.digest = ?1 OR provenance.digest = ?1 "
      "ORDER BY mutants.id",
      {digest}, [&](const Row& row) {
        require_intact(database, Sealed::mutant, row["id"]);
        mutants.push_back({{.name = row["name"].text(),
                            .kind = mutant_kind_from(row["kind"].text()),
                            .what = row["what"].text(),
                            .file = row["file"].text(),
                            .line = static_cast<int>(row["line"].integer()),
                            .before = row["before_edit"].text(),
                            .after = row["after_edit"].text(),
                            .gate = row["gate"].text(),
                            .builds = row["builds"].flag(),
                            .trials = load_trials(database, row["id"].integer())},
                           read_provenance(row)});
      });
  return mutants;
}

void copy_mutants(const Database& from, Database& to) {
  std::vector<std::string> digests;
  from.each("SELECT DISTINCT digest FROM mutants", {},
            [&](const Row& row) { digests.push_back(row["digest"].text()); });
  for (const std::string& digest : digests)
    for (const StoredMutant& stored : load_mutants(from, digest))
      if (!has_mutant(to, digest, stored.mutant)) insert_mutant(to, stored);
}

}  // namespace mpmvv::store
