#include "tests/mutation/command.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/console.hpp"
#include "studies/store/provenance.hpp"
#include "studies/support/error.hpp"
#include "studies/support/process.hpp"
#include "tests/mutation/batch_bench.hpp"
#include "tests/mutation/campaign.hpp"
#include "tests/mutation/mistake.hpp"
#include "tests/mutation/plan.hpp"
#include "tests/mutation/program_bench.hpp"
#include "tests/mutation/program_gate.hpp"
#include "tests/mutation/results.hpp"
#include "tests/mutation/texts.hpp"
#include "tests/mutation/unmatched.hpp"

namespace mpmvv::mutation {

namespace {

struct Options {
  std::string results, source = ".", work;
  std::vector<std::string> only;
  Draw draw{.count = 100, .seed = 1};
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  bool list = false, check = false, known = false, publish = false, json = false;

  std::filesystem::path lists() const { return source + "/tests/mutation"; }
  std::filesystem::path planted() const { return lists() / "planted.toml"; }
};

int list(const Options& options) {
  const auto mistakes = read_mistakes(options.planted());
  if (!options.json) {
    for (const Mistake& mistake : mistakes) cli::print_text(text_of(mistake));
    return 0;
  }
  nlohmann::json json = nlohmann::json::array();
  for (const Mistake& m : mistakes)
    json.push_back({{"name", m.name}, {"what", m.what}, {"file", m.file}, {"equivalent", m.reason}});
  cli::print_json({{"mistakes", json}});
  return 0;
}

int answer(const Results& results, bool json) {
  const Score score = score_of(results.mutants);
  if (json)
    cli::print_json(to_json(results));
  else
    cli::print_text(text_of(score));
  return score.missed.empty() ? 0 : 1;
}

int tell_known(const Options& options, const Results& results) {
  constexpr int missing = 3;
  const bool knows_none = results.mutants.empty();
  if (options.publish) {
    if (knows_none) throw support::UsageError(options.results + " knows no mutant of this program (try some)");
    cli::note("published in {}\n", publish(results, options.lists()).string());
  }
  if (!knows_none || options.json) {
    const int verdict = answer(results, options.json);
    if (!knows_none) return verdict;
  }
  cli::note("{} knows no mutant of this program (`./run mutants` tries some)\n", options.results);
  return missing;
}

/// Prints the entries of the lists that do not match the sources.
int check(const Options& options, const Reasons& reasons) {
  const auto mistakes = read_mistakes(options.planted());
  const auto wrong = unmatched(mistakes, reasons.explanations(), read_sources(options.source));
  for (const Unmatched& entry : wrong) {
    cli::print("{}\n", entry.complaint);
    if (!entry.nearest.empty()) cli::print("    {}\n", entry.nearest);
  }
  cli::note("{} of {} entries do not match the sources\n", wrong.size(),
            mistakes.size() + reasons.explanations().size());
  return wrong.empty() ? 0 : 1;
}

/// Throws when an entry of the lists does not match the sources. A mistake then cannot be made and an explanation may
/// be wrong, so a campaign begins with neither.
void require_match(const Options& options, const std::vector<Mistake>& mistakes, const Reasons& reasons) {
  const auto wrong = unmatched(mistakes, reasons.explanations(), read_sources(options.source));
  if (wrong.empty()) return;
  const std::string more = wrong.size() == 1 ? "" : fmt::format("; --check lists {} more", wrong.size() - 1);
  throw support::UsageError(wrong.front().complaint + more);
}

/// Throws unless the programs start that a campaign calls beside what it builds.
void require_tools() {
  for (const char* tool : {"cmake", "ninja"})
    if (!support::run_process({tool, "--version"}, ".", {}, std::chrono::seconds(60)).good())
      throw support::UsageError(
          fmt::format("no program '{}' that starts on the PATH (install what `./run build` does)", tool));
}

CampaignPlan reasoned_plan(const Options& options, const std::vector<Mistake>& mistakes, const Reasons& reasons,
                           const ScratchTree& tree, const std::string& gate) {
  CampaignPlan plan = plan_of(mistakes, options.draw, tree, gate);
  keep_named(plan, options.only);
  for (auto* candidates : {&plan.planted, &plan.draws})
    for (Candidate& candidate : *candidates) candidate.mutant.reason = reasons.of(candidate.mutant);
  return plan;
}

int run(const Options& options) {
  if (options.list) return list(options);
  const Reasons reasons(options.lists());
  if (options.check) return check(options, reasons);
  if (options.results.empty()) throw support::UsageError("no --results given (a file such as results/mutants.json)");
  ResultsFile results(options.results, reasons, store::current_provenance());
  if (options.known || options.publish) return tell_known(options, results.known());
  const auto mistakes = read_mistakes(options.planted());
  require_match(options, mistakes, reasons);
  require_tools();
  const std::filesystem::path work = options.work.empty() ? options.source + "/build/mutation" : options.work;
  ScratchTree tree(options.source, work, program_parts());
  const std::string gate = gate_version(tree);
  const CampaignPlan plan = reasoned_plan(options, mistakes, reasons, tree, gate);

  Results known = results.known();
  const auto find = [&](const Mutant& wanted) { return known_result(known.mutants, wanted); };
  const auto tell = [](const std::string& line) { cli::note("{}\n", line); };
  const auto keep = [&](const Mutant& mutant) { results.keep(mutant); };
  ScratchTree batch_tree(options.source, work / "batch", program_parts());
  ProgramBench alone(tree, options.jobs), batched(batch_tree, options.jobs);
  BatchBench bench(alone, batched, edits_to_try(plan, find), tell);
  auto tried = run_campaign(plan, gate, bench, {.find = find, .keep = keep, .tell = tell});
  return answer({known.digest, known.commit, std::move(tried)}, options.json);
}

}  // namespace

void add_options(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  app.add_option("--results", options->results, "JSON file that results are kept in; what it knows is not tried again");
  app.add_option("--source", options->source, "top of the source tree (default: .)");
  app.add_option("--work", options->work, "scratch folder (default: build/mutation in the source tree)");
  CLI::Option* only = app.add_option("--only", options->only, "only these mutants");
  app.add_option("--random", options->draw.count, "random mutations beside the planted ones (default: 100)")
      ->check(CLI::Range(0, 100'000));
  app.add_option("--seed", options->draw.seed, "of their draw (default: 1)");
  app.add_option("--jobs", options->jobs, "compilers and cases at once (default: all cores)")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--list", options->list, "print the planted mistakes");
  app.add_flag("--check", options->check, "print the planted mistakes and explanations that the sources do not match");
  app.add_flag("--known", options->known, "print what is known of this program's mutants, try none")->excludes(only);
  app.add_flag("--publish", options->publish, "write its summary to tests/mutation/summary.json, too")->excludes(only);
  app.add_flag("--json", options->json, "print one JSON object");
  app.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mpmvv::mutation
