#include "reports/plot.hpp"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "studies/error.hpp"
#include "studies/file.hpp"
#include "studies/process.hpp"

namespace mpmvv {

namespace fs = std::filesystem;

namespace {

constexpr const char* advice = "install it with: apt-get install gnuplot-nox";

fs::path script_file(const fs::path& folder, const Plot& plot) {
  return folder / (plot.name + ".gp");
}

/// A script under this name has not been drawn yet, so a run that was cut off is taken up again.
fs::path pending_script_file(const fs::path& folder, const Plot& plot) {
  return folder / (plot.name + ".gp.part");
}

bool has_pictures(const fs::path& folder, const Plot& plot) {
  for (const char* ending : {".svg", ".pdf"}) {
    std::error_code absent;
    const auto size = fs::file_size(folder / (plot.name + ending), absent);
    if (absent || size == 0) return false;
  }
  return true;
}

bool is_drawn(const fs::path& folder, const Plot& plot) {
  return has_pictures(folder, plot) && read_file(script_file(folder, plot)) == plot.script &&
         read_file(folder / (plot.name + ".dat")) == plot.data;
}

void write_sources(const fs::path& folder, const Plot& plot) {
  for (const char* ending : {".gp", ".svg", ".pdf"}) {
    std::error_code ignored;
    fs::remove(folder / (plot.name + ending), ignored);
  }
  write_if_changed(folder / (plot.name + ".dat"), plot.data);
  const auto file = pending_script_file(folder, plot);
  const auto refuse = [&] {
    throw UsageError(fmt::format("cannot write {}; name a folder that can be written", file.string()));
  };
  try {
    Gnuplot out(">" + file.string());
    out << plot.script << std::flush;
    if (!out) refuse();
  } catch (const std::ios_base::failure&) {
    refuse();
  }
}

std::string last_line(const std::string& text) {
  const auto end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return "it said nothing";
  const auto start = text.find_last_of("\r\n", end);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     end - (start == std::string::npos ? std::string::npos : start));
}

std::string what_went_wrong(const ProcessEnd& end, std::chrono::milliseconds limit) {
  if (end.start_error == ENOENT) return fmt::format("gnuplot is not on the PATH; {}", advice);
  if (end.start_error != 0)
    return fmt::format("gnuplot cannot be started: {}; {}", std::strerror(end.start_error), advice);
  if (end.timed_out)
    return fmt::format("gnuplot was still running after {} s and was stopped",
                       static_cast<double>(limit.count()) / 1000);
  if (end.exit_code != 0) return fmt::format("gnuplot ended with code {}: {}", end.exit_code, last_line(end.output));
  return fmt::format("gnuplot left a picture out: {}; it needs the terminals svg and pdfcairo ({})",
                     last_line(end.output), advice);
}

}  // namespace

namespace {

/// cairo 1.16 writes the time into a PDF and knows no SOURCE_DATE_EPOCH: one fixed time, digit for digit in place.
void fix_creation_date(const fs::path& pdf) {
  const std::string key = "/CreationDate (D:", date = "19700101000000";
  std::fstream file(pdf, std::ios::in | std::ios::out | std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto place = text.rfind(key);
  if (place == std::string::npos) return;
  file.seekp(static_cast<std::streamoff>(place + key.size()));
  file << date;
}

}  // namespace

int draw(const std::vector<Plot>& plots, const fs::path& folder, std::chrono::milliseconds limit) {
  std::vector<const Plot*> changed;
  std::vector<std::string> command{"gnuplot", "-d"};
  for (const auto& plot : plots) {
    if (is_drawn(folder, plot)) continue;
    write_sources(folder, plot);
    changed.push_back(&plot);
    command.push_back(pending_script_file("", plot).string());
  }
  if (changed.empty()) return 0;

  const std::map<std::string, std::string> environment{{"LC_ALL", "C.UTF-8"}};
  const auto end = run_process(command, folder, environment, limit);
  auto culprit = std::ranges::find_if_not(changed, [&](const Plot* p) { return has_pictures(folder, *p); });
  if (culprit == changed.end() && !end.good()) --culprit;
  if (culprit != changed.end())
    throw UsageError(fmt::format("cannot draw figure '{}': {}", (*culprit)->name, what_went_wrong(end, limit)));
  for (const auto* plot : changed) fix_creation_date(folder / (plot->name + ".pdf"));
  for (const auto* plot : changed) fs::rename(pending_script_file(folder, *plot), script_file(folder, *plot));
  return static_cast<int>(changed.size());
}

}  // namespace mpmvv
