#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"
#include "tests/walk.hpp"

/// Codes of other people, by their adapters.
namespace mpmvv::cli::other_codes_test {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const std::string small_mpm = MPMVV_SOURCE_DIR "/tests/codes/small_mpm.py";

class OtherCodes : public testing::Test {
 protected:
  Answer in_folder(const std::string& lines) const { return carry_out(folder_, lines); }

  std::string follow(const std::string& name) const {
    const Answer answer = in_folder("export MY_CODE=$PWD/my_code.py\n" + walk(name));
    EXPECT_EQ(answer.code, 0) << name << ": " << answer.out << answer.err;
    return answer.out;
  }

  const Folder folder_;
};

/// docs/other-codes.md as it stands.
TEST_F(OtherCodes, FromNothingToTheOrdersOfOnesOwnCode) {
  std::filesystem::copy_file(small_mpm, folder_ / "my_code.py");
  follow("own-code-folder");
  folder_.write("adapters/my-code/adapter.toml", walk("own-code-adapter"));
  folder_.write("adapters/my-code/input.mustache", walk("own-code-input"));
  folder_.write("orders.toml", walk("own-code-study"));
  EXPECT_THAT(follow("own-code-list"), AllOf(HasSubstr("my-code"), HasSubstr("1.0")));
  EXPECT_THAT(follow("own-code-run"), AllOf(HasSubstr("bar with code my-code (1.0)"), HasSubstr("status ok")));
  EXPECT_THAT(read_text(folder_ / "trial/input.txt"), HasSubstr("cells 16"));
  EXPECT_THAT(follow("own-code-orders"), HasSubstr("9 cases run"));
  EXPECT_THAT(in_folder("mpmvv claims --db results.db").out, HasSubstr("confirmed"));
  follow("own-code-report");
  EXPECT_THAT(read_text(folder_ / "report/codes.html"),
              AllOf(HasSubstr("my-code 1.0"), HasSubstr("second order"), Not(HasSubstr("mpmvv, quadratic"))));
  follow("own-code-propose");
  EXPECT_THAT(read_text(folder_ / "goldens/orders.toml"), HasSubstr("mine, quadratic"));
  EXPECT_THAT(follow("own-code-trend"), AllOf(HasSubstr("1.0 (digest "), HasSubstr("order of 'mine, quadratic'")));

  // Velocities half a step off from the start on: the order stays, the errors show it.
  std::string code = read_text(small_mpm);
  const std::string right = "0.5 if n == 0 else 1.0";
  ASSERT_NE(code.find(right), std::string::npos);
  folder_.write("my_code.py", code.replace(code.find(right), right.size(), "1.0"));
  EXPECT_THAT(in_folder("export MY_CODE=$PWD/my_code.py\n" + walk("own-code-orders")).out,
              ContainsRegex("fails +0.9 to 1.1 +0.35"));
}

TEST_F(OtherCodes, APlantedMistakeGetsNoGolden) {
  folder_.write("planted.toml", R"(title = "Planted"
[fixed]
problem = "bar"
ppc = 2
cfl = 0.5
blowup_error = 10
code = "small-mpm"
variant = "linear"
[[series]]
name = "right"
[[series]]
name = "b misplaced"
force_form = "misplaced"
[[series]]
name = "no b"
force_form = "none"
[sweep]
cells = [4]
[[figure]]
caption = "Errors"
xlabel = "cells"
ylabel = "error"
)");
  const Answer propose = in_folder("mpmvv study planted.toml --db r.db > log\nmpmvv propose --db r.db --study planted");
  ASSERT_EQ(propose.code, 0) << propose.err;
  EXPECT_THAT(propose.err, HasSubstr("no golden of planted mistakes: 'b misplaced', 'no b'\n"));
  EXPECT_THAT(propose.out,
              AllOf(HasSubstr("series = \"right\""), Not(HasSubstr("series = \"no b\"")),
                    HasSubstr("# No golden of \"b misplaced\": a planted mistake, force_form = \"misplaced\"")));
}

/// A planted mistake that the exact solution hides where it ends: the particles are back at their places.
TEST_F(OtherCodes, AStudyWhoseSolutionReturnsSaysSo) {
  std::string study = R"(title = "Returning"
[fixed]
problem = "bar-rest"
ppc = 2
cfl = 0.5
[[series]]
name = "theirs"
code = "small-mpm"
variant = "linear"
[[series]]
name = "no b"
code = "small-mpm"
variant = "linear"
force_form = "none"
[[series]]
name = "ours"
basis = "linear"
integrator = "usl"
boundary = "periodic"
[sweep]
cells = [4, 8]
)";
  study.insert(study.find("ppc"), "end_time = 0.02\n");
  folder_.write("r.toml", study);
  const std::string caution =
      "r, 'theirs', 'no b': at the end of the case, 0.02 s, the exact solution is where it started";
  EXPECT_THAT(in_folder("mpmvv study r.toml --db r.db --plan").err, HasSubstr(caution));
  EXPECT_THAT(in_folder("mpmvv study r.toml --db r.db --plan --json").json()["cautions"][0].get<std::string>(),
              HasSubstr(caution));
  const Answer answer = in_folder("mpmvv study r.toml --db r.db");
  EXPECT_THAT(answer.err, HasSubstr(caution));
  EXPECT_EQ(answer.err.find(caution), answer.err.rfind(caution)) << "once";
  folder_.write("r.toml", study.replace(study.find("0.02"), 4, "0.01"));
  EXPECT_THAT(in_folder("mpmvv study r.toml --db r.db --plan").err, Not(HasSubstr("where it started")));
}

TEST_F(OtherCodes, TheAdapterSaysTheColumnsOfWhatIsScored) {
  const std::string adapter = walk("own-code-adapter"), file = "file = \"particles.csv\"";
  const auto at = adapter.find(file);
  ASSERT_NE(at, std::string::npos);
  const auto naming = [&](const std::string& columns) {
    folder_.write("adapters/my-code/adapter.toml", std::string(adapter).insert(at, columns));
    return in_folder("export MY_CODE='" + small_mpm + "'\nmpmvv score case.json end.csv");
  };
  std::filesystem::create_directories(folder_ / "adapters/my-code");
  folder_.write("adapters/my-code/adapter.toml", adapter);
  folder_.write("adapters/my-code/input.mustache", walk("own-code-input"));
  const std::string the_case =
      "--code my-code --variant quadratic --problem bar --cells 8 --ppc 2 --cfl 0.2 --end-time 0.002";
  const Answer run =
      in_folder("export MY_CODE='" + small_mpm + "'\nmpmvv case " + the_case + " > case.json && mpmvv run " + the_case +
                " --keep trial && sed '/^id/s/,x,/,posx,/' trial/particles.csv > end.csv");
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  ASSERT_THAT(read_text(folder_ / "end.csv"), HasSubstr(",posx,"));
  EXPECT_THAT(naming("").err, HasSubstr("no positions in end.csv"));
  const Answer scored = naming("columns = { x = \"posx\" }\n");
  EXPECT_EQ(scored.code, 0) << scored.err;
  EXPECT_THAT(scored.out, HasSubstr("status ok"));
  EXPECT_THAT(scored.err, HasSubstr("columns and units are those of adapters/my-code/adapter.toml"));
  EXPECT_THAT(naming("format = \"nairn\"\ncolumns = { x = \"posx\" }\n").out, HasSubstr("status ok"))
      << "the name of the file says its format";
  EXPECT_THAT(naming("format = 3\n").err,
              AllOf(HasSubstr("not those of the code's adapter: 'format'"), HasSubstr("no positions in end.csv")));
  EXPECT_THAT(in_folder("mpmvv score case.json end.csv --columns x=m").out, HasSubstr("status unstable"));
}

TEST_F(OtherCodes, WhatIsNotThereIsLeftOutOfAFolderAndRefusedByName) {
  std::filesystem::create_directories(folder_ / "adapters/gone/studies");
  std::string adapter = walk("own-code-adapter"), study = walk("own-code-study");
  const auto replace = [](std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at; (at = text.find(what)) != std::string::npos;) text.replace(at, what.size(), by);
  };
  replace(adapter, "my-code", "gone");
  replace(adapter, "MY_CODE", "MPMVV_GONE");
  replace(study, "my-code", "gone");
  folder_.write("adapters/gone/adapter.toml", adapter);
  folder_.write("adapters/gone/input.mustache", "");
  folder_.write("adapters/gone/studies/orders.toml", study);
  const Answer all = in_folder("mpmvv study --studies adapters/gone/studies --db r.db");
  EXPECT_EQ(all.code, 3) << all.err;
  EXPECT_EQ(in_folder("mpmvv study --studies adapters/gone/studies --db r.db --plan").code, 0);
  EXPECT_THAT(all.err, HasSubstr("orders is left out: code 'gone' is not there (MPMVV_GONE=PROGRAM"));
  const Answer named = in_folder("mpmvv study adapters/gone/studies/orders.toml --db r.db");
  EXPECT_EQ(named.code, 2);
  EXPECT_THAT(named.err, HasSubstr("MPMVV_GONE=PROGRAM"));
  const Answer one = in_folder("mpmvv run --code gone --variant linear --problem bar --cells 4 --ppc 2 --cfl 0.5");
  EXPECT_EQ(one.code, 2);
  EXPECT_THAT(one.err, HasSubstr("MPMVV_GONE=PROGRAM"));
  EXPECT_THAT(in_folder("mpmvv list codes").out, HasSubstr("MPMVV_GONE=PROGRAM"));
}

TEST_F(OtherCodes, ABrokenAdapterTakesItsOwnPlaceInTheListAlone) {
  std::filesystem::create_directories(folder_ / "adapters/broken");
  folder_.write("adapters/broken/adapter.toml", "code = 1\n");
  const Answer list = in_folder("mpmvv list codes --json");
  ASSERT_EQ(list.code, 0) << list.err;
  std::map<std::string, nlohmann::json> codes;
  const nlohmann::json answer = list.json();
  for (const nlohmann::json& code : answer["codes"]) codes[code["code"]] = code;
  EXPECT_THAT(codes.at("broken")["fault"], HasSubstr("adapters/broken/adapter.toml:1"));
  EXPECT_TRUE(codes.at("small-mpm").contains("program"));
}

/// What `list codes` says of a code whose program is this script.
nlohmann::json listed(const Folder& folder, const std::string& code, const std::string& script) {
  std::string variable = "MPMVV_" + code;
  std::ranges::transform(variable, variable.begin(), [](unsigned char c) { return c == '-' ? '_' : std::toupper(c); });
  const std::string program = folder.write("program", "#!/bin/sh\n" + script + "\n");
  const Answer list =
      carry_out(folder, "chmod +x program\nexport " + variable + "='" + program + "'\nmpmvv list codes --json");
  const nlohmann::json answer = list.json();
  for (const nlohmann::json& each : answer["codes"])
    if (each["code"] == code) return each;
  return {};
}

TEST_F(OtherCodes, AProgramThatSaysNoVersionHasAFaultInItsPlace) {
  const std::string broken = "echo \"$0: error while loading shared libraries: x.so\" >&2; exit 127",
                    wrong = "echo 'usage: program page'", silent = "exit 0";
  for (const std::string code : {"nairn", "karamelo"}) {
    for (const std::string& script : {broken, wrong, silent}) {
      const nlohmann::json entry = listed(folder_, code, script);
      EXPECT_FALSE(entry.contains("version")) << entry;
      EXPECT_THAT(entry.value("fault", ""), HasSubstr("code '" + code + "' gives no version")) << script;
    }
    EXPECT_THAT(listed(folder_, code, broken).value("fault", ""), HasSubstr("error while loading shared libraries"));
  }
  EXPECT_THAT(listed(folder_, "small-mpm", broken).value("fault", ""), HasSubstr("gives no version"));
}

TEST_F(OtherCodes, AVersionIsFoundInWhatAProgramSays) {
  const std::string trouble = "\necho 'no input' >&2; exit 1";
  EXPECT_EQ(listed(folder_, "nairn", "echo 'This is NairnMPM 19.0 build 0'" + trouble).value("version", ""), "19.0");
  EXPECT_EQ(listed(folder_, "karamelo", "echo 'GIT SHA1:08e444db1dff of 2025'" + trouble).value("version", ""),
            "08e444db1d");
}

TEST_F(OtherCodes, AreListedInLinesThatATerminalHolds) {
  std::istringstream list(in_folder("SHELL=/bin/sh script -qec 'stty cols 80; mpmvv list codes' /dev/null").out);
  int lines = 0;
  for (std::string line; std::getline(list, line); ++lines) {
    const bool has_path = line.find('/') != std::string::npos;  // which is one word
    EXPECT_TRUE(has_path || line.size() <= 81) << line;
  }
  EXPECT_GT(lines, 12);
}

TEST_F(OtherCodes, TheOnesOfTheProgramAreFoundByName) {
  const Answer run =
      in_folder("mpmvv run --code small-mpm --variant linear --problem bar --cells 4 --ppc 2 --cfl 0.5 --json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.json()["status"], "ok");
  EXPECT_EQ(run.json()["scheme"]["code"], "small-mpm");
  EXPECT_FALSE(run.json()["scheme"].contains("basis"));
}

TEST_F(OtherCodes, OptionsOfOurOwnSolverAreRefused) {
  const std::string ours = "mpmvv run --problem bar --cells 4 --ppc 2 --cfl 0.5 ",
                    theirs = ours + "--code small-mpm --variant linear ";
  for (const auto& [call, message] :
       {std::pair{theirs + "--basis linear", "basis in --basis has no meaning for code 'small-mpm'"},
        {theirs + "--threads 2", "--threads for code 'small-mpm' (it takes one)"},
        {theirs + "--vtu frames", "--vtu for code 'small-mpm' (what it writes itself is kept with --keep FOLDER)"},
        {theirs + "--repeat 3 --keep here", "--keep beside --repeat (each repetition has a folder of its own"},
        {ours + "--keep here", "--keep without --code"}}) {
    const Answer answer = in_folder(call);
    EXPECT_EQ(answer.code, 2) << call;
    EXPECT_THAT(answer.err, HasSubstr(message));
  }
}

/// A case for another machine, where the code is: with its version and adapter it can go into a store.
TEST_F(OtherCodes, ACaseOfACodeThatIsNotThereTakesItsVersionByHand) {
  std::filesystem::create_directories(folder_ / "adapters/my-code");
  folder_.write("adapters/my-code/adapter.toml", walk("own-code-adapter"));
  folder_.write("adapters/my-code/input.mustache", walk("own-code-input"));
  const std::string absent = "mpmvv case --code my-code --variant linear --problem bar --cells 4 --ppc 2 --cfl 0.5 ",
                    note = "without its version the case cannot go into a store";
  EXPECT_THAT(in_folder(absent).err, HasSubstr(note));
  EXPECT_THAT(in_folder(absent + "--code-version 1.0").err, HasSubstr(note));
  const Answer whole = in_folder(absent + "--code-version 1.0 --adapter 605f50183cc29faf");
  EXPECT_EQ(whole.code, 0) << whole.err;
  EXPECT_EQ(whole.err, "");
}

using OtherCodesNightly = OtherCodes;

/// The worked example, as `./run codes` runs it.
TEST_F(OtherCodesNightly, TheSmallCodeHoldsItsGoldens) {
  const std::string adapter = "'" MPMVV_SOURCE_DIR "/adapters/small-mpm'";
  const Answer study = in_folder("mpmvv study --studies " + adapter + "/studies --db r.db");
  ASSERT_EQ(study.code, 0) << study.out << study.err;
  EXPECT_THAT(study.out, Not(HasSubstr("fails")));
  const Answer gate = in_folder("mpmvv gate --db r.db --goldens " + adapter + "/goldens/1.0");
  EXPECT_EQ(gate.code, 0) << gate.out;
}

}  // namespace mpmvv::cli::other_codes_test
