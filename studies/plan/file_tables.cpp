#include "studies/plan/file_tables.hpp"

#include <algorithm>

namespace mpmvv::plan {

namespace {

FileTable top_of_the_file() {
  return {
      "",
      "The file",
      "Keys that stand before the first table. A study has series with a sweep, a limit or both; or it has a check.",
      false,
      {{"title", "text", "", "what the study asks, in a line"},
       {"claims", "texts", "none",
        "ids of claims that it judges and another file states, beside it or shipped ([claims.md](claims.md))"},
       {"check", "text", "none",
        "a property that is measured instead of runs (`mpmvv list checks`); then there is no `fixed`, `series`, "
        "`sweep`, `limit` or `replicates`"}}};
}

FileTable claim_table() {
  return {"claim",
          "[[claim]]",
          "A claim that the study states and judges. Other studies may name it by its id.",
          false,
          {{"id", "text", "", "a word that no other claim has"},
           {"statement", "text", "", "what is claimed: a sentence that a study can judge"},
           {"source", "text", "none", "who claims it, \"Steffen et al. 2008\""},
           {"where", "text", "none", "the place in the source, \"Fig. 10\""}}};
}

FileTable limit_table() {
  return {
      "limit",
      "[limit]",
      "Searches the stability limit: a scan from `from` to `to`, then bisection "
      "([measuring.md](measuring.md#stability-limit)). If the sweep is over `cells`, the search takes the "
      "`cells` of `[fixed]` or of the series. Both ends of the bracket were run, with steps that divide the end time.",
      false,
      {{"key", "text", "", "what is varied: `cfl` or `smoothing_length`"},
       {"from", "number", "", "the scan's smallest value"},
       {"to", "number", "", "the scan's largest value"},
       {"scan_ratio", "number", "1.1", "neighbours of the scan differ by this factor at most"},
       {"tolerance", "number", "0.01", "bisection ends when the bracket is this narrow, relative to its stable end"},
       {"stable", "text", "`below`", "on which side runs are stable: `below` the limit or `above` it"},
       {"series", "names of series", "all", "those whose limit is searched"}}};
}

FileTable fit_table() {
  return {"fit",
          "[[fit]]",
          "Fits the order of a norm ([measuring.md](measuring.md#observed-order)).",
          false,
          {{"norm", "text", "", "what is fitted, a name of [measuring.md](measuring.md#errors)"},
           {"window", "two numbers", "", "first and last swept value that count; three values or more"},
           {"floor_window", "two numbers", "none",
            "a second fit, with a floor, over six values or more ([measuring.md](measuring.md#floor))"},
           {"series", "names of series", "all", "those that are fitted; those that turn the norm off are left out"}}};
}

FileTable extrapolate_table() {
  return {
      "extrapolate",
      "[[extrapolate]]",
      "Extrapolates a quantity to h = 0 in a sweep over `cells`, to dt = 0 or cfl = 0 in one over these: one without "
      "an "
      "exact value, or an error, of which it gives the part that is left ([measuring.md](measuring.md#extrapolation)).",
      false,
      {{"norm", "text", "", "which quantity"},
       {"window", "two numbers", "", "first and last swept value that count; four values or more"},
       {"series", "names of series", "all", "those that are extrapolated"}}};
}

FileTable figure_table() {
  return {
      "figure",
      "[[figure]]",
      "A figure of the report. Captions, labels and names of series are no LaTeX: `$` is a dollar sign, while `u_h`, "
      "`h^2`, `σ` and single letters are set as mathematics ([figures.md](figures.md#texts)).",
      false,
      {{"caption", "text", "", "what it shows"},
       {"xlabel", "text", "", "label of the axis to the right"},
       {"ylabel", "text", "", "label of the axis upwards"},
       {"name", "text", "the study's", "name of its files, if the study has more than one figure"},
       {"kind", "text", "`curves`",
        "`curves`: a quantity against the swept value; `work-precision`: against the measured cost, where every "
        "series has `repeat`; `particles`: particles and voxels that a check has recorded, or the particles of each "
        "series' last sound run, coloured by their errors, where every series has `particle_errors`"},
       {"quantity", "text", "`l2`", "what is drawn, a norm; `y` where a check brings the curves; not with `particles`"},
       {"xscale", "text", "`log`", "`log` or `linear`; not with `particles`"},
       {"yscale", "text", "`log`", "`log` or `linear`; not with `particles`"},
       {"x_range", "two numbers", "as the points are", "where the axis begins and ends"},
       {"y_range", "two numbers", "as the points are", "where the axis begins and ends"},
       {"series", "names of series", "all", "those that are drawn; those that turn the quantity off are left out"},
       {"marks", "names of series", "none", "those that are drawn as points without a line"},
       {"slopes", "numbers", "none", "powers of h to draw for comparison"}}};
}

FileTable criterion_table() {
  return {
      "criterion",
      "[[criterion]]",
      "What is asked of the results, as a number with bounds. All criteria of a claim make its verdict "
      "([measuring.md](measuring.md#criteria-and-verdicts)). Commit a criterion before its first full run; "
      "if its bounds, its window or all of it came later, the end of its `statement` says so: `(bounds set after a "
      "run)` "
      "([how-sure.md](how-sure.md#before-or-after-the-run)).",
      false,
      {{"claim", "text", "", "id of a claim that the file names or states"},
       {"statement", "text", "", "what is asked, in a sentence"},
       {"measure", "text", "", "the number: a word of [Measures](#measures)"},
       {"series", "names of series", "as [Measures](#measures) says", "the series whose number it is; each must pass"},
       {"over", "name of a series", "as [Measures](#measures) says", "the series that ratios divide by"},
       {"name", "text", "as [Measures](#measures) says", "name of a check's value"},
       {"norm", "text", "as [Measures](#measures) says",
        "which error; of `slope-ratio` and `slope-share` also a time, `ns_per_particle_step`"},
       {"over_norm", "text", "as [Measures](#measures) says", "the norm whose order is subtracted"},
       {"window", "two numbers", "as [Measures](#measures) says", "first and last swept value that count"},
       {"at_least", "number", "no bound", "the least that the number may be; this or `at_most` or both"},
       {"at_most", "number", "no bound", "the most that the number may be"},
       {"reason", "text", "none",
        "why it fails, written after looking at the evidence; of `awaited`: what would decide it"}}};
}

}  // namespace

const std::vector<FileTable>& file_tables() {
  static const std::vector<FileTable> tables{
      top_of_the_file(),
      claim_table(),
      {"fixed",
       "[fixed]",
       "[Settings](#settings) of all series. `param = { amplitude = 0.02 }` gives values of the problem "
       "(`mpmvv list problems`).",
       true,
       {}},
      {"series",
       "[[series]]",
       "A line of the study's figure: its own [settings](#settings) go before those of `[fixed]`.",
       true,
       {{"name", "text", "", "what figures and tables call it"}}},
      {"sweep",
       "[sweep]",
       "One numeric key of the [settings](#settings) with the values that it takes in turn; "
       "`param.amplitude = [0.01, 0.02]` varies a value of the problem.",
       true,
       {}},
      limit_table(),
      {"replicates",
       "[replicates]",
       "One key of the [settings](#settings) that should not matter, `grid_offset` or `shuffle`, with two values or "
       "more: every point becomes the mean of such runs, and a limit is searched for each "
       "([how-sure.md](how-sure.md)).",
       true,
       {}},
      fit_table(),
      extrapolate_table(),
      figure_table(),
      criterion_table()};
  return tables;
}

void require_known_keys(const support::TomlTable& table, const std::string& name) {
  std::vector<std::string> known;
  for (const FileKey& key : std::ranges::find(file_tables(), name, &FileTable::name)->keys) known.push_back(key.key);
  if (name.empty())
    for (const FileTable& inner : file_tables())
      if (!inner.name.empty()) known.push_back(inner.name);
  table.allow_only(known);
}

}  // namespace mpmvv::plan
