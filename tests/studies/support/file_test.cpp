#include "studies/support/file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "studies/support/error.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::support::file_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class File : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder / "folder");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("/dev/full", folder / "full");
    fs::create_symlink("/dev/null", folder / "null");
  }
  void TearDown() override { fs::remove_all(folder); }

  template <class Action>
  static std::string refusal(const Action& action) {
    try {
      action();
    } catch (const UsageError& e) {
      return e.what();
    }
    return "none";
  }

  const fs::path folder = own_folder("file-test");
};

TEST_F(File, IsRequiredToBeOneAndNothingElse) {
  const std::pair<const char*, const char*> whys[] = {{"absent", "No such file"},
                                                      {"folder", "a directory"},
                                                      {"pipe", "a pipe or a device"},
                                                      {"null", "a pipe or a device"},
                                                      {"folder/x/y", "No such file"}};
  for (const auto& [name, why] : whys) {
    EXPECT_EQ(read_file(folder / name), std::nullopt) << name;
    EXPECT_THAT(refusal([&] { require_file(folder / name, "a list"); }),
                AllOf(HasSubstr(name), HasSubstr(why), HasSubstr("(a list)")));
  }
}

TEST_F(File, ThatTheSystemDoesNotGiveIsNamed) {
  const std::filesystem::path memory = "/proc/self/mem";  // it is there, and its first byte cannot be read
  EXPECT_EQ(read_file(memory), std::nullopt);
  try {
    require_file(memory, "a study file");
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_STREQ(e.what(), "cannot read '/proc/self/mem': it may not be read (a study file)");
  }
}

TEST_F(File, AMessageGoesOnBehindAByteOfZero) {
  EXPECT_STREQ(UsageError(std::string("1\0 for m", 8)).what(), "1\\x00 for m");
}

TEST_F(File, AppearsWholeOrNotAtAll) {
  EXPECT_TRUE(write_if_changed(folder / "new", "text"));
  EXPECT_FALSE(write_if_changed(folder / "new", "text"));
  EXPECT_EQ(require_file(folder / "new", "a text"), "text");
  for (const char* name : {"folder", "absent/new", "new/new", "full"})
    EXPECT_THAT(refusal([&] { write_if_changed(folder / name, "text"); }), HasSubstr("cannot write")) << name;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 5) << "what SetUp made, and the new one";
}

TEST_F(File, TakesNoNameThatAnotherFileHas) {
  write_if_changed(folder / "new.part", "another's");
  const std::string next = fmt::format("new.{}-0.part", getpid());
  fs::create_symlink(folder / "new.part", folder / next);
  EXPECT_TRUE(write_if_changed(folder / "new", "text"));
  for (const std::string& other : {std::string("new.part"), next})
    EXPECT_EQ(read_file(folder / other), "another's") << other;
}

TEST_F(File, IsAsOpenToOthersAsAnyNewOne) {
  const mode_t before = umask(027);
  write_if_changed(folder / "new", "text");
  umask(before);
  using fs::perms;
  EXPECT_EQ(fs::status(folder / "new").permissions(), perms::owner_read | perms::owner_write | perms::group_read);
}

TEST_F(File, ThatIsReplacedKeepsItsPermissions) {
  const fs::path file = folder / "mine";
  write_if_changed(file, "first");
  fs::create_symlink(file, folder / "link");
  for (const fs::perms own : {fs::perms::owner_read | fs::perms::owner_write, fs::perms::owner_read})
    for (const char* name : {"mine", "link"}) {
      fs::permissions(file, own);
      EXPECT_TRUE(write_if_changed(folder / name, name));
      EXPECT_EQ(fs::status(file).permissions(), own);
    }
}

TEST_F(File, IsWrittenThroughSymbolicLinks) {
  fs::create_symlink("../target", folder / "folder/link");
  fs::create_symlink(folder / "folder/link", folder / "link");
  for (const char* text : {"first", "second"}) {
    EXPECT_TRUE(write_if_changed(folder / "link", text));
    EXPECT_EQ(read_file(folder / "target"), text);
  }
  EXPECT_TRUE(fs::is_symlink(folder / "link") && fs::is_symlink(folder / "folder/link"));
  fs::create_symlink("round", folder / "round");
  EXPECT_THAT(refusal([&] { write_if_changed(folder / "round", "text"); }), HasSubstr("cannot write"));
}

TEST_F(File, DoesNotTakeThePlaceOfADevice) {
  EXPECT_TRUE(write_if_changed(folder / "null", "text"));
  EXPECT_TRUE(fs::is_character_file(folder / "null"));
}

}  // namespace mpmvv::support::file_test
