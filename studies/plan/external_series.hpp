#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "studies/codes/code.hpp"
#include "studies/plan/study.hpp"

/// Series that other codes run.
namespace mpmvv::plan {

/// Finds adapters and codes, each once.
class CodeFinder {
 public:
  /// `shipped`: the folder `adapters` that comes with the program; empty: there is none.
  explicit CodeFinder(std::filesystem::path shipped) : shipped_(std::move(shipped)) {}

  /// The adapter's file for a study in this folder: in its `adapters/`, among those that the study's own folder belongs
  /// to (`adapters/CODE/studies`), in `adapters/` here, else one that comes with the program. UsageError where there is
  /// none.
  std::filesystem::path adapter_file(const std::string& code, const std::filesystem::path& study_folder,
                                     const std::string& where) const;

  /// The files of all adapters, here and of the program, by code.
  std::vector<std::filesystem::path> adapter_files() const;

  /// Completes the settings of a case of another code: its variant, where there is only one; the version of the
  /// program; the digest of the adapter. UsageError without an adapter, for a variant that is unknown or missing, and
  /// for another version or adapter than the one found. Returns how to get the code where it is not there; else an
  /// empty text.
  std::string complete(std::vector<settings::Setting>& settings, const std::filesystem::path& study_folder);

  /// Completes the variant alone, of a code whose program need not be there, with the same errors.
  void complete_variant(std::vector<settings::Setting>& settings, const std::filesystem::path& study_folder);

  /// The codes that were found.
  const codes::Codes& codes() const { return codes_; }

 private:
  const codes::Adapter& adapter(const std::string& code, const std::filesystem::path& file, const std::string& where);

  std::filesystem::path shipped_;
  std::map<std::string, codes::Adapter> adapters_;  ///< by code
  codes::Codes codes_;
};

/// Completes all series of the study that other codes run; UsageError for a case that its code cannot run. Returns how
/// to get a code that is not there; an empty text when all are.
std::string complete_series(StudyPlan& plan, const std::filesystem::path& file, CodeFinder& finder);

}  // namespace mpmvv::plan
