#include "studies/codes/adapter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::codes::adapter_test {

using support::UsageError;
using testing::ElementsAre;
using testing::HasSubstr;

/// The adapter of docs/adapters.md, in a folder of its own.
class AdapterFile : public testing::Test {
 protected:
  AdapterFile() {
    support::make_folder(folder_);
    support::write_if_changed(folder_ / "input.mustache", "cells {{cells}}\n");
    const std::string page = support::require_file(MPMVV_SOURCE_DIR "/docs/adapters.md", "a page");
    const auto begin = page.find("    code = "), end = page.find("\nWhat columns");
    for (std::size_t at = begin; at < end; at = page.find('\n', at) + 1)
      if (const std::string line = page.substr(at, page.find('\n', at) + 1 - at); line.size() > 4)
        text_ += line.substr(4);
  }
  ~AdapterFile() override { std::filesystem::remove_all(top_); }

  Adapter read(const std::string& text) const {
    support::write_if_changed(folder_ / "adapter.toml", text);
    return read_adapter(folder_ / "adapter.toml");
  }

  std::string complaint_without(const std::string& part, const std::string& instead = "") const {
    std::string text = text_;
    text.replace(text.find(part), part.size(), instead);
    try {
      read(text);
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  }

  const std::filesystem::path top_ = own_folder("adapter"), folder_ = top_ / "small-mpm";
  std::string text_;
};

TEST_F(AdapterFile, IsReadAsItsPageSays) {
  const Adapter adapter = read(text_);
  EXPECT_EQ(adapter.name, "small-mpm");
  EXPECT_EQ(adapter.program.variable, "MPMVV_SMALL_MPM");
  EXPECT_THAT(adapter.program.version, ElementsAre("{{program}}", "--version"));
  ASSERT_EQ(adapter.inputs.size(), 1U);
  EXPECT_EQ(adapter.inputs[0].file, "input.txt");
  EXPECT_EQ(adapter.inputs[0].text, "cells {{cells}}\n");
  EXPECT_EQ(adapter.time_limit, std::chrono::seconds(300));
  EXPECT_EQ(adapter.output.columns.names.at("x"), "px");
  EXPECT_EQ(adapter.output.columns.length, 1e-3);
  EXPECT_EQ(adapter.output.convert.at(0).at(0), "{{adapter}}/convert.py");
  EXPECT_EQ(adapter.variants.at("linear").at("shape"), "1");
  EXPECT_THAT(adapter.capabilities.dimensions, ElementsAre(1, 2));
  EXPECT_TRUE(adapter.stepping.is_given);
}

TEST_F(AdapterFile, ATimeToleranceIsAPartOfTheEndTime) {
  const std::string line = "time_tolerance = ";
  for (const char* right : {"0", "1e-6", "0.1"}) EXPECT_EQ(complaint_without(line + "1e-9", line + right), "");
  for (const char* wrong : {"-1e-9", "0.11", "5"})
    EXPECT_THAT(complaint_without(line + "1e-9", line + wrong), HasSubstr("(of the end time: from 0 to 0.1)"));
}

/// What a template says decides results as much as the file does.
TEST_F(AdapterFile, ItsDigestIsOfItsTemplatesToo) {
  const std::string before = read(text_).digest;
  EXPECT_EQ(read(text_).digest, before);
  support::write_if_changed(folder_ / "input.mustache", "cells {{cells}} \n");
  const std::string with_template = read(text_).digest;
  EXPECT_NE(with_template, before);
  support::write_if_changed(folder_ / "convert.py", "print()\n");
  EXPECT_NE(read(text_).digest, with_template) << "a command names it";
}

TEST_F(AdapterFile, ItsDigestIsOfAllFilesThatACommandMayName) {
  const auto depends = [this](const std::string& word, const std::string& file) {
    std::string text = text_;
    text.replace(text.find("{{adapter}}/convert.py"), 22, word);
    support::make_folder((folder_ / file).parent_path());
    support::write_if_changed(folder_ / file, "one\n");
    const std::string before = read(text).digest;
    support::write_if_changed(folder_ / file, "another\n");
    return read(text).digest != before;
  };
  const std::string blanks(200'000, ' ');
  EXPECT_TRUE(depends("{{" + blanks + "adapter" + blanks + "}}/linear.conf", "linear.conf"));
  for (const auto& [word, file] : {std::pair{"{{adapter}}/linear.conf", "linear.conf"},
                                   {"{{{ adapter }}}/linear.conf", "linear.conf"},
                                   {"{{& adapter }}/linear.conf", "linear.conf"},
                                   {"adapter {{adapter}}/linear.conf", "linear.conf"},
                                   {"--conf={{adapter}}/linear.conf", "linear.conf"},
                                   {"{{ adapter }}/linear.conf", "linear.conf"},
                                   {"{{adapter}}/{{variant}}.conf", "linear.conf"},
                                   {"{{adapter}}/{{#is_odd}}odd/{{/is_odd}}linear.conf", "odd/linear.conf"},
                                   {"{{adapter}}/lib", "lib/move.py"},
                                   {"{{adapter}}/lib/move.py:{{adapter}}/linear.conf", "lib/move.py"},
                                   {"{{adapter}}/lib/move.py:{{adapter}}/linear.conf", "linear.conf"}})
    EXPECT_TRUE(depends(word, file)) << word;
  for (const auto& [word, file] : {std::pair{"{{adapter}}/linear.conf", "linear.conf.old"},
                                   {"{{adapter}}/{{variant}}.conf", "notes.txt"},
                                   {"{{adapter}}/", "goldens/orders.toml"},
                                   {"{{program}}", "linear.conf"}})
    EXPECT_FALSE(depends(word, file)) << word;
}

TEST_F(AdapterFile, MistakesAreNamedWithTheirLine) {
  EXPECT_THAT(complaint_without("\"small-mpm\"", "\"other\""), HasSubstr("name of the adapter's folder, small-mpm"));
  EXPECT_THAT(complaint_without("\"csv\"", "\"xml\""), HasSubstr("unknown format 'xml' in"));
  EXPECT_THAT(complaint_without("time_limit = 300", "time_limit = 0"), HasSubstr("adapter.toml:14"));
  EXPECT_THAT(complaint_without("\"left the grid\"", "\"\""), HasSubstr("an empty text of 'unstable' in"));
  EXPECT_THAT(complaint_without("[capabilities]", "[ability]"), HasSubstr("unknown key 'ability'"));
  EXPECT_THAT(complaint_without("x = \"px\"", "q = \"px\""), HasSubstr("adapter.toml:21"));
  EXPECT_THAT(complaint_without("\"input.txt\"  ", "\"../a\"  "), HasSubstr("a name in the run's folder"));
  EXPECT_THAT(complaint_without("\"input.mustache\"", "\"none\""), HasSubstr("a template of an adapter"));
  EXPECT_THAT(complaint_without("\"misplaced\"", "\"moved\""), HasSubstr("unknown force_forms 'moved'"));
}

TEST_F(AdapterFile, SaysHowThickAPlaneBodyIs) {
  EXPECT_EQ(read(text_).output.columns.thickness, 1e-3);
  EXPECT_THAT(complaint_without("thickness = 1e-3", "thickness = 0"), HasSubstr("thickness = 0 in"));
  EXPECT_THAT(complaint_without("[1, 2]", "[1, 3]"), HasSubstr("a thickness in"));
}

/// A value in the place of the case's would be reported as the case's.
TEST_F(AdapterFile, ValuesForTemplatesHaveNoNamesOfTheCase) {
  const std::string field = "solver = \"explicit\"", of_variant = "shape = 1";
  EXPECT_THAT(complaint_without(field, "dt = 0.0005"), HasSubstr("'dt' of [fields] in "));
  EXPECT_THAT(complaint_without(field, "dt = 0.0005"), HasSubstr("adapter.toml:"));
  EXPECT_THAT(complaint_without(field, "b_x = \"0\""), HasSubstr("'b_x' of [fields] in "));
  EXPECT_THAT(complaint_without(of_variant, "poissons_ratio = 0.29"),
              HasSubstr("'poissons_ratio' of [variants.linear] in "));
  EXPECT_EQ(complaint_without(of_variant, "solver = \"implicit\""), "") << "of [fields]";
}

TEST_F(AdapterFile, ATemplateIsInTheUnitsOfTheOutput) {
  EXPECT_FALSE(read(text_).inputs.at(0).in_units);
  std::string text = text_;
  text.replace(text.find("in_units = false"), 16, "in_units = true");
  EXPECT_TRUE(read(text).inputs.at(0).in_units);
  text.replace(text.find("units = {"), 0, "# ");
  EXPECT_THAT([&] { read(text); }, testing::ThrowsMessage<UsageError>(HasSubstr("but no units in [output]")));
}

}  // namespace mpmvv::codes::adapter_test
