#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/entry.hpp"
#include "cli/help.hpp"
#include "studies/store/provenance.hpp"

namespace mpmvv::cli {

namespace {

std::string version() {
  const store::Provenance own = store::current_provenance();
  return fmt::format("mpmvv {}{}\ndigest {}\n{}, {}", own.commit, own.dirty ? " with changes" : "", own.digest,
                     own.compiler, own.build_type);
}

void add_commands(CLI::App& app, int& exit_code) {
  app.require_subcommand(1);
  app.set_version_flag("--version", version, "Print the commit, the digest of what decides a result, and the compiler");
  add_run(app, exit_code);
  add_solution(app, exit_code);
  add_particles(app, exit_code);
  add_expression(app, exit_code);
  add_case(app, exit_code);
  add_score(app, exit_code);
  add_study(app, exit_code);
  add_submit(app, exit_code);
  add_gate(app, exit_code);
  add_propose(app, exit_code);
  add_report(app, exit_code);
  add_figure(app, exit_code);
  add_paper(app, exit_code);
  add_compare(app, exit_code);
  add_trend(app, exit_code);
  add_cost(app, exit_code);
  add_claims(app, exit_code);
  add_list(app, exit_code);
  add_db(app, exit_code);
  add_manual(app, exit_code);
  add_examples(app, {"mpmvv run --problem bar --basis bspline2 --integrator cd --cells 64 --ppc 4 --cfl 0.2",
                     "mpmvv study s-fig4 --db results.db", "mpmvv claims --db results.db",
                     "mpmvv report --db results.db --out report"});
}

}  // namespace
}  // namespace mpmvv::cli

int main(int argc, char** argv) {
  return mpmvv::cli::enter(argc, argv, "mpmvv", "Verification and validation of the Material Point Method",
                           mpmvv::cli::add_commands);
}
