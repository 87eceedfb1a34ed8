#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mpmvv::reports {

/// A report's folder while the next report is made. That one is made in a folder of its own inside, and when it is
/// whole, its files take their places there, the page last: until then the old report stands as it was. Nothing else in
/// the folder is touched, so it may be a mount point, a link to a folder, or hold files that are not the report's.
class ReportPlace {
 public:
  /// Makes the folder where there is none, waits until no other process makes a report there, puts into its place what
  /// a process was killed over, and drops what another one left unfinished. Throws UsageError when that fails.
  ReportPlace(const std::filesystem::path& folder, const std::function<void(const std::string&)>& progress);
  ~ReportPlace();  ///< what has not taken its place is gone
  ReportPlace(const ReportPlace&) = delete;
  ReportPlace& operator=(const ReportPlace&) = delete;

  /// Where the next report is made; it holds the old one's files already (write none of them in place).
  const std::filesystem::path& draft() const { return draft_; }

  /// The draft becomes the report. Throws UsageError when it cannot.
  void take_place() const;

 private:
  void take_lock(const std::function<void(const std::string&)>& progress);
  void begin_draft() const;
  void put_into_place() const;
  void leave() const;

  std::filesystem::path folder_, draft_, whole_;
  std::vector<std::filesystem::path> made_;  ///< folders that were not there, the inmost first
  int lock_ = -1;
};

}  // namespace mpmvv::reports
