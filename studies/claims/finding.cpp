#include "studies/claims/finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "studies/claims/claim.hpp"
#include "studies/claims/samples.hpp"

namespace mpmvv::claims {

using records::Series;
using records::StudyResult;

namespace {

/// Whether a quantity is an error. The `y` of a check's curves counts as one.
bool is_error(const std::string& quantity) {
  const auto has_its_name = [&](const records::RunNumber& number) { return quantity == number.name; };
  return std::ranges::none_of(records::run_by_products(), has_its_name) && quantity != "particles" &&
         quantity != "steps" && quantity != "dt";
}

/// The quantities that the study fits for a series, and the errors that its figures draw.
std::set<std::string> fitted_or_drawn(const StudyResult& study, const Series& series) {
  std::set<std::string> quantities;
  for (const fits::ObservedOrder& order : series.orders) quantities.insert(order.norm);
  for (const records::Figure& figure : study.figures)
    if (figure.kind != records::Figure::Kind::particles && is_error(figure.quantity))
      quantities.insert(figure.quantity);
  return quantities;
}

/// The sound points of a quantity, in increasing x.
std::vector<Finding::Level> levels_of(const Series& series, const std::string& quantity) {
  std::vector<Finding::Level> levels;
  for (const records::Point& point : series.points)
    if (const auto y = point.y.find(quantity);
        point.status == records::Status::ok && y != point.y.end() && !std::isnan(y->second))
      levels.push_back({point.x, y->second});
  std::ranges::stable_sort(levels, {}, &Finding::Level::x);
  return levels;
}

const Finding::Level& finest(const StudyResult& study, const std::vector<Finding::Level>& levels) {
  return is_finer(levels.back().x, levels.front().x, study.sweep) ? levels.back() : levels.front();
}

Finding with_word_if_not_measured(Finding finding) {
  if (std::isnan(finding.number)) finding.word = "not measured";
  return finding;
}

Finding order_finding(const StudyResult& study, const Series& series, const fits::ObservedOrder& order) {
  return with_word_if_not_measured(
      {.study = study.name,
       .kind = Finding::Kind::order,
       .name = fmt::format("order of '{}' in {} over [{:g}, {:g}]", series.name, order.norm, order.from, order.to),
       .number = order.order,
       .better = 1,
       .series = series.name,
       .window = {order.from, order.to}});
}

/// A check's curve is no sequence of refinements: it has no finest level.
void add_errors(std::vector<Finding>& findings, const StudyResult& study, const Series& series) {
  for (const std::string& quantity : fitted_or_drawn(study, series)) {
    const auto levels = levels_of(series, quantity);
    if (levels.empty()) continue;
    if (study.kind == records::StudyKind::check) {
      findings.push_back({.study = study.name,
                          .kind = Finding::Kind::error,
                          .name = fmt::format("curve '{}' of {}", series.name, quantity),
                          .word = "curve",
                          .levels = levels,
                          .quantity = quantity});
      continue;
    }
    const auto [x, y] = finest(study, levels);
    findings.push_back({.study = study.name,
                        .kind = Finding::Kind::error,
                        .name = fmt::format("error of '{}' in {}", series.name, quantity),
                        .number = y,
                        .better = -1,
                        .levels = levels,
                        .at = x,
                        .quantity = quantity,
                        .series = series.name});
  }
}

/// 1 where all values tried are stable, so that the limit lies beyond them; -1 where none is; else 0.
int side_of_all_tried(const fits::StabilityLimit& limit) {
  const int any_stable = std::ranges::any_of(limit.probes, &fits::Probe::stable);
  const int any_unstable = !std::ranges::all_of(limit.probes, &fits::Probe::stable);
  return any_stable - any_unstable;
}

Finding limit_finding(const StudyResult& study, const Series& series, const fits::StabilityLimit& limit) {
  Finding finding{.study = study.name,
                  .kind = Finding::Kind::limit,
                  .name = fmt::format("{} limit of '{}'", limit.key, series.name),
                  .better = limit.stable < limit.unstable ? 1 : -1,
                  .quantity = limit.key};
  if (limit.found)
    finding.number = limit.value(), finding.monotone = limit.monotone;
  else
    finding.word = text_without_limit(limit), finding.side = side_of_all_tried(limit);
  return finding;
}

/// An extrapolated value as a finding. Its uncertainty is that of the finest grid's value, as the procedure gives it.
Finding extrapolated_finding(const StudyResult& study, const Series& series, const fits::Extrapolation& e) {
  return with_word_if_not_measured(
      {.study = study.name,
       .kind = Finding::Kind::value,
       .name = fmt::format("extrapolated {} of '{}' over [{:g}, {:g}]", e.norm, series.name, e.from, e.to),
       .number = e.limit,
       .uncertainty = e.uncertainty,
       .quantity = e.norm});
}

void add_statuses(std::vector<Finding>& findings, const StudyResult& study, const Series& series) {
  for (const records::Point& point : series.points)
    findings.push_back({.study = study.name,
                        .kind = Finding::Kind::status,
                        .name = fmt::format("status of '{}' at {:g}", series.name, point.x),
                        .word = to_string(point.status),
                        .at = point.x,
                        .series = series.name});
}

void add_criteria(std::vector<Finding>& findings, const StudyResult& study) {
  for (const records::ClaimPart& part : study.parts)
    if (part.verdict != records::PartVerdict::shown)
      findings.push_back({.study = study.name,
                          .kind = Finding::Kind::verdict,
                          .name = fmt::format("criterion of {}: {}", part.claim, part.statement),
                          .word = to_string(part.verdict)});
}

void add_cost(std::vector<Finding>& findings, const StudyResult& study, const Series& series) {
  if (levels_of(series, "step_seconds").empty()) return;
  const auto levels = levels_of(series, "ns_per_particle_step");
  if (levels.empty()) return;
  findings.push_back({.study = study.name,
                      .kind = Finding::Kind::cost,
                      .name = fmt::format("ns per particle and step of '{}'", series.name),
                      .number = finest(study, levels).y,
                      .better = -1});
}

}  // namespace

std::string text(const Finding& finding) {
  if (!finding.word.empty()) return finding.word;
  const std::string number = fmt::format("{:.6g}", finding.number);
  if (!std::isnan(finding.uncertainty))
    return fmt::format("{} (the finest value's ± {:.2g})", number, finding.uncertainty);
  if (!finding.monotone) return number + ", not monotone";
  return std::isnan(finding.at) ? number : fmt::format("{} at {:g}", number, finding.at);
}

std::vector<Finding> findings_of(const StudyResult& study) {
  std::vector<Finding> findings;
  for (const Series& series : study.series) {
    for (const fits::ObservedOrder& order : series.orders) findings.push_back(order_finding(study, series, order));
    add_errors(findings, study, series);
    for (const fits::Extrapolation& e : series.extrapolations)
      findings.push_back(extrapolated_finding(study, series, e));
    if (series.limit) findings.push_back(limit_finding(study, series, *series.limit));
    if (study.kind != records::StudyKind::check) add_statuses(findings, study, series);
    add_cost(findings, study, series);
  }
  for (const records::Value& value : study.values)
    findings.push_back(with_word_if_not_measured({.study = study.name,
                                                  .kind = Finding::Kind::value,
                                                  .name = fmt::format("value '{}'", value.name),
                                                  .number = value.value}));
  return findings;
}

std::vector<Finding> findings_of(const std::vector<StudyResult>& studies) {
  std::vector<Finding> findings;
  for (const StudyResult& study : studies) {
    std::ranges::move(findings_of(study), std::back_inserter(findings));
    add_criteria(findings, study);
  }
  for (const Claim& claim : judge_claims(studies))
    if (!claim.studies.empty())
      findings.push_back({.kind = Finding::Kind::verdict,
                          .name = "claim " + claim.id,
                          .word = to_string(claim.verdict),
                          .judges = claim.studies});
  return findings;
}

}  // namespace mpmvv::claims
