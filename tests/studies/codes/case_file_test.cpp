#include "studies/codes/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "studies/problems/problem.hpp"
#include "studies/settings/settings.hpp"
#include "studies/settings/solver_words.hpp"
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

/// Draws words and numbers for some keys of a case. Whether they go together is for `make_case` to say.
std::vector<settings::Setting> drawn_settings(std::mt19937& random) {
  const auto one_of = [&random](const auto& all) { return all[random() % all.size()]; };
  std::vector<settings::Setting> given{{"problem", one_of(problems::problems()).name, "the test"}};
  const auto give = [&](const char* key, const std::vector<std::string>& values, unsigned one_in) {
    if (random() % one_in == 0) given.push_back({key, one_of(values), "the test"});
  };
  give("cells", {"1", "4", "6", "8", "16"}, 1);
  give("ppc", {"1", "2", "3"}, 1);
  give("cfl", {"0.05", "0.2", "0.37"}, 1);
  for (const settings::SolverWords& list : settings::solver_words())
    give(list.key.c_str(), list.words, list.key == "material" ? 8 : 2);
  for (const cases::SettingKey& key : cases::setting_keys())
    if (key.member && key.key != "force_form" && (key.member->is_flag || !key.member->words.empty()))
      give(key.key.c_str(), key.member->is_flag ? std::vector<std::string>{"true", "false"} : key.member->words, 8);
  give("boundary", {"periodic", "free", "symmetry", "mirror", "dirichlet", "wall"}, 3);
  give("order", {"1", "2", "5"}, 3);
  give("wall_depth", {"0", "0.5", "2"}, 4);
  give("cfl_x", {"0.8"}, 8);
  give("smoothing_length", {"0.5"}, 8);
  give("grid_offset", {"0.3"}, 6);
  give("shuffle", {"7"}, 6);
  give("steps", {"3", "100"}, 4);
  give("param.poissons_ratio", {"0.3"}, 4);
  give("blowup_energy", {"3.5"}, 6);
  return given;
}

TEST_F(CaseFile, HoldsAnyCaseThatSettingsMake) {
  std::mt19937 random(20261129);
  std::set<std::string> seen;
  for (int draw = 0; draw < 6000; ++draw) {
    cases::Case c;
    try {
      c = settings::make_case(drawn_settings(random));
    } catch (const support::UsageError&) {
      continue;
    }
    const std::string text = cases::canonical_text(c);
    ASSERT_EQ(complaint_about(case_text(c)), "") << text;
    ASSERT_TRUE(read_case(file_) == c) << text;
    seen.insert(c.problem.name);
    if (c.scheme.wall_depth == 0 && c.scheme.wall_gradient != cases::WallGradient::none) seen.insert("wall_depth 0");
    for (const std::string& word : {c.scheme.velocity_update, c.scheme.boundary}) seen.insert(word);
  }
  EXPECT_THAT(seen, testing::IsSupersetOf({"bar", "square", "ring", "stretch", "swing", "wave", "flip", "apic", "fmpm",
                                           "free", "wall", "wall_depth 0"}));
}

}  // namespace mpmvv::codes::case_file_test
