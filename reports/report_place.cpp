#include "reports/report_place.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <sstream>
#include <string_view>
#include <system_error>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::reports {

using support::make_folder;

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> missing_folders(fs::path folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (folder = fs::absolute(folder).lexically_normal(); !fs::exists(folder, ignored); folder = folder.parent_path())
    missing.push_back(folder);
  return missing;
}

void remove_tree(const fs::path& tree) {
  std::error_code ignored;
  fs::remove_all(tree, ignored);
}

/// All files below the folder, relative to it: those in its subfolders first, and `index.html` at the very end.
std::vector<fs::path> files_in_order(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, ignored))
    if (entry.symlink_status(ignored).type() == fs::file_type::regular)
      files.push_back(entry.path().lexically_relative(folder));
  std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
    const auto place = [](const fs::path& file) { return file == "index.html" ? 2 : file.has_parent_path() ? 0 : 1; };
    return place(a) != place(b) ? place(a) < place(b) : a > b;
  });
  return files;
}

bool is_reports_own(const fs::path& file) {
  static constexpr std::array<std::string_view, 8> endings{".csv", ".dat", ".gp",  ".html",
                                                           ".js",  ".pdf", ".svg", ".tex"};
  return std::ranges::find(endings, file.extension().string()) != endings.end();
}

constexpr const char* list_name = ".report-files";
constexpr std::array pages{"index.html", "gate.html",    "trend.html", "benchmark.html",
                           "codes.html", "mutants.html", "style.css",  "report.js"};

std::set<fs::path> listed_files(const fs::path& folder) {
  std::set<fs::path> files;
  std::istringstream lines(support::read_file(folder / list_name).value_or(""));
  for (std::string line; std::getline(lines, line);) files.insert(line);
  return files;
}

/// The files that the report in `before` wrote and the one in `after` does not. Nothing outside the folder is among
/// them, even where the list was tampered with.
std::vector<fs::path> files_gone(const fs::path& before, const fs::path& after) {
  std::vector<fs::path> gone;
  const std::set<fs::path> kept = listed_files(after);
  if (kept.empty()) return gone;
  for (const fs::path& file : listed_files(before))
    if (!kept.contains(file) && file.is_relative() && std::ranges::find(file, "..") == file.end() &&
        is_reports_own(file))
      gone.push_back(file);
  return gone;
}

/// Makes a hard link to the file, or a copy of it where the file system has no hard links.
void carry_over(const fs::path& from, const fs::path& to) {
  make_folder(to.parent_path());
  std::error_code failed;
  fs::create_hard_link(from, to, failed);
  if (failed) fs::copy_file(from, to, failed);
}

bool is_same_folder(int descriptor, const fs::path& folder) {
  struct stat opened {
  }, named{};
  return fstat(descriptor, &opened) == 0 && stat(folder.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

}  // namespace

ReportPlace::ReportPlace(const fs::path& folder, const std::function<void(const std::string&)>& progress)
    : folder_(folder),
      draft_(folder / ".report-in-the-making"),
      whole_(folder / ".report-taking-its-place"),
      made_(missing_folders(folder)) {
  try {
    take_lock(progress);
    if (fs::is_directory(whole_)) put_into_place();
    require_own_pages();
    begin_draft();
  } catch (...) {
    leave();
    throw;
  }
}

ReportPlace::~ReportPlace() {
  leave();
}

/// Removes the draft, and the folders that were made for it if they are empty.
void ReportPlace::leave() const {
  if (lock_ >= 0) remove_tree(draft_);
  for (const auto& folder : made_) rmdir(folder.c_str());
  close(lock_);
}

void ReportPlace::take_lock(const std::function<void(const std::string&)>& progress) {
  while (true) {
    make_folder(folder_);
    lock_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_ < 0)
      throw support::UsageError(fmt::format("cannot read the folder {}; name another one", folder_.string()));
    if (flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      progress(fmt::format("waiting for the end of another report into {}", folder_.string()));
      while (flock(lock_, LOCK_EX) != 0 && errno == EINTR) continue;
    }
    if (is_same_folder(lock_, folder_)) return;
    close(lock_);
  }
}

void ReportPlace::require_own_pages() const {
  const std::string front = support::read_file(folder_ / "index.html").value_or("");
  if (fs::exists(folder_ / list_name) || front.find("<title>mpmvv: ") != std::string::npos) return;
  for (const char* page : pages)
    if (fs::exists(folder_ / page))
      throw support::UsageError(fmt::format(
          "{} is of no report and would be overwritten (another folder, or move it away)", (folder_ / page).string()));
}

void ReportPlace::begin_draft() const {
  remove_tree(draft_);
  make_folder(draft_);
  if (fs::is_regular_file(folder_ / list_name)) carry_over(folder_ / list_name, draft_ / list_name);
  for (const char* page : pages)
    if (fs::is_regular_file(folder_ / page)) carry_over(folder_ / page, draft_ / page);
  for (const char* part : {"claims", "figures", "points", "studies", "tables", "trends"}) {
    if (!fs::is_directory(folder_ / part)) continue;
    for (const auto& file : files_in_order(folder_ / part))
      if (is_reports_own(file)) carry_over(folder_ / part / file, draft_ / part / file);
  }
}

void ReportPlace::take_place(const std::set<fs::path>& files) const {
  std::string list;
  for (const fs::path& file : files) list += file.string() + '\n';
  support::write_if_changed(draft_ / list_name, list);
  for (const auto& file : files_in_order(draft_))
    if (fs::is_directory(folder_ / file))
      throw support::UsageError(
          fmt::format("{} is a folder where the report has a file (move it away)", (folder_ / file).string()));
  support::move_file(draft_, whole_);
  put_into_place();
}

void ReportPlace::put_into_place() const {
  for (const fs::path& file : files_gone(folder_, whole_))
    for (const fs::path& place : {whole_, folder_}) {
      std::error_code ignored;
      if (fs::symlink_status(place / file, ignored).type() == fs::file_type::regular) fs::remove(place / file, ignored);
    }
  for (const auto& file : files_in_order(whole_)) {
    make_folder((folder_ / file).parent_path());
    support::move_file(whole_ / file, folder_ / file);
  }
  remove_tree(whole_);
}

}  // namespace mpmvv::reports
