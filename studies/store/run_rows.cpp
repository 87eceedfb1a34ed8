#include "studies/store/run_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "studies/store/particle_errors.hpp"
#include "studies/store/seal.hpp"

namespace mpmvv::store {

using records::Record;
using records::RunNumber;

namespace {

/// Calls visit(number) for each number of a run that has a column of its name.
template <class Visit>
void for_numbers(const Visit& visit) {
  for (const auto* numbers : {&records::run_errors(), &records::run_by_products()})
    for (const RunNumber& number : *numbers) visit(number);
}

/// With all digits; nulls where nothing was timed.
void add_rounds(const fits::Rounds& rounds, Columns& columns) {
  const bool is_timed = !rounds.costs.empty();
  columns.emplace_back("step_costs", is_timed ? Value(fmt::format("{}", fmt::join(rounds.costs, " "))) : Value());
  columns.emplace_back("cost_session", is_timed ? Value(rounds.session) : Value());
}

Columns run_columns(const Record& r) {
  const auto& [problem, scheme, resolution, measure] = r.the_case;
  const auto [basis, integrator, velocity_update] = cases::method_of(scheme);
  Columns columns{{"case_text", cases::canonical_text(r.the_case)},
                  {"problem", problem.name},
                  {"basis", basis},
                  {"integrator", integrator},
                  {"velocity_update", velocity_update},
                  {"boundary", scheme.boundary},
                  {"cells", resolution.cells},
                  {"ppc", resolution.ppc},
                  {"dt", resolution.dt},
                  {"end_time", problem.end_time},
                  {"particles", r.particles},
                  {"steps", r.steps},
                  {"threads", r.threads},
                  {"status", to_string(r.status)},
                  {"reason", r.reason},
                  {"failure", r.failure == records::Failure::none ? Value() : Value(to_string(r.failure))}};
  for_numbers([&](const RunNumber& number) { columns.emplace_back(number.name, number.get(r)); });
  columns.emplace_back("particle_errors", value_of(r.particle_errors));
  add_rounds(r.cost.rounds, columns);
  return columns;
}

Value id_of(const Database& database, const Value& case_text, const Value& digest) {
  return database.scalar("SELECT id FROM runs WHERE case_text = ? AND digest = ?", {case_text, digest});
}

}  // namespace

std::int64_t insert_run_row(Database& database, const Columns& columns, const Value& case_text, const Value& digest) {
  std::vector<std::string> replacements;
  for (const auto& [name, value] : columns) replacements.push_back(fmt::format("{0} = excluded.{0}", name));
  const std::int64_t kept = database.insert(
      "runs", columns,
      fmt::format("ON CONFLICT (case_text, digest) DO UPDATE SET {} WHERE status = 'failed' AND "
                  "(excluded.status <> 'failed' OR excluded.failure IS 'case' OR failure IS NOT 'case') "
                  "OR status = 'ok' AND excluded.cost_session IS NOT NULL "
                  "OR cost_session IS NOT NULL AND excluded.status <> 'ok' AND excluded.failure IS NOT 'machine'",
                  fmt::join(replacements, ", ")));
  if (kept > 0) seal(database, Sealed::run, id_of(database, case_text, digest).integer());
  return kept;
}

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
  insert_run_row(database, columns, cases::canonical_text(r.the_case), p.digest);
}

std::optional<Record> find_run(const Database& database, const cases::Case& c, const std::string& digest) {
  std::optional<Record> found;
  const std::string case_text = cases::canonical_text(c);
  database.each("SELECT * FROM runs WHERE case_text = ? AND digest = ?", {case_text, digest}, [&](const Row& row) {
    require_intact_run(database, row);
    if (row["case_text"].text() != case_text || row["digest"].text() != digest)
      database.fail_damaged("an index leads to the run of another case");
    const Value &failure = row["failure"], &threads = row["threads"];
    found = Record{.the_case = c,
                   .particles = row["particles"].integer(),
                   .steps = row["steps"].integer(),
                   .status = support::from_word<records::Status>(row["status"].text(), "status"),
                   .failure = failure.null() ? records::Failure::none
                                             : support::from_word<records::Failure>(failure.text(), "failure"),
                   .reason = row["reason"].text(),
                   .error = {},
                   .energy = {},
                   .balance = {},
                   .threads = threads.null() ? 1 : static_cast<int>(threads.integer())};
    for_numbers([&](const RunNumber& number) { number.set(*found) = row[number.name].real(); });
    found->particle_errors = particle_errors_of(row["particle_errors"]);
    found->cost.rounds = rounds_of(row);
  });
  return found;
}

fits::Rounds rounds_of(const Row& row) {
  fits::Rounds rounds;
  if (row["step_costs"].null()) return rounds;
  std::istringstream costs(row["step_costs"].text());
  for (double cost = 0; costs >> cost;) rounds.costs.push_back(cost);
  rounds.session = row["cost_session"].text();
  return rounds;
}

std::map<std::string, double> run_quantities(const Row& row) {
  std::map<std::string, double> quantities;
  const auto add = [&](const char* name) {
    if (const Value& value = row[name]; !value.null()) quantities[name] = value.real();
  };
  for_numbers([&](const RunNumber& number) { add(number.name); });
  add("particles");
  if (row["steps"].integer() > 0) add("steps");
  if (!row["cfl"].null()) add("dt");  // else another code chose it
  return quantities;
}

}  // namespace mpmvv::store
