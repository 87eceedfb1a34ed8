#include "studies/codes/field_names.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "studies/support/file.hpp"

namespace mpmvv::codes::field_names_test {

TEST(FieldNames, AreThoseOfThePage) {
  std::istringstream page(support::require_file(MPMVV_SOURCE_DIR "/docs/adapters.md", "a page"));
  const std::regex name("`([A-Za-z0-9_]+)`");
  std::string line;
  while (std::getline(page, line) && !line.starts_with("| field |")) continue;
  int count = 0;
  while (std::getline(page, line) && line.starts_with("|")) {
    const std::string column = line.substr(1, line.find('|', 1) - 1);
    if (column.find("[fields]") != std::string::npos) continue;
    for (std::sregex_iterator each(column.begin(), column.end(), name), end; each != end; ++each, ++count)
      EXPECT_TRUE(is_field_of_case((*each)[1])) << (*each)[1];
  }
  EXPECT_GT(count, 60);
}

TEST(FieldNames, AreAlsoThoseOfOtherCases) {
  for (const char* name : {"param_rate", "F0_zy", "cells_z", "z_above", "is_per_particle", "is_none", "is_mirror",
                           "zmax_is_dirichlet", "boundary_zmin", "ymax_velocity", "is_solid", "v_z"})
    EXPECT_TRUE(is_field_of_case(name)) << name;
  for (const char* name : {"shape", "method", "scheme", "is_odd", "xmin", "wall", "is_walled", "F"})
    EXPECT_FALSE(is_field_of_case(name)) << name;
}

}  // namespace mpmvv::codes::field_names_test
