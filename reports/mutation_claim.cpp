#include "reports/mutation_claim.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mpmvv::reports {

namespace {

records::PartVerdict catch_verdict(const PlantedScore& score) {
  if (!score.missed.empty()) return records::PartVerdict::fails;
  return score.open > 0 ? records::PartVerdict::inconclusive : records::PartVerdict::holds;
}

std::string catch_evidence(const PlantedScore& score) {
  const std::string open = score.open == 0 ? "" : fmt::format(", {} not tried to the end", score.open);
  const std::string missed = score.missed.empty() ? "" : fmt::format(", not {}", fmt::join(score.missed, ", "));
  return fmt::format("{} of {}{}{}; {} by the quick gate alone, {} by the unit tests alone", score.caught,
                     score.should_show, open, missed, score.quick, score.unit_tests);
}

/// The claim asks for so many runs of the quick gate without a false alarm.
constexpr int runs_without_alarm = 200;

AlarmCount sum_over_builds(const std::vector<AlarmCount>& builds) {
  AlarmCount sum;
  for (const AlarmCount& of : builds) sum.runs += of.runs, sum.alarms += of.alarms;
  return sum;
}

records::PartVerdict alarm_verdict(const MutationResults& mutation, const std::vector<AlarmCount>& builds) {
  const AlarmCount sum = sum_over_builds(builds);
  if (!mutation.unchanged_passes.value_or(true) || sum.alarms > 0) return records::PartVerdict::fails;
  return sum.runs < runs_without_alarm ? records::PartVerdict::inconclusive : records::PartVerdict::holds;
}

std::string alarm_evidence(const MutationResults& mutation, const std::vector<AlarmCount>& builds) {
  const AlarmCount sum = sum_over_builds(builds);
  const auto unchanged = !mutation.unchanged_passes   ? ""
                         : *mutation.unchanged_passes ? "; the campaign's tree passes"
                                                      : "; the campaign's tree does not pass";
  return fmt::format("{} in {} runs of {} build{}, other orders and places of the particles{}", sum.alarms, sum.runs,
                     builds.size(), builds.size() == 1 ? "" : "s", unchanged);
}

}  // namespace

records::StudyResult mutation_study(const std::optional<MutationResults>& mutation,
                                    const std::vector<AlarmCount>& alarms) {
  records::StudyResult study;
  study.name = "mutants";
  study.title = "Planted mistakes";
  study.kind = records::StudyKind::check;
  study.claims = {mutants_claim};
  if (!mutation || mutation->planted.should_show == 0) return study;
  const auto add = [&study](const std::string& statement, records::PartVerdict verdict, const std::string& evidence) {
    study.parts.push_back({mutants_claim, statement, verdict, evidence, ""});
  };
  add("tests and goldens catch every planted mistake that an order, an error, a limit or a report can show",
      catch_verdict(mutation->planted), catch_evidence(mutation->planted));
  add(fmt::format("they raise no false alarm (in {} runs of the quick gate)", runs_without_alarm),
      alarm_verdict(*mutation, alarms), alarm_evidence(*mutation, alarms));
  return study;
}

}  // namespace mpmvv::reports
