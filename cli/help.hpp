#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace mpmvv::cli {

/// `--help` as wide as the terminal: meanings are wrapped beside the options, which say what value they take,
/// and examples are continued as a shell reads them.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_description(const CLI::App* command) const override;
  std::string make_footer(const CLI::App* command) const override;
};

/// Ends a command's help with calls of it.
void add_examples(CLI::App& command, const std::vector<std::string>& calls);

}  // namespace mpmvv::cli
