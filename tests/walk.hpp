#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace mpmvv {

inline std::string text_of_file(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// What people read of a tree: its pages at the top, and those in docs/ and docs/other-codes/.
inline std::vector<std::filesystem::path> pages_of(const std::filesystem::path& tree) {
  std::vector<std::filesystem::path> pages;
  for (const auto& folder : {tree, tree / "docs", tree / "docs/other-codes"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".md") pages.push_back(entry.path());
  return pages;
}

/// The fenced block that follows `<!-- walk: NAME -->` in one of the pages: what readers are told to write or to do.
inline std::string walk(const std::string& name) {
  std::vector<std::string> found;
  for (const auto& page : pages_of(MPMVV_SOURCE_DIR)) {
    const std::string text = text_of_file(page);
    const auto mark = text.find("<!-- walk: " + name + " -->");
    if (mark == std::string::npos) continue;
    const auto begin = text.find('\n', text.find("```", mark)) + 1;
    found.push_back(text.substr(begin, text.find("```", begin) - begin));
  }
  EXPECT_EQ(found.size(), 1U) << "pages with a walk '" << name << "'";
  return found.size() == 1 ? found[0] : "";
}

}  // namespace mpmvv
