#include "cli/gate_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>

#include "cli/console.hpp"
#include "cli/lines.hpp"
#include "cli/numbers.hpp"
#include "cli/table.hpp"

namespace mpmvv::cli {

using goldens::GateResult;
using goldens::Verdict;

namespace {

/// The golden, and what was found. What a run says that is not ok stands at the first golden of the study that it
/// fails; `said` has what the study's runs have said so far.
std::string description(const GateResult& r, std::set<std::string>& said) {
  std::string text = fmt::format("{}: expected {}{}", r.name, r.expected, measured_text(r));
  if (r.reason.empty()) return text;
  std::string reason = r.reason;
  if (!r.cause.empty() && !said.insert(r.cause).second)
    reason.replace(reason.size() - r.cause.size(), r.cause.size(), "as above");
  return fmt::format("{} ({})", text, reason);
}

/// Prints one line on the studies of which the store has nothing. It names them where they are few, and says how to
/// judge the others alone.
void print_absent(const goldens::GateReport& report) {
  constexpr std::size_t few = 6;
  std::map<std::string, int> goldens;
  std::size_t all = 0;
  for (const GateResult& r : report.results)
    if (r.is_absent) ++goldens[r.study], ++all;
  if (goldens.empty()) return;
  std::vector<std::string> names;
  for (const auto& [study, count] : goldens) names.push_back(fmt::format("{} ({})", study, count));
  const bool named = goldens.size() <= few;
  std::vector<std::string> hints;
  if (!named) hints.emplace_back("--verbose names them");
  if (all < report.results.size()) hints.emplace_back("--only STUDY judges one");
  print_indented(fmt::format("nothing in the store for {} of {}{}{}", count_text(all, "golden"),
                             count_text(goldens.size(), "study", "studies"),
                             named ? fmt::format(": {}", fmt::join(names, ", ")) : "",
                             hints.empty() ? "" : fmt::format(" ({})", fmt::join(hints, ", "))),
                 0);
}

/// "judged: my-code 1.0 in orders, of 2026-01-01T00:00:00Z"; with the digest where the version does not tell the
/// program from others.
void print_judged(const GatedCodes& codes) {
  for (const auto& [ran, shares_version] : codes.judged)
    print("judged: {} {} in {}, of {}\n", ran.code.name,
          shares_version ? store::label({ran.code.digest, {ran.code.version}, ""}) : ran.code.version, ran.study,
          ran.kept_at);
  if (!codes.without_golden.empty())
    print_indented(fmt::format("no goldens of: {}", fmt::join(codes.without_golden, ", ")), 0);
}

}  // namespace

void print_gate(const goldens::GateReport& report, const GatedCodes& codes, bool verbose) {
  Table table({{"verdict", Table::Kind::verdict}, {"study"}, {"golden", Table::Kind::prose}}, 0);
  std::map<std::string, std::set<std::string>> said;  // by study
  for (const Verdict verdict : {Verdict::fail, Verdict::inconclusive, Verdict::pass})
    for (const GateResult& r : report.results) {
      const bool is_news = verdict != Verdict::pass && !r.is_absent;
      if (r.verdict == verdict && (is_news || verbose))
        table.add({to_string(verdict), r.study, description(r, said[r.study])});
    }
  table.print();
  if (!verbose) print_absent(report);
  print_judged(codes);
  print("gate: {} pass, {} fail, {} inconclusive\n", report.count(Verdict::pass), report.count(Verdict::fail),
        report.count(Verdict::inconclusive));
}

}  // namespace mpmvv::cli
