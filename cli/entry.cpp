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
#include "studies/support/reason.hpp"

namespace mpmvv::cli {

namespace {

constexpr int usage_error = 2;

/// One line on standard error, whatever the message holds.
int complain(const std::string& program, const std::string& message) {
  note("{}: {}\n", program, message);
  return usage_error;
}

/// If a standard stream is closed, the next file that is opened gets its number, and our messages would end up in that
/// file. So a closed one is replaced by a stream that cannot be written.
void fill_standard_streams() {
  for (int k = STDIN_FILENO; k <= STDERR_FILENO; ++k)
    if (fcntl(k, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDONLY);
}

/// A write beyond the limit of a file's size, or to a pipe that nobody reads, fails and gets a message, instead of
/// ending the program. A function, as other programs that this one starts would inherit that a signal is ignored.
void survive_failed_writes() {
  for (const int write_failed : {SIGXFSZ, SIGPIPE}) std::signal(write_failed, [](int) {});
}

std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) known.push_back(command->get_name());
  return fmt::format("unknown command '{}' (known: {})", argc > 1 ? argv[1] : "", fmt::join(known, ", "));
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

int run(CLI::App& app, int argc, char** argv, const int& exit_code) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {
    std::ostringstream help;
    app.exit(wanted, help, help);
    print_text(help.str());
  } catch (const CLI::ValidationError& e) {
    return complain(app.get_name(), e.what());
  } catch (const CLI::ParseError& e) {
    const bool lacks_command = !app.get_subcommands({}).empty() && app.get_subcommands().empty();
    return complain(app.get_name(), lacks_command ? unknown_command(app, argc, argv) : e.what());
  }
  return exit_code;
}

}  // namespace

int enter(int argc, char** argv, const std::string& name, const std::string& description, const AddCommands& add) {
  fill_standard_streams();
  survive_failed_writes();
  try {
    CLI::App app{description, name};
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
