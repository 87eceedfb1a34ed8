#include "cli/criteria_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "cli/console.hpp"
#include "cli/lines.hpp"
#include "cli/numbers.hpp"
#include "cli/table.hpp"
#include "reports/criteria.hpp"
#include "studies/claims/found_text.hpp"

namespace mpmvv::cli {

using records::ClaimPart;
using records::Found;
using Kind = Table::Kind;

std::string asked_text(const ClaimPart& part) {
  const std::string text = reports::asked_text(part);
  return text.empty() ? "-" : text;
}

/// An order with an unstable run in its window lies below any bound.
std::string value_text(const ClaimPart& part, double value) {
  if (std::isinf(value)) return value < 0 ? "unstable" : number_text(value);
  return reports::told_from_bounds(part, value);
}

namespace {

/// What stands behind the number; of a limit its bracket, too.
std::string interval_text(const ClaimPart& part, const Found& found) {
  std::string text = claims::interval_text(part, found);
  if (!part.is_limit() || !text.empty() || !claims::has_interval(found)) return text;
  return fmt::format(" ({})", claims::range_text(found.lower, found.upper));
}

}  // namespace

std::string found_text(const ClaimPart& part, const Found& found) {
  if (std::isnan(found.value)) return "-";
  const std::string text = value_text(part, found.value) + interval_text(part, found);
  return claims::has_interval(found) || found.remark.empty() ? text : fmt::format("{} ({})", text, found.remark);
}

namespace {

/// One or two numbers are shown themselves, of more their range.
constexpr std::size_t most_shown = 2;

std::vector<Found> known_numbers(const ClaimPart& part) {
  std::vector<Found> known = part.found;
  std::erase_if(known, [](const Found& found) { return std::isnan(found.value); });
  return known;
}

/// Whether the remark on a number stands beside its criterion: those on numbers with an interval are among the grounds,
/// but that a limit is not monotone says what the limit is.
bool has_remark(const ClaimPart& part, const Found& found) {
  return !found.remark.empty() && (part.is_limit() || !claims::has_interval(found));
}

/// The statement of a criterion, with the remarks on its numbers; one that is not on all says on which.
std::string statement_with_remarks(const ClaimPart& part) {
  std::map<std::string, std::vector<std::string>> numbers;  // by remark
  for (const Found& found : part.found)
    if (has_remark(part, found)) numbers[found.remark].push_back(found.what);
  std::vector<std::string> remarks;
  for (const auto& [remark, whats] : numbers)
    remarks.push_back(whats.size() == part.found.size() ? remark
                      : whats.size() == 1               ? fmt::format("{}: {}", whats.front(), remark)
                                          : fmt::format("{} of {}: {}", whats.size(), part.found.size(), remark));
  return remarks.empty() ? part.statement : fmt::format("{} ({})", part.statement, fmt::join(remarks, "; "));
}

}  // namespace

std::string found_text(const ClaimPart& part) {
  const std::vector<Found> known = known_numbers(part);
  std::vector<std::string> texts;
  for (const Found& found : known) texts.push_back(value_text(part, found.value) + interval_text(part, found));
  if (known.empty()) return "-";
  if (known.size() <= most_shown) return fmt::format("{}", fmt::join(texts, ", "));
  const auto [first, last] = std::ranges::minmax_element(known, {}, &Found::value);
  const std::string least = value_text(part, first->value), most = value_text(part, last->value);
  return least == most ? least : fmt::format("{} to {}", least, most);
}

void print_criteria(const std::string& head, const std::vector<LabelledPart>& parts) {
  Table table({{head}, {"verdict", Kind::verdict}, {"asked"}, {"found"}, {"criterion", Kind::prose}});
  for (const auto& [label, part] : parts)
    table.add({label, to_string(part.verdict), asked_text(part), found_text(part), statement_with_remarks(part)});
  table.print();
}

namespace {

/// The numbers of an evidence, parted by "; ". Names of series, in quotes, may have that, too, and apostrophes.
std::vector<std::string> numbers_of(const std::string& evidence) {
  std::vector<std::string> numbers(1);
  bool in_quotes = false;
  const auto is_in_word = [&](std::size_t at) {
    return at < evidence.size() && std::isalnum(static_cast<unsigned char>(evidence[at])) != 0;
  };
  for (std::size_t at = 0; at < evidence.size(); ++at) {
    if (evidence[at] == '\'' && !is_in_word(in_quotes ? at + 1 : at - 1)) in_quotes = !in_quotes;
    if (!in_quotes && evidence.compare(at, 2, "; ") == 0)
      numbers.emplace_back(), ++at;
    else
      numbers.back() += evidence[at];
  }
  return numbers;
}

}  // namespace

void print_grounds(const std::vector<LabelledPart>& parts) {
  for (const auto& [label, part] : parts) {
    print("\n");
    print_indented(fmt::format("{} {}: {}", label, to_string(part.verdict), part.statement), 2);
    for (const std::string& number : numbers_of(part.evidence)) print_indented(number);
  }
}

namespace {

void print_reason(const std::string& head, const ClaimPart& part, const std::string& reason) {
  print("\n");
  print_indented(fmt::format("{}: {}", head, part.statement), 2);
  print_indented(reason);
}

}  // namespace

void print_undecided(const std::vector<LabelledPart>& parts, bool have_grounds) {
  for (const auto& [label, part] : parts) {
    if (part.verdict != records::PartVerdict::inconclusive) continue;
    const std::string why = reports::undecided_text(part);
    if (!have_grounds || why != part.evidence) print_reason("why it is inconclusive", part, why);
  }
}

void print_reasons(const std::vector<LabelledPart>& parts) {
  for (const auto& [label, part] : parts)
    if (!part.reason.empty()) print_reason("why it fails", part, part.reason);
}

}  // namespace mpmvv::cli
