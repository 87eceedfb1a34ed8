#include <algorithm>
#include <cmath>

#include "studies/store/run_rows.hpp"
#include "studies/store/seal.hpp"
#include "studies/store/study_rows.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::store {

namespace {

/// The row that an item belongs to: its id, and the column that refers to it.
struct Parent {
  const char* column;
  std::int64_t id;
};

std::int64_t insert_item(Database& database, const char* table, Parent parent, std::size_t ordinal, Columns columns) {
  columns.insert(columns.end(), {{parent.column, parent.id}, {"ordinal", ordinal}});
  database.insert(table, columns);
  return database.last_row_id();
}

template <class Item, class ColumnsOf>
void insert_items(Database& database, const char* table, Parent parent, const std::vector<Item>& items,
                  ColumnsOf columns_of) {
  for (std::size_t k = 0; k < items.size(); ++k) insert_item(database, table, parent, k, columns_of(items[k]));
}

void insert_point(Database& database, std::int64_t series, std::size_t ordinal, const records::Point& point,
                  const std::string& case_text, const std::string& digest) {
  Value run;
  std::map<std::string, double> from_run;
  if (!case_text.empty()) {
    database.each("SELECT * FROM runs WHERE case_text = ? AND digest = ?", {case_text, digest}, [&](const Row& row) {
      run = row["id"];
      from_run = run_quantities(row);
    });
    if (run.null())
      throw support::UsageError(
          "a run of this study is not in the store, where `mpmvv db prune` may have removed it "
          "(run the study again): " +
          case_text);
  }
  const std::int64_t id =
      insert_item(database, "points", {"series", series}, ordinal,
                  {{"x", point.x}, {"status", to_string(point.status)}, {"reason", point.reason}, {"run", run}});
  for (const auto& [quantity, value] : point.y)
    if (const auto it = from_run.find(quantity); it == from_run.end() || it->second != value)
      database.insert("point_values", {{"point", id}, {"quantity", quantity}, {"value", value}});
  for (const auto& [quantity, values] : point.replicates)
    insert_items(database, "point_replicates", {"point", id}, values, [&quantity = quantity](double value) {
      return Columns{{"quantity", quantity}, {"value", value}};
    });
}

void insert_order(Database& database, std::int64_t series, std::size_t ordinal, const fits::ObservedOrder& order) {
  Columns columns{{"norm", order.norm},
                  {"window_from", order.from},
                  {"window_to", order.to},
                  {"points", order.points},
                  {"fitted_order", order.order},
                  {"half_width", order.half_width},
                  {"constant", order.constant},
                  {"r_squared", order.r_squared},
                  {"asymptotic", order.asymptotic},
                  {"asymptotic_from", order.asymptotic_from},
                  {"asymptotic_to", order.asymptotic_to}};
  if (order.floor)
    columns.insert(columns.end(), {{"floor_constant", order.floor->constant},
                                   {"floor_order", order.floor->order},
                                   {"floor_value", order.floor->floor},
                                   {"floor_residual", order.floor->residual},
                                   {"floor_accepted", order.floor->accepted},
                                   {"floor_reason", order.floor->reason}});
  if (order.replicates)
    columns.insert(columns.end(), {{"replicate_observations", order.replicates->observations},
                                   {"replicate_scatter", order.replicates->scatter},
                                   {"replicate_half_width", order.replicates->half_width},
                                   {"lack_of_fit", order.replicates->lack_of_fit}});
  const std::int64_t id = insert_item(database, "fits", {"series", series}, ordinal, columns);
  insert_items(database, "segments", {"fit", id}, order.segments, [](const fits::SegmentOrder& s) {
    return Columns{{"x_from", s.from}, {"x_to", s.to}, {"segment_order", s.order}};
  });
}

void insert_limit(Database& database, std::int64_t series, const fits::StabilityLimit& limit) {
  database.insert("limits", {{"series", series},
                             {"swept_key", limit.key},
                             {"stable", limit.stable},
                             {"unstable", limit.unstable},
                             {"monotone", limit.monotone},
                             {"found", limit.found}});
  insert_items(database, "probes", {"series", series}, limit.probes, [](const fits::Probe& p) {
    return Columns{{"value", p.value}, {"stable", p.stable}, {"reason", p.reason}, {"steps", p.steps}};
  });
}

void insert_series(Database& database, std::int64_t study, std::size_t ordinal, const records::Series& series,
                   const std::vector<std::string>& cases, const std::string& digest) {
  Columns columns{{"name", series.name}};
  if (series.code)
    columns.insert(columns.end(), {{"code", series.code->name},
                                   {"code_version", series.code->version},
                                   {"variant", series.code->variant},
                                   {"force_form", series.code->force_form}});
  const std::int64_t id = insert_item(database, "series", {"study", study}, ordinal, columns);
  for (std::size_t k = 0; k < series.points.size(); ++k)
    insert_point(database, id, k, series.points[k], k < cases.size() ? cases[k] : "", digest);
  for (std::size_t k = 0; k < series.orders.size(); ++k) insert_order(database, id, k, series.orders[k]);
  if (series.limit) insert_limit(database, id, *series.limit);
  insert_items(database, "extrapolations", {"series", id}, series.extrapolations, [](const fits::Extrapolation& e) {
    return Columns{{"norm", e.norm},
                   {"window_from", e.from},
                   {"window_to", e.to},
                   {"points", e.points},
                   {"model", e.model},
                   {"free_order", e.order},
                   {"limit_value", e.limit},
                   {"deviation", e.deviation},
                   {"finest", e.finest},
                   {"uncertainty", e.uncertainty},
                   {"convergence_index", e.convergence_index},
                   {"remark", e.remark}};
  });
}

void insert_figure(Database& database, std::int64_t study, std::size_t ordinal, const records::Figure& figure) {
  const std::int64_t id = insert_item(database, "figures", {"study", study}, ordinal,
                                      {{"name", figure.name},
                                       {"caption", figure.caption},
                                       {"xlabel", figure.xlabel},
                                       {"ylabel", figure.ylabel},
                                       {"log_x", figure.log_x},
                                       {"log_y", figure.log_y},
                                       {"quantity", figure.quantity},
                                       {"x_min", figure.x_min},
                                       {"x_max", figure.x_max},
                                       {"y_min", figure.y_min},
                                       {"y_max", figure.y_max},
                                       {"kind", to_string(figure.kind)}});
  insert_items(database, "figure_series", {"figure", id}, figure.series, [](const std::string& name) {
    return Columns{{"name", name}};
  });
  insert_items(database, "figure_marks", {"figure", id}, figure.marks, [](const std::string& name) {
    return Columns{{"name", name}};
  });
  insert_items(database, "figure_slopes", {"figure", id}, figure.slopes, [](double slope) {
    return Columns{{"slope", slope}};
  });
}

/// A claim that a study names and, where it is known, what it says.
Columns claim_columns(const std::string& id, const std::vector<records::ClaimText>& statements) {
  Columns columns{{"claim", id}};
  if (const auto text = std::ranges::find(statements, id, &records::ClaimText::id); text != statements.end())
    columns.insert(
        columns.end(),
        {{"statement", text->statement}, {"source", text->source}, {"place", text->where}, {"stated_in", text->study}});
  return columns;
}

void insert_part(Database& database, std::int64_t study, std::size_t ordinal, const records::ClaimPart& part) {
  insert_item(database, "claim_parts", {"study", study}, ordinal,
              {{"claim", part.claim},
               {"statement", part.statement},
               {"verdict", to_string(part.verdict)},
               {"evidence", part.evidence},
               {"reason", part.reason},
               {"measure", part.measure},
               {"at_least", part.at_least},
               {"at_most", part.at_most}});
  insert_items(database, "claim_found", {"study", study}, part.found, [ordinal](const records::Found& found) {
    const Value infinite = std::isinf(found.value) ? Value(found.value > 0 ? 1 : -1) : Value();
    return Columns{{"part", ordinal},      {"what", found.what},   {"value", found.value},  {"infinite", infinite},
                   {"lower", found.lower}, {"upper", found.upper}, {"remark", found.remark}};
  });
}

}  // namespace

void replace_study(Database& database, const StoredStudy& study) {
  database.change("DELETE FROM studies WHERE name = ? AND digest = ? AND (codes IS NULL OR codes = ?)",
                  {study.result.name, study.provenance.digest, study.codes});
  insert_study(database, study);
}

void insert_study(Database& database, const StoredStudy& study) {
  const records::StudyResult& s = study.result;
  const Provenance& p = study.provenance;
  database.insert("studies", {{"name", s.name},
                              {"digest", p.digest},
                              {"provenance", provenance_id(database, p)},
                              {"kept_at", p.time},
                              {"title", s.title},
                              {"kind", to_string(s.kind)},
                              {"sweep", s.sweep},
                              {"text", s.text},
                              {"codes", study.codes.empty() ? Value() : Value(study.codes)}});
  const std::int64_t id = database.last_row_id();
  const Parent parent{"study", id};
  insert_items(database, "study_claims", parent, s.claims,
               [&](const std::string& claim) { return claim_columns(claim, s.statements); });
  for (std::size_t k = 0; k < s.parts.size(); ++k) insert_part(database, id, k, s.parts[k]);
  insert_items(database, "check_values", parent, s.values, [](const mpmvv::records::Value& v) {
    const double value = std::isinf(v.value) ? std::copysign(for_infinity, v.value) : v.value;
    return Columns{{"name", v.name}, {"value", value}, {"meaning", v.meaning}};
  });
  const std::vector<std::string> no_runs;
  for (std::size_t k = 0; k < s.series.size(); ++k)
    insert_series(database, id, k, s.series[k], k < study.cases.size() ? study.cases[k] : no_runs, p.digest);
  for (std::size_t k = 0; k < s.figures.size(); ++k) insert_figure(database, id, k, s.figures[k]);
  seal(database, Sealed::study, id);
}

}  // namespace mpmvv::store
