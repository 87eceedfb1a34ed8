#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "studies/plan/claim_reader.hpp"
#include "studies/plan/file_reference.hpp"
#include "studies/problems/problem.hpp"
#include "studies/records/record.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/toml_file.hpp"
#include "tests/walk.hpp"

/// The pages in docs/ against the code: they name all that there is, and nothing points to what there is not.
namespace mpmvv::docs_test {

namespace fs = std::filesystem;

const fs::path top = MPMVV_SOURCE_DIR;

std::string page(const std::string& name) {
  return text_of_file(top / "docs" / name);
}

void expect_words(const std::string& name, const std::vector<std::string>& words) {
  const std::string text = page(name);
  for (const std::string& word : words)
    EXPECT_NE(text.find("`" + word + "`"), std::string::npos) << "docs/" << name << " says nothing of '" << word << "'";
}

TEST(Docs, NameEveryWordOfEverySetting) {
  for (const settings::SettingKey& key : settings::setting_keys())
    expect_words("theory.md", settings::words_of_key(key.key));
}

TEST(Docs, NameEveryProblem) {
  for (const problems::Problem& problem : problems::problems()) expect_words("problems.md", {problem.name});
}

TEST(Docs, NameEveryNumberOfARun) {
  expect_words("measuring.md", records::norm_words());
}

TEST(Docs, HaveTheStudyFileAsItIsRead) {
  EXPECT_TRUE(page("study-files.md") == plan::study_file_reference())
      << "docs/study-files.md is stale: mpmvv list study-file > docs/study-files.md";
}

/// What the shipped study files state: a study may name a claim that another one states, and no claim is stated twice.
std::vector<plan::StatedClaim> stated_claims() {
  std::vector<plan::StatedClaim> claims;
  for (const auto& entry : fs::directory_iterator(top / "studies"))
    if (entry.path().extension() == ".toml")
      for (const plan::StatedClaim& claim :
           plan::read_claims(support::TomlTable::read(entry.path()), entry.path().stem().string()))
        claims.push_back(claim);
  return claims;
}

TEST(Docs, SayOfEveryClaimWhatItsStudySays) {
  const std::string text = page("claims.md");
  std::set<std::string> ids;
  for (const auto& [claim, where] : stated_claims()) {
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id << " is stated twice, the second time in " << where;
    const bool is_ours = claim.source == "mpmvv";
    const std::string place = is_ours ? "" : claim.where.empty() ? " |" : " " + claim.where + " |";
    const std::string row = "\n| " + claim.id + " | " + claim.statement + " |" + place + "\n";
    EXPECT_NE(text.find(row), std::string::npos) << where << ": docs/claims.md has no row" << row;
  }
  const std::regex row("\n\\| ([SWNBX]-[^ ]+) \\|");
  const auto rows = std::distance(std::sregex_iterator(text.begin(), text.end(), row), std::sregex_iterator());
  EXPECT_EQ(static_cast<std::size_t>(rows), ids.size());
}

/// Headings as the address of a section has them: "Moving walls" is #moving-walls.
std::string anchor(const std::string& heading) {
  std::string result;
  for (const char c : heading) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) || c == '-') result += static_cast<char>(std::tolower(letter));
    if (c == ' ') result += '-';
  }
  return result;
}

std::vector<std::string> headings(const std::string& text) {
  static const std::regex line("(^|\n)#+ ([^\n]+)");
  std::vector<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it) all.push_back((*it)[2]);
  return all;
}

bool has_anchor(const std::string& text, const std::string& wanted) {
  for (const std::string& heading : headings(text))
    if (anchor(heading) == wanted) return true;
  return false;
}

/// Calls visit(match, place) for each match in the sources, study files and goldens.
template <class Visit>
void for_matches(const std::regex& pattern, const Visit& visit) {
  for (const char* folder : {"mms", "solver", "studies", "goldens", "reports", "cli", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      const auto ending = entry.path().extension();
      if (ending != ".hpp" && ending != ".cpp" && ending != ".toml" && ending != ".txt") continue;
      const std::string text = text_of_file(entry.path());
      for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
        visit(*it, fs::relative(entry.path(), top).string());
    }
}

/// As comments cite a page: its name alone, with a "Section", or with the number of a row.
TEST(Docs, HaveWhatCommentsCite) {
  const std::regex cited(R"re(docs/([a-z-]+\.md)(, "([^"]+)"|, ([A-Z][0-9]+))?)re");
  int found = 0;
  for_matches(cited, [&found](const std::smatch& match, const std::string& place) {
    ++found;
    const std::string text = page(match[1]);
    EXPECT_FALSE(text.empty()) << match[1] << " in " << place;
    const bool has_section = !match[3].matched || has_anchor(text, anchor(match[3]));
    const bool has_row = !match[4].matched || text.find("\n| " + match[4].str() + " |") != std::string::npos;
    EXPECT_TRUE(has_section && has_row) << match[0] << " in " << place;
  });
  EXPECT_GT(found, 0);
}

/// Whether the tree has the file, or the page tells its readers to write it.
bool is_there_or_to_be_written(const std::string& file, const std::string& page) {
  return fs::exists(top / file) || page.find("as\n`" + file + "`") != std::string::npos ||
         page.find("as `" + file + "`") != std::string::npos;
}

/// Links between the pages and to pictures, and files of the tree that they name.
TEST(Docs, PointToWhatThereIs) {
  const std::regex link(R"re(\]\(([A-Za-z0-9._/-]*)(#([a-z0-9-]+))?\))re");
  const std::regex file(R"re(`((mms|solver|studies|goldens|reports|cli|tests|cmake|docs)/[a-z0-9_/-]+\.[a-z]+)`)re");
  int found = 0;
  for (const fs::path& from : pages_of(top)) {
    const std::string text = text_of_file(from);
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      ++found;
      const std::string target = (*it)[1];
      const fs::path to = target.empty() ? from : from.parent_path() / target;
      EXPECT_TRUE(fs::exists(to)) << target << " in " << from;
      EXPECT_TRUE(!(*it)[3].matched || has_anchor(text_of_file(to), (*it)[3])) << (*it)[0] << " in " << from;
    }
    for (std::sregex_iterator it(text.begin(), text.end(), file), end; it != end; ++it)
      EXPECT_TRUE(is_there_or_to_be_written((*it)[1], text)) << (*it)[1] << " in " << from;
  }
  EXPECT_GT(found, 100);
}

/// Nothing but an address of the web may be linked in another way than the test above knows.
TEST(Docs, LinkNothingThatIsNotLookedAt) {
  const std::regex any_link(R"re(\]\(([^)]*)\))re"), known(R"re([A-Za-z0-9._/-]*(#[a-z0-9-]+)?|https://.*)re");
  const std::regex block("```[^`]*```");
  for (const fs::path& from : pages_of(top)) {
    const std::string text = std::regex_replace(text_of_file(from), block, "");
    for (std::sregex_iterator it(text.begin(), text.end(), any_link), end; it != end; ++it)
      EXPECT_TRUE(std::regex_match((*it)[1].str(), known)) << (*it)[0] << " in " << from;
  }
}

/// From the README a reader gets to each page, or to the page that its folder belongs to and from there to it.
TEST(Docs, AreAllReachedFromTheReadme) {
  for (const fs::path& to : pages_of(top)) {
    const fs::path folder = fs::relative(to, top).parent_path();
    const bool is_nested = folder.has_parent_path();
    const fs::path from = is_nested ? top / (folder.string() + ".md") : top / "README.md";
    const std::string link = "](" + fs::relative(to, from.parent_path()).string() + ")";
    EXPECT_TRUE(to == from || text_of_file(from).find(link) != std::string::npos) << link << " in " << from;
  }
}

/// What a page tells its readers to write or to do, some test writes or does.
TEST(Docs, AreCarriedOut) {
  std::string tests;
  for (const auto& entry : fs::recursive_directory_iterator(top / "tests"))
    if (entry.path().extension() == ".cpp") tests += text_of_file(entry.path());
  const std::regex mark("<!-- walk: ([^ ]+) -->\n```");
  int found = 0;
  for (const fs::path& from : pages_of(top)) {
    const std::string text = text_of_file(from);
    for (std::sregex_iterator it(text.begin(), text.end(), mark), end; it != end; ++it) {
      ++found;
      const std::string name = "\"" + (*it)[1].str() + "\")";
      const bool is_used =
          tests.find("walk(" + name) != std::string::npos || tests.find("follow(" + name) != std::string::npos;
      EXPECT_TRUE(is_used) << (*it)[0] << " in " << from;
    }
  }
  EXPECT_GT(found, 20);
}

}  // namespace mpmvv::docs_test
