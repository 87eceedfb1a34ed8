#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tests/mutation/edit.hpp"
#include "tests/mutation/mutant.hpp"

namespace mpmvv::mutation {

/// A realistic mistake that someone has chosen: an exact text of one file, and what stands there with the mistake.
struct Mistake {
  std::string name;  ///< kebab-case
  std::string what;  ///< one sentence in the field's words
  std::string file;  ///< from the top of the tree
  std::string find, replace;
  std::string reason;  ///< why no order, error or limit can show it; empty when one should
  std::string where;   ///< FILE:LINE of the entry
};

/// The [[mistake]] tables of a file, `shows = "nothing"` with its `reason` where a mistake changes efficiency or
/// robustness only. UsageError on every mistake in the file itself, with FILE:LINE.
std::vector<Mistake> read_mistakes(const std::filesystem::path& file);

/// As an edit of the file's text; UsageError unless `find` occurs there exactly once.
Edit edit_of(const Mistake& mistake, const std::string& text);

/// Why a random mutation survives: equivalent, or beyond what the gate can show. Lines are named by their text, so that
/// an explanation stays when they move.
struct Explanation {
  std::string file;
  std::string before, after;  ///< the line without and with the mutation
  std::string reason;
  std::string where;  ///< FILE:LINE of the entry

  bool is_of(const Mutant& mutant) const;
};

/// Mutants as someone reviews them: with their reasons; planted ones in the order of the folder's list, without what it
/// does not name any more, and with what has not been tried. None where no mutant is given.
std::vector<Mutant> reviewed(std::vector<Mutant> mutants, const std::filesystem::path& folder);

/// The [[survivor]] tables of a file. UsageError on every mistake in it, with FILE:LINE.
std::vector<Explanation> read_explanations(const std::filesystem::path& file);

/// Why nothing shows a mutant, from `planted.toml` and `explained.toml` in a folder, as far as they are there.
class Reasons {
 public:
  explicit Reasons(const std::filesystem::path& folder);

  /// Empty where nobody has given one.
  std::string of(const Mutant& mutant) const;

  /// UsageError unless every explanation is of one of these mutants: it does not outlive the line that it is given for.
  void check(const std::vector<Mutant>& mutants) const;

 private:
  std::vector<Mistake> planted_;
  std::vector<Explanation> explained_;
};

}  // namespace mpmvv::mutation
