#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "studies/store/load_points.hpp"
#include "studies/store/run_rows.hpp"
#include "studies/store/seal.hpp"
#include "studies/store/study_rows.hpp"
#include "studies/store/trial.hpp"

namespace mpmvv::store {

namespace {

/// Reads the rows of a table that refer to one parent row, in their order, and makes an item of each.
template <class Make>
auto load_items(const Database& database, const char* table, const char* parent, const Value& id, Make make) {
  std::vector<decltype(make(std::declval<const Row&>()))> items;
  database.each(fmt::format("SELECT * FROM {} WHERE {} = ? ORDER BY ordinal", table, parent), {id},
                [&](const Row& row) { items.push_back(make(row)); });
  return items;
}

fits::ObservedOrder load_order(const Database& database, const Row& row) {
  fits::ObservedOrder order{.norm = row["norm"].text(),
                            .from = row["window_from"].real(),
                            .to = row["window_to"].real(),
                            .points = static_cast<int>(row["points"].integer()),
                            .order = row["fitted_order"].real(),
                            .half_width = row["half_width"].real(),
                            .constant = row["constant"].real(),
                            .r_squared = row["r_squared"].real(),
                            .asymptotic = row["asymptotic"].flag(),
                            .asymptotic_from = row["asymptotic_from"].real(),
                            .asymptotic_to = row["asymptotic_to"].real(),
                            .segments = load_items(database, "segments", "fit", row["id"],
                                                   [](const Row& s) {
                                                     return fits::SegmentOrder{.from = s["x_from"].real(),
                                                                               .to = s["x_to"].real(),
                                                                               .order = s["segment_order"].real()};
                                                   }),
                            .floor = std::nullopt};
  if (!row["floor_accepted"].null())
    order.floor = fits::FloorFit{.constant = row["floor_constant"].real(),
                                 .order = row["floor_order"].real(),
                                 .floor = row["floor_value"].real(),
                                 .residual = row["floor_residual"].real(),
                                 .accepted = row["floor_accepted"].flag(),
                                 .reason = row["floor_reason"].text()};
  if (!row["replicate_observations"].null())
    order.replicates = fits::ReplicateFit{.observations = static_cast<int>(row["replicate_observations"].integer()),
                                          .scatter = row["replicate_scatter"].real(),
                                          .half_width = row["replicate_half_width"].real(),
                                          .lack_of_fit = row["lack_of_fit"].real()};
  return order;
}

fits::StabilityLimit load_limit(const Database& database, const Row& row) {
  return {.key = row["swept_key"].text(),
          .stable = row["stable"].real(),
          .unstable = row["unstable"].real(),
          .monotone = row["monotone"].flag(),
          .found = row["found"].flag(),
          .probes = load_items(database, "probes", "series", row["series"], [](const Row& p) {
            return fits::Probe{.value = p["value"].real(),
                               .stable = p["stable"].flag(),
                               .reason = p["reason"].text(),
                               .steps = p["steps"].null() ? 0 : p["steps"].integer()};
          })};
}

fits::Extrapolation load_extrapolation(const Row& row) {
  return {.norm = row["norm"].text(),
          .from = row["window_from"].real(),
          .to = row["window_to"].real(),
          .points = static_cast<int>(row["points"].integer()),
          .model = row["model"].text(),
          .order = row["free_order"].real(),
          .limit = row["limit_value"].real(),
          .deviation = row["deviation"].real(),
          .finest = row["finest"].real(),
          .uncertainty = row["uncertainty"].real(),
          .convergence_index = row["convergence_index"].real(),
          .remark = row["remark"].text()};
}

/// A series and the texts of its cases.
std::pair<records::Series, std::vector<std::string>> load_series(const Database& database, const Row& row) {
  records::Series series{.name = row["name"].text(), .points = {}, .orders = {}, .limit = std::nullopt};
  std::vector<std::string> cases;
  const Value& id = row["id"];
  for (StoredPoint& stored : load_points(database, id)) {
    series.points.push_back(std::move(stored.point));
    cases.push_back(std::move(stored.case_text));
  }
  series.orders = load_items(database, "fits", "series", id, [&](const Row& r) { return load_order(database, r); });
  database.each("SELECT * FROM limits WHERE series = ?", {id},
                [&](const Row& r) { series.limit = load_limit(database, r); });
  series.code = other_code(row);
  series.extrapolations = load_items(database, "extrapolations", "series", id, load_extrapolation);
  return {series, cases};
}

records::Figure load_figure(const Database& database, const Row& row) {
  return {
      .name = row["name"].text(),
      .caption = row["caption"].text(),
      .xlabel = row["xlabel"].text(),
      .ylabel = row["ylabel"].text(),
      .log_x = row["log_x"].flag(),
      .log_y = row["log_y"].flag(),
      .quantity = row["quantity"].text(),
      .series =
          load_items(database, "figure_series", "figure", row["id"], [](const Row& s) { return s["name"].text(); }),
      .marks = load_items(database, "figure_marks", "figure", row["id"], [](const Row& s) { return s["name"].text(); }),
      .slopes =
          load_items(database, "figure_slopes", "figure", row["id"], [](const Row& s) { return s["slope"].real(); }),
      .x_min = row["x_min"].optional_real(),
      .x_max = row["x_max"].optional_real(),
      .y_min = row["y_min"].optional_real(),
      .y_max = row["y_max"].optional_real(),
      .kind = support::from_word<records::Figure::Kind>(row["kind"].text(), "figure kind")};
}

records::Value load_value(const Row& row) {
  const double kept = row["value"].real();
  const double value =
      std::abs(kept) == for_infinity ? std::copysign(std::numeric_limits<double>::infinity(), kept) : kept;
  return {.name = row["name"].text(), .value = value, .meaning = row["meaning"].text()};
}

records::Found load_found(const Row& row) {
  constexpr double without_end = std::numeric_limits<double>::infinity();
  const Value& infinite = row["infinite"];
  records::Found found{
      .what = row["what"].text(),
      .value = infinite.null() ? row["value"].real() : static_cast<double>(infinite.integer()) * without_end};
  if (row["remark"].null()) return found;
  found.remark = row["remark"].text();
  if (!std::isfinite(found.value)) return found;
  found.lower = row["lower"].optional_real().value_or(-without_end);
  found.upper = row["upper"].optional_real().value_or(without_end);
  return found;
}

records::ClaimPart load_part(const Database& database, const Row& row) {
  records::ClaimPart part{
      .claim = row["claim"].text(),
      .statement = row["statement"].text(),
      .verdict = support::from_word<records::PartVerdict>(row["verdict"].text(), "verdict of a claim's part"),
      .evidence = row["evidence"].text(),
      .reason = row["reason"].text(),
      .measure = row["measure"].null() ? "" : row["measure"].text(),
      .at_least = row["at_least"].optional_real(),
      .at_most = row["at_most"].optional_real()};
  database.each("SELECT * FROM claim_found WHERE study = ? AND part = ? ORDER BY ordinal",
                {row["study"], row["ordinal"]}, [&](const Row& found) { part.found.push_back(load_found(found)); });
  return part;
}

/// Loads the ids of a study's claims, and the texts of those whose text was kept.
void load_claims(const Database& database, const Value& study, records::StudyResult& result) {
  database.each("SELECT * FROM study_claims WHERE study = ? ORDER BY ordinal", {study}, [&](const Row& row) {
    result.claims.push_back(row["claim"].text());
    if (row["statement"].null()) return;
    result.statements.push_back({.id = row["claim"].text(),
                                 .statement = row["statement"].text(),
                                 .source = row["source"].text(),
                                 .where = row["place"].text(),
                                 .study = row["stated_in"].text()});
  });
}

StoredStudy load_study(const Database& database, const Row& row) {
  const Value& id = row["study"];
  require_intact(database, Sealed::study, id);
  StoredStudy study{.result = {.name = row["name"].text(),
                               .title = row["title"].text(),
                               .kind = support::from_word<records::StudyKind>(row["kind"].text(), "kind of a study"),
                               .sweep = row["sweep"].text(),
                               .text = row["text"].text(),
                               .claims = {},
                               .series = {},
                               .values = load_items(database, "check_values", "study", id, load_value),
                               .figures = load_items(database, "figures", "study", id,
                                                     [&](const Row& r) { return load_figure(database, r); }),
                               .parts = load_items(database, "claim_parts", "study", id,
                                                   [&](const Row& r) { return load_part(database, r); })},
                    .cases = {},
                    .codes = row["codes"].null() ? "" : row["codes"].text(),
                    .provenance = read_provenance(row)};
  load_claims(database, id, study.result);
  database.each("SELECT * FROM series WHERE study = ? ORDER BY ordinal", {id}, [&](const Row& series_row) {
    auto [series, cases] = load_series(database, series_row);
    study.result.series.push_back(std::move(series));
    study.cases.push_back(std::move(cases));
  });
  return study;
}

/// Studies that fulfil a condition on ?1, by name and, of one name, by time.
std::vector<StoredStudy> load_where(const Database& database, const std::string& condition, const Value& value) {
  std::vector<StoredStudy> studies;
  database.each(
      fmt::format("SELECT studies.id AS study, studies.*, provenance.* FROM studies NOT INDEXED JOIN provenance ON "
                  "provenance.id = studies.provenance WHERE {} ORDER BY name, kept_at, studies.id",
                  condition),
      {value}, [&](const Row& row) { studies.push_back(load_study(database, row)); });
  return studies;
}

}  // namespace

std::optional<records::OtherCode> other_code(const Row& series) {
  if (series["code"].null()) return std::nullopt;
  return records::OtherCode{.name = series["code"].text(),
                            .version = series["code_version"].text(),
                            .variant = series["variant"].text(),
                            .force_form = series["force_form"].text(),
                            .digest = {}};
}

std::vector<StoredStudy> load_studies(const Database& database, const std::string& digest) {
  // Where damage has changed a study's digest, the digest of its provenance still finds the study, and its seal then
  // complains. No index is used (load_where), as an index might be what is damaged.
  return load_where(database, fmt::format("(studies.digest = ?1 OR provenance.digest = ?1) AND {}", is_newest), digest);
}

std::vector<StoredStudy> load_studies_of_code(const Database& database, const std::string& line) {
  auto all = load_where(database, "instr(char(10) || codes, char(10) || ?1 || char(10))", line);
  std::erase_if(all, [](const StoredStudy& study) { return !trial_of(study.result.text).empty(); });
  std::map<std::string, StoredStudy> newest;
  for (StoredStudy& study : all) newest[study.result.name] = std::move(study);
  std::vector<StoredStudy> studies;
  for (auto& [name, study] : newest) studies.push_back(std::move(study));
  return studies;
}

void copy_studies(const Database& from, Database& to) {
  using Key = std::array<std::string, 3>;
  std::map<Key, std::string> kept_at;
  to.each("SELECT name, digest, coalesce(codes, '') AS codes, kept_at FROM studies", {}, [&](const Row& row) {
    kept_at[{row["name"].text(), row["digest"].text(), row["codes"].text()}] = row["kept_at"].text();
  });
  from.each("SELECT id FROM studies ORDER BY id", {}, [&](const Row& row) {
    for (const StoredStudy& study : load_where(from, "studies.id = ?1", row["id"])) {
      const std::string &name = study.result.name, &digest = study.provenance.digest;
      const auto known = kept_at.find({name, digest, study.codes});
      if (known != kept_at.end() && known->second >= study.provenance.time) continue;
      to.change("DELETE FROM studies WHERE name = ? AND digest = ? AND coalesce(codes, '') = ?",
                {name, digest, study.codes});
      insert_study(to, study);
    }
  });
}

}  // namespace mpmvv::store
