#include "goldens/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <system_error>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/shipped.hpp"
#include "cli/table.hpp"
#include "studies/fits/median.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/process.hpp"
#include "studies/support/program.hpp"

namespace mpmvv::cli {

using goldens::Verdict;
using Kind = Table::Kind;

namespace {

struct CostOptions {
  std::string baseline, cases;
  bool json = false;
};

/// A case as the options of `mpmvv run`, and what it costs.
struct CostedCase {
  std::string name;
  goldens::CostRatio cost;
};

/// The cases in the studies here, or else in those that come with the program.
std::string default_cases() {
  const std::filesystem::path here = "studies/cost.txt";
  std::error_code unknown;
  if (std::filesystem::exists(here, unknown)) return here;
  const std::filesystem::path of_program = shipped("studies");
  if (of_program.empty())
    throw support::UsageError("no studies/cost.txt here, and this program finds none of its own (--cases FILE)");
  return of_program / "cost.txt";
}

/// The options of a run, and where they stand.
struct ListedCase {
  std::string options, where;
};

std::vector<ListedCase> read_cases(const std::string& file) {
  std::istringstream in(support::require_file(file, "a file with the options of a run on each line"));
  std::vector<ListedCase> cases;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line.erase(std::min(line.find_first_of("#\r"), line.size()));
    if (line.find_first_not_of(" \t") != std::string::npos) cases.push_back({line, fmt::format("{}:{}", file, number)});
  }
  if (cases.empty())
    throw support::UsageError(fmt::format("{} names no case (the options of a run on each line)", file));
  return cases;
}

/// A program, the options that it runs with, and where they stand.
struct TimedRun {
  std::string program, options, where;
};

/// Each run times its steps three times.
support::ProcessEnd end_of(const TimedRun& run) {
  std::vector<std::string> command{run.program, "run", "--json", "--repeat", "3"};
  std::istringstream words(run.options);
  for (std::string word; words >> word;) command.push_back(word);
  return support::run_process(command, ".", {}, std::chrono::minutes(5));
}

/// ns per particle and step, the median of the run's rounds; none where the program has not carried the run out. An
/// older program gives the median alone.
std::optional<double> cost_of(const support::ProcessEnd& end) {
  if (!end.good()) return {};
  const auto record = nlohmann::json::parse(end.output, nullptr, false);
  if (!record.is_object() || record.value("status", nlohmann::json()) != "ok") return {};
  const auto cost = record.value("ns_per_particle_step", nlohmann::json());
  if (!cost.is_number()) return {};
  const nlohmann::json::json_pointer place("/cost/rounds");
  const auto rounds = record.contains(place) ? record.at(place) : nlohmann::json();
  const auto is_number = [](const nlohmann::json& round) { return round.is_number(); };
  const bool has_rounds = rounds.is_array() && !rounds.empty() && std::ranges::all_of(rounds, is_number);
  const double ns = has_rounds ? fits::median_of(rounds.get<std::vector<double>>()) : cost.get<double>();
  return ns > 0 ? std::optional(ns) : std::nullopt;
}

/// How a run ended that has no cost.
std::string end_text(const support::ProcessEnd& end) {
  if (end.start_error != 0) return std::strerror(end.start_error);
  if (end.timed_out) return "not at its end after five minutes";
  if (end.output.empty()) return fmt::format("it prints nothing, and its exit code is {}", end.exit_code);
  const auto record = nlohmann::json::parse(end.output, nullptr, false);
  const auto status = record.find("status"), reason = record.find("reason");
  if (!record.is_object() || status == record.end() || reason == record.end() || !status->is_string() ||
      !reason->is_string())
    return end.output.substr(0, end.output.find('\n')).substr(0, 300);
  return fmt::format("{} ({})", status->get<std::string>(), reason->get<std::string>());
}

/// Throws unless the program says of itself that it is mpmvv.
void require_ours(const std::string& program) {
  const support::ProcessEnd end = support::run_process({program, "--version"}, ".", {}, std::chrono::seconds(30));
  if (end.good() && end.output.starts_with("mpmvv ")) return;
  throw support::UsageError(
      fmt::format("baseline '{}' is no mpmvv, by what it says to --version: '{}' (another build "
                  "of this one)",
                  program, end.output.substr(0, end.output.find('\n'))));
}

double required_cost(const TimedRun& run) {
  const support::ProcessEnd end = end_of(run);
  if (const auto cost = cost_of(end)) return *cost;
  throw support::UsageError(
      fmt::format("{} does not carry out the case in {}, '{}' (a program like this one, and a run that ends ok): {}",
                  run.program, run.where, run.options, end_text(end)));
}

/// The baseline's run of the case, of the whole body as here. A version that does not know --whole always runs whole
/// bodies. None where that version refuses the case's options.
std::optional<TimedRun> baseline_run(const std::string& program, const ListedCase& listed) {
  constexpr int usage_error = 2;
  for (const char* whole : {" --whole", ""})
    if (TimedRun run{program, listed.options + whole, listed.where}; end_of(run).exit_code != usage_error) return run;
  return {};
}

goldens::CostRatio beside(const TimedRun& own, const TimedRun& baseline) {
  bool own_first = false;
  return goldens::measure_cost([&] {
    own_first = !own_first;
    goldens::CostPair pair;
    if (own_first) pair.now = required_cost(own);
    pair.baseline = required_cost(baseline);
    if (!own_first) pair.now = required_cost(own);
    return pair;
  });
}

std::vector<goldens::CostRatio> costs_of(const std::vector<CostedCase>& cases) {
  std::vector<goldens::CostRatio> costs;
  for (const CostedCase& one : cases) costs.push_back(one.cost);
  return costs;
}

nlohmann::json mean_json(const std::vector<CostedCase>& cases) {
  if (cases.empty()) return nullptr;
  const goldens::MeanCost mean = goldens::mean_cost(costs_of(cases));
  return {{"ratio", mean.ratio}, {"least", mean.least}, {"most", mean.most}, {"verdict", to_string(mean.verdict())}};
}

nlohmann::json cost_json(const std::vector<CostedCase>& cases, const std::vector<std::string>& left_out) {
  nlohmann::json all = nlohmann::json::array();
  for (const auto& [name, cost] : cases)
    all.push_back({{"case", name},
                   {"now", cost.now},
                   {"baseline", cost.baseline},
                   {"ratio", cost.ratio},
                   {"least", cost.least},
                   {"most", cost.most},
                   {"pairs", cost.pairs},
                   {"verdict", to_string(cost.verdict())}});
  return {{"cases", all}, {"mean", mean_json(cases)}, {"left_out", left_out}};
}

void print_costs(const std::vector<CostedCase>& cases) {
  Table table({{"verdict", Kind::verdict},
               {"ratio", Kind::number},
               {"99 %"},
               {"now\n(ns)", Kind::number},
               {"baseline\n(ns)", Kind::number},
               {"case", Kind::prose}},
              0);
  for (const auto& [name, cost] : cases)
    table.add({to_string(cost.verdict()), fmt::format("{:.3f}", cost.ratio),
               fmt::format("{:.3f} to {:.3f}", cost.least, cost.most), fmt::format("{:.1f}", cost.now),
               fmt::format("{:.1f}", cost.baseline), name});
  table.print();
}

std::string mean_text(const std::vector<CostedCase>& cases) {
  const goldens::MeanCost mean = goldens::mean_cost(costs_of(cases));
  return fmt::format("mean of the cases: {}, {:.3f} (99 %: {:.3f} to {:.3f}; at most {})", to_string(mean.verdict()),
                     mean.ratio, mean.least, mean.most, goldens::mean_cost_band);
}

std::size_t count(const std::vector<CostedCase>& cases, Verdict verdict) {
  return static_cast<std::size_t>(
      std::ranges::count_if(cases, [&](const CostedCase& c) { return c.cost.verdict() == verdict; }));
}

void print_end(const std::vector<CostedCase>& cases) {
  print_costs(cases);
  print("cost: {} pass, {} fail, {} inconclusive (at most {} of the baseline's)", count(cases, Verdict::pass),
        count(cases, Verdict::fail), count(cases, Verdict::inconclusive), goldens::cost_band);
  print("{}\n", cases.empty() ? "" : "; " + mean_text(cases));
}

int exit_code_of(Verdict verdict) {
  return verdict == Verdict::pass ? 0 : verdict == Verdict::fail ? 1 : 3;
}

int cost(const CostOptions& options) {
  const std::string own = std::filesystem::read_symlink("/proc/self/exe"),
                    baseline = std::filesystem::absolute(options.baseline);
  if (!support::is_program(baseline))
    throw support::UsageError(fmt::format("baseline '{}' is no program (another build of this one)", options.baseline));
  require_ours(baseline);
  const auto columns = note_columns();
  std::vector<CostedCase> costed;
  std::vector<std::string> left_out;
  const auto cases = read_cases(options.cases.empty() ? default_cases() : options.cases);
  for (const ListedCase& listed : cases) {
    const std::string& name = listed.options;
    if (columns)
      note_text("\r\033[K" +
                cut(fmt::format("[{}/{}] {}", costed.size() + left_out.size(), cases.size(), name), *columns - 1));
    const TimedRun own_run{own, name + " --whole", listed.where};
    required_cost(own_run);
    const auto other_run = baseline_run(baseline, listed);
    if (other_run)
      costed.push_back({name, beside(own_run, *other_run)});
    else
      left_out.push_back(name);
    if (columns) note_text("\r\033[K");
    if (!other_run) note("left out, as the baseline refuses it: {}\n", name);
  }
  if (options.json)
    print_json(cost_json(costed, left_out));
  else
    print_end(costed);
  return exit_code_of(goldens::verdict_of(costs_of(costed)));
}

}  // namespace

void add_cost(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CostOptions>();
  CLI::App* command = app.add_subcommand("cost", "Time cases beside another build of this program, run by run");
  command->add_option("baseline", options->baseline, "that program")->required()->type_name("PROGRAM");
  command
      ->add_option("--cases", options->cases,
                   "file with a run's options on each line (default: studies/cost.txt here, else that of the program)")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "print one JSON object");
  add_examples(*command, {"mpmvv cost other/mpmvv --cases cases.txt"});
  command->callback([options, &exit_code] { exit_code = cost(*options); });
}

}  // namespace mpmvv::cli
