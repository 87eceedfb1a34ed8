#include "studies/store/schema.hpp"

#include <array>

namespace mpmvv::store {

namespace {

constexpr const char* schema_1 = R"sql(
  -- Where results come from: one row per build and processor.
  CREATE TABLE provenance (
    id INTEGER PRIMARY KEY,
    digest TEXT NOT NULL,
    git_commit TEXT NOT NULL,
    dirty INTEGER NOT NULL CHECK (dirty IN (0, 1)),
    compiler TEXT NOT NULL,
    flags TEXT NOT NULL,
    build_type TEXT NOT NULL,
    cpu TEXT NOT NULL,
    UNIQUE (digest, git_commit, dirty, compiler, flags, build_type, cpu),
    UNIQUE (id, digest)
  ) STRICT;

  -- One run of one case. The case is `case_text`; the columns from `problem` to `end_time` repeat parts of it.
  CREATE TABLE runs (
    id INTEGER PRIMARY KEY,
    case_text TEXT NOT NULL,
    digest TEXT NOT NULL,
    provenance INTEGER NOT NULL,
    kept_at TEXT NOT NULL,
    problem TEXT NOT NULL,
    basis TEXT NOT NULL,
    integrator TEXT NOT NULL,
    velocity_update TEXT NOT NULL,
    boundary TEXT NOT NULL,
    cells INTEGER NOT NULL,
    ppc INTEGER NOT NULL,
    dt REAL,
    end_time REAL,
    particles INTEGER NOT NULL,
    steps INTEGER NOT NULL,
    cfl REAL,
    status TEXT NOT NULL CHECK (status IN ('ok', 'unstable', 'failed')),
    reason TEXT NOT NULL,
    l1 REAL,
    l2 REAL,
    linf REAL,
    l1_all_steps REAL,
    l2_all_steps REAL,
    linf_all_steps REAL,
    kinetic REAL,
    strain REAL,
    initial_total REAL,
    wall_seconds REAL,
    ns_per_particle_step REAL,
    UNIQUE (case_text, digest),
    FOREIGN KEY (provenance, digest) REFERENCES provenance (id, digest)
  ) STRICT;

  CREATE TABLE studies (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL,
    digest TEXT NOT NULL,
    provenance INTEGER NOT NULL,
    kept_at TEXT NOT NULL,
    title TEXT NOT NULL,
    kind TEXT NOT NULL,
    sweep TEXT NOT NULL,
    text TEXT NOT NULL,
    UNIQUE (name, digest),
    FOREIGN KEY (provenance, digest) REFERENCES provenance (id, digest)
  ) STRICT;

  CREATE TABLE study_claims (
    study INTEGER NOT NULL REFERENCES studies ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    claim TEXT NOT NULL,
    PRIMARY KEY (study, ordinal)
  ) STRICT, WITHOUT ROWID;

  CREATE TABLE claim_parts (
    study INTEGER NOT NULL REFERENCES studies ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    claim TEXT NOT NULL,
    statement TEXT NOT NULL,
    verdict TEXT NOT NULL CHECK (verdict IN ('holds', 'fails', 'shown', 'inconclusive')),
    evidence TEXT NOT NULL,
    reason TEXT NOT NULL,
    PRIMARY KEY (study, ordinal)
  ) STRICT, WITHOUT ROWID;

  CREATE TABLE check_values (
    study INTEGER NOT NULL REFERENCES studies ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    name TEXT NOT NULL,
    value REAL,
    meaning TEXT NOT NULL,
    PRIMARY KEY (study, ordinal)
  ) STRICT, WITHOUT ROWID;

  CREATE TABLE series (
    id INTEGER PRIMARY KEY,
    study INTEGER NOT NULL REFERENCES studies ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    name TEXT NOT NULL,
    UNIQUE (study, ordinal)
  ) STRICT;

  -- A point is a run, or has values of its own, or both.
  CREATE TABLE points (
    id INTEGER PRIMARY KEY,
    series INTEGER NOT NULL REFERENCES series ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    x REAL,
    status TEXT NOT NULL CHECK (status IN ('ok', 'unstable', 'failed')),
    reason TEXT NOT NULL,
    run INTEGER REFERENCES runs,
    UNIQUE (series, ordinal)
  ) STRICT;

  CREATE TABLE point_values (
    point INTEGER NOT NULL REFERENCES points ON DELETE CASCADE,
    quantity TEXT NOT NULL,
    value REAL,
    PRIMARY KEY (point, quantity)
  ) STRICT, WITHOUT ROWID;

  -- e = constant h^fitted_order over the declared window; with a floor where floor_accepted is not NULL.
  CREATE TABLE fits (
    id INTEGER PRIMARY KEY,
    series INTEGER NOT NULL REFERENCES series ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    norm TEXT NOT NULL,
    window_from REAL,
    window_to REAL,
    points INTEGER NOT NULL,
    fitted_order REAL,
    half_width REAL,
    constant REAL,
    r_squared REAL,
    asymptotic INTEGER NOT NULL CHECK (asymptotic IN (0, 1)),
    asymptotic_from REAL,
    asymptotic_to REAL,
    floor_constant REAL,
    floor_order REAL,
    floor_value REAL,
    floor_residual REAL,
    floor_accepted INTEGER CHECK (floor_accepted IN (0, 1)),
    floor_reason TEXT,
    UNIQUE (series, ordinal)
  ) STRICT;

  CREATE TABLE segments (
    fit INTEGER NOT NULL REFERENCES fits ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    x_from REAL,
    x_to REAL,
    segment_order REAL,
    PRIMARY KEY (fit, ordinal)
  ) STRICT, WITHOUT ROWID;

  CREATE TABLE limits (
    series INTEGER PRIMARY KEY REFERENCES series ON DELETE CASCADE,
    swept_key TEXT NOT NULL,
    stable REAL,
    unstable REAL,
    monotone INTEGER NOT NULL CHECK (monotone IN (0, 1)),
    found INTEGER NOT NULL CHECK (found IN (0, 1))
  ) STRICT;

  CREATE TABLE probes (
    series INTEGER NOT NULL REFERENCES limits ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    value REAL,
    stable INTEGER NOT NULL CHECK (stable IN (0, 1)),
    reason TEXT NOT NULL,
    PRIMARY KEY (series, ordinal)
  ) STRICT, WITHOUT ROWID;

  CREATE TABLE figures (
    id INTEGER PRIMARY KEY,
    study INTEGER NOT NULL REFERENCES studies ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    name TEXT NOT NULL,
    caption TEXT NOT NULL,
    xlabel TEXT NOT NULL,
    ylabel TEXT NOT NULL,
    log_x INTEGER NOT NULL CHECK (log_x IN (0, 1)),
    log_y INTEGER NOT NULL CHECK (log_y IN (0, 1)),
    quantity TEXT NOT NULL,
    x_min REAL,
    x_max REAL,
    y_min REAL,
    y_max REAL,
    UNIQUE (study, ordinal)
  ) STRICT;

  CREATE TABLE figure_series (
    figure INTEGER NOT NULL REFERENCES figures ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    name TEXT NOT NULL,
    PRIMARY KEY (figure, ordinal)
  ) STRICT, WITHOUT ROWID;

  CREATE TABLE figure_marks (
    figure INTEGER NOT NULL REFERENCES figures ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    name TEXT NOT NULL,
    PRIMARY KEY (figure, ordinal)
  ) STRICT, WITHOUT ROWID;

  CREATE TABLE figure_slopes (
    figure INTEGER NOT NULL REFERENCES figures ON DELETE CASCADE,
    ordinal INTEGER NOT NULL,
    slope REAL,
    PRIMARY KEY (figure, ordinal)
  ) STRICT, WITHOUT ROWID;
)sql";

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

/// How the gate takes mistakes.
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

/// What is to be said of an extrapolation.
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

constexpr std::array all_migrations{schema_1, schema_2, schema_3, schema_4, schema_5,
                                    schema_6, schema_7, schema_8, schema_9};

}  // namespace

std::span<const char* const> migrations() {
  return all_migrations;
}

}  // namespace mpmvv::store
