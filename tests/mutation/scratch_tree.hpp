#pragma once
#include <boost/interprocess/sync/file_lock.hpp>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/support/process.hpp"
#include "tests/mutation/edit.hpp"

namespace mpmvv::mutation {

/// Whether a file is this part of a tree (a file or a folder) or lies in it.
bool is_within(const std::string& file, const std::string& part);

/// A scratch copy of a source tree that is changed in one way at a time, with a folder in it to build it in: a program
/// finds what the tree ships from where it was built. The tree itself is only read, and only at the start.
class ScratchTree {
 public:
  /// Brings WORK/tree in line with these parts (files and folders) of the source, whatever an earlier run has left
  /// there. WORK is absent, empty, or a folder that this has made and marked: UsageError, with nothing touched, when it
  /// is anything else, holds the source or links, lies within a part, or a part is not there; also when another process
  /// works there.
  ScratchTree(const std::filesystem::path& source, const std::filesystem::path& work,
              const std::vector<std::string>& parts);

  const std::vector<std::string>& files() const { return files_; }  ///< of the copy, sorted, from its top
  std::string text(const std::string& file) const;                  ///< without any edit
  std::filesystem::path tree() const { return work_ / "tree"; }
  std::filesystem::path build() const { return builds() / "mutants"; }

  /// A digest of the files that are wanted, without any edit. Of C++ files it is that of their code: comments, empty
  /// lines and indentation do not change it.
  std::string digest(const std::function<bool(const std::string& file)>& is_wanted) const;

  void apply(const Edit& edit);  ///< replaces the change before
  /// Gives files, by their names, other texts; this replaces the change before. A file that the tree does not have is
  /// new.
  void apply(const std::map<std::string, std::string>& texts);
  void undo();

  /// Runs a command in the copy's top, with these environment variables, until `stop` asks for its end.
  support::ProcessEnd run(const std::vector<std::string>& command, std::chrono::seconds limit,
                          const std::map<std::string, std::string>& environment = {},
                          const std::stop_token& stop = {}) const;

 private:
  using Originals = std::map<std::string, std::optional<std::string>>;  ///< texts by file; none for a new file

  void restore(const std::string& file, const std::optional<std::string>& original) const;
  void lock();
  void copy(const std::filesystem::path& source, const std::string& part);
  void remove_strays() const;
  std::filesystem::path builds() const { return tree() / "build"; }
  std::vector<std::filesystem::path> copied() const;  ///< what lies in the copy, but for what is built

  std::filesystem::path work_;
  boost::interprocess::file_lock lock_;
  std::vector<std::string> files_;
  Originals originals_;  ///< of the files that are changed
};

}  // namespace mpmvv::mutation
