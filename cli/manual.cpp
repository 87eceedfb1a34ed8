#include <memory>

#include "cli/checks.hpp"
#include "cli/command.hpp"
#include "cli/completion.hpp"
#include "cli/console.hpp"
#include "cli/man_page.hpp"

namespace mpmvv::cli {

/// The build calls both commands for what it installs. They are of no group, which hides them from people.
void add_manual(CLI::App& app, int&) {
  CLI::App* man = app.add_subcommand("man", "Print the page for man")->group("");
  man->callback([&app] { print_text(man_page(command_text(app))); });
  auto shell = std::make_shared<std::string>();
  CLI::App* completion = app.add_subcommand("completion", "Print the completion script of a shell")->group("");
  completion->add_option("shell", *shell, "bash, zsh or fish")->required()->check(one_of({"bash", "zsh", "fish"}));
  completion->callback([&app, shell] {
    const CommandText program = command_text(app);
    print_text(*shell == "bash"  ? bash_completion(program)
               : *shell == "zsh" ? zsh_completion(program)
                                 : fish_completion(program));
  });
}

}  // namespace mpmvv::cli
