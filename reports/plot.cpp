#include "reports/plot.hpp"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <system_error>

#include "reports/text.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/process.hpp"

namespace mpmvv::reports {

using support::read_file;

namespace fs = std::filesystem;

namespace {

constexpr const char* advice = "install it with: apt-get install gnuplot-nox";

/// The only variables of the caller's environment that gnuplot sees, so that no terminal, language or search path of
/// its own changes a picture.
const std::set<std::string> kept_variables{"HOME", "LD_LIBRARY_PATH", "PATH", "TMPDIR"};

fs::path script_file(const fs::path& folder, const Plot& plot) {
  return folder / (plot.name + ".gp");
}

/// A script under this name has not been drawn yet, so a run that was cut off is taken up again.
fs::path pending_script_file(const fs::path& folder, const Plot& plot) {
  return folder / (plot.name + ".gp.part");
}

/// What a whole picture ends with.
std::string last_words(const std::string& ending) {
  return ending == ".svg" ? "</svg>" : ending == ".pdf" ? "%%EOF" : "\\endgroup";
}

/// Whether the pictures are complete: on a full disk gnuplot cuts them off without a message.
bool has_pictures(const fs::path& folder, const Plot& plot) {
  return std::ranges::all_of(plot.endings, [&](const std::string& ending) {
    const std::string text = read_file(folder / (plot.name + ending)).value_or("");
    return text.find(last_words(ending), text.size() - std::min<std::size_t>(text.size(), 16)) != std::string::npos;
  });
}

bool is_drawn(const fs::path& folder, const Plot& plot) {
  return has_pictures(folder, plot) && read_file(script_file(folder, plot)) == plot.script &&
         read_file(folder / (plot.name + ".dat")) == plot.data;
}

void write_sources(const fs::path& folder, const Plot& plot) {
  std::error_code ignored;
  fs::remove(script_file(folder, plot), ignored);
  for (const auto& ending : plot.endings) fs::remove(folder / (plot.name + ending), ignored);
  support::write_if_changed(folder / (plot.name + ".dat"), plot.data);
  const auto file = pending_script_file(folder, plot);
  const auto refuse = [&] {
    throw support::UsageError(
        fmt::format("cannot write {} ({}); name a folder that can be written", file.string(), std::strerror(errno)));
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

/// Throws when the folder takes no more, as on a full disk.
void require_room(const fs::path& picture) {
  constexpr std::size_t more_than_a_picture = 1 << 20;
  support::write_if_changed(picture, std::string(more_than_a_picture, ' '));
  std::error_code ignored;
  fs::remove(picture, ignored);
}

std::string why_not_started(int error) {
  if (error == ENOENT) return fmt::format("gnuplot is not on the PATH; {}", advice);
  const bool busy = error == EAGAIN || error == ENOMEM || error == EMFILE || error == ENFILE;
  return fmt::format("gnuplot cannot be started: {} ({})", std::strerror(error),
                     busy ? "call again when less runs on this machine"
                          : "the gnuplot that comes first on the PATH has to be a program");
}

std::string what_went_wrong(const support::ProcessEnd& end, std::chrono::milliseconds limit) {
  if (end.start_error != 0) return why_not_started(end.start_error);
  if (end.timed_out)
    return fmt::format("gnuplot was still running after {} s and was stopped",
                       static_cast<double>(limit.count()) / 1000);
  const std::string said = last_line(end.output);
  const std::string what =
      end.exit_code == 0 ? "gnuplot left a picture out" : fmt::format("gnuplot ended with code {}", end.exit_code);
  const bool lacks_terminal = said.find("terminal") != std::string::npos;
  return fmt::format(
      "{}: {}{}", what, said,
      lacks_terminal ? fmt::format("; it needs the terminals svg, pdfcairo and cairolatex ({})", advice) : "");
}

/// Replaces, digit for digit, the time that cairo 1.16 writes into a PDF (it knows no SOURCE_DATE_EPOCH) by a fixed
/// one, so that the same picture is the same file. Cairo 1.18 compresses it, so there the date stays.
void fix_creation_date(const fs::path& pdf) {
  const std::string key = "/CreationDate (D:", date = "19700101000000";
  std::fstream file(pdf, std::ios::in | std::ios::out | std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto place = text.rfind(key);
  if (place == std::string::npos) return;
  file.seekp(static_cast<std::streamoff>(place + key.size()));
  file << date;
}

/// Escapes `]]>`, which may not stand in a text of XML; gnuplot does not escape it.
void close_no_section(const fs::path& svg) {
  support::write_if_changed(svg, replace_all(read_file(svg).value_or(""), "]]>", "]]&gt;"));
}

/// Escapes tildes in the name of the picture that a text takes in: for LaTeX a tilde is a space.
void keep_tildes(const fs::path& tex) {
  const std::string name = "{" + tex.stem().string() + "}";
  support::write_if_changed(tex, replace_all(read_file(tex).value_or(""), name, replace_all(name, "~", "\\string~")));
}

void mend(const fs::path& picture) {
  if (picture.extension() == ".pdf") fix_creation_date(picture);
  if (picture.extension() == ".svg") close_no_section(picture);
  if (picture.extension() == ".tex") keep_tildes(picture);
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

  limit *= static_cast<int>((changed.size() + 9) / 10);
  const auto end = support::run_process(command, folder, {{"LC_ALL", "C.UTF-8"}}, limit, kept_variables);
  auto culprit = std::ranges::find_if_not(changed, [&](const Plot* p) { return has_pictures(folder, *p); });
  if (culprit == changed.end() && !end.good()) --culprit;
  if (culprit != changed.end()) {
    require_room(folder / ((*culprit)->name + (*culprit)->endings.front()));
    throw support::UsageError(
        fmt::format("cannot draw figure '{}': {}", (*culprit)->name, what_went_wrong(end, limit)));
  }
  for (const auto* plot : changed) {
    for (const auto& ending : plot->endings) mend(folder / (plot->name + ending));
    support::move_file(pending_script_file(folder, *plot), script_file(folder, *plot));
  }
  return static_cast<int>(changed.size());
}

}  // namespace mpmvv::reports
