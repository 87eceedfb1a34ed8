#pragma once
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli {

/// Puts a study file, small.toml, into the folder, and beside it r.db: the store that `mpmvv study` makes of it. The
/// program runs a study once, and later tests get a copy of its store. The store's name.
inline std::string store_of(const Folder& folder, const std::string& text = small_study) {
  static std::map<std::string, std::string> stores;  // by the study's text
  const std::string file = folder.write("small.toml", text);
  std::string db = folder / "r.db";
  if (const auto made = stores.find(text); made != stores.end()) return folder.write("r.db", made->second);
  const Answer study = call(folder, "study " + file + " --db " + db);
  EXPECT_EQ(study.code, 0) << study.err;
  stores[text] = read_text(db);
  return db;
}

}  // namespace mpmvv::cli
