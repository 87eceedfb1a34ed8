#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>

#include "cli/command.hpp"
#include "studies/error.hpp"

namespace mpmvv {

void print_json(const nlohmann::json& object) {
  fmt::print("{}\n", object.dump(2));
}

namespace {

constexpr int failure = 1, usage_error = 2;

/// One line on standard error: the first of the message.
int complain(std::string message, int code) {
  message.resize(std::min(message.find('\n'), message.size()));
  fmt::print(stderr, "mpmvv: {}\n", message);
  return code;
}

int run_program(int argc, char** argv) {
  CLI::App app{"Verification and validation of the Material Point Method", "mpmvv"};
  app.require_subcommand(1);
  int exit_code = 0;
  add_run(app, exit_code);
  add_solution(app, exit_code);
  add_study(app, exit_code);
  add_gate(app, exit_code);
  add_propose(app, exit_code);
  add_report(app, exit_code);
  add_claims(app, exit_code);
  add_list(app, exit_code);
  add_db(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& e) {
    return complain(e.what(), usage_error);
  }
  return exit_code;
}

}  // namespace
}  // namespace mpmvv

int main(int argc, char** argv) {
  try {
    return mpmvv::run_program(argc, argv);
  } catch (const mpmvv::UsageError& e) {
    return mpmvv::complain(e.what(), mpmvv::usage_error);
  } catch (const std::exception& e) {
    return mpmvv::complain(e.what(), mpmvv::failure);
  }
}
