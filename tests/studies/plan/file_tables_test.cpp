#include "studies/plan/file_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "studies/plan/file_reference.hpp"
#include "studies/plan/study.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::file_tables_test {

using store::store_samples::complaint;
using testing::HasSubstr;

using Lines = std::map<std::string, std::string>;  ///< by key

/// A study with every key that can stand beside the others.
std::map<std::string, Lines> every_key() {
  const std::string names = "[\"one\"]";
  return {
      {"", {{"title", "\"T\""}, {"claims", "[\"S-fig10\"]"}}},
      {"claim", {{"id", "\"C\""}, {"statement", "\"S\""}, {"source", "\"P\""}, {"where", "\"p. 1\""}}},
      {"fixed",
       {{"problem", "\"bar\""}, {"basis", "\"bspline2\""}, {"integrator", "\"cd\""}, {"ppc", "4"}, {"repeat", "3"}}},
      {"series", {{"name", "\"one\""}, {"cells", "16"}}},
      {"sweep", {{"cfl", "[0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35]"}}},
      {"limit",
       {{"key", "\"cfl\""},
        {"from", "0.2"},
        {"to", "1.5"},
        {"scan_ratio", "1.2"},
        {"tolerance", "0.02"},
        {"stable", "\"below\""},
        {"series", names}}},
      {"replicates", {{"shuffle", "[1, 2]"}}},
      {"fit", {{"norm", "\"l2\""}, {"window", "[0.05, 0.35]"}, {"floor_window", "[0.05, 0.35]"}, {"series", names}}},
      {"extrapolate", {{"norm", "\"energy_loss\""}, {"window", "[0.05, 0.35]"}, {"series", names}}},
      {"figure",
       {{"caption", "\"C\""},
        {"xlabel", "\"x\""},
        {"ylabel", "\"y\""},
        {"name", "\"other\""},
        {"kind", "\"curves\""},
        {"quantity", "\"l2\""},
        {"xscale", "\"log\""},
        {"yscale", "\"log\""},
        {"x_range", "[0.05, 0.35]"},
        {"y_range", "[0.05, 0.35]"},
        {"series", names},
        {"marks", names},
        {"slopes", "[2]"}}},
      {"criterion",
       {{"claim", "\"C\""},
        {"statement", "\"S\""},
        {"measure", "\"order-difference\""},
        {"series", names},
        {"norm", "\"l2\""},
        {"over_norm", "\"linf\""},
        {"window", "[0.05, 0.35]"},
        {"at_least", "1"},
        {"at_most", "2"},
        {"reason", "\"R\""}}}};
}

std::string text_of(const std::map<std::string, Lines>& study) {
  std::string text;
  for (const FileTable& table : file_tables()) {
    if (!table.name.empty()) text += table.heading + "\n";
    for (const auto& [key, value] : study.at(table.name)) text.append(key).append(" = ").append(value).append("\n");
  }
  return text;
}

class FileTables : public store::store_samples::StoreTest {
 protected:
  /// What reading the file complains of; nothing where it is right.
  std::string complaint_of(const std::string& text) const {
    const auto file = folder_ / "study.toml";
    std::ofstream(file) << text;
    try {
      read_study(file);
    } catch (const support::UsageError& e) {
      return e.what();
    }
    return "";
  }
};

TEST_F(FileTables, NameEveryKeyThatIsReadAndSayWhichMustBeThere) {
  const auto study = every_key();
  ASSERT_EQ(complaint_of(text_of(study)), "");
  for (const FileTable& table : file_tables())
    for (const FileKey& key : table.keys) {
      if (key.key == "check" || key.absent.find("#measures") != std::string::npos) continue;
      auto without_it = study;
      ASSERT_EQ(without_it[table.name].erase(key.key), 1U) << table.heading << " " << key.key;
      const std::string complaint = complaint_of(text_of(without_it));
      EXPECT_EQ(complaint.find("'" + key.key + "'") != std::string::npos, key.absent.empty())
          << table.heading << " without " << key.key << ": " << complaint;
    }
}

TEST_F(FileTables, RefuseEveryOtherKey) {
  for (const FileTable& table : file_tables()) {
    auto study = every_key();
    study[table.name]["other"] = "1";
    EXPECT_THAT(complaint_of(text_of(study)),
                testing::AnyOf(HasSubstr("unknown key 'other'"), HasSubstr("2 keys"), HasSubstr("replicates in")))
        << table.heading;
  }
  EXPECT_THAT(complaint_of("title = \"T\"\ncheck = \"jump-errors\"\n[fixed]\n"), HasSubstr("beside a check"));
}

/// The keys that the reference names in the row of each measure: "| `order` | its number | `series`, `norm` |".
std::map<std::string, std::string> needs_by_measure() {
  const std::string reference = study_file_reference();
  const std::string rows = reference.substr(reference.find("## Measures"));
  const std::regex row("\n\\| `([a-z-]+)` \\| [^|]* \\| ([^|]*) \\|");
  std::map<std::string, std::string> needs;
  for (const char* word : words_of(claims::Criterion::Kind{})) {
    std::smatch found;
    const std::string from = rows.substr(rows.find(std::string("\n| `") + word + "` |"));
    if (std::regex_search(from, found, row)) needs[found[1]] = found[2];
  }
  return needs;
}

TEST(StudyFileReference, WrapsItsProse) {
  std::istringstream reference(study_file_reference());
  for (std::string line; std::getline(reference, line);)
    if (!line.starts_with('|')) {
      EXPECT_LE(line.size(), 150U) << line;
    }
}

TEST_F(FileTables, SayWhatEveryMeasureNeedsAndItTakesNoOtherKey) {
  ASSERT_EQ(needs_by_measure().size(), words_of(claims::Criterion::Kind{}).size());
  for (const auto& [measure, needs] : needs_by_measure()) {
    const std::string window = measure == "cost-ratio" ? "[1e-6, 1e-3]" : "[0.05, 0.35]";
    const Lines keys{{"series", "[\"one\"]"}, {"over", "\"two\""},       {"name", "\"value\""},
                     {"norm", "\"l2\""},      {"over_norm", "\"linf\""}, {"window", window}};
    Lines given{{"claim", "\"C\""}, {"statement", "\"S\""}, {"measure", '"' + measure + '"'}, {"reason", "\"R\""}};
    if (!needs.empty()) given["at_least"] = "1";
    for (const auto& [key, value] : keys)
      if (needs.find("`" + key + "`") != std::string::npos) given[key] = value;
    const auto complaint_with = [&](const Lines& criterion) {
      auto study = every_key();
      study["criterion"] = criterion;
      study["limit"]["series"] = "[\"one\", \"two\"]";
      return complaint_of(text_of(study) + "\n[[series]]\nname = \"two\"\ncells = 8\n");
    };
    ASSERT_EQ(complaint_with(given), "") << measure;
    for (const auto& [key, value] : keys) {
      Lines other = given;
      const bool was_needed = other.erase(key) == 1;
      if (!was_needed) other[key] = value;
      EXPECT_THAT(complaint_with(other), HasSubstr(was_needed ? key : "has no meaning for measure '" + measure + "'"));
    }
    Lines bounded = given;
    bounded["at_most"] = "2";
    EXPECT_EQ(complaint_with(bounded).empty(), !needs.empty()) << measure;
  }
}

/// Settings that are the same, said or not.
TEST_F(FileTables, SayWhatCountsWithoutASetting) {
  const std::vector<settings::Setting> given{
      {"problem", "bar", "test"}, {"cells", "16", "test"}, {"ppc", "4", "test"}, {"cfl", "0.1", "test"}};
  for (const settings::SettingKey& key : settings::setting_keys()) {
    std::string value = without(key);
    std::erase(value, '`');
    std::vector<settings::Setting> shorter = given;
    if (value.empty()) {
      std::erase_if(shorter, [&](const auto& setting) { return setting.key == key.key; });
      EXPECT_THAT(complaint([&] { settings::make_case(shorter); }), HasSubstr(key.key));
      continue;
    }
    if (value.find(' ') != std::string::npos || key.key == "steps") continue;  // said in words
    if (key.key == "start") shorter.push_back({"integrator", "cd", "test"});
    if (key.key.starts_with("wall_") && key.key != "wall_acceleration")
      for (const char* of_a_wall : {"problem=stretch-1d", "velocity_update=fmpm", "order=2"}) {
        const std::string text = of_a_wall;
        shorter.push_back({text.substr(0, text.find('=')), text.substr(text.find('=') + 1), "test"});
      }
    std::vector<settings::Setting> longer = shorter;
    longer.push_back({key.key, value, "test"});
    EXPECT_EQ(settings::make_case(longer), settings::make_case(shorter)) << key.key << " = " << value;
  }
}

}  // namespace mpmvv::plan::file_tables_test
