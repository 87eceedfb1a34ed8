#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "studies/store/provenance.hpp"
#include "studies/support/reason.hpp"

namespace mpmvv::cli {

void print_json(const nlohmann::json& object) {
  constexpr bool only_ascii = true;  // no character that a terminal obeys
  print_text(object.dump(2, ' ', only_ascii, nlohmann::json::error_handler_t::replace) + "\n");
}

namespace {

constexpr int usage_error = 2;

/// One line on standard error, whatever the message holds.
int complain(const std::string& message) {
  note("mpmvv: {}\n", message);
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

std::string version() {
  const store::Provenance own = store::current_provenance();
  return fmt::format("mpmvv {}{}\ndigest {}\n{}, {}", own.commit, own.dirty ? " with changes" : "", own.digest,
                     own.compiler, own.build_type);
}

std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
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

int run_program(int argc, char** argv) {
  CLI::App app{"Verification and validation of the Material Point Method", "mpmvv"};
  app.require_subcommand(1);
  app.set_version_flag("--version", version, "Print the commit, the digest of what decides a result, and the compiler");
  int exit_code = 0;
  add_run(app, exit_code);
  add_solution(app, exit_code);
  add_study(app, exit_code);
  add_gate(app, exit_code);
  add_propose(app, exit_code);
  add_report(app, exit_code);
  add_compare(app, exit_code);
  add_trend(app, exit_code);
  add_cost(app, exit_code);
  add_claims(app, exit_code);
  add_mutants(app, exit_code);
  add_list(app, exit_code);
  add_db(app, exit_code);
  check_values(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {
    std::ostringstream help;
    app.exit(wanted, help, help);
    print_text(help.str());
  } catch (const CLI::ValidationError& e) {
    return complain(e.what());
  } catch (const CLI::ParseError& e) {
    return complain(app.get_subcommands().empty() ? unknown_command(app, argc, argv) : e.what());
  }
  return exit_code;
}

}  // namespace
}  // namespace mpmvv::cli

int main(int argc, char** argv) {
  mpmvv::cli::fill_standard_streams();
  mpmvv::cli::survive_failed_writes();
  try {
    const int exit_code = mpmvv::cli::run_program(argc, argv);
    mpmvv::cli::flush_text();
    return exit_code;
  } catch (const std::exception& e) {
    return mpmvv::cli::complain(mpmvv::support::reason_of(e));
  }
}
