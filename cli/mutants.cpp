#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <thread>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/results.hpp"
#include "goldens/mutants/campaign.hpp"
#include "goldens/mutants/mistake.hpp"
#include "goldens/mutants/mutation.hpp"
#include "goldens/mutants/program_bench.hpp"
#include "goldens/mutants/together_bench.hpp"
#include "studies/support/error.hpp"
#include "studies/support/process.hpp"

namespace mpmvv::cli {

using store::current_provenance;
using store::Store;
using support::UsageError;

namespace {

struct MutantsOptions {
  std::string db, source = ".", work;
  std::vector<std::string> only;
  int random = 100;
  std::uint64_t seed = 1;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  bool list = false, known = false, publish = false, json = false;

  std::string goldens() const { return source + "/goldens"; }
  std::filesystem::path lists() const { return goldens() + "/mutants"; }
  std::filesystem::path planted() const { return lists() / "planted.toml"; }
};

Candidate candidate_of(const std::string& name, Mutant::Kind kind, const std::string& what, const Edit& edit,
                       const std::string& text, const std::string& gate) {
  const std::string mutated = edited(edit, text);
  return {{.name = name,
           .kind = kind,
           .what = what,
           .file = edit.file,
           .line = line_of(text, edit.at),
           .before = lines_at(text, edit.at, edit.before.size()),
           .after = lines_at(mutated, edit.at, edit.after.size()),
           .gate = gate},
          edit};
}

std::vector<Candidate> planted_candidates(const std::vector<Mistake>& mistakes, const Laboratory& laboratory,
                                          const std::string& gate) {
  std::vector<Candidate> candidates;
  for (const Mistake& mistake : mistakes) {
    if (std::ranges::find(laboratory.files(), mistake.file) == laboratory.files().end())
      throw UsageError(fmt::format("no file '{}' for mistake '{}' in {} (a file of the tree)", mistake.file,
                                   mistake.name, mistake.where));
    const std::string text = laboratory.text(mistake.file);
    candidates.push_back(
        candidate_of(mistake.name, Mutant::Kind::planted, mistake.what, edit_of(mistake, text), text, gate));
  }
  return candidates;
}

std::vector<Candidate> random_candidates(std::uint64_t seed, const Laboratory& laboratory, const std::string& gate) {
  std::vector<Edit> edits;
  for (const std::string& file : mutated_files(laboratory.files()))
    for (Edit& edit : mutations_of(file, laboratory.text(file))) edits.push_back(std::move(edit));
  std::vector<Candidate> candidates;
  for (const Edit& edit : shuffled(std::move(edits), seed))
    candidates.push_back(candidate_of(fmt::format("random-{}", candidates.size() + 1), Mutant::Kind::random,
                                      fmt::format("'{}' becomes '{}'", edit.before, edit.after), edit,
                                      laboratory.text(edit.file), gate));
  return candidates;
}

std::vector<Mutant> mutants_of(const std::vector<Candidate>& candidates) {
  std::vector<Mutant> mutants;
  for (const Candidate& candidate : candidates) mutants.push_back(candidate.mutant);
  return mutants;
}

/// Leaves only what is named, if anything is.
void keep_named(CampaignPlan& plan, const std::vector<std::string>& names) {
  if (names.empty()) return;
  const auto is_named = [&](const Candidate& c) { return std::ranges::find(names, c.mutant.name) != names.end(); };
  for (const std::string& name : names) {
    const auto has_name = [&](const Candidate& c) { return c.mutant.name == name; };
    if (std::ranges::none_of(plan.planted, has_name) && std::ranges::none_of(plan.draws, has_name))
      throw UsageError(fmt::format("no mutant '{}' (see `mpmvv mutants --list`, or random-1, random-2, ...)", name));
  }
  std::erase_if(plan.planted, std::not_fn(is_named));
  std::erase_if(plan.draws, std::not_fn(is_named));
  plan.random = static_cast<int>(plan.draws.size());
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

void print_score(const std::vector<Mutant>& mutants) {
  const MutantScore score = score_of(mutants);
  print("planted: {} that should show, {} caught: {} by the unit tests, {} by the quick gate, {} by the nightly gate\n",
        score.planted, score.by_any, score.by_unit_tests, score.by_quick, score.by_nightly);
  if (score.silent > 0) print("planted: {} that change efficiency or robustness only\n", score.silent);
  if (!score.missed.empty()) print("not caught: {}\n", joined(score.missed));
  if (score.random > 0)
    print("random: {}, {} caught, {} explained{}{}\n", score.random, score.random_caught, score.random_explained,
          score.unexplained.empty() ? "" : ", not explained: ", joined(score.unexplained));
}

int list(const MutantsOptions& options) {
  const auto mistakes = read_mistakes(options.planted());
  nlohmann::json json = nlohmann::json::array();
  for (const Mistake& m : mistakes) {
    json.push_back({{"name", m.name}, {"what", m.what}, {"file", m.file}, {"reason", m.reason}});
    if (!options.json) print("{:<44} {:<40} {}\n", m.name, m.file, m.what);
  }
  if (options.json) print_json({{"mistakes", json}});
  return 0;
}

int answer(const std::vector<Mutant>& mutants, bool json) {
  const store::Provenance own = current_provenance();
  if (json)
    print_json(to_json({own.digest, own.commit, mutants}));
  else
    print_score(mutants);
  return score_of(mutants).missed.empty() ? 0 : 1;
}

int tell_known(const MutantsOptions& options) {
  constexpr int missing = 3;
  const auto mutants = own_mutants(Store(options.db, Store::Mode::read), options.goldens());
  if (!options.publish) {
    const int verdict = answer(mutants, options.json);
    if (!mutants.empty()) return verdict;
    note("{} knows no mutant of this program (`mpmvv mutants --db` tries some)\n", options.db);
    return missing;
  }
  const store::Provenance own = current_provenance();
  if (mutants.empty()) throw UsageError(fmt::format("{} knows no mutant of this program (try some)", options.db));
  const auto file = publish({own.digest, own.commit + (own.dirty ? " with changes" : ""), mutants}, options.lists());
  note("published in {}\n", file.string());
  return answer(mutants, options.json);
}

/// The store that results go to, made with the first of them: what fails before leaves none.
class Results {
 public:
  explicit Results(const std::filesystem::path& db) : db_(db) {
    const auto folder = std::filesystem::absolute(db).parent_path();
    if (std::filesystem::exists(db))
      store();
    else if (access(folder.c_str(), W_OK) != 0)
      throw UsageError(fmt::format("no folder '{}' that may be written for results store '{}' (make it first)",
                                   folder.string(), db.string()));
  }

  std::vector<Mutant> known() const {
    return store_ ? store_->mutants(current_provenance().digest) : std::vector<Mutant>{};
  }
  void keep(const Mutant& mutant) { store().keep_mutant(mutant, current_provenance()); }

 private:
  Store& store() {
    if (!store_) store_.emplace(db_, Store::Mode::create_or_write);
    return *store_;
  }

  std::filesystem::path db_;
  std::optional<Store> store_;
};

/// What a campaign calls beside what it builds.
void require_tools() {
  for (const char* tool : {"cmake", "ninja"})
    if (!support::run_process({tool, "--version"}, ".", {}, std::chrono::seconds(60)).good())
      throw UsageError(fmt::format("no program '{}' that starts on the PATH (install what `./run build` does)", tool));
}

int mutants(const MutantsOptions& options) {
  if (options.list) return list(options);
  if (options.db.empty()) throw UsageError("no --db given (a results store)");
  if (options.known || options.publish) return tell_known(options);
  const auto mistakes = read_mistakes(options.planted());
  require_tools();
  Results results(options.db);
  const std::filesystem::path work = options.work.empty() ? options.source + "/build/laboratory" : options.work;
  Laboratory laboratory(options.source, work, program_parts());
  const std::string gate = gate_version(laboratory);
  CampaignPlan plan{planted_candidates(mistakes, laboratory, gate), random_candidates(options.seed, laboratory, gate),
                    options.random};
  const Reasons reasons(options.lists());
  reasons.check(mutants_of(plan.draws));
  keep_named(plan, options.only);
  for (auto* candidates : {&plan.planted, &plan.draws})
    for (Candidate& candidate : *candidates) candidate.mutant.reason = reasons.of(candidate.mutant);

  const std::vector<Mutant> known = with_published(results.known(), read_tried(options.lists()).mutants);
  const auto find = [&](const Mutant& wanted) { return known_result(known, wanted); };
  const auto tell = [](const std::string& line) { note("{}\n", line); };
  Laboratory shared(options.source, work / "together", program_parts());
  ProgramBench alone(laboratory, options.jobs), together(shared, options.jobs);
  TogetherBench bench(alone, together, edits_to_try(plan, find), tell);
  const auto keep = [&](const Mutant& mutant) { results.keep(mutant); };
  return answer(run_campaign(plan, gate, bench, {.find = find, .keep = keep, .tell = tell}), options.json);
}

}  // namespace

void add_mutants(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<MutantsOptions>();
  CLI::App* command =
      app.add_subcommand("mutants", "Plant mistakes in a copy of the sources and see what catches them");
  command->add_option("--db", options->db, "results store");
  command->add_option("--source", options->source, "top of the source tree (default: .)");
  command->add_option("--work", options->work, "scratch folder (default: build/laboratory in the source tree)");
  CLI::Option* only = command->add_option("--only", options->only, "only these mutants");
  command->add_option("--random", options->random, "how many random mutations beside the planted ones (default: 100)")
      ->check(CLI::Range(0, 100'000));
  command->add_option("--seed", options->seed, "of their draw (default: 1)");
  command->add_option("--jobs", options->jobs, "compilers and cases at once (default: all cores)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--list", options->list, "print the planted mistakes");
  command->add_flag("--known", options->known, "print what is known of this program's mutants, try none")
      ->excludes(only);
  command->add_flag("--publish", options->publish, "write that into goldens/mutants/tried.json, too")->excludes(only);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, &exit_code] { exit_code = mutants(*options); });
}

}  // namespace mpmvv::cli
