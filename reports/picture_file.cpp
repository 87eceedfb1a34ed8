#include "reports/picture_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "reports/plot.hpp"
#include "reports/text.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::reports {

namespace fs = std::filesystem;

namespace {

/// The folder for temporary files. The system takes the first of these variables that is set, else /tmp.
fs::path temporary_place() {
  std::error_code failed;
  fs::path place = fs::temp_directory_path(failed);
  if (!failed) return place;
  for (const char* variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"})
    if (const char* named = std::getenv(variable))
      throw support::UsageError(
          fmt::format("{} is '{}', which is no folder (one that is there and can be written)", variable, named));
  throw support::UsageError("/tmp is no folder (TMPDIR names one that is there and can be written)");
}

/// A temporary folder for drawing, removed at the end.
class Scratch {
 public:
  Scratch() : path_((temporary_place() / "mpmvv-figure-XXXXXX").string()) {
    if (!mkdtemp(path_.data()))
      throw support::UsageError("cannot make " + path_ + " (" + std::strerror(errno) +
                                "); name a folder that can be written in TMPDIR");
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  fs::path path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

std::vector<fs::path> picture_files(const fs::path& file, Format format) {
  if (format != Format::tex) return {file};
  return {file, file.parent_path() / (file.stem().string() + "-lines" + ending_of(Format::pdf))};
}

void draw_picture(const Chart& chart, const Sheet& sheet, const fs::path& file) {
  const Scratch scratch;
  const Plot plot = plot_of(chart, sheet);
  draw({plot}, scratch.path());
  const auto files = picture_files(file, sheet.format);
  for (std::size_t i = files.size(); i-- > 0;) {
    std::string picture = support::require_file(scratch.path() / (plot.name + plot.endings[i]), "a picture");
    if (plot.endings[i] == ending_of(Format::tex))
      picture = replace_all(picture, "{" + latex_file(plot.name) + "}", "{" + latex_file(files[1].stem()) + "}");
    support::write_if_changed(files[i], picture);
  }
}

}  // namespace mpmvv::reports
