#include "tests/mutation/gate_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>

#include "tests/mutation/bench.hpp"

namespace mpmvv::mutation {

namespace fs = std::filesystem;

namespace {

/// What stands behind the mark up to the next space or comma.
std::string word_behind(const std::string& text, std::size_t mark, std::size_t length) {
  const std::size_t begin = mark + length;
  return text.substr(begin, text.find_first_of(" ,\n", begin) - begin);
}

struct LineOfFile {
  std::string path;
  int number = 0;
};

/// What the text first names as "path:number:".
std::optional<LineOfFile> line_named(std::string_view text) {
  constexpr std::string_view of_paths = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./-";
  for (auto colon = text.find(':'); colon != std::string_view::npos; colon = text.find(':', colon + 1)) {
    const std::string_view before = text.substr(0, colon), path = before.substr(before.find_last_not_of(of_paths) + 1);
    const char* const last = text.data() + text.size();
    int number = 0;
    const auto [end, error] = std::from_chars(text.data() + colon + 1, last, number);
    if (!path.empty() && error == std::errc() && end != last && *end == ':')
      return LineOfFile{fs::path(path).lexically_normal().string(), number};
  }
  return std::nullopt;
}

}  // namespace

std::set<int> choices_named(const std::string& output, const std::map<std::string, std::vector<ChoicePlace>>& places) {
  std::set<int> edited, both;
  std::istringstream lines(output);
  for (std::string text; std::getline(lines, text);) {
    const auto named = line_named(text);
    if (!named) continue;
    const auto& [path, line] = *named;
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

}  // namespace mpmvv::mutation
