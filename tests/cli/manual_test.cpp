#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/cli/program.hpp"

/// The man page and the completions of shells, which the program makes of its own command line.
namespace mpmvv::cli::manual_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Manual : public testing::Test {
 protected:
  std::string said(const std::string& arguments) const {
    const Answer answer = call(folder_, arguments);
    EXPECT_EQ(answer.code, 0) << answer.err;
    return answer.out;
  }

  /// What the program, or a command of it, names in its help: "run" or "--db".
  std::set<std::string> named(const std::string& command, const std::string& pattern) const {
    const std::string help = said(command + " --help");
    const std::regex name(pattern);
    std::set<std::string> names;
    for (std::sregex_iterator it(help.begin(), help.end(), name), end; it != end; ++it) names.insert((*it)[1]);
    return names;
  }

  std::set<std::string> commands() const { return named("", "\n  ([a-z]+) +[A-Z]"); }

  /// What bash offers for the last of these words, with the completion that lies in the folder.
  std::string offered(const std::string& words) const {
    const Answer bash =
        shell("cd '" + (folder_ / "") + "' && bash -c 'source ./mpmvv.bash; COMP_WORDS=(mpmvv " + words +
              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _mpmvv; echo \"${COMPREPLY[*]}\"' 2>&1");
    EXPECT_EQ(bash.code, 0);
    return bash.out;
  }

  const Folder folder_;
};

TEST_F(Manual, NamesEveryCommandAndEveryOption) {
  const std::string man = std::regex_replace(said("man"), std::regex(R"(\\-)"), "-");
  const std::string bash = said("completion bash"), zsh = said("completion zsh"), fish = said("completion fish");
  EXPECT_THAT(commands(), testing::IsSupersetOf({"run", "study", "gate", "report", "db"}));
  std::set<std::string> all = commands();
  for (const std::string& below : named("db", "\n  ([a-z]+) +[A-Z]")) all.insert("db " + below);
  EXPECT_THAT(all, testing::IsSupersetOf({"db info", "db merge"}));
  for (const std::string& command : all) {
    EXPECT_THAT(man, HasSubstr("mpmvv " + command)) << command;
    for (const std::string& option : named(command, "\n  (?:-h,)?(--[a-z-]+)")) {
      const auto whole = testing::ContainsRegex(option + "[^a-z-]");  // and not --set in --set-where-taken
      for (const std::string& text : {man, bash, zsh}) EXPECT_THAT(text, whole) << command;
      EXPECT_THAT(fish, HasSubstr(" -l " + option.substr(2))) << command;
    }
  }
}

/// The words in a text that the pattern's group takes.
std::set<std::string> words_in(const std::string& text, const std::regex& pattern) {
  std::set<std::string> words;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) words.insert((*it)[1]);
  return words;
}

/// By exit code the commands that docs/commands.md names, and those of the man page.
std::map<std::string, std::set<std::string>> exit_codes_of_page() {
  const std::string page = read_text(MPMVV_SOURCE_DIR "/docs/commands.md");
  std::istringstream rows(page.substr(page.find("| exit code | of | when |")));
  std::map<std::string, std::set<std::string>> commands;
  std::string code;
  std::smatch row;
  for (std::string line; std::getline(rows, line) && !line.empty();) {
    if (!std::regex_search(line, row, std::regex(R"(^\| ?(\d*) ?\|([^|]*)\|)"))) continue;
    if (row[1].length() > 0) code = row[1];
    commands[code].merge(words_in(row[2], std::regex("`([a-z ]+)`")));
  }
  return commands;
}

std::map<std::string, std::set<std::string>> exit_codes_of_man(const std::string& man) {
  const auto begin = man.find(".SH EXIT STATUS");
  const std::string section = man.substr(begin, man.find(".SH FILES") - begin);
  const std::regex entry(R"(\.TP\n(\d+)\n([^.]*))");
  std::map<std::string, std::set<std::string>> commands;
  for (std::sregex_iterator it(section.begin(), section.end(), entry), end; it != end; ++it)
    commands[(*it)[1]] = words_in((*it)[2], std::regex(R"(\\fB([a-z ]+)\\fR)"));
  return commands;
}

TEST_F(Manual, HasTheExitCodesOfTheirPage) {
  auto page = exit_codes_of_page(), man = exit_codes_of_man(said("man"));
  for (const char* code : {"1", "3"}) {
    EXPECT_FALSE(page[code].empty()) << code;
    EXPECT_EQ(man[code], page[code]) << code;
  }
  for (const char* code_of_all : {"0", "2", "130"})
    EXPECT_TRUE(page.contains(code_of_all) && man.contains(code_of_all)) << code_of_all;
}

TEST_F(Manual, IsHiddenFromHelpAndFromTheKnownCommands) {
  EXPECT_THAT(said("--help"), Not(HasSubstr("completion")));
  const Answer unknown = call(folder_, "completions");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, Not(HasSubstr("completion,")));
  const Answer shell = call(folder_, "completion tcsh");
  EXPECT_EQ(shell.code, 2);
  EXPECT_THAT(shell.err, HasSubstr("shell: unknown word 'tcsh' (known: bash, zsh, fish)"));
}

TEST_F(Manual, IsSoundShell) {
  const std::string script = said("completion bash");
  EXPECT_THAT(script, HasSubstr("_mpmvv"));
  folder_.write("mpmvv.bash", script);
  const Answer bash = shell("bash -n '" + (folder_ / "mpmvv.bash") + "' 2>&1");
  EXPECT_EQ(bash.code, 0);
  EXPECT_THAT(bash.out, IsEmpty());
}

TEST_F(Manual, CompletesInBash) {
  folder_.write("mpmvv.bash", said("completion bash"));
  folder_.write("mine.db", "");
  std::filesystem::create_directories(folder_ / "mine");
  EXPECT_EQ(offered("r"), "run report\n");
  EXPECT_EQ(offered("db in"), "info\n");
  EXPECT_EQ(offered("db info --j"), "--json\n");
  EXPECT_EQ(offered("run --velocity-update f"), "flip fmpm\n");
  EXPECT_EQ(offered("run --velocity-update = f"), "flip fmpm\n") << "as bash divides --velocity-update=f";
  EXPECT_EQ(offered("solution --problem sh"), "shell shock\n");
  EXPECT_THAT(offered("run \"\""), HasSubstr("--basis")) << "it takes nothing but options";
  EXPECT_THAT(offered("gate --db mi"), HasSubstr("mine.db"));
  EXPECT_THAT(offered("study mi"), HasSubstr("mine.db"));
  EXPECT_THAT(offered("score mi"), AllOf(HasSubstr("mine.db"), Not(HasSubstr("compgen"))))
      << "both of its words are files";
  EXPECT_THAT(offered("study s-fig10"), HasSubstr("s-fig10")) << "that comes with the program";
  EXPECT_EQ(offered("run --cells \"\""), "\n") << "a number is no file";
  EXPECT_EQ(offered("gate --goldens mi"), "mine\n") << "a folder alone";
  EXPECT_EQ(offered("gate --only s-fig11"), "s-fig11\n");
  EXPECT_EQ(offered("list studi"), "studies\n");
  EXPECT_THAT(offered("score --start mi"), HasSubstr("mine.db")) << "a file, not a word of the setting `start`";
  EXPECT_EQ(offered("figure --format p"), "pdf\n");
  EXPECT_EQ(offered("expression --form c"), "current\n");
  EXPECT_EQ(offered("expression --dialect f"), "fortran\n");
  EXPECT_THAT(offered("score --format \"\""), HasSubstr("csv"));
}

TEST_F(Manual, CompletesWordsAndFilesInZsh) {
  const std::string zsh = said("completion zsh");
  EXPECT_THAT(zsh, HasSubstr("'*:output:_files'"));
  EXPECT_THAT(zsh, testing::ContainsRegex("'\\*:files:\\{ compadd -- b-fig16 [^}]*; _files }'"))
      << "a study that comes with the program, or a file of one's own";
}

TEST_F(Manual, HasDefaultsAndTheSignsOfAShell) {
  const std::string man = said("man");
  EXPECT_THAT(man, HasSubstr("(default: reference)"));
  EXPECT_THAT(man, HasSubstr("case that \\(gampmvv case\\(ga wrote")) << "roff makes a quotation mark of a bare one";
  EXPECT_THAT(man, HasSubstr("the problem\\(aqs"));
}

/// Shells and `man` that a system need not have.
using ManualNightly = Manual;

TEST_F(ManualNightly, IsAManPageWithoutWarnings) {
  folder_.write("mpmvv.1", said("man"));
  const Answer man =
      shell("MANWIDTH=80 man -l --warnings '" + (folder_ / "mpmvv.1") + "' 2>'" + (folder_ / "warnings") + "'");
  EXPECT_EQ(man.code, 0);
  EXPECT_EQ(read_text(folder_ / "warnings"), "");
  EXPECT_THAT(man.out, HasSubstr("--velocity-update"));
  EXPECT_THAT(man.out, HasSubstr("EXIT STATUS"));
}

/// At home in the folder: fish reads the settings that its user has there, and leaves some.
TEST_F(ManualNightly, CompletesInFish) {
  folder_.write("mpmvv.fish", said("completion fish"));
  const auto fish = [&](const std::string& line) {
    return shell("cd '" + (folder_ / "") + "' && env -u XDG_CONFIG_HOME -u XDG_DATA_HOME HOME=\"$PWD\" " +
                 "fish -c 'source mpmvv.fish; complete -C \"mpmvv " + line + "\"' 2>&1")
        .out;
  };
  EXPECT_THAT(fish("r"), HasSubstr("report\tWrite"));
  EXPECT_THAT(fish("db in"), HasSubstr("info\t"));
  EXPECT_THAT(fish("run --velocity-update fl"), HasSubstr("flip"));
  EXPECT_THAT(fish("study mpmvv"), HasSubstr("mpmvv.fish"));
  EXPECT_THAT(fish("study --sh"), HasSubstr("--shard"));
  EXPECT_THAT(fish("db study --"), AllOf(HasSubstr("--db"), Not(HasSubstr("--shard")))) << "another command";
  EXPECT_THAT(fish("study case --"), AllOf(HasSubstr("--shard"), Not(HasSubstr("--problem")))) << "a file of that name";
}

/// On a terminal of its own, as its completion works nowhere else: the only word is written out.
TEST_F(ManualNightly, CompletesInZsh) {
  folder_.write("_mpmvv", said("completion zsh"));
  folder_.write("mine.toml", "");
  folder_.write("drive.zsh", R"(zmodload zsh/zpty
zpty -b shell zsh -f -i
heard() {  # what the shell says until it says $1, or for ten seconds
  local part all=
  repeat 1000; do
    while zpty -r -t shell part 2> /dev/null; do all+=$part; done
    [[ $all == *$1* ]] && break
    sleep 0.01
  done
  print -r -- $all
}
zpty -w shell 'fpath=($PWD $fpath); autoload -U compinit; compinit -u -D; print rea''dy'
heard ready
for line completed in 'mpmvv rep' ort 'mpmvv study mi' ne.toml 'mpmvv db in' fo \
  'mpmvv run --velocity-update fl' ip 'mpmvv run --velocity-up' date; do
  zpty -w -n shell $line$'\t'
  heard $line$completed
  zpty -w -n shell $'\x15'
done
zpty -d shell
)");
  const Answer zsh = shell("cd '" + (folder_ / "") + "' && zsh -n _mpmvv && timeout 60 zsh -f drive.zsh 2>&1");
  EXPECT_EQ(zsh.code, 0) << zsh.out;
  for (const char* completed :
       {"mpmvv report", "mpmvv study mine.toml", "mpmvv db info", "--velocity-update flip", "--velocity-update "})
    EXPECT_THAT(zsh.out, HasSubstr(completed));
}

}  // namespace mpmvv::cli::manual_test
