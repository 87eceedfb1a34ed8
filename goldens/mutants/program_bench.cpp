#include "goldens/mutants/program_bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "studies/support/error.hpp"

namespace mpmvv {

using support::ProcessEnd;
using support::UsageError;

namespace fs = std::filesystem;
using std::chrono::seconds;

namespace {

constexpr seconds build_limit = std::chrono::hours(6);
constexpr seconds gate_limit = std::chrono::hours(1);
constexpr int out_of_time = 128 + SIGXCPU;

/// A command that gets so much of the processors, whatever else they do, and not all the memory that it may ask for.
std::vector<std::string> confined_command(seconds limit, const std::vector<std::string>& command) {
  std::vector<std::string> confined{"prlimit", "--as=8589934592",
                                    fmt::format("--cpu={}:{}", limit.count(), limit.count() + 10)};
  confined.insert(confined.end(), command.begin(), command.end());
  return confined;
}

/// Far too large for every mutant.
const std::vector<std::string> cubes{"s-fig12"};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string how_it_ended(const ProcessEnd& end, seconds limit) {
  if (end.timed_out || end.exit_code == out_of_time) return fmt::format("not at its end after {} s", limit.count());
  return end.exit_code > 128 ? fmt::format("ended by signal {}", end.exit_code - 128)
                             : fmt::format("exit code {}", end.exit_code);
}

std::string last_lines(const std::string& output) {
  constexpr std::size_t most = 2000;
  return output.substr(output.size() > most ? output.size() - most : 0);
}

/// What stands behind the mark up to the next space or comma.
std::string word_behind(const std::string& text, std::size_t mark, std::size_t length) {
  const std::size_t begin = mark + length;
  return text.substr(begin, text.find_first_of(" ,\n", begin) - begin);
}

/// Studies with goldens, by the goldens' files.
std::vector<std::string> studies_with_goldens(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const fs::path file : files)
    if (file.parent_path() == "goldens" && file.extension() == ".toml") names.push_back(file.stem().string());
  return names;
}

}  // namespace

std::vector<std::string> program_parts() {
  return {".github", "CMakeLists.txt", "CMakePresets.json", "README.md", "cli",
          "cmake",   "docs",           "goldens",           "mms",       "reports",
          "run",     "solver",         "studies",           "tests"};
}

std::string gate_version(const Laboratory& laboratory) {
  const auto decides = [](const std::string& file) {
    constexpr std::array indifferent{".github",
                                     "README.md",
                                     "cli",
                                     "docs",
                                     "goldens/mutants",
                                     "goldens/cost.cpp",
                                     "goldens/cost.hpp",
                                     "run",
                                     "studies/cost.txt",
                                     "tests/benchmark"};
    return std::ranges::none_of(indifferent, [&](const char* part) { return is_within(file, part); });
  };
  const auto expects = [](const std::string& file) {
    return is_within(file, "reports") || is_within(file, "tests") || file.ends_with(".toml") ||
           file == "studies/quick.txt";
  };
  const auto digest = [&](bool expecting) {
    return laboratory.digest([&](const std::string& file) { return decides(file) && expects(file) == expecting; });
  };
  return digest(false) + "/" + digest(true);
}

std::vector<std::string> listed_studies(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    if (std::string name; words >> name) names.push_back(fs::path(name).stem().string());
  }
  return names;
}

std::vector<std::string> test_programs(const std::string& file) {
  if (file.starts_with("mms/")) return {"test_cli", "test_mms", "test_studies", "test_solver"};
  if (file.starts_with("solver/")) return {"test_cli", "test_studies", "test_solver"};
  if (file.starts_with("reports/")) return {"test_reports", "test_cli"};
  return {"test_cli", "test_goldens", "test_reports", "test_mms", "test_studies", "test_solver"};
}

std::set<int> choices_named(const std::string& output, const std::map<std::string, std::vector<ChoicePlace>>& places) {
  static const std::regex line_of_file(R"(([\w./-]+):(\d+):.*)");
  std::set<int> edited, both;
  for (std::sregex_iterator found(output.begin(), output.end(), line_of_file), end; found != end; ++found) {
    const std::string path = fs::path((*found)[1].str()).lexically_normal().string();
    const int line = std::stoi((*found)[2].str());
    for (const auto& [file, of_file] : places)
      if (path == file || path.ends_with("/" + file))
        for (const ChoicePlace& place : of_file) {
          if (place.first_line <= line && line <= place.last_line) edited.insert(place.number);
          if (place.first_line <= line && line <= place.last_line_of_both) both.insert(place.number);
        }
  }
  return edited.empty() ? both : edited;
}

std::string failed_test(const std::string& output) {
  constexpr std::string_view failed = "[  FAILED  ] ", running = "[ RUN      ] ";
  if (const auto mark = output.find(failed); mark != std::string::npos) return word_behind(output, mark, failed.size());
  const auto mark = output.rfind(running);
  return mark == std::string::npos ? "before the first test" : word_behind(output, mark, running.size());
}

std::vector<std::string> goldens_not_passed(const std::string& json) {
  std::vector<std::string> names;
  const auto report = nlohmann::json::parse(json, nullptr, false);
  if (report.is_discarded()) return {"the gate prints no JSON"};
  for (const auto& result : report.at("results")) {
    const std::string verdict = result.at("verdict");
    if (verdict != "pass")
      names.push_back(fmt::format("{}: {}{}", result.at("study").get<std::string>(),
                                  result.at("name").get<std::string>(), verdict == "fail" ? "" : " (" + verdict + ")"));
  }
  std::stable_partition(names.begin(), names.end(), std::not_fn(is_inconclusive));
  return names;
}

Trial first_catch(GateStage stage, const std::vector<std::string>& studies,
                  const std::function<std::vector<std::string>(const std::string& study)>& complaints_of) {
  Trial trial{.stage = stage};
  for (const std::string& study : studies) {
    const auto complaints = complaints_of(study);
    const bool decides = !std::ranges::all_of(complaints, is_inconclusive);
    if (trial.by.empty() || decides) trial.by = complaints;
    if (decides) break;
  }
  trial.caught = !trial.by.empty();
  return trial;
}

ProgramBench::ProgramBench(Laboratory& laboratory, int jobs)
    : laboratory_(laboratory), jobs_(jobs), quick_(listed_studies(laboratory.text("studies/quick.txt"))) {
  const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
  };
  for (const std::string& name : studies_with_goldens(laboratory.files()))
    if (!is_in(quick_, name) && !is_in(cubes, name)) nightly_.push_back(name);
}

void ProgramBench::configure() const {
  if (fs::exists(laboratory_.build() / "build.ninja")) return;
  const ProcessEnd end = laboratory_.run(
      {"cmake", "--preset", "mutants", "-B", laboratory_.build().string(), "--log-level=WARNING"}, build_limit);
  if (!end.good())
    throw UsageError(fmt::format("cmake cannot configure {}: {}", laboratory_.tree().string(), end.output));
}

ProcessEnd ProgramBench::make(const std::vector<std::string>& targets) const {
  std::vector<std::string> command{
      "cmake", "--build", laboratory_.build().string(), "--parallel", std::to_string(jobs_), "--target"};
  command.insert(command.end(), targets.begin(), targets.end());
  return laboratory_.run(command, build_limit);
}

/// A compiler that ends without having found an error has told nothing of the mutant.
bool ProgramBench::compiles(const std::string& target) {
  const ProcessEnd end = make({target});
  if (end.good()) return true;
  complaint_ = last_lines(end.output);
  const bool is_error = end.output.find(" error: ") != std::string::npos;
  const bool is_killed = end.output.find("Killed signal") != std::string::npos;
  if (!is_error || is_killed)
    throw UsageError(fmt::format("cannot build {}: {} (memory and disk for a compiler)", target, complaint_));
  return false;
}

bool ProgramBench::build(const Edit* edit) {
  tests_ = test_programs(edit ? edit->file : "");
  chosen_ = 0;
  is_edited_ = edit != nullptr;
  if (edit)
    laboratory_.apply(*edit);
  else
    laboratory_.undo();
  configure();
  return compiles("mpmvv");
}

std::vector<int> ProgramBench::build(const std::vector<Choice>& choices) {
  std::map<std::string, std::vector<Choice>> by_file;
  for (const Choice& choice : choices) by_file[choice.edit.file].push_back(choice);
  std::map<std::string, std::string> texts{{choice_header, choice_header_text()}};
  std::map<std::string, std::vector<ChoicePlace>> places;
  std::vector<int> numbers;
  for (const auto& [file, of_file] : by_file) {
    SideBySide both = side_by_side(laboratory_.text(file), of_file);
    if (both.places.empty()) continue;
    for (const ChoicePlace& place : both.places) numbers.push_back(place.number);
    texts[file] = std::move(both.text);
    places[file] = std::move(both.places);
  }
  if (numbers.empty()) return {};
  laboratory_.apply(texts);
  configure();
  std::vector<std::string> targets = test_programs("");
  targets.insert(targets.begin(), "mpmvv");
  const ProcessEnd end = make(targets);
  if (end.good()) return numbers;
  complaint_ = last_lines(end.output);
  const std::set<int> bad = choices_named(end.output, places);
  if (bad.empty()) return {};
  std::vector<Choice> left = choices;
  std::erase_if(left, [&](const Choice& choice) { return bad.contains(choice.number); });
  return build(left);
}

void ProgramBench::choose(const Choice* choice) {
  tests_ = test_programs(choice ? choice->edit.file : "");
  chosen_ = choice ? choice->number : 0;
  is_edited_ = choice != nullptr;
}

Trial ProgramBench::meet(GateStage stage, seconds limit) {
  const auto start = std::chrono::steady_clock::now();
  Trial trial = stage == GateStage::unit_tests ? run_unit_tests(limit)
                : stage == GateStage::quick    ? run_gate(stage, quick_, limit)
                                               : run_gate(stage, nightly_, limit);
  trial.seconds = seconds_since(start);
  return trial;
}

ProcessEnd ProgramBench::run(const std::vector<std::string>& command, seconds limit) const {
  return laboratory_.run(command, limit, {{choice_variable, std::to_string(chosen_)}});
}

seconds ProgramBench::limit_of(const std::string& name, seconds stage_limit) const {
  const auto usual = usual_.find(name);
  if (!is_edited_ || usual == usual_.end()) return stage_limit;
  return std::min(stage_limit, seconds(std::lround(30 + 5 * usual->second)));
}

/// Of what waits for ever, instead of working, the processors see nothing.
ProcessEnd ProgramBench::run_confined(const std::string& name, const std::vector<std::string>& command, seconds limit) {
  const auto start = std::chrono::steady_clock::now();
  const ProcessEnd end = run(confined_command(jobs_ * limit, command), 20 * limit);
  if (!is_edited_ && end.good()) usual_[name] = seconds_since(start);
  return end;
}

/// Test programs are built one by one: most mistakes need no more than the first.
Trial ProgramBench::run_unit_tests(seconds stage_limit) {
  Trial trial{.stage = GateStage::unit_tests};
  for (const std::string& test : tests_) {
    if (!compiles(test)) {
      trial.caught = true;
      trial.by = {test + ": does not compile"};
      return trial;
    }
    const seconds limit = limit_of(test, stage_limit);
    const ProcessEnd end = run_confined(
        test, {program(test), "--gtest_fail_fast", "--gtest_color=no", "--gtest_filter=-*Nightly*:PlantedMistakes.*"},
        limit);
    if (end.good()) continue;
    trial.caught = true;
    const std::string ending =
        end.exit_code == 1 && !end.timed_out ? "" : fmt::format(" ({})", how_it_ended(end, limit));
    trial.by = {fmt::format("{}: {}{}", test, failed_test(end.output), ending)};
    return trial;
  }
  return trial;
}

Trial ProgramBench::run_gate(GateStage stage, const std::vector<std::string>& studies, seconds stage_limit) {
  const std::string db = (laboratory_.build() / (to_string(stage) + ".db")).string();
  fs::remove(db);
  fs::remove(db + "-journal");
  return first_catch(stage, studies, [&](const std::string& study) { return complaints_of(study, db, stage_limit); });
}

std::vector<std::string> ProgramBench::complaints_of(const std::string& study, const std::string& db,
                                                     seconds stage_limit) {
  const seconds limit = limit_of(study, stage_limit);
  const ProcessEnd ran = run_confined(
      study,
      {program("mpmvv"), "study", "--db", db, "--jobs", std::to_string(jobs_), fmt::format("studies/{}.toml", study)},
      limit);
  const std::string ending = fmt::format("{}: {}", study, how_it_ended(ran, limit));
  if (ran.timed_out || ran.exit_code > 1) return {ending};
  const ProcessEnd judged = run({program("mpmvv"), "gate", "--db", db, "--json", "--only", study}, gate_limit);
  if (ran.good() && judged.good()) return {};
  const auto goldens = goldens_not_passed(judged.output);
  return goldens.empty() ? std::vector{ending} : goldens;
}

}  // namespace mpmvv
