#include "reports/paper.hpp"

#include <memory>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/length.hpp"
#include "cli/numbers.hpp"
#include "cli/outputs.hpp"
#include "cli/results.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

namespace {

struct PaperOptions {
  std::vector<std::string> names;
  std::string db, out, width = "84mm", font_size = "8pt";
};

int paper(const PaperOptions& options) {
  require_apart("--out", options.out, {options.db});
  reports::Sheet column;
  column.format = reports::Format::tex;
  column.width = figure_width(options.width);
  column.font_size = figure_font_size(options.font_size);
  const auto studies = own_results(options.db);
  require_own_results(studies, options.db);
  const store::Store store(options.db, store::Store::Mode::read);
  const auto codes = store.code_series(store::current_provenance().digest);
  const auto summary =
      reports::write_paper(studies, provenances_of(studies, store), options.out, column, options.names, codes);
  print("{}/main.tex: {} ({} drawn), {}\n", options.out,
        count_text(static_cast<std::size_t>(summary.figures), "figure"), summary.figures_drawn,
        count_text(static_cast<std::size_t>(summary.tables), "table"));
  for (const auto& missing : summary.without) print("  {}\n", missing);
  for (const auto& trial : summary.trials) note("{}\n", trial);
  for (const auto& remark : summary.remarks) note("{}\n", remark);
  return 0;
}

}  // namespace

void add_paper(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<PaperOptions>();
  CLI::App* command = app.add_subcommand("paper", "Write figures, orders and errors as a LaTeX document");
  command
      ->add_option("names", options->names,
                   "figures, claims or studies, in the order of the document (default: all of the store)")
      ->type_name("NAME");
  command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
  command->add_option("--out", options->out, "folder of the document")->required()->type_name("FOLDER");
  command->add_option("--width", options->width, "of a column (default: 84mm)")->type_name("LENGTH");
  command->add_option("--font-size", options->font_size, "of the figures' texts (default: 8pt)")->type_name("LENGTH");
  add_examples(*command,
               {"mpmvv paper --db results.db --out paper", "mpmvv paper splines --db results.db --out paper"});
  command->callback([options, &exit_code] { exit_code = paper(*options); });
}

}  // namespace mpmvv::cli
