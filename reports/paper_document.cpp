#include "reports/paper_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "reports/convergence_table.hpp"
#include "reports/figure_choice.hpp"
#include "reports/latex_table.hpp"
#include "reports/orders_table.hpp"
#include "reports/plot.hpp"
#include "reports/table.hpp"
#include "reports/text.hpp"
#include "reports/typeset.hpp"

namespace mpmvv::reports {

using records::StudyResult;

namespace {

using Chosen = std::vector<const StudyResult*>;

std::string latex_of(const std::string& text) {
  return typeset(text, Notation::latex);
}

/// Whether these words say no more than which figure: "2(a)", "16.4, left".
bool name_a_figure(std::string_view words) {
  const auto blank = words.find(' ');
  return blank == std::string_view::npos ||
         (words.find(", ") + 1 == blank && words.find(' ', blank + 1) == std::string_view::npos);
}

/// The caption without "Compare S Fig. 2(a).", which the figure's label says already.
std::string own_caption(const Chart& chart) {
  const std::string text = chart.caption + ' ';  // so that its last sentence ends as the others do
  const auto begin = text.find(" Compare "), label = text.find(" Fig. ", begin);
  if (label != begin + std::string_view(" Compare S").size()) return chart.caption;
  const auto number = label + std::string_view(" Fig. ").size(), end = text.find(". ", number);
  if (end == std::string::npos || !name_a_figure(text.substr(number, end - number))) return chart.caption;
  return chart.caption.substr(0, begin) + chart.caption.substr(end + 1);
}

/// The caption in LaTeX, with what tells of a trial and of what the figure leaves out.
std::string whole_caption(const Chart& chart, const std::string& caption) {
  std::string text = latex_of(caption);
  if (!chart.trial.empty()) text += " " + latex_text(chart.trial);
  for (const std::string& omission : chart.omissions) text += " " + latex_of(omission);
  return text;
}

template <class Belongs>
Chosen studies_where(const std::vector<StudyResult>& studies, const Belongs& belongs) {
  Chosen chosen;
  for (const StudyResult& study : studies)
    if (belongs(study)) chosen.push_back(&study);
  return chosen;
}

/// A study's table below a line that says what it is; empty without rows.
std::string headed(const StudyResult& study, const Table& table) {
  if (table.empty()) return "";
  const std::string trial = trial_sentence(study);
  return fmt::format("\\par\\medskip\\noindent{{\\footnotesize {}. {}.{}\\par}}\n{}", latex_text(study.title),
                     latex_of(table.caption), trial.empty() ? "" : " " + latex_text(trial), latex_tables({table}));
}

/// The tables of these studies that have rows; `key` tells the files of a part from those of others.
std::vector<PrintedTables> printed_tables(const Chosen& studies, const std::string& key) {
  std::vector<PrintedTables> all{{"orders-" + key, latex_long_table(orders_table(studies))},
                                 {"extrapolations-" + key, latex_long_table(extrapolated_table(studies))}};
  for (const StudyResult* study : studies) {
    all.push_back({"errors-" + study->name, latex_convergence_tables(*study)});
    all.push_back({"limits-" + study->name, headed(*study, limits_table(*study))});
    all.push_back({"costs-" + study->name, headed(*study, cheapest_table(*study))});
  }
  std::erase_if(all, [](const PrintedTables& tables) { return tables.text.empty(); });
  return all;
}

bool has_results(const PaperPart& part) {
  return !part.figures.empty() || !part.tables.empty();
}

}  // namespace

std::string letter_of(std::size_t panel) {
  return fmt::format("({})", static_cast<char>('a' + panel));
}

PaperDocument::PaperDocument(const std::vector<StudyResult>& studies, const Sheet& column,
                             const std::vector<std::string>& names)
    : studies_(studies), column_(column), charts_(charts_of_all(studies, letter_on(column))) {
  for (std::size_t i = 0; i < studies.size(); ++i)
    for (const Chart& chart : charts_[i]) by_name_[chart.name] = &chart, study_of_[chart.name] = &studies[i];
  if (!names.empty()) {
    add(the_named(names));
    return;
  }
  for (const StudyResult& study : studies) shown_.push_back(&study);
  for (const Paper& paper : papers()) {
    PaperPart part = part_of(paper);
    if (!has_results(part)) absent_.push_back(paper.source);
    add(std::move(part));
  }
  if (parts_.empty()) absent_.clear();
  add(the_rest());
}

void PaperDocument::add(PaperPart part) {
  if (has_results(part)) parts_.push_back(std::move(part));
}

PaperPart PaperDocument::part_of(const Paper& paper) {
  PaperPart part{paper.source, {}, {}, {}};
  part.tables =
      printed_tables(studies_where(studies_, [&](const StudyResult& s) { return paper.has(s.name); }), paper.key);
  for (const PaperFigure& figure : paper.figures) add_figure(part, figure, paper.key + " Fig. " + figure.number);
  return part;
}

void PaperDocument::add_figure(PaperPart& part, const PaperFigure& figure, const std::string& label) {
  std::vector<std::string> drawn, absent;
  for (const auto& name : figure.panels) (by_name_.contains(name) ? drawn : absent).push_back(name);
  const char* how_far = drawn.empty() ? "" : "wholly ";
  for (const auto& name : absent)
    part.missing.push_back(fmt::format("{} is not {}drawn: the store has no figure {}.", label, how_far, name));
  if (!figure.without.empty()) part.missing.push_back(fmt::format("{} is not drawn: {}.", label, figure.without));
  if (drawn.empty()) return;
  PrintedFigure printed{{}, latex_text(label + "."), figure.wide};
  for (const auto& name : drawn) {
    const Chart& chart = *by_name_.at(name);
    printed.caption += (drawn.size() == 1 ? " " : " " + letter_of(printed.panels.size()) + " ") +
                       whole_caption(chart, own_caption(chart));
    printed.panels.push_back(&chart);
    taken_.insert(name);
  }
  if (!figure.differs.empty()) printed.caption += latex_of(" Not as in the original: " + figure.differs + ".");
  part.figures.push_back(std::move(printed));
}

PrintedFigure PaperDocument::alone(const Chart& chart) const {
  constexpr double tallest = 180;  ///< mm, with which a page still has room for a caption
  const bool takes_two_columns = !has_room(chart, column_) || height_of(chart, column_) > tallest;
  return {{&chart}, latex_text(chart.name + ".") + " " + whole_caption(chart, chart.caption), takes_two_columns};
}

PaperPart PaperDocument::the_rest() const {
  PaperPart part{"Further studies", {}, {}, {}};
  for (const auto& of_study : charts_)
    for (const Chart& chart : of_study)
      if (!taken_.contains(chart.name)) part.figures.push_back(alone(chart));
  const auto is_further = [](const StudyResult& study) {
    return std::ranges::none_of(papers(), [&](const Paper& paper) { return paper.has(study.name); });
  };
  part.tables = printed_tables(studies_where(studies_, is_further), "further");
  return part;
}

/// The charts that a name means; none of a study that draws nothing.
std::vector<std::string> PaperDocument::charts_named(const std::string& name) const {
  for (std::size_t i = 0; i < studies_.size(); ++i)
    if (studies_[i].name == name && charts_[i].empty()) return {};
  std::vector<std::string> names;
  for (const Chart& chart : choose_figures(studies_, name).chosen) names.push_back(chart.name);
  return names;
}

PaperPart PaperDocument::the_named(const std::vector<std::string>& names) {
  PaperPart part{"Figures and tables", {}, {}, {}};
  const auto add_study = [&](const StudyResult* study) {
    if (std::ranges::find(shown_, study) == shown_.end()) shown_.push_back(study);
  };
  for (const std::string& name : names) {
    const auto charts = charts_named(name);
    for (const std::string& chart : charts) {
      if (taken_.insert(chart).second) part.figures.push_back(alone(*by_name_.at(chart)));
      add_study(study_of_.at(chart));
    }
    if (charts.empty()) add_study(&*std::ranges::find(studies_, name, &StudyResult::name));
  }
  part.tables = printed_tables(shown_, "named");
  return part;
}

}  // namespace mpmvv::reports
