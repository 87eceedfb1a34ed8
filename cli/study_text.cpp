#include "cli/study_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "cli/console.hpp"
#include "cli/criteria_text.hpp"
#include "cli/error_tables.hpp"
#include "cli/numbers.hpp"
#include "cli/run_reasons.hpp"
#include "cli/table.hpp"
#include "reports/text.hpp"
#include "studies/claims/samples.hpp"

namespace mpmvv::cli {

using records::Series;
using Kind = Table::Kind;

namespace {

void print_orders(const records::StudyResult& study) {
  Table table({{"order of"},
               {"in"},
               {"over"},
               {"points", Kind::number},
               {"order", Kind::number},
               {"interval", Kind::number},
               {"asymptotic"}});
  for (const Series& series : study.series)
    for (const fits::ObservedOrder& order : series.orders)
      table.add({series.name, order.norm, reports::window_text(order.from, order.to),
                 claims::points_text(series, order), order_text(order.order), half_width_text(fits::half_width(order)),
                 fits::asymptotic_word(order)});
  table.print_apart();
}

/// Points that an order does not take, and why.
void print_left_out(const records::StudyResult& study) {
  for (const Series& series : study.series)
    for (const fits::ObservedOrder& order : series.orders)
      if (const std::string values = claims::left_out(series, order.norm); !values.empty())
        print_indented(fmt::format("left out of the order of '{}' in {}: {}", series.name, order.norm, values));
}

std::string replicates_text(const std::string& whose, const fits::ReplicateFit& fit) {
  if (fit.observations == 0)
    return fmt::format("replicates of {}: no interval from them, as one is missing or not above 0", whose);
  std::string text = fmt::format("replicates of {}: {} runs", whose, fit.observations);
  if (std::isnan(fit.half_width)) return text + ", too few for an interval";
  text += fmt::format(" that scatter by {:.2g} of the error, order ± {:.2f}", fit.scatter, fit.half_width);
  return std::isnan(fit.lack_of_fit) ? text : text + fmt::format(", lack of fit p = {:.2g}", fit.lack_of_fit);
}

/// Prints on what grounds fits say what they do: floors, replicates and remarks.
void print_fits(const Series& series) {
  for (const fits::ObservedOrder& order : series.orders) {
    const std::string whose = fmt::format("'{}' in {}", series.name, order.norm);
    if (order.floor)
      print_indented(fmt::format("floor of {}: {} ({})", whose,
                                 order.floor->accepted ? number_text(order.floor->floor) : "none",
                                 order.floor->reason));
    if (const auto& fit = order.replicates) print_indented(replicates_text(whose, *fit));
  }
  for (const fits::Extrapolation& e : series.extrapolations)
    if (!e.remark.empty()) print_indented(fmt::format("'{}' in {}: {}", series.name, e.norm, e.remark));
}

void print_extrapolations(const records::StudyResult& study) {
  Table table({{"extrapolated\nto " + claims::extrapolated_to(study.sweep)},
               {"of"},
               {"over"},
               {"model"},
               {"free\norder", Kind::number},
               {"limit", Kind::number},
               {reports::replace_all(claims::finest_level(study.sweep), " ", "\n"), Kind::number},
               {"95 %", Kind::number},
               {"GCI", Kind::number}});
  for (const Series& series : study.series)
    for (const fits::Extrapolation& e : series.extrapolations)
      table.add({series.name, e.norm, reports::window_text(e.from, e.to), e.model, order_text(e.order),
                 number_text(e.limit), number_text(e.finest), half_width_text(e.uncertainty),
                 number_text(e.convergence_index)});
  table.print_apart();
}

std::string remark_on(const fits::StabilityLimit& limit) {
  std::vector<std::string> remarks;
  if (!limit.found) remarks.push_back(text_without_limit(limit));
  if (limit.found && !limit.monotone) remarks.emplace_back("not monotone: a stable probe lies beyond an unstable one");
  if (const std::string few = too_few_steps(limit); !few.empty()) remarks.push_back(few + ": take a longer end_time");
  return fmt::format("{}", fmt::join(remarks, "; "));
}

void print_limits(const records::StudyResult& study) {
  Table table({{"limit of"},
               {"key"},
               {"stable", Kind::number},
               {"unstable", Kind::number},
               {"steps", Kind::number},
               {"growth\nseen", Kind::number},
               {"probes", Kind::number},
               {"", Kind::prose}});
  for (const Series& series : study.series)
    if (const auto& limit = series.limit) {
      const std::int64_t steps = steps_at_limit(*limit);
      table.add({series.name, limit->key, number_text(limit->stable), number_text(limit->unstable),
                 steps > 0 ? fmt::format("{}", steps) : "", reports::growth_text(steps),
                 fmt::format("{}", limit->probes.size()), remark_on(*limit)});
    }
  table.print_apart();
}

void print_values(const records::StudyResult& study) {
  Table table({{"value"}, {"is", Kind::number}, {"meaning", Kind::prose}});
  for (const records::Value& value : study.values) table.add({value.name, number_text(value.value), value.meaning});
  table.print_apart();
}

/// Prints each criterion under the id of its claim.
void print_criteria(const records::StudyResult& study, bool verbose) {
  std::vector<LabelledPart> parts;
  for (const records::ClaimPart& part : study.parts) parts.push_back({part.claim, part});
  if (parts.empty()) return;
  print("\n");
  print_criteria("claim", parts);
  if (verbose) print_grounds(parts);
  print_undecided(parts, verbose);
  if (!verbose) return;
  print_reasons(parts);
}

}  // namespace

void print_study(const records::StudyResult& study, bool verbose) {
  print("{}: {}\n", study.name, study.title);
  print_errors(study);
  print_run_reasons(study, verbose);
  print_orders(study);
  print_left_out(study);
  print_extrapolations(study);
  print_limits(study);
  print_values(study);
  print_criteria(study, verbose);
  if (verbose)
    for (const Series& series : study.series) print_fits(series);
  print("\n");
}

}  // namespace mpmvv::cli
