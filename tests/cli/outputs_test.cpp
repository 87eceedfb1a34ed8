#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::outputs_test {

using testing::HasSubstr;

/// A store with a study, and goldens, under several names each.
class Outputs : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder / "goldens");
    folder.write("goldens/g.toml", "[[order]]\n");
    records::StudyResult study;
    study.name = "s", study.text = small_study;
    store::Store made(folder / "v.db", store::Store::Mode::create_or_write);
    made.keep_study(study, {}, store::current_provenance());
    std::filesystem::create_hard_link(folder / "v.db", folder / "hard");
    std::filesystem::create_symlink("v.db", folder / "soft");
    std::filesystem::create_symlink("goldens", folder / "same-goldens");
  }

  const Folder folder;
};

TEST_F(Outputs, AreNeverAnInputUnderWhateverName) {
  const std::string cd = "cd '" + (folder / "") + "' && ", goldens = " --goldens goldens";
  const std::vector<std::string> calls{
      "db export --db v.db --out v.db",
      "db export --db v.db --out hard",
      "db export --db v.db --out soft",
      "db export --db soft --out goldens/../hard",
      "gate --db v.db --junit hard" + goldens,
      "gate --db v.db --junit goldens/g.toml" + goldens,
      "gate --db v.db --junit same-goldens/g.toml" + goldens,
      "gate --db v.db --junit s.toml" + goldens,
      "gate --db v.db --junit s-soft.toml" + goldens,
      "study s.toml --db s.toml",
      "study s.toml --db s-soft.toml",
  };
  const std::string store = read_text(folder / "v.db");
  folder.write("s.toml", small_study);
  std::filesystem::create_symlink("s.toml", folder / "s-soft.toml");
  for (const std::string& arguments : calls) {
    const Answer answer = call(folder, arguments, cd);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_THAT(answer.err, HasSubstr("would overwrite")) << arguments;
  }
  EXPECT_EQ(read_text(folder / "v.db"), store);
  EXPECT_EQ(read_text(folder / "goldens/g.toml"), "[[order]]\n");
  EXPECT_EQ(read_text(folder / "s.toml"), small_study);
}

TEST_F(Outputs, ReplaceNoFileOfAnotherKind) {
  const std::string cd = "cd '" + (folder / "") + "' && ";
  folder.write("notes.txt", "dear diary\n");
  for (const char* arguments : {"db export --db v.db --out notes.txt",
                                "particles --problem bar --cells 8 --ppc 2 --basis linear --cfl 0.2 --csv notes.txt",
                                "particles --problem bar --cells 8 --ppc 2 --basis linear --cfl 0.2 --vtu notes.txt"}) {
    const Answer answer = call(folder, arguments, cd);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_THAT(answer.err, HasSubstr("notes.txt is there, and is not what this command writes")) << arguments;
  }
  EXPECT_EQ(read_text(folder / "notes.txt"), "dear diary\n");
  const std::string drawing = "<?xml version=\"1.0\"?>\n<svg>a drawing</svg>\n",
                    with_vtu = "particles --problem bar --cells 8 --ppc 2 --basis linear --cfl 0.2 --vtu ";
  folder.write("drawing.svg", drawing);
  EXPECT_EQ(call(folder, with_vtu + "drawing.svg", cd).code, 2);
  EXPECT_EQ(read_text(folder / "drawing.svg"), drawing);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(call(folder, with_vtu + "bar.vtu", cd).code, 0) << k;
  folder.write("notes.txt", "");
  for (int k = 0; k < 2; ++k) EXPECT_EQ(call(folder, "db export --db v.db --out notes.txt", cd).code, 0) << k;
}

TEST_F(Outputs, AreNoPipeThatNobodyMayRead) {
  const std::string cd = "cd '" + (folder / "") + "' && ", particles = "particles --problem bar --cells 8 --ppc 2 ";
  ASSERT_EQ(shell("mkfifo '" + (folder / "pipe") + "'").code, 0);
  folder.write("goldens/g.toml",
               "study = \"s\"\nreviewed = \"now\"\n[[value]]\nname = \"gap\"\nexpected = 1\nband = 0.1\n");
  for (const std::string& arguments :
       {std::string("gate --db v.db --goldens goldens --junit pipe"), std::string("db export --db v.db --out pipe"),
        particles + "--cfl 0.2 --csv pipe", particles + "--cfl 0.2 --vtu pipe"}) {
    const Answer answer = call(folder, arguments, cd + "timeout 20 ");
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_THAT(answer.err, HasSubstr(" pipe is a pipe, a socket or a disk (a file, or /dev/stdout)\n"));
  }
}

TEST_F(Outputs, AreStreamsThatAreOpen) {
  const std::string cd = "cd '" + (folder / "") + "' && timeout 20 ", exported = "db export --db v.db --out ";
  const std::string csv = call(folder, "db export --db v.db", cd).out;
  ASSERT_NE(csv, "");
  EXPECT_EQ(call(folder, exported + "/dev/stdout", cd).out, csv);
  EXPECT_EQ(call(folder, exported + "/dev/fd/3 3>&1 >&2", cd).out, csv);
  EXPECT_EQ(call(folder, exported + "/dev/null", cd).code, 0);
  EXPECT_EQ(on_terminal(folder, 80, exported + "/dev/stdout"), csv);
}

TEST_F(Outputs, AreNoFolderThatHoldsAnInput) {
  const std::string cd = "cd '" + (folder / "") + "' && ";
  for (const char* arguments :
       {"report --db v.db --out goldens", "report --db v.db --out same-goldens", "report --db soft --out ."}) {
    const Answer answer = call(folder, std::string(arguments) + " --goldens goldens", cd);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_THAT(answer.err, HasSubstr("is a folder that holds '")) << arguments;
  }
  folder.write("s.toml", small_study);
  for (const char* option : {"", " --plan"})
    for (const char* db : {".", "..", "/"})
      EXPECT_EQ(call(folder, std::string("study s.toml --db ") + db + option, cd).err,
                "mpmvv: results store '" + std::string(db) + "' is not a file (name a file)\n");
}

TEST_F(Outputs, OfAnotherPlaceAreWritten) {
  const std::string exported = "db export --db " + (folder / "v.db") + " --out " + (folder / "v.csv");
  EXPECT_EQ(call(folder, exported).code, 0);
  EXPECT_EQ(call(folder, exported).code, 0) << "not over an earlier one";
  EXPECT_TRUE(std::filesystem::exists(folder / "v.csv"));
}

}  // namespace mpmvv::cli::outputs_test
