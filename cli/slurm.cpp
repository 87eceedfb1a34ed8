#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/engines.hpp"
#include "studies/support/shell.hpp"

namespace mpmvv::cli {

using support::shell_quoted;

namespace {

/// The script of a shard. Its log says what ended it; its store keeps what it has finished.
constexpr const char* shard_body = R"sh(
i=$SLURM_ARRAY_TASK_ID
rm -f "$folder/shard-$i.done"
cd "$place" || exit
code=0
"$program" study "${studies[@]}" --shard "$i/$shards" "${costs[@]}" --db "$folder/shard-$i.db" --jobs "$jobs" || code=$?
# 0 and 1: all of it is recorded, some of it as failed.
((code > 1)) || touch "$folder/shard-$i.done"
exit "$code"
)sh";

constexpr const char* merge_body = R"sh(
missing=() stores=()
for ((i = 1; i <= shards; ++i)); do
  stores+=("$folder/shard-$i.db")
  [[ -e $folder/shard-$i.done ]] || missing+=("$i")
done
if ((${#missing[@]})); then
  list=$(IFS=,; echo "${missing[*]}")
  echo "missing: shards $list of $shards (why: $folder/shard-NUMBER.log); nothing is merged"
  echo "again, each from where it was: '$folder/submit.sh' $list"
  exit 1
fi
cd "$place" || exit
status=0
step() {
  local code=0
  "$@" || code=$?
  ((status)) || status=$code
}
"$program" db merge "${stores[@]}" --db "$db" || exit
step "$program" study "${studies[@]}" --db "$db" --jobs "$jobs" --no-retry
((${#gated[@]} == 0)) || step "$program" gate --db "$db" "${gated[@]}" "${goldens[@]}"
step "$program" report --db "$db" --out "$folder/report" "${goldens[@]}"
exit "$status"
)sh";

constexpr const char* submit_body = R"sh(
set -euo pipefail
# Prints the number of the job that is queued.
queue() {
  local answer
  answer=$(sbatch --parsable "$@") || return
  if [[ ! $answer =~ ^([0-9]+)(\;[^[:space:]]*)?$ ]]; then
    echo "error: sbatch --parsable answers '$answer' (a job's number; squeue --me lists what is queued)" >&2
    return 1
  fi
  echo "${BASH_REMATCH[1]}"
}
(($#)) || rm -f "$folder"/shard-*.done
array=$(queue --array="${1:-1-$shards}" "$folder/shard.sh")
echo "shards ${1:-1-$shards}: job $array"
merge=$(queue --dependency="afterany:$array" "$folder/merge.sh") || {
  echo "error: job $array is queued without its merge (before the next try: scancel $array)" >&2
  exit 1
}
echo "merge, gate and report: job $merge, $folder/merge.log"
)sh";

std::string list(const std::string& option, const std::vector<std::string>& values) {
  std::vector<std::string> words;
  for (const std::string& value : values) {
    if (!option.empty()) words.push_back(option);
    words.push_back(shell_quoted(value));
  }
  return fmt::format("({})", fmt::join(words, " "));
}

/// An option with a value that may be absent.
std::string list(const std::string& option, const std::string& value) {
  return value.empty() ? "()" : list(option, std::vector{value});
}

std::string directives(const Submission& s, const char* name, const char* log, std::size_t minutes,
                       std::size_t megabytes) {
  std::vector<std::string> all{fmt::format("job-name=mpmvv-{}", name),
                               fmt::format("output=\"{}/{}\"", s.folder.string(), log),
                               "open-mode=append",
                               "ntasks=1",
                               fmt::format("cpus-per-task={}", s.jobs),
                               fmt::format("time={}", minutes),
                               fmt::format("mem={}M", megabytes)};
  if (!s.partition.empty()) all.push_back("partition=" + s.partition);
  if (!s.account.empty()) all.push_back("account=" + s.account);
  std::string lines = "#!/bin/bash\n";
  for (const std::string& option : all) lines += fmt::format("#SBATCH --{}\n", option);
  for (const std::string& option : s.options) lines += fmt::format("#SBATCH {}\n", option);
  return lines;
}

std::string variables(const Submission& s) {
  return fmt::format(
      "program={}\nplace={}\nfolder={}\ndb={}\nstudies={}\ncosts={}\ngated={}\ngoldens={}\nshards={}\njobs={}\n",
      shell_quoted(s.program), shell_quoted(s.place), shell_quoted(s.folder), shell_quoted(s.db), list("", s.files),
      list("--costs", s.costs), list("--only", s.gated), list("--goldens", s.goldens), s.shards, s.jobs);
}

}  // namespace

std::vector<Script> slurm_scripts(const Submission& s) {
  constexpr std::size_t merge_minutes = 120, merge_megabytes = 4096;
  const std::string alone = s.alone ? "#SBATCH --exclusive\n" : "";
  return {
      {"shard.sh", directives(s, "shard", "shard-%a.log", s.minutes, s.megabytes) + alone + variables(s) + shard_body},
      {"merge.sh", directives(s, "merge", "merge.log", merge_minutes, merge_megabytes) + variables(s) + merge_body},
      {"submit.sh", "#!/bin/bash\n" + variables(s) + submit_body}};
}

}  // namespace mpmvv::cli
