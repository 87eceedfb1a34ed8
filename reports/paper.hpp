#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "reports/origin.hpp"
#include "reports/sheet.hpp"
#include "studies/records/result.hpp"
#include "studies/store/code_series.hpp"

namespace mpmvv::reports {

/// What a call wrote.
struct PaperSummary {
  int figures = 0, figures_drawn = 0;
  int tables = 0;                    ///< files of tables
  std::vector<std::string> without;  ///< figures of the papers that were not drawn, and why
  std::vector<std::string> trials;   ///< among the studies that it shows, "STUDY: what was set"
  std::vector<std::string> remarks;  ///< what will not look as it was meant, "FIGURE: why"
};

/// Writes OUT/main.tex, which latexmk compiles, OUT/figures/NAME.{tex,pdf,gp,dat} and OUT/tables/*.tex: the figures of
/// the papers in their order, then those of all other studies, and in each part its fitted orders (orders-KEY.tex), its
/// extrapolated values (extrapolations-KEY.tex) and the errors, limits and costs of each study (errors-STUDY.tex, ...).
/// With names, what these mean, in their order (PaperDocument). It says of the studies that it shows where they come
/// from, and the versions of the codes that ran them. Throws UsageError when a name means nothing, gnuplot is missing
/// or fails, or a file cannot be written.
PaperSummary write_paper(const std::vector<records::StudyResult>& studies, const Provenances& provenances,
                         const std::filesystem::path& out_dir, const Sheet& column,
                         const std::vector<std::string>& names = {}, const std::vector<store::CodeSeries>& codes = {});

}  // namespace mpmvv::reports
