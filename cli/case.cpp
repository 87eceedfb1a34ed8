#include <memory>

#include "cli/case_options.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "studies/codes/case_file.hpp"

namespace mpmvv::cli {

void add_case(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CaseOptions>();
  CLI::App* command =
      app.add_subcommand("case", "Print a case as JSON: what another code's input and its score are made from");
  options->add_to(*command);
  add_examples(*command, {"mpmvv case --problem square-rest --cells 16 --ppc 2 --cfl 0.2 > case.json"});
  command->callback([options, &exit_code] {
    print_text(codes::case_text(options->the_case()));
    exit_code = 0;
  });
}

}  // namespace mpmvv::cli
