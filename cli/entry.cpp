#include "cli/entry.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <sstream>

#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/interruption.hpp"
#include "cli/lines.hpp"
#include "studies/support/printable.hpp"
#include "studies/support/reason.hpp"
#include "studies/support/suggestion.hpp"

namespace mpmvv::cli {

namespace {

constexpr int usage_error = 2;

/// One line on standard error, whatever the message holds. Of one that quotes more than anybody reads the middle is
/// left out, for its end says what would be right.
int complain(const std::string& program, const std::string& message) {
  constexpr std::size_t longest = 2000, end = 300;
  std::string text = support::printable(support::with_suggestion(message));
  if (columns_of(text) > longest) {
    std::size_t tail = text.size() - end;
    while ((text[tail] & 0xC0) == 0x80) ++tail;  // to where a character begins
    text = cut(text, longest - end) + text.substr(tail);
  }
  note("{}: {}\n", program, text);
  return usage_error;
}

/// If a standard stream is closed, the next file that is opened gets its number, and our messages would end up in that
/// file. So a closed one is replaced by a stream that cannot be written.
void fill_standard_streams() {
  for (int k = STDIN_FILENO; k <= STDERR_FILENO; ++k)
    if (fcntl(k, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDONLY);
}

/// A write beyond the limit of a file's size, or to a pipe that nobody reads, fails and gets a message, instead of
/// ending the program. The handler is a function, because programs that this one starts would inherit an ignored
/// signal.
void survive_failed_writes() {
  for (const int write_failed : {SIGXFSZ, SIGPIPE}) std::signal(write_failed, [](int) {});
}

/// This program may have been started with SIGCHLD ignored. Then it could not wait for its children, and they would
/// inherit that.
void heed_children() {
  std::signal(SIGCHLD, SIG_DFL);
}

/// "mpmvv db info".
std::string full_name(const CLI::App& app) {
  return (app.get_parent() ? full_name(*app.get_parent()) + ' ' : "") + app.get_name();
}

/// The innermost command that was called; the program itself without one.
const CLI::App& called(const CLI::App& app) {
  const auto given = app.get_subcommands();
  return given.empty() ? app : called(*given.front());
}

std::string unknown_option(const CLI::App& app, const std::string& option) {
  std::vector<std::string> known;
  for (const CLI::Option* each : app.get_options())
    if (each->nonpositional()) known.push_back("--" + each->get_lnames().front());
  return fmt::format("unknown option '{}' in `{}` (known: {})", option, full_name(app), fmt::join(known, ", "));
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) known.push_back(command->get_name());
  return fmt::format("unknown command '{}' (known: {})", word, fmt::join(known, ", "));
}

/// Why the program cannot do what it was called for.
std::string refusal(const CLI::App& app, const CLI::ParseError& e) {
  const CLI::App& command = app.remaining().empty() ? called(app) : app;
  const auto beyond = command.remaining();
  const std::string first = beyond.empty() ? "" : beyond.front();
  std::string what = e.what();
  if (dynamic_cast<const CLI::ValidationError*>(&e)) return what;
  if (first.starts_with('-')) return unknown_option(command, first);
  if (!command.get_subcommands({}).empty()) return unknown_command(command, first);
  if (dynamic_cast<const CLI::ExtrasError*>(&e))
    return fmt::format("'{}' behind `{}` is too much (--help says what it takes)", first, full_name(command));
  if (dynamic_cast<const CLI::RequiredError*>(&e))
    return fmt::format("{} by `{}` (--help says what it is)", what, full_name(command));
  if (const auto name = what.find(": At Most"); name != std::string::npos)
    return fmt::format("{} stands there several times (once)", what.substr(0, name));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&e))
    return fmt::format("{} without its value (--help says what it takes)", what.substr(0, what.find(':')));
  return what;
}

/// An empty text is never a value: it is what a shell makes of a variable that is not set. A flag takes =true, =false
/// or nothing.
void check_values(CLI::App& app) {
  const CLI::Validator not_empty(
      [](const std::string& text) {
        return text.empty() ? "an empty text (leave it out, or give it a value)" : std::string();
      },
      "");
  const CLI::Validator true_or_false(
      [](const std::string& word) {
        return word == "true" || word == "false" ? "" : fmt::format("'{}' (true or false)", word);
      },
      "");
  for (CLI::Option* option : app.get_options())
    option->check(option->get_items_expected_max() > 0 ? not_empty : true_or_false);
  for (CLI::App* command : app.get_subcommands({})) check_values(*command);
}

/// Whether the words end where a command has to follow.
bool lacks_command(const CLI::App& app, const CLI::ParseError& e) {
  return dynamic_cast<const CLI::RequiredError*>(&e) && app.remaining(true).empty() &&
         !called(app).get_subcommands({}).empty();
}

int run(CLI::App& app, int argc, char** argv, const int& exit_code) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {
    std::ostringstream help;
    app.exit(wanted, help, help);
    print_text(help.str());
  } catch (const CLI::ParseError& e) {
    if (lacks_command(app, e)) {
      note_text(app.help());
      return usage_error;
    }
    return complain(app.get_name(), refusal(app, e));
  }
  return exit_code;
}

}  // namespace

int enter(int argc, char** argv, const std::string& name, const std::string& description, const AddCommands& add) {
  fill_standard_streams();
  survive_failed_writes();
  heed_children();
  try {
    const Interrupts interrupts(name);
    CLI::App app{description, name};
    app.formatter(std::make_shared<HelpFormatter>());
    int exit_code = 0;
    add(app, exit_code);
    check_values(app);
    exit_code = run(app, argc, argv, exit_code);
    flush_text();
    return exit_code;
  } catch (const std::exception& e) {
    return complain(name, support::reason_of(e));
  }
}

}  // namespace mpmvv::cli
