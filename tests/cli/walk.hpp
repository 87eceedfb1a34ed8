#pragma once
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.hpp"

namespace mpmvv::cli {

/// The fenced block that follows `<!-- walk: NAME -->` in a page of the tree.
inline std::string walk_block(const std::string& page, const std::string& name) {
  const std::string text = read_text(std::string(MPMVV_SOURCE_DIR) + "/" + page);
  const auto mark = text.find("<!-- walk: " + name + " -->");
  EXPECT_NE(mark, std::string::npos) << name << " in " << page;
  const auto begin = text.find('\n', text.find("```", mark)) + 1;
  return text.substr(begin, text.find("```", begin) - begin);
}

}  // namespace mpmvv::cli
