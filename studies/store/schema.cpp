#include "studies/store/schema.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "studies/records/record.hpp"
#include "studies/store/first_schema.hpp"

namespace mpmvv::store {

namespace {

/// Errors of the nodes' accelerations.
constexpr const char* schema_2 = R"sql(
  ALTER TABLE runs ADD COLUMN nodal_l1 REAL;
  ALTER TABLE runs ADD COLUMN nodal_l2 REAL;
  ALTER TABLE runs ADD COLUMN nodal_linf REAL;
)sql";

constexpr const char* schema_3 = R"sql(
  -- Cost as evidence: median over exclusive repetitions, and their range over the median.
  ALTER TABLE runs ADD COLUMN step_seconds REAL;
  ALTER TABLE runs ADD COLUMN step_seconds_spread REAL;

  -- How a figure is drawn.
  ALTER TABLE figures ADD COLUMN kind TEXT NOT NULL DEFAULT 'curves'
    CHECK (kind IN ('curves', 'work-precision', 'particles'));
)sql";

/// Errors of the velocity and the stress, balances.
constexpr const char* schema_4 = R"sql(
  ALTER TABLE runs ADD COLUMN velocity_error REAL;
  ALTER TABLE runs ADD COLUMN stress_error REAL;
  ALTER TABLE runs ADD COLUMN mass_change REAL;
  ALTER TABLE runs ADD COLUMN momentum_change REAL;
  ALTER TABLE runs ADD COLUMN angular_momentum_change REAL;
)sql";

/// Results of mutation testing, which schema 9 drops again.
constexpr const char* schema_5 = R"sql(
  -- A variant of the program with one mistake. `gate` names the tests, studies and goldens that it met.
  CREATE TABLE mutants (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL,
    digest TEXT NOT NULL,
    provenance INTEGER NOT NULL,
    kept_at TEXT NOT NULL,
    gate TEXT NOT NULL,
    kind TEXT NOT NULL CHECK (kind IN ('baseline', 'planted', 'random')),
    what TEXT NOT NULL,
    file TEXT NOT NULL,
    line INTEGER NOT NULL,
    before_edit TEXT NOT NULL,
    after_edit TEXT NOT NULL,
    builds INTEGER NOT NULL CHECK (builds IN (0, 1)),
    UNIQUE (name, digest, gate),
    FOREIGN KEY (provenance, digest) REFERENCES provenance (id, digest)
  ) STRICT;

  CREATE TABLE mutant_trials (
    mutant INTEGER NOT NULL REFERENCES mutants ON DELETE CASCADE,
    stage TEXT NOT NULL CHECK (stage IN ('unit tests', 'quick', 'nightly')),
    caught INTEGER NOT NULL CHECK (caught IN (0, 1)),
    caught_by TEXT NOT NULL,
    seconds REAL,
    UNIQUE (mutant, stage)
  ) STRICT;
)sql";

/// Replicates, and extrapolation to h = 0.
constexpr const char* schema_6 = R"sql(
  -- Quantities of replicates, of which a point has the mean.
  CREATE TABLE point_replicates (
    point INTEGER NOT NULL REFERENCES points ON DELETE CASCADE,
    quantity TEXT NOT NULL,
    ordinal INTEGER NOT NULL,
    value REAL,
    PRIMARY KEY (point, quantity, ordinal)
  ) STRICT, WITHOUT ROWID;

  -- What they say of an order, where replicate_observations is not NULL.
  ALTER TABLE fits ADD COLUMN replicate_observations INTEGER;
  ALTER TABLE fits ADD COLUMN replicate_scatter REAL;
  ALTER TABLE fits ADD COLUMN replicate_half_width REAL;
  ALTER TABLE fits ADD COLUMN lack_of_fit REAL;

  -- A quantity without an exact value, extrapolated to h = 0.
  CREATE TABLE extrapolations (
    series INTEGER NOT NULL REFERENCES series ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    norm TEXT NOT NULL,
    window_from REAL,
    window_to REAL,
    points INTEGER NOT NULL,
    model TEXT NOT NULL,
    free_order REAL,
    limit_value REAL,
    deviation REAL,
    finest REAL,
    uncertainty REAL,
    convergence_index REAL,
    PRIMARY KEY (series, ordinal)
  ) STRICT, WITHOUT ROWID;
)sql";

/// Remarks on extrapolations.
constexpr const char* schema_7 = R"sql(
  ALTER TABLE extrapolations ADD COLUMN remark TEXT NOT NULL DEFAULT '';
)sql";

constexpr const char* schema_8 = R"sql(
  -- Of what is written for a row and all that belongs to it (seal.hpp): SQLite has no checksums.
  ALTER TABLE runs ADD COLUMN seal INTEGER;
  ALTER TABLE studies ADD COLUMN seal INTEGER;
  ALTER TABLE mutants ADD COLUMN seal INTEGER;

  -- Why a run has failed. One of the machine is tried again, and so is one of an older store, which does not say.
  ALTER TABLE runs ADD COLUMN failure TEXT CHECK (failure IN ('case', 'machine'));
)sql";

/// Mutation testing keeps its results in a file of its own.
constexpr const char* schema_9 = R"sql(
  DROP TABLE mutant_trials;
  DROP TABLE mutants;
)sql";

/// How many images of the part that was run make up the body.
constexpr const char* schema_10 = R"sql(
  ALTER TABLE runs ADD COLUMN images REAL;
)sql";

constexpr const char* schema_11 = R"sql(
  -- A claim as a study file states it: `stated_in` names the study.
  ALTER TABLE study_claims ADD COLUMN statement TEXT;
  ALTER TABLE study_claims ADD COLUMN source TEXT;
  ALTER TABLE study_claims ADD COLUMN place TEXT;
  ALTER TABLE study_claims ADD COLUMN stated_in TEXT;

  -- What a criterion asked, and each number that it compared with that: `infinite` is 1 or -1 where it has no end.
  ALTER TABLE claim_parts ADD COLUMN measure TEXT;
  ALTER TABLE claim_parts ADD COLUMN at_least REAL;
  ALTER TABLE claim_parts ADD COLUMN at_most REAL;
  CREATE TABLE claim_found (
    study INTEGER NOT NULL,
    part INTEGER NOT NULL,
    ordinal INTEGER NOT NULL,
    what TEXT NOT NULL,
    value REAL,
    infinite INTEGER CHECK (infinite IN (-1, 1)),
    PRIMARY KEY (study, part, ordinal),
    FOREIGN KEY (study, part) REFERENCES claim_parts (study, ordinal) ON DELETE CASCADE
  ) STRICT, WITHOUT ROWID;
)sql";

/// The floor of another code's output.
constexpr const char* schema_12 = R"sql(
  ALTER TABLE runs ADD COLUMN output_floor REAL;
)sql";

/// The floor of a solution that is not of the body's law.
constexpr const char* schema_13 = R"sql(
  ALTER TABLE runs ADD COLUMN solution_floor REAL;
)sql";

constexpr const char* schema_14 = R"sql(
  -- Displacement errors of particles at the end: x, y and error in m, a line for each.
  ALTER TABLE runs ADD COLUMN particle_errors TEXT;

  -- The code that ran a series, where it is another than our own solver.
  ALTER TABLE series ADD COLUMN code TEXT;
  ALTER TABLE series ADD COLUMN code_version TEXT;
  ALTER TABLE series ADD COLUMN variant TEXT;
  ALTER TABLE series ADD COLUMN force_form TEXT;
)sql";

/// Keeps a study of one version of a code beside that of another version. SQLite cannot drop the constraint that
/// forbade this, so the table is made anew.
constexpr const char* schema_15 = R"sql(
  CREATE TABLE studies_15 (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL,
    digest TEXT NOT NULL,
    provenance INTEGER NOT NULL,
    kept_at TEXT NOT NULL,
    title TEXT NOT NULL,
    kind TEXT NOT NULL,
    sweep TEXT NOT NULL,
    text TEXT NOT NULL,
    seal INTEGER,
    -- The other codes that ran it, a line for each with its name, version and digest. NULL: none, or an older store.
    codes TEXT,
    FOREIGN KEY (provenance, digest) REFERENCES provenance (id, digest)
  ) STRICT;
  INSERT INTO studies_15 SELECT id, name, digest, provenance, kept_at, title, kind, sweep, text, seal, NULL FROM studies;
  DROP TABLE studies;
  ALTER TABLE studies_15 RENAME TO studies;
  CREATE UNIQUE INDEX studies_by_codes ON studies (name, digest, coalesce(codes, ''));
)sql";

/// How many threads shared the run; NULL in older stores.
constexpr const char* schema_16 = R"sql(
  ALTER TABLE runs ADD COLUMN threads INTEGER;
)sql";

/// What a case cost in each timed round, in ns per particle and step, separated by blanks; and the id that all cases
/// timed in the same rounds share. NULL in older stores and where nothing was timed. How many steps a probe of a limit
/// took; NULL in older stores.
constexpr const char* schema_17 = R"sql(
  ALTER TABLE runs ADD COLUMN step_costs TEXT;
  ALTER TABLE runs ADD COLUMN cost_session TEXT;
  ALTER TABLE probes ADD COLUMN steps INTEGER;
)sql";

constexpr const char* schema_18 = R"sql(
  -- Where a number that was found may lie (NULL: no end there; of one that is itself infinite or unknown they say
  -- nothing) and what is to be said of it. A remark of NULL: an older store, which has only the number.
  ALTER TABLE claim_found ADD COLUMN lower REAL;
  ALTER TABLE claim_found ADD COLUMN upper REAL;
  ALTER TABLE claim_found ADD COLUMN remark TEXT;
)sql";

constexpr std::array written{schema_1,  schema_2,  schema_3,  schema_4,  schema_5,  schema_6,
                             schema_7,  schema_8,  schema_9,  schema_10, schema_11, schema_12,
                             schema_13, schema_14, schema_15, schema_16, schema_17, schema_18};

/// The statements for the run numbers whose schema is later than those written above. Before another schema is written
/// above by hand, these statements must be written there as well.
std::string columns_of(int schema) {
  std::string text;
  for (const auto* numbers : {&records::run_errors(), &records::run_by_products()})
    for (const records::RunNumber& number : *numbers)
      if (number.schema == schema) text += fmt::format("  ALTER TABLE runs ADD COLUMN {} REAL;\n", number.name);
  return text;
}

std::vector<std::string> all_migrations() {
  std::vector<std::string> all(written.begin(), written.end());
  for (std::string more; !(more = columns_of(static_cast<int>(all.size()) + 1)).empty();) all.push_back(more);
  return all;
}

}  // namespace

std::span<const char* const> migrations() {
  static const std::vector<std::string> texts = all_migrations();
  static const std::vector<const char*> all = [] {
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    return pointers;
  }();
  return all;
}

}  // namespace mpmvv::store
