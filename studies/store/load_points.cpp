#include "studies/store/load_points.hpp"

#include <cstdint>
#include <map>
#include <utility>

#include "studies/store/particle_errors.hpp"
#include "studies/store/run_rows.hpp"
#include "studies/store/seal.hpp"

namespace mpmvv::store {

namespace {

/// What the runs say of the points that they are, by the id of the run.
using Runs = std::map<std::int64_t, StoredPoint>;

Runs load_runs(const Database& database, const Value& series) {
  Runs runs;
  database.each("SELECT * FROM runs WHERE id IN (SELECT run FROM points WHERE series = ?)", {series},
                [&](const Row& row) {
                  require_intact_run(database, row);
                  StoredPoint& run = runs[row["id"].integer()];
                  run.point.y = run_quantities(row);
                  run.point.particle_errors = particle_errors_of(row["particle_errors"]);
                  run.point.rounds = rounds_of(row);
                  run.case_text = row["case_text"].text();
                });
  return runs;
}

/// Adds what the points have beyond their runs. `places` has the place of each among `points`, by its id.
void load_own_numbers(const Database& database, const Value& series, const std::map<std::int64_t, std::size_t>& places,
                      std::vector<StoredPoint>& points) {
  const auto each = [&](const std::string& columns, const std::string& order, const auto& add) {
    database.each("SELECT point, quantity, value FROM " + columns +
                      " WHERE point IN (SELECT id FROM points WHERE series = ?)" + order,
                  {series}, [&](const Row& row) {
                    add(points[places.at(row["point"].integer())].point, row["quantity"].text(), row["value"].real());
                  });
  };
  each("point_values", "", [](records::Point& p, const std::string& quantity, double value) {
    p.y[quantity] = value;
    // After a merge the run that is there may have been timed on another machine than the one that the study was made
    // of.
    if (quantity == "ns_per_particle_step") p.rounds = {};
  });
  each("point_replicates", " ORDER BY point, quantity, ordinal",
       [](records::Point& p, const std::string& quantity, double value) { p.replicates[quantity].push_back(value); });
}

}  // namespace

std::vector<StoredPoint> load_points(const Database& database, const Value& series) {
  const Runs runs = load_runs(database, series);
  std::vector<StoredPoint> points;
  std::map<std::int64_t, std::size_t> places;
  database.each("SELECT id, x, status, reason, run FROM points WHERE series = ? ORDER BY ordinal", {series},
                [&](const Row& row) {
                  places.emplace(row["id"].integer(), points.size());
                  StoredPoint& stored = points.emplace_back();
                  if (const Value& run = row["run"]; !run.null()) {
                    const auto found = runs.find(run.integer());
                    if (found == runs.end()) database.fail_damaged("a point's run is not there");
                    stored = found->second;
                  }
                  stored.point.x = row["x"].real();
                  stored.point.status = support::from_word<records::Status>(row["status"].text(), "status");
                  stored.point.reason = row["reason"].text();
                });
  load_own_numbers(database, series, places, points);
  return points;
}

}  // namespace mpmvv::store
