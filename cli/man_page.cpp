#include "cli/man_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace mpmvv::cli {

namespace {

/// Escapes a text for roff: no line is taken for a command, no backslash for an escape, and every sign stays what it is
/// in ASCII, as a shell needs it.
std::string roff(const std::string& text) {
  static const std::map<char, const char*> escapes{{'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"}, {'`', "\\(ga"},
                                                   {'^', "\\(ha"}, {'~', "\\(ti"}, {'\n', "\n\\&"}};
  std::string out = "\\&";
  for (const char c : text) {
    const auto escape = escapes.find(c);
    out += escape == escapes.end() ? std::string(1, c) : escape->second;
  }
  return out;
}

std::string capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// "--db FILE", in bold and italics.
std::string head_of(const ArgumentText& argument) {
  if (argument.flags.empty()) return fmt::format("\\fI{}\\fR", roff(argument.name));
  std::vector<std::string> flags;
  for (const std::string& flag : argument.flags) flags.push_back(fmt::format("\\fB{}\\fR", roff(flag)));
  const std::string value = argument.value.empty() ? "" : fmt::format(" \\fI{}\\fR", roff(argument.value));
  return fmt::format("{}{}", fmt::join(flags, ", "), value);
}

std::string entry_of(const ArgumentText& argument) {
  const std::string required = argument.required ? " Required." : "";
  return fmt::format(".TP\n{}\n{}\n", head_of(argument), roff(argument.meaning + "." + required));
}

/// "mpmvv gate --db FILE [options]".
std::string usage_of(const CommandText& command) {
  std::string usage = fmt::format("\\fBmpmvv {}\\fR", roff(command.path));
  for (const ArgumentText& option : command.options)
    if (option.required) usage += " " + head_of(option);
  for (const ArgumentText& positional : command.positionals) {
    const std::string name = head_of(positional) + (positional.repeatable ? " ..." : "");
    usage += positional.required ? " " + name : fmt::format(" [{}]", name);
  }
  return usage + " [\\fIoptions\\fR]";
}

/// What stands at the end of a command's help, line by line.
std::string footer_of(const CommandText& command) {
  if (command.footer.empty()) return "";
  return fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.footer));
}

/// The section of a command. One that has commands of its own is shown by these alone.
std::string section_of(const CommandText& command) {
  std::string text;
  if (command.commands.empty()) {
    text = fmt::format(".SS {}\n{}\n.PP\n{}\n", roff("mpmvv " + command.path), usage_of(command),
                       roff(command.meaning + "."));
    for (const ArgumentText& argument : command.positionals) text += entry_of(argument);
    for (const ArgumentText& option : command.options)
      if (option.flags.back() != "--help") text += entry_of(option);
    text += footer_of(command);
  }
  for (const CommandText& inner : command.commands) text += section_of(inner);
  return text;
}

constexpr const char* ending = R"(.SH EXIT STATUS
.TP
0
what was asked for was done; of \fBgate\fR: every golden passes. A run that blows up is a result, and so is a claim that
\fBclaims\fR shows as refuted
.TP
1
a run of \fBrun\fR, \fBscore\fR or \fBstudy\fR has failed or a study could not be kept, \fBgate\fR has found a
regression, \fBcost\fR a case that is slower, \fBdb check\fR a store that is damaged
.TP
2
bad input: one line on standard error says what is wrong, where, and what would be right; nothing is written
.TP
3
\fBstudy\fR has left out a study whose code is not there, \fBgate\fR lacks a result or knows it too badly, \fBcost\fR
had nothing to compare or too much noise
.TP
130
the command was interrupted, and has ended what it had started; what \fBrun\fR and \fBstudy\fR had finished is kept
.SH FILES
Below the prefix that the program was installed to:
.TP
share/mpmvv/studies, share/mpmvv/goldens
the studies that come with the program, and their goldens
.TP
share/doc/mpmvv/docs/first\-study.md
from a study file to a gate that passes, in five commands
)";

}  // namespace

std::string man_page(const CommandText& program) {
  std::string text = fmt::format(".TH {} 1 \"\" {} \"\"\n.SH NAME\n{} \\- {}\n", capitals(program.name), program.name,
                                 program.name, roff(program.meaning));
  text += fmt::format(".SH SYNOPSIS\n\\fB{0}\\fR \\fIcommand\\fR [\\fIoptions\\fR]\n", program.name);
  text += ".SH OPTIONS\n";
  for (const ArgumentText& option : program.options) text += entry_of(option);
  text += footer_of(program);
  text += ".SH COMMANDS\n";
  for (const CommandText& command : program.commands) text += section_of(command);
  return text + ending;
}

}  // namespace mpmvv::cli
