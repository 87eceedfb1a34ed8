#include "studies/mutant.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <tuple>

namespace mpmvv {

using records::PartVerdict;
using records::StudyResult;

namespace {

constexpr std::array stage_words{"unit tests", "quick", "nightly"};
constexpr std::array mutant_kind_words{"baseline", "planted", "random"};

template <class Enum>
Enum enum_of(const auto& words, const std::string& word) {
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) throw std::invalid_argument("unknown word '" + word + "'");
  return static_cast<Enum>(found - words.begin());
}

void count_planted(MutantScore& score, const Mutant& mutant) {
  if (!mutant.reason.empty()) {
    ++score.silent;
    return;
  }
  ++score.planted;
  score.by_unit_tests += mutant.caught_by(GateStage::unit_tests);
  score.by_quick += mutant.caught_by(GateStage::quick);
  score.by_nightly += mutant.caught_by(GateStage::nightly);
  score.by_any += mutant.caught();
  score.open += mutant.open();
  if (!mutant.caught() && !mutant.open()) score.missed.push_back(mutant.name);
}

void count_random(MutantScore& score, const Mutant& mutant) {
  if (!mutant.builds) return;
  ++score.random;
  if (mutant.caught())
    ++score.random_caught;
  else if (!mutant.reason.empty())
    ++score.random_explained;
  else if (!mutant.open())
    score.unexplained.push_back(mutant.name);
}

PartVerdict catch_verdict(const MutantScore& score) {
  if (!score.missed.empty()) return PartVerdict::fails;
  return score.open > 0 ? PartVerdict::inconclusive : PartVerdict::holds;
}

std::string catch_evidence(const MutantScore& score) {
  const std::string open = score.open == 0 ? "" : fmt::format(", {} not tried to the end", score.open);
  const std::string missed = score.missed.empty() ? "" : fmt::format(", not {}", fmt::join(score.missed, ", "));
  return fmt::format("{} of {}{}{}; {} by the quick gate alone, {} by the unit tests alone", score.by_any,
                     score.planted, open, missed, score.by_quick, score.by_unit_tests);
}

/// Asked of the quick gate: no false alarm in so many runs.
constexpr std::size_t runs_without_alarm = 200;

PartVerdict alarm_verdict(const MutantScore& score, const std::vector<AlarmRun>& runs) {
  if (!score.passes_baseline || std::ranges::any_of(runs, &AlarmRun::is_alarm)) return PartVerdict::fails;
  return runs.size() < runs_without_alarm ? PartVerdict::inconclusive : PartVerdict::holds;
}

std::string alarm_evidence(const MutantScore& score, const std::vector<AlarmRun>& runs) {
  std::set<std::string> builds;
  for (const AlarmRun& run : runs) builds.insert(run.build);
  const auto baseline = !score.has_baseline     ? ""
                        : score.passes_baseline ? "; the campaign's tree passes"
                                                : "; the campaign's tree does not pass";
  return fmt::format("{} in {} runs of {} builds, other orders and places of the particles{}",
                     std::ranges::count_if(runs, &AlarmRun::is_alarm), runs.size(), builds.size(), baseline);
}

}  // namespace

std::string to_string(GateStage stage) {
  return stage_words[static_cast<std::size_t>(stage)];
}

GateStage gate_stage_from(const std::string& word) {
  return enum_of<GateStage>(stage_words, word);
}

std::string to_string(Mutant::Kind kind) {
  return mutant_kind_words[static_cast<std::size_t>(kind)];
}

Mutant::Kind mutant_kind_from(const std::string& word) {
  return enum_of<Mutant::Kind>(mutant_kind_words, word);
}

const Trial* Mutant::trial(GateStage stage) const {
  const auto found = std::ranges::find(trials, stage, &Trial::stage);
  return found == trials.end() ? nullptr : &*found;
}

bool Mutant::caught() const {
  return std::ranges::any_of(trials, &Trial::caught);
}

bool Mutant::open() const {
  constexpr std::array all{GateStage::unit_tests, GateStage::quick, GateStage::nightly};
  return builds && !caught() && std::ranges::any_of(all, [this](GateStage stage) { return !trial(stage); });
}

bool Mutant::caught_by(GateStage stage) const {
  const Trial* met = trial(stage);
  return met && met->caught;
}

const Mutant* find_mutant(const std::vector<Mutant>& mutants, const Mutant& wanted) {
  const auto identity = [](const Mutant& m) { return std::tie(m.name, m.gate, m.file, m.line, m.before, m.after); };
  const auto found = std::ranges::find_if(mutants, [&](const Mutant& m) { return identity(m) == identity(wanted); });
  return found == mutants.end() ? nullptr : &*found;
}

std::vector<Mutant> newest(const std::vector<Mutant>& mutants) {
  std::vector<Mutant> latest;
  for (const Mutant& mutant : mutants) {
    const auto earlier = std::ranges::find(latest, mutant.name, &Mutant::name);
    if (earlier == latest.end())
      latest.push_back(mutant);
    else
      *earlier = mutant;
  }
  return latest;
}

MutantScore score_of(const std::vector<Mutant>& mutants) {
  MutantScore score;
  for (const Mutant& mutant : mutants) {
    if (mutant.kind == Mutant::Kind::planted) count_planted(score, mutant);
    if (mutant.kind == Mutant::Kind::random) count_random(score, mutant);
    if (mutant.kind != Mutant::Kind::baseline) continue;
    score.has_baseline = true;
    score.passes_baseline = score.passes_baseline && !mutant.caught();
  }
  return score;
}

StudyResult mutant_study(const std::vector<Mutant>& mutants, const std::vector<AlarmRun>& runs) {
  const MutantScore score = score_of(mutants);
  StudyResult study;
  study.name = "mutants";
  study.title = "Planted mistakes";
  study.kind = "check";
  study.claims = {"X-mutants"};
  if (score.planted == 0) return study;
  const auto add = [&study](const std::string& statement, PartVerdict verdict, const std::string& evidence) {
    study.parts.push_back({"X-mutants", statement, verdict, evidence, ""});
  };
  add("tests and goldens catch every planted mistake that an order, an error, a limit or a report can show",
      catch_verdict(score), catch_evidence(score));
  add(fmt::format("they raise no false alarm (in {} runs of the quick gate)", runs_without_alarm),
      alarm_verdict(score, runs), alarm_evidence(score, runs));
  return study;
}

}  // namespace mpmvv
