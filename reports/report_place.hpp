#pragma once
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace mpmvv::reports {

/// A report's folder while the next report is made. The new report is written to a draft folder inside it; when it is
/// complete its files are moved to their places, the page last. Until then the old report stays as it was. What it
/// wrote and the new one does not is removed; a list in the folder, .report-files, says what that is. Other files are
/// not touched, and the folder may be a mount point or a link.
class ReportPlace {
 public:
  /// Makes the folder if it is absent, and waits until no other process makes a report there. A report that was whole
  /// when its process was killed is moved to its place, an unfinished draft is deleted. Throws UsageError on failure,
  /// and where a page would take the place of one that is no report's.
  ReportPlace(const std::filesystem::path& folder, const std::function<void(const std::string&)>& progress);
  ~ReportPlace();  ///< deletes a draft that was not published
  ReportPlace(const ReportPlace&) = delete;
  ReportPlace& operator=(const ReportPlace&) = delete;

  /// Where the next report is made; it holds the old one's files already (write none of them in place).
  const std::filesystem::path& draft() const { return draft_; }

  /// The draft becomes the report, which is made of these files. Throws UsageError when it cannot.
  void take_place(const std::set<std::filesystem::path>& files) const;

 private:
  void take_lock(const std::function<void(const std::string&)>& progress);
  void require_own_pages() const;
  void begin_draft() const;
  void put_into_place() const;
  void leave() const;

  std::filesystem::path folder_, draft_, whole_;
  std::vector<std::filesystem::path> made_;  ///< folders that were not there, the inmost first
  int lock_ = -1;
};

}  // namespace mpmvv::reports
