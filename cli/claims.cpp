#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/case_commands.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/criteria_text.hpp"
#include "cli/help.hpp"
#include "cli/lines.hpp"
#include "cli/results.hpp"
#include "cli/table.hpp"
#include "reports/criteria.hpp"
#include "studies/claims/claim.hpp"
#include "studies/claims/found_text.hpp"
#include "studies/support/error.hpp"
#include "studies/support/shell.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::cli {

using claims::Claim;
using Kind = Table::Kind;

namespace {

struct ClaimsOptions {
  std::string db;
  std::vector<std::string> ids;
  bool json = false, verbose = false;
};

/// A number that was found. JSON has no infinite ones: `value` is null then, and `infinite` has the sign.
nlohmann::json found_json(const records::ClaimPart& part, const records::Found& found) {
  nlohmann::json json{{"what", found.what}, {"value", found.value}, {"text", found_text(part, found)}};
  if (std::isinf(found.value)) json["infinite"] = found.value > 0 ? 1 : -1;
  if (claims::has_interval(found)) {
    if (part.is_order())
      json["half_width"] = found.value - found.lower;
    else
      json["interval"] = {found.lower, found.upper};
  }
  if (!found.remark.empty()) json["remark"] = found.remark;
  return json;
}

nlohmann::json part_json(const claims::JudgedPart& judged) {
  const records::ClaimPart& part = judged.part;
  nlohmann::json found = nlohmann::json::array();
  for (const records::Found& number : part.found) found.push_back(found_json(part, number));
  const auto bound = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
  };
  return {{"study", judged.study},
          {"statement", part.statement},
          {"verdict", to_string(part.verdict)},
          {"measure", part.measure},
          {"at_least", bound(part.at_least)},
          {"at_most", bound(part.at_most)},
          {"found", found},
          {"evidence", part.evidence},
          {"reason", part.reason.empty() ? part.withheld : part.reason}};
}

nlohmann::json claim_json(const Claim& c) {
  nlohmann::json parts = nlohmann::json::array();
  for (const claims::JudgedPart& part : c.parts) parts.push_back(part_json(part));
  return {{"id", c.id},
          {"statement", c.statement},
          {"source", c.source},
          {"where", c.where},
          {"verdict", to_string(c.verdict)},
          {"evidence", c.evidence},
          {"studies", c.studies},
          {"not_run", c.not_run},
          {"criteria", parts}};
}

/// "5 of 6 hold".
std::string holding(const Claim& c) {
  const auto asks = [](const claims::JudgedPart& judged) { return judged.part.verdict != records::PartVerdict::shown; };
  const auto holds = [](const claims::JudgedPart& judged) {
    return judged.part.verdict == records::PartVerdict::holds;
  };
  const auto all = std::ranges::count_if(c.parts, asks);
  return all == 0 ? "-" : fmt::format("{} of {}", std::ranges::count_if(c.parts, holds), all);
}

/// "2 of 3", the studies that have a part of the verdict; empty where all that the program knows have one.
std::string studies_counted(const Claim& c) {
  if (c.not_run.empty()) return "";
  return fmt::format("{} of {}", c.studies.size(), c.studies.size() + c.not_run.size());
}

void print_list(const std::vector<Claim>& all) {
  std::vector<Table::Column> columns{{"claim"}, {"verdict", Kind::verdict}, {"hold"}};
  const bool is_in_part = std::ranges::any_of(all, [](const Claim& c) { return !c.not_run.empty(); });
  if (is_in_part) columns.push_back({"studies"});
  columns.push_back({"statement", Kind::line});
  Table table(std::move(columns), 0);
  for (const Claim& c : all) {
    std::vector<std::string> cells{c.id, to_string(c.verdict), holding(c)};
    if (is_in_part) cells.push_back(studies_counted(c));
    cells.push_back(c.statement);
    table.add(std::move(cells));
  }
  table.print();
  if (is_in_part)
    print_indented(
        "studies: those in the store, of all that judge the claim; with the others its verdict may change "
        "(`mpmvv claims ID` names them)",
        0);
}

std::string source_text(const Claim& c) {
  return c.where.empty() || c.source.empty() ? c.source + c.where : fmt::format("{}, {}", c.source, c.where);
}

/// The command that finds the numbers of a claim once more; empty where no study judges it.
std::string repeated_by(const Claim& c, const std::vector<records::StudyResult>& results, const std::string& db) {
  if (c.id == reports::mutants_claim) return reports::mutants_command;
  std::vector<reports::StudyCall> calls;
  for (const records::StudyResult& study : results)
    if (std::ranges::find(c.studies, study.name) != c.studies.end()) calls.push_back(study_call(study));
  return reports::study_command(calls, db, db);
}

/// Prints the command, how to get the files of studies that do not come with the program, and how to run all anew.
void print_repeated(const Claim& c, const std::vector<records::StudyResult>& results, const std::string& command,
                    const std::string& db) {
  constexpr std::size_t below = 10;
  print("\n  repeat: {}\n", command);
  if (c.id == reports::mutants_claim) return;
  for (const records::StudyResult& study : results) {
    const bool judges = std::ranges::find(c.studies, study.name) != c.studies.end();
    if (judges && study_call(study).study != study.name)
      print_indented(
          fmt::format("{0}.toml is what `mpmvv db study {0} --db {1}` prints", study.name, support::shell_word(db)),
          below);
  }
  print_indented("runs that the store has are not run again; with a new store all are", below);
}

void print_page(const Claim& c, const std::vector<records::StudyResult>& results, const ClaimsOptions& options) {
  print("{}: {}\n", c.id, to_string(c.verdict));
  for (const std::string& text : {c.statement, source_text(c)})
    if (!text.empty()) print_indented(text);
  std::vector<LabelledPart> parts;
  for (const claims::JudgedPart& judged : c.parts) parts.push_back({judged.study, judged.part});
  if (parts.empty() && c.id == reports::mutants_claim) print_indented("not judged yet for this version of the program");
  print("\n");
  print_criteria("study", parts);
  if (options.verbose) print_grounds(parts);
  print_undecided(parts, options.verbose);
  print_reasons(parts);
  if (!c.not_run.empty()) {
    print("\n");
    print_indented(fmt::format("judged without {}: not in the store", support::listed(c.not_run)));
  }
  const std::string command = repeated_by(c, results, options.db);
  if (command.empty())
    print("  no study in the store judges it\n");
  else
    print_repeated(c, results, command, options.db);
  print("\n");
}

const Claim& find_claim(const std::vector<Claim>& all, const std::string& id, const std::string& db) {
  if (const auto found = std::ranges::find(all, id, &Claim::id); found != all.end()) return *found;
  std::vector<std::string> known;
  for (const Claim& c : all) known.push_back(c.id);
  throw support::UsageError(fmt::format("unknown claim '{}': no study of this program in {} names it (known: {})", id,
                                        db, support::listed(known)));
}

int show(const ClaimsOptions& options) {
  if (options.verbose && options.ids.empty())
    throw support::UsageError("--verbose without a claim (it is of pages: `mpmvv claims ID --verbose`)");
  const auto results = own_results(options.db);
  require_own_results(results, options.db);
  std::vector<Claim> judged = judged_claims(results, own_mutation(options.db));
  if (!options.ids.empty()) {
    std::vector<Claim> wanted;
    for (const std::string& id : options.ids) wanted.push_back(find_claim(judged, id, options.db));
    judged = std::move(wanted);
  }
  if (options.json) {
    nlohmann::json all = nlohmann::json::array();
    for (const Claim& c : judged) all.push_back(claim_json(c));
    print_json({{"claims", all}});
  } else if (judged.empty()) {
    print("no study of this program in {} names a claim\n", options.db);
  } else if (options.ids.empty()) {
    print_list(judged);
  } else {
    for (const Claim& c : judged) print_page(c, results, options);
  }
  return 0;
}

}  // namespace

void add_claims(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ClaimsOptions>();
  CLI::App* command = app.add_subcommand("claims", "Print every claim with its verdict, or the pages of some");
  command->add_option("ids", options->ids, "claims whose pages to print (default: a line for each claim)")
      ->type_name("ID");
  command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
  command->add_flag("--verbose", options->verbose, "on a page print every number that was compared, too");
  command->add_flag("--json", options->json, "print one JSON object");
  add_examples(*command, {"mpmvv claims --db results.db", "mpmvv claims S-fig4 --db results.db"});
  command->callback([options, &exit_code] { exit_code = show(*options); });
}

}  // namespace mpmvv::cli
