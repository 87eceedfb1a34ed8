#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tests/mutation/edit.hpp"
#include "tests/mutation/mutant.hpp"

namespace mpmvv::mutation {

/// A realistic mistake that someone has chosen: a piece of code, and what stands there with the mistake. Other code may
/// change its name, its place or its layout without touching it.
struct Mistake {
  std::string name = {};                ///< kebab-case
  std::string what = {};                ///< one sentence in the field's words
  std::string file = {};                ///< name of a source, with as much of its path as makes it the only one
  std::string function = {};            ///< function or class that holds the code; empty where the file has it once
  std::string find = {}, replace = {};  ///< code, by its tokens; the text that takes its place
  std::string reason = {};  ///< why it is equivalent: no order, error or limit can show it; empty when one should
  std::string where = {};   ///< FILE:LINE of the entry
};

/// The [[mistake]] tables of a file. UsageError on every mistake in the file itself, with FILE:LINE.
std::vector<Mistake> read_mistakes(const std::filesystem::path& file);

/// The path of its file in a tree; UsageError unless there is exactly one.
std::string file_of(const Mistake& mistake, const std::vector<std::string>& files);

/// The mistake as an edit of that file, which has this text. UsageError unless the code occurs there exactly once.
Edit edit_of(const Mistake& mistake, const std::string& file, const std::string& text);

/// Why a random mutation survives: equivalent, or beyond what the gate can show. As a planted mistake it is found by
/// the end of its file's path and the tokens of its lines, so that an explanation stays when they move.
struct Explanation {
  std::string file;
  std::string before, after;  ///< the lines without and with the mutation
  std::string reason;
  std::string where;  ///< FILE:LINE of the entry

  bool is_of(const Mutant& mutant) const;
};

/// The [[survivor]] tables of a file. UsageError on every mistake in it, with FILE:LINE.
std::vector<Explanation> read_explanations(const std::filesystem::path& file);

/// Why nothing shows a mutant, from `planted.toml` and `explained.toml` in a folder, as far as they are there.
class Reasons {
 public:
  explicit Reasons(const std::filesystem::path& folder);

  /// Empty where nobody has given one.
  std::string of(const Mutant& mutant) const;

  /// Mutants as someone reviews them: with their reasons; planted ones in the order of the list, without what it does
  /// not name any more, and with what has not been tried. None where no mutant is given.
  std::vector<Mutant> reviewed(std::vector<Mutant> mutants) const;

  const std::vector<Explanation>& explanations() const { return explained_; }

 private:
  std::vector<Mistake> planted_;
  std::vector<Explanation> explained_;
};

}  // namespace mpmvv::mutation
