#include "studies/codes/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "studies/support/error.hpp"
#include "studies/support/suggestion.hpp"
#include "tests/studies/codes/written_run.hpp"

namespace mpmvv::codes::case_file_test {

using nlohmann::json;
using testing::HasSubstr;

class CaseFile : public testing::Test {
 protected:
  ~CaseFile() override { std::filesystem::remove(file_); }

  std::string complaint(const json& object) const { return complaint_about(object.dump()); }

  /// What is said of a file with this in it; empty where it is read.
  std::string complaint_about(const std::string& text) const {
    std::ofstream(file_) << text;
    try {
      read_case(file_);
    } catch (const support::UsageError& e) {
      return support::with_suggestion(e.what());
    }
    return "";
  }

  const cases::Case case_ = written_run::square();
  const json whole_ = json::parse(case_text(case_));
  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("mpmvv-case-" + std::to_string(getpid()) + ".json");
};

TEST_F(CaseFile, HoldsTheCaseThatItWasWrittenOf) {
  EXPECT_EQ(complaint(whole_), "");
  EXPECT_EQ(cases::canonical_text(read_case(file_)), cases::canonical_text(case_));
}

/// All that a file has is necessary.
TEST_F(CaseFile, WithoutAFieldIsRefusedByItsName) {
  for (const auto& [name, value] : whole_.items()) {
    json without = whole_;
    without.erase(name);
    EXPECT_THAT(complaint(without), HasSubstr("no field '" + name + "' in " + file_.string())) << value;
  }
}

TEST_F(CaseFile, WithAFieldOfAnotherTypeIsRefused) {
  const std::map<std::string, std::string> types{
      {"case", "a text"},         {"problem", "a text"},         {"parameters", "an object of numbers"},
      {"dimension", "a whole n"}, {"end_time", "a number"},      {"settings", "an object of texts"},
      {"dt", "a number"},         {"steps", "a whole n"},        {"units", "an object of texts"},
      {"h", "a number"},          {"columns", "a list of texts"}};
  for (const auto& [name, value] : whole_.items())
    for (const json& wrong : {json(true), json(), json({1, 2}), json({{"a", json::array()}})}) {
      json other = whole_;
      other[name] = wrong;
      const std::string text = wrong.is_array() ? "a list" : wrong.is_object() ? "an object" : wrong.dump();
      EXPECT_THAT(complaint(other), HasSubstr(name + " = " + text + ", which is not " + types.at(name)));
    }
}

TEST_F(CaseFile, WithListsInListsWithoutEndIsRefused) {
  const std::string list = std::string(200'000, '[') + std::string(200'000, ']'), was = whole_["dt"].dump();
  std::string text = whole_.dump();
  text.replace(text.find("\"dt\":" + was) + 5, was.size(), list);
  EXPECT_THAT(complaint_about(text), HasSubstr("dt = a list, which is not a number, in "));
}

TEST_F(CaseFile, WithAFieldThatIsNoneIsRefusedAndToldWhichWasMeant) {
  for (const auto& [name, value] : whole_.items()) {
    json misspelt = whole_;
    misspelt.erase(name);
    misspelt[name + "s"] = value;
    EXPECT_THAT(complaint(misspelt), HasSubstr("unknown field '" + name + "s' in ")) << value;
    if (name.size() > 2) {
      EXPECT_THAT(complaint(misspelt), HasSubstr("did you mean '" + name + "'?"));
    }
  }
}

TEST_F(CaseFile, ThatSaysTwoThingsIsRefused) {
  const std::map<std::string, json> others{
      {"problem", "square-inverse"}, {"dimension", 3}, {"steps", 7}, {"h", 0.3}, {"units", {{"length", "mm"}}}};
  for (const auto& [name, value] : others) {
    json other = whole_;
    other[name] = value;
    EXPECT_THAT(complaint(other), HasSubstr(name + " = " + value.dump() + ", where its text has "));
  }
  for (const char* name : {"dt", "end_time", "case"}) {
    json other = whole_;
    other[name] = std::string(name) == "case" ? json("problem=bar") : json(0.5);
    EXPECT_THAT(complaint(other), HasSubstr("settings that make another case than its text")) << name;
  }
}

/// Those of parameters and settings.
TEST_F(CaseFile, NamesInItAreChecked) {
  json other = whole_;
  other["parameters"]["amplitud"] = 0.1;
  EXPECT_THAT(complaint(other), HasSubstr("did you mean 'amplitude'?"));
  other = whole_;
  other["settings"]["cels"] = "8";
  EXPECT_THAT(complaint(other), HasSubstr("did you mean 'cells'?"));
  for (const char* name : {"problem", "cells", "ppc"}) {
    other = whole_;
    other["settings"].erase(name);
    EXPECT_THAT(complaint(other), HasSubstr(name));
  }
  EXPECT_THAT(complaint(json::array()), HasSubstr("no object in"));
}

}  // namespace mpmvv::codes::case_file_test
