#include <algorithm>
#include <memory>

#include "cli/case_options.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/shipped.hpp"
#include "studies/codes/case_file.hpp"
#include "studies/plan/external_series.hpp"

namespace mpmvv::cli {

namespace {

/// The case; one of another code with its version and adapter, by which a study finds it.
cases::Case case_of(const CaseOptions& options) {
  std::vector<settings::Setting> settings = options.settings();
  plan::CodeFinder finder(shipped("adapters"));
  const std::string absent = finder.complete(settings, ".");
  // Where the code is absent, its version and adapter may have been given by hand.
  const auto is_adapter = [](const settings::Setting& setting) { return setting.key == "adapter"; };
  const auto is_version = [](const settings::Setting& setting) { return setting.key == "code_version"; };
  const bool has_version = std::ranges::any_of(settings, is_adapter) && std::ranges::any_of(settings, is_version);
  if (!absent.empty() && !has_version) note("mpmvv: {}; without its version the case cannot go into a store\n", absent);
  return settings::make_case(settings);
}

}  // namespace

void add_case(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CaseOptions>();
  CLI::App* command =
      app.add_subcommand("case", "Print a case as JSON: what another code's input and its score are made from");
  options->add_to(*command);
  add_examples(*command, {"mpmvv case --problem square-rest --cells 16 --ppc 2 --cfl 0.2 --end-time 0.008 > case.json",
                          "mpmvv case --code small-mpm --variant linear --problem bar --cells 4 --ppc 2 --cfl 0.2"});
  command->callback([options, &exit_code] {
    print_text(codes::case_text(case_of(*options)));
    exit_code = 0;
  });
}

}  // namespace mpmvv::cli
