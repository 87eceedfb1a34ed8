#include "studies/store/run_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mpmvv::db {

namespace {

Columns run_columns(const Record& r) {
  const auto& [problem, scheme, resolution, measure] = r.the_case;
  return {{"case_text", canonical_text(r.the_case)},
          {"problem", problem.name},
          {"basis", scheme.basis},
          {"integrator", scheme.integrator},
          {"velocity_update", scheme.velocity_update},
          {"boundary", scheme.boundary},
          {"cells", resolution.cells},
          {"ppc", resolution.ppc},
          {"dt", resolution.dt},
          {"end_time", problem.end_time},
          {"particles", r.particles},
          {"steps", r.steps},
          {"cfl", r.cfl},
          {"status", to_string(r.status)},
          {"reason", r.reason},
          {"l1", r.error.l1},
          {"l2", r.error.l2},
          {"linf", r.error.linf},
          {"l1_all_steps", r.error.l1_all_steps},
          {"l2_all_steps", r.error.l2_all_steps},
          {"linf_all_steps", r.error.linf_all_steps},
          {"nodal_l1", r.error.nodal_l1},
          {"nodal_l2", r.error.nodal_l2},
          {"nodal_linf", r.error.nodal_linf},
          {"velocity_error", r.error.velocity},
          {"stress_error", r.error.stress},
          {"mass_change", r.balance.mass},
          {"momentum_change", r.balance.momentum},
          {"angular_momentum_change", r.balance.angular_momentum},
          {"kinetic", r.energy.kinetic},
          {"strain", r.energy.strain},
          {"initial_total", r.energy.initial_total},
          {"wall_seconds", r.wall_seconds},
          {"ns_per_particle_step", r.ns_per_particle_step},
          {"step_seconds", r.cost.step_seconds},
          {"step_seconds_spread", r.cost.spread}};
}

/// Inserts a row of `runs`; 1 when it was kept.
std::int64_t insert_row(Database& database, const Columns& columns) {
  std::vector<std::string> replacements;
  for (const auto& [name, value] : columns) replacements.push_back(fmt::format("{0} = excluded.{0}", name));
  return database.insert("runs", columns,
                         fmt::format("ON CONFLICT (case_text, digest) DO UPDATE SET {} "
                                     "WHERE status = 'failed' AND excluded.status <> 'failed'",
                                     fmt::join(replacements, ", ")));
}

}  // namespace

std::int64_t provenance_id(Database& database, const Provenance& p) {
  database.insert("provenance",
                  {{"digest", p.digest},
                   {"git_commit", p.commit},
                   {"dirty", p.dirty},
                   {"compiler", p.compiler},
                   {"flags", p.flags},
                   {"build_type", p.build_type},
                   {"cpu", p.cpu}},
                  "ON CONFLICT DO NOTHING");
  return database
      .scalar(
          "SELECT id FROM provenance WHERE digest = ? AND git_commit = ? AND dirty = ? AND compiler = ? AND flags = ? "
          "AND build_type = ? AND cpu = ?",
          {p.digest, p.commit, p.dirty, p.compiler, p.flags, p.build_type, p.cpu})
      .integer();
}

Provenance read_provenance(const Row& row) {
  return {.digest = row["digest"].text(),
          .commit = row["git_commit"].text(),
          .dirty = row["dirty"].flag(),
          .compiler = row["compiler"].text(),
          .flags = row["flags"].text(),
          .build_type = row["build_type"].text(),
          .cpu = row["cpu"].text(),
          .time = row["kept_at"].text()};
}

void insert_run(Database& database, const Record& r, const Provenance& p) {
  Columns columns = run_columns(r);
  columns.insert(columns.end(),
                 {{"provenance", provenance_id(database, p)}, {"digest", p.digest}, {"kept_at", p.time}});
  insert_row(database, columns);
}

std::optional<Record> find_run(const Database& database, const Case& c, const std::string& digest) {
  std::optional<Record> found;
  database.each(
      "SELECT * FROM runs WHERE case_text = ? AND digest = ?", {canonical_text(c), digest}, [&](const Row& row) {
        found =
            Record{.the_case = c,
                   .particles = row["particles"].integer(),
                   .steps = row["steps"].integer(),
                   .cfl = row["cfl"].real(),
                   .status = status_from(row["status"].text()),
                   .reason = row["reason"].text(),
                   .error = {.l1 = row["l1"].real(),
                             .l2 = row["l2"].real(),
                             .linf = row["linf"].real(),
                             .l1_all_steps = row["l1_all_steps"].real(),
                             .l2_all_steps = row["l2_all_steps"].real(),
                             .linf_all_steps = row["linf_all_steps"].real(),
                             .nodal_l1 = row["nodal_l1"].real(),
                             .nodal_l2 = row["nodal_l2"].real(),
                             .nodal_linf = row["nodal_linf"].real(),
                             .velocity = row["velocity_error"].real(),
                             .stress = row["stress_error"].real()},
                   .energy = {.kinetic = row["kinetic"].real(),
                              .strain = row["strain"].real(),
                              .initial_total = row["initial_total"].real()},
                   .balance = {.mass = row["mass_change"].real(),
                               .momentum = row["momentum_change"].real(),
                               .angular_momentum = row["angular_momentum_change"].real()},
                   .wall_seconds = row["wall_seconds"].real(),
                   .ns_per_particle_step = row["ns_per_particle_step"].real(),
                   .cost = {.step_seconds = row["step_seconds"].real(), .spread = row["step_seconds_spread"].real()}};
      });
  return found;
}

std::map<std::string, double> run_quantities(const Row& row) {
  std::map<std::string, double> quantities;
  for (const char* name : {"l1",
                           "l2",
                           "linf",
                           "l1_all_steps",
                           "l2_all_steps",
                           "linf_all_steps",
                           "nodal_l1",
                           "nodal_l2",
                           "nodal_linf",
                           "velocity_error",
                           "stress_error",
                           "mass_change",
                           "momentum_change",
                           "angular_momentum_change",
                           "wall_seconds",
                           "ns_per_particle_step",
                           "step_seconds",
                           "step_seconds_spread",
                           "kinetic",
                           "strain",
                           "initial_total",
                           "particles",
                           "steps",
                           "dt",
                           "cfl"})
    if (const Value& value = row[name]; !value.null()) quantities[name] = value.real();
  return quantities;
}

std::int64_t copy_runs(const Database& from, Database& to) {
  std::map<std::int64_t, std::int64_t> ids;  // of provenance, there and here
  from.each("SELECT *, '' AS kept_at FROM provenance", {},
            [&](const Row& row) { ids[row["id"].integer()] = provenance_id(to, read_provenance(row)); });
  std::int64_t copied = 0;
  from.each("SELECT * FROM runs ORDER BY id", {}, [&](const Row& row) {
    Columns columns{{"provenance", ids.at(row["provenance"].integer())}};
    for (std::size_t i = 0; i < row.names().size(); ++i)
      if (const std::string& name = row.names()[i]; name != "id" && name != "provenance")
        columns.emplace_back(name, row.values()[i]);
    copied += insert_row(to, columns);
  });
  return copied;
}

}  // namespace mpmvv::db
