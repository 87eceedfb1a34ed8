#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cstdio>
#include <exception>

#include "cli/command.hpp"
#include "studies/provenance.hpp"

namespace mpmvv {

void print_json(const nlohmann::json& object) {
  fmt::print("{}\n", object.dump(2));
}

namespace {

constexpr int usage_error = 2;

/// One line on standard error, whatever the message holds.
int complain(const std::string& message) {
  std::string line;
  for (const char c : message) line += std::iscntrl(static_cast<unsigned char>(c)) ? ' ' : c;
  fmt::print(stderr, "mpmvv: {}\n", line);
  return usage_error;
}

std::string version() {
  const Provenance own = current_provenance();
  return fmt::format("mpmvv {}{}\ndigest {}\n{}, {}", own.commit, own.dirty ? " with changes" : "", own.digest,
                     own.compiler, own.build_type);
}

std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
  return fmt::format("unknown command '{}' (known: {})", argc > 1 ? argv[1] : "", fmt::join(known, ", "));
}

/// An empty text is never a value: it is what a shell makes of a variable that is not set.
void refuse_empty_texts(CLI::App& app) {
  const CLI::Validator not_empty(
      [](const std::string& text) {
        return text.empty() ? "an empty text (leave it out, or give it a value)" : std::string();
      },
      "");
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() > 0) option->check(not_empty);
  for (CLI::App* command : app.get_subcommands({})) refuse_empty_texts(*command);
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
  refuse_empty_texts(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& e) {
    return complain(app.get_subcommands().empty() ? unknown_command(app, argc, argv) : e.what());
  }
  return exit_code;
}

}  // namespace
}  // namespace mpmvv

int main(int argc, char** argv) {
  constexpr const char* no_room = "cannot write to standard output (a place with room)";
  int exit_code = 0;
  try {
    exit_code = mpmvv::run_program(argc, argv);
    if (std::fflush(stdout) != 0) return mpmvv::complain(no_room);
  } catch (const std::exception& e) {
    return mpmvv::complain(std::ferror(stdout) != 0 ? no_room : e.what());  // fmt says less
  }
  return exit_code;
}
