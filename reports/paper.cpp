#include "reports/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>

#include "page_template.hpp"
#include "reports/chart.hpp"
#include "reports/orders_table.hpp"
#include "reports/papers.hpp"
#include "reports/plot.hpp"
#include "reports/template_data.hpp"
#include "reports/text.hpp"
#include "reports/text_remarks.hpp"
#include "reports/typeset.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::reports {

namespace fs = std::filesystem;
using records::StudyResult;
using template_data::data;
using template_data::list_of;
using template_data::object;
using template_data::text_list;

namespace {

/// A figure of the document: charts side by side under one caption, which is LaTeX.
struct PrintedFigure {
  std::vector<const Chart*> panels;
  std::string caption;
  bool wide = false;
};

struct Part {
  std::string title;
  std::vector<PrintedFigure> figures;
  std::vector<std::string> missing;  ///< figures that are not drawn, and why
  std::string orders_name, orders;
};

std::string latex(const std::string& text) {
  return typeset(text, Notation::latex);
}

/// The caption without "Compare S Fig. 2(a).", which the figure's label says already.
std::string own_caption(const Chart& chart) {
  static const std::regex comparison(R"( Compare [A-Z] Fig\. [^ ]*[^ .](, [a-z]+)?\.)");
  return std::regex_replace(chart.caption, comparison, "");
}

/// The caption in LaTeX, with what tells of a trial and of what the figure leaves out.
std::string whole_caption(const Chart& chart, const std::string& caption) {
  std::string text = latex(caption);
  if (!chart.trial.empty()) text += " " + latex_text(chart.trial);
  for (const std::string& omission : chart.omissions) text += " " + latex(omission);
  return text;
}

/// "(a)", "(b)".
std::string letter_of(std::size_t panel) {
  return fmt::format("({})", static_cast<char>('a' + panel));
}

bool is_of(const StudyResult& study, const Paper& paper) {
  const char letter = static_cast<char>(std::tolower(static_cast<unsigned char>(paper.key[0])));
  return study.name.starts_with(std::string{letter, '-'});
}

/// Sorts the figures and orders of studies into the parts of a document.
class Document {
 public:
  Document(const std::vector<StudyResult>& studies, const Sheet& column)
      : studies_(studies), column_(column), charts_(charts_of_all(studies, paper_letter)) {
    for (const auto& of_study : charts_)
      for (const Chart& chart : of_study) by_name_[chart.name] = &chart;
    for (const Paper& paper : papers()) add(part_of(paper));
    add(the_rest());
  }

  const std::vector<Part>& parts() const { return parts_; }

 private:
  void add(Part part) {
    if (!part.figures.empty() || !part.orders.empty()) parts_.push_back(std::move(part));
  }

  template <class Belongs>
  std::string orders_of(const Belongs& belongs) const {
    std::vector<const StudyResult*> chosen;
    for (const StudyResult& study : studies_)
      if (belongs(study)) chosen.push_back(&study);
    return latex_long_table(orders_table(chosen));
  }

  Part part_of(const Paper& paper) {
    Part part{paper.source, {}, {}, "orders-" + paper.key, ""};
    part.orders = orders_of([&](const StudyResult& s) { return is_of(s, paper); });
    for (const PaperFigure& figure : paper.figures) add_figure(part, figure, paper.key + " Fig. " + figure.number);
    return part;
  }

  void add_figure(Part& part, const PaperFigure& figure, const std::string& label) {
    PrintedFigure printed{{}, latex_text(label + "."), figure.wide};
    for (const auto& name : figure.panels) {
      const auto chart = by_name_.find(name);
      if (chart == by_name_.end()) {
        part.missing.push_back(fmt::format("{} is not drawn: the store has no figure {}.", label, name));
        continue;
      }
      const bool alone = figure.panels.size() == 1;
      printed.caption += (alone ? " " : " " + letter_of(printed.panels.size()) + " ") +
                         whole_caption(*chart->second, own_caption(*chart->second));
      printed.panels.push_back(chart->second);
      taken_.insert(name);
    }
    if (!figure.without.empty()) part.missing.push_back(fmt::format("{} is not drawn: {}.", label, figure.without));
    if (!figure.differs.empty()) printed.caption += latex(" Not as in the original: " + figure.differs + ".");
    if (!printed.panels.empty()) part.figures.push_back(std::move(printed));
  }

  Part the_rest() const {
    Part part{"Further studies", {}, {}, "orders-further", ""};
    for (const auto& of_study : charts_)
      for (const Chart& chart : of_study)
        if (!taken_.contains(chart.name))
          part.figures.push_back({{&chart},
                                  latex_text(chart.name + ".") + " " + whole_caption(chart, chart.caption),
                                  !has_room(chart, column_)});
    part.orders = orders_of([](const StudyResult& study) {
      return std::ranges::none_of(papers(), [&](const Paper& paper) { return is_of(study, paper); });
    });
    return part;
  }

  const std::vector<StudyResult>& studies_;
  const Sheet& column_;
  std::vector<std::vector<Chart>> charts_;
  std::map<std::string, const Chart*> by_name_;
  std::set<std::string> taken_;
  std::vector<Part> parts_;
};

constexpr double column_gap = 6;  ///< mm

double two_columns(const Sheet& column) {
  return 2 * column.width + column_gap;
}

double panel_width(const PrintedFigure& figure, const Sheet& column) {
  return figure.wide ? two_columns(column) : column.width;
}

bool fills_row(const PrintedFigure& figure) {
  return figure.wide || figure.panels.size() > 1;
}

std::vector<Plot> plots_of(const std::vector<Part>& parts, const Sheet& column) {
  std::vector<Plot> plots;
  for (const Part& part : parts)
    for (const PrintedFigure& figure : part.figures)
      for (const Chart* chart : figure.panels) {
        Sheet sheet = column;
        sheet.width = panel_width(figure, column);
        plots.push_back(plot_of(*chart, sheet));
      }
  return plots;
}

std::vector<std::string> remarks_on(const std::vector<Part>& parts) {
  std::vector<std::string> remarks;
  for (const Part& part : parts)
    for (const PrintedFigure& figure : part.figures)
      for (const Chart* chart : figure.panels) {
        std::vector<std::string> texts = drawn_texts(*chart);
        texts.push_back(chart->caption);
        for (const std::string& remark : text_remarks(texts, Format::tex))
          remarks.push_back(fmt::format("{}: {}", chart->name, remark));
      }
  return remarks;
}

std::string in_mm(double length) {
  return fmt::format("{:g}mm", length);
}

data panels_data(const PrintedFigure& figure, const Sheet& column) {
  data list{data::type::list};
  const std::size_t count = figure.panels.size();
  for (std::size_t i = 0; i < count; ++i)
    list << object({{"width", in_mm(panel_width(figure, column))},
                    {"file", latex_file(figure.panels[i]->name)},
                    {"letter", count > 1 ? letter_of(i) + "\\\\" : ""},
                    {"gap", i + 1 == count ? ""
                            : i % 2 == 0   ? "\\hfill"
                                           : "\\\\[2ex]"}});
  return list;
}

data figure_data(const PrintedFigure& figure, const Sheet& column, bool has_neighbour) {
  return object({{"panels", panels_data(figure, column)},
                 {"width", in_mm(fills_row(figure) ? two_columns(column) : column.width)},
                 {"caption", figure.caption},
                 {"gap", has_neighbour ? "\\hfill" : ""}});
}

/// Two figures of a column's width stand beside one another.
data rows_data(const std::vector<PrintedFigure>& figures, const Sheet& column) {
  data rows{data::type::list};
  for (std::size_t i = 0; i < figures.size(); ++i) {
    data row{data::type::list};
    const bool pair = !fills_row(figures[i]) && i + 1 < figures.size() && !fills_row(figures[i + 1]);
    row << figure_data(figures[i], column, pair);
    if (pair) row << figure_data(figures[++i], column, false);
    rows << object({{"figures", row}});
  }
  return rows;
}

data part_data(const Part& part, const Sheet& column) {
  const std::vector<std::string> orders(part.orders.empty() ? 0 : 1, part.orders_name);
  return object({{"title", latex_text(part.title)},
                 {"rows", rows_data(part.figures, column)},
                 {"missing", list_of(part.missing, [](const std::string& m) { return data(latex_text(m)); })},
                 {"orders", text_list(orders)}});
}

std::string main_text(const std::vector<Part>& parts, const store::Provenance& provenance, const Sheet& column) {
  constexpr double margins = 36;  ///< mm
  const std::string commit = store::in_short(provenance.commit);
  kainjow::mustache::mustache text{std::string(paper_template)};
  return text.render(object({{"commit", latex_text(commit + (provenance.dirty ? " with changes" : ""))},
                             {"date", provenance.time.substr(0, 10)},
                             {"text_width", fmt::format("{:g}", two_columns(column))},
                             {"page_width", fmt::format("{:g}", two_columns(column) + margins)},
                             {"parts", list_of(parts, [&](const Part& part) { return part_data(part, column); })}}));
}

constexpr std::string_view first_line = "% Figures and tables of mpmvv ";

void require_own_document(const fs::path& main) {
  if (const auto text = support::read_file(main); text && text->find(first_line) == std::string::npos)
    throw support::UsageError(
        fmt::format("{} is none of ours and would be overwritten (another folder, or move it away)", main.string()));
}

}  // namespace

PaperSummary write_paper(const std::vector<StudyResult>& studies, const store::Provenance& provenance,
                         const fs::path& out_dir, const Sheet& column) {
  require_own_document(out_dir / "main.tex");
  const Document document(studies, column);
  const auto plots = plots_of(document.parts(), column);
  PaperSummary summary;
  support::make_folder(out_dir / "figures");
  support::make_folder(out_dir / "tables");
  summary.figures = static_cast<int>(plots.size());
  summary.figures_drawn = draw(plots, out_dir / "figures");
  for (const Part& part : document.parts()) {
    summary.without.insert(summary.without.end(), part.missing.begin(), part.missing.end());
    if (part.orders.empty()) continue;
    support::write_if_changed(out_dir / "tables" / (part.orders_name + ".tex"), part.orders);
    ++summary.tables;
  }
  support::write_if_changed(out_dir / "main.tex", main_text(document.parts(), provenance, column));
  summary.remarks = remarks_on(document.parts());
  return summary;
}

}  // namespace mpmvv::reports
