#include "goldens/propose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "goldens/gate.hpp"
#include "goldens/judgement.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/observed_order.hpp"
#include "studies/fits/window.hpp"
#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"
#include "studies/support/printable.hpp"

namespace mpmvv::goldens {

using fits::half_width;
using fits::ObservedOrder;
using records::Point;
using records::Series;
using support::UsageError;

namespace {

constexpr double taken_for_round_off = 1e-9;  ///< check values below it get a bound and no band

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\u{:04X}", static_cast<int>(c));
    } else {
      out += c;
    }
  }
  return out + '"';
}

/// The file as it grows: tables for the reader of goldens, remarks for people.
class Draft {
 public:
  void refusal(const std::string& text) {
    refusals_.push_back(text);
    remark(text);
    line("");
  }
  void remark(const std::string& text) { text_ += "# " + support::printable(text) + '\n'; }
  void line(const std::string& text) { text_ += text + '\n'; }
  void table(const std::string& kind, const std::string& body) {
    line(fmt::format("[[{}]]\n{}\n", kind, body));
    ++tables_;
  }
  bool has_tables() const { return tables_ > 0; }

  /// "No limit of ... (and 2 more without a golden)"; empty where nothing was refused.
  std::string why_empty() const {
    if (refusals_.empty()) return "";
    const auto more = refusals_.size() - 1;
    return refusals_.front() + (more > 0 ? fmt::format(" (and {} more without a golden)", more) : "");
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::vector<std::string> refusals_;
  int tables_ = 0;
};

/// The stable point with the finest grid among the swept values of a window; nullptr when there is none.
const Point* finest_stable(const std::string& sweep, const Series& series, const std::string& norm,
                           const fits::Window& window = {-INFINITY, INFINITY}) {
  const Point* finest = nullptr;
  for (const Point& point : series.points) {
    const auto error = point.y.find(norm);
    if (!window.holds(point.x) || point.status != records::Status::ok || error == point.y.end()) continue;
    if (!(error->second > 0 && error->second <= largest_number)) continue;
    if (!finest || claims::is_finer(point.x, finest->x, sweep)) finest = &point;
  }
  return finest;
}

/// Why no golden may state this norm at this swept value; empty where one may.
std::string no_golden_at(const std::string& norm, double x) {
  const std::vector<std::string> known = golden_norms();
  if (std::ranges::find(known, norm) == known.end()) return "goldens know no such norm";
  return x > 0 ? "" : fmt::format("goldens know no level at {:g}, only above 0", x);
}

/// Why a golden of this order could not be read or pass; empty where it could.
std::string no_golden(const Series& series, const ObservedOrder& fit) {
  if (const std::string why = no_golden_at(fit.norm, fit.from); !why.empty()) return why;
  if (fit.points < 3) return fmt::format("{} usable points, at least 3 are needed", fit.points);
  if (!std::isfinite(fit.order)) return "none could be fitted";
  if (half_width(fit) > widest_interval) return fmt::format("known to ± {:.2f} only", half_width(fit));
  if (fit.norm != "y")
    for (const double end : {fit.from, fit.to})
      if (!find_point(series, end)) return fmt::format("no level at {}", end);
  return "";
}

void propose_order(Draft& draft, const std::string& sweep, const Series& series, const ObservedOrder& fit) {
  if (const std::string why = no_golden(series, fit); !why.empty()) {
    draft.refusal(fmt::format("No order of {} in {} over [{:g}, {:g}]: {}.", quoted(series.name), fit.norm, fit.from,
                              fit.to, why));
    return;
  }
  const double width = half_width(fit);
  const std::string interval = width > 0 ? fmt::format(" ± {:.3f}", width) : "";
  draft.remark(fmt::format("Measured {:.4f}{} over [{:g}, {:g}], {} points, {}.", fit.order, interval, fit.from, fit.to,
                           fit.points, fit.asymptotic ? "asymptotic" : "not asymptotic"));
  const double expected = std::round(fit.order * 1000) / 1000;
  const Point* finest = finest_stable(sweep, series, fit.norm, {fit.from, fit.to});
  const std::string level = finest ? fmt::format("\nfinest = [{}, {:.4g}]", finest->x, finest->y.at(fit.norm)) : "";
  const std::string asymptotic = fit.asymptotic ? "\nasymptotic = true" : "";
  const bool is_wide = interval_margin * width > 2 * order_band;
  const std::string wide = is_wide ? fmt::format("\ninterval = {:.2f}", width) : "";
  draft.table(
      "order",
      fmt::format("series = {}\nnorm = \"{}\"\nwindow = [{}, {}]\npoints = {}\nexpected = {:.3f}\nlower = {:.3f}\n"
                  "upper = {:.3f}{}{}{}",
                  quoted(series.name), fit.norm, fit.from, fit.to, fit.points, expected, expected - order_band,
                  expected + order_band, level, asymptotic, wide));
}

/// Whether an order over a window that ends at this level has a golden: the order then fails where this error grows.
bool guards_order(const std::string& sweep, const Series& series, const std::string& norm, const Point& level) {
  return std::ranges::any_of(series.orders, [&](const ObservedOrder& fit) {
    return fit.norm == norm && no_golden(series, fit).empty() &&
           finest_stable(sweep, series, norm, {fit.from, fit.to}) == &level;
  });
}

void propose_error(Draft& draft, const std::string& sweep, const Series& series, const std::string& norm) {
  const Point* point = finest_stable(sweep, series, norm);
  const std::string why = point ? no_golden_at(norm, point->x) : "no stable point with an error above 0";
  if (!why.empty()) {
    draft.refusal(fmt::format("No error of {} in {}: {}.", quoted(series.name), norm, why));
    return;
  }
  const bool is_finest = std::ranges::none_of(series.points, [&](const Point& other) {
    return other.status == records::Status::ok && claims::is_finer(other.x, point->x, sweep);
  });
  draft.remark(fmt::format("The finest stable level in {}{}.", sweep,
                           is_finest ? "" : " with an error above 0, which finer ones lack"));
  if (guards_order(sweep, series, norm, *point))
    draft.remark("An order above fails where this error grows; this golden fails where it falls, too.");
  draft.table("error", fmt::format("series = {}\nnorm = \"{}\"\nat = {}\nexpected = {:.4g}\nband = {}",
                                   quoted(series.name), norm, point->x, point->y.at(norm), error_band));
}

void propose_limit(Draft& draft, const Series& series, const fits::StabilityLimit& limit) {
  if (!limit.found) {
    draft.refusal(fmt::format("No limit of {} in {}: {}.", quoted(series.name), limit.key, text_without_limit(limit)));
    return;
  }
  const double half_bracket = std::abs(limit.unstable - limit.stable) / 2 / limit.value();
  // Twice the half bracket, rounded up to a per cent: other replicates or probes may lie as far out on either side.
  const double wide_band = std::ceil(200 * half_bracket) / 100;
  if (wide_band >= 1) {
    draft.refusal(fmt::format("No limit of {} in {}: it lies between {:.4g} and {:.4g}, too far apart.",
                              quoted(series.name), limit.key, limit.stable, limit.unstable));
    return;
  }
  draft.remark(fmt::format("Stable at {} = {:.6g}, unstable at {:.6g}{}.", limit.key, limit.stable, limit.unstable,
                           limit.monotone ? "" : "; not monotone"));
  std::string golden = fmt::format("series = {}\nexpected = {:.4g}\n", quoted(series.name), limit.value());
  if (half_bracket > limit_band / 2)
    golden += fmt::format("band = {:.2g}\nwhy = \"it lies between {:.4g} and {:.4g}; the band is twice that\"",
                          wide_band, limit.stable, limit.unstable);
  else
    golden += fmt::format("band = {}", limit_band);
  draft.table("limit", golden);
}

/// A power of ten, at least one decade away from a number that is nearly zero.
double round_off_bound(double size) {
  return size == 0 ? 1e-15 : std::pow(10, std::ceil(std::log10(size)) + 1);
}

void propose_value(Draft& draft, const records::Value& value) {
  const double size = std::abs(value.value);
  if (!(size <= largest_number)) {
    draft.refusal(fmt::format("No value {}: {}.", quoted(value.name),
                              std::isnan(size) ? "it was not measured" : "it is no number of use"));
    return;
  }
  draft.remark(fmt::format("Measured {:.6g}: {}", value.value, value.meaning));
  if (size >= taken_for_round_off) {
    draft.table("value",
                fmt::format("name = {}\nexpected = {:.4g}\nband = {}", quoted(value.name), value.value, error_band));
  } else if (value.value >= 0) {
    draft.table("value", fmt::format("name = {}\nat_most = {:g}", quoted(value.name), round_off_bound(size)));
  } else {
    draft.table("value", fmt::format("name = {}\nat_least = {:g}", quoted(value.name), -round_off_bound(size)));
  }
}

/// The errors that figures draw of a series.
std::set<std::string> drawn_norms(const records::StudyResult& study, const Series& series) {
  std::set<std::string> norms;
  for (const records::Figure& figure : study.figures) {
    const auto has_it = [&](const Point& point) { return point.y.contains(figure.quantity); };
    const bool draws_series =
        figure.series.empty() || std::ranges::find(figure.series, series.name) != figure.series.end();
    if (figure.kind == records::Figure::Kind::curves && draws_series && std::ranges::any_of(series.points, has_it))
      norms.insert(figure.quantity);
  }
  return norms;
}

/// Proposes the series' orders, the finest errors beside them, and its limit; where a study of runs asks for none of
/// these, the finest errors that its figures draw.
void propose_series(Draft& draft, const records::StudyResult& study, const Series& series) {
  std::set<std::string> norms;
  for (const ObservedOrder& fit : series.orders) {
    propose_order(draft, study.sweep, series, fit);
    norms.insert(fit.norm);
  }
  if (study.kind != records::StudyKind::check && series.orders.empty() && !series.limit)
    norms = drawn_norms(study, series);
  for (const std::string& norm : norms) propose_error(draft, study.sweep, series, norm);
  if (series.limit) propose_limit(draft, series, *series.limit);
}

/// Says why a planted mistake has no golden: whether it is worse or better than before says nothing of the code.
void refuse_planted(Draft& draft, const Series& series) {
  const std::string form = series.code ? fmt::format(", force_form = {}", quoted(series.code->force_form)) : "";
  draft.refusal(
      fmt::format("No golden of {}: a planted mistake{}, which is a criterion's matter.", quoted(series.name), form));
}

/// The other codes that ran series of the study, with their versions.
std::set<std::pair<std::string, std::string>> codes_of(const records::StudyResult& study) {
  std::set<std::pair<std::string, std::string>> codes;
  for (const Series& series : study.series)
    if (series.code) codes.emplace(series.code->name, series.code->version);
  return codes;
}

void refuse_worse(const records::StudyResult& study, std::vector<Golden> standing) {
  std::erase_if(standing, [&](const Golden& golden) { return golden.study != study.name; });
  if (standing.empty()) return;
  for (const GateResult& result : run_gate(standing, {study}).results)
    if (result.verdict == Verdict::fail && !result.better)
      throw UsageError(
          fmt::format("{} of study '{}' is worse than its golden in {}: expected {}{} (mend it, or delete that golden "
                      "with the reason in the commit)",
                      result.name, study.name, result.where, result.expected, measured_text(result)));
}

}  // namespace

void require_committed(const records::StudyResult& study, const store::Provenance& provenance) {
  if (provenance.dirty)
    throw UsageError(
        fmt::format("the results of study '{}' come from a dirty tree at commit {} (commit, build and run "
                    "the study again)",
                    study.name, provenance.commit));
}

std::string propose_goldens(const records::StudyResult& study, const store::Provenance& provenance,
                            const std::vector<Golden>& standing, const std::set<std::string>& planted) {
  if (const std::string trial = store::trial_of(study.text); !trial.empty())
    throw UsageError(fmt::format("the results of study '{}' were made with --set: {} (run the study as it stands)",
                                 study.name, trial));
  refuse_worse(study, standing);
  Draft draft;
  draft.remark(fmt::format("Proposed from commit {}{}, digest {}, {}.", provenance.commit,
                           provenance.dirty ? " with changes that are not committed" : "", provenance.digest,
                           provenance.time));
  for (const auto& [name, version] : codes_of(study)) draft.remark(fmt::format("Of {} {}.", name, version));
  draft.remark("To review: hold each number against its claim, delete what proves nothing, give a wider band its why,");
  draft.remark("then add reviewed = \"DATE: who and on what grounds\".");
  draft.line(fmt::format("study = {}\n", quoted(study.name)));
  for (const Series& series : study.series)
    planted.contains(series.name) ? refuse_planted(draft, series) : propose_series(draft, study, series);
  for (const records::Value& value : study.values) propose_value(draft, value);
  if (draft.has_tables()) return draft.text();
  const std::string why = draft.why_empty();
  throw UsageError(fmt::format("nothing to propose for study '{}'{}", study.name,
                               why.empty() ? " (a [[fit]], a [limit], a check, or a [[figure]] of kind curves of an "
                                             "error that some run has)"
                                           : ": " + why));
}

}  // namespace mpmvv::goldens
