#include "reports/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "page_template.hpp"
#include "reports/paper_document.hpp"
#include "reports/plot.hpp"
#include "reports/template_data.hpp"
#include "reports/text.hpp"
#include "reports/text_remarks.hpp"
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

std::vector<Plot> plots_of(const std::vector<PaperPart>& parts, const Sheet& column) {
  std::vector<Plot> plots;
  for (const PaperPart& part : parts)
    for (const PrintedFigure& figure : part.figures)
      for (const Chart* chart : figure.panels) {
        Sheet sheet = column;
        sheet.width = panel_width(figure, column);
        plots.push_back(plot_of(*chart, sheet));
      }
  return plots;
}

std::vector<std::string> remarks_on(const std::vector<PaperPart>& parts) {
  std::vector<std::string> remarks;
  for (const PaperPart& part : parts)
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

data part_data(const PaperPart& part, const Sheet& column, bool is_first) {
  return object({{"title", latex_text(part.title)},
                 {"break", is_first ? "" : "\\clearpage\n"},
                 {"rows", rows_data(part.figures, column)},
                 {"missing", list_of(part.missing, [](const std::string& m) { return data(latex_text(m)); })},
                 {"tables", list_of(part.tables, [](const auto& t) { return data(latex_file(t.name)); })}});
}

/// What is said of papers of which the document shows nothing.
std::vector<std::string> words_on_absent(const std::vector<std::string>& papers) {
  std::vector<std::string> words;
  for (const std::string& paper : papers)
    words.push_back("The store has neither figures nor tables of: " + paper + ".");
  return words;
}

std::vector<Origin> origins_of_shown(const PaperDocument& document, Provenances provenances) {
  std::erase_if(provenances, [&](const auto& of_study) { return !document.shows(of_study.first); });
  return origins_of(provenances);
}

data origin_data(const Origin& origin) {
  const store::Provenance& p = origin.provenance;
  return object({{"commit", latex_text(p.commit + (p.dirty ? " with changes" : ""))},
                 {"digest", latex_text(p.digest)},
                 {"compiler", latex_text(p.compiler + ", " + p.build_type)},
                 {"flags", latex_text(p.flags)},
                 {"cpu", latex_text(p.cpu)},
                 {"studies", studies_text(origin.studies)},
                 {"date", p.time.substr(0, 10)}});
}

/// The versions of other codes that ran the studies shown, each once: name, and version with its digest.
std::set<std::pair<std::string, std::string>> versions_of(const std::vector<store::CodeSeries>& codes,
                                                          const PaperDocument& document) {
  std::set<std::pair<std::string, std::string>> versions;
  for (const auto& [study, series, code, kept_at] : codes)
    if (document.shows(study)) versions.emplace(code.name, fmt::format("{}, digest {}", code.version, code.digest));
  return versions;
}

data codes_data(const std::vector<store::CodeSeries>& codes, const PaperDocument& document) {
  data list{data::type::list};
  for (const auto& [name, version] : versions_of(codes, document))
    list << object({{"name", latex_text(name)}, {"version", latex_text(version)}});
  return list;
}

std::string main_text(const PaperDocument& document, const std::vector<Origin>& origins, const Sheet& column,
                      const std::vector<store::CodeSeries>& codes) {
  constexpr double margins = 36;  ///< mm
  const std::vector<PaperPart>& parts = document.parts();
  kainjow::mustache::mustache text{std::string(paper_template)};
  const auto set = [&](const PaperPart& part) { return part_data(part, column, &part == &parts.front()); };
  return text.render(object({{"versions", latex_text(versions_text(origins))},
                             {"date", origins.empty() ? "" : origins.front().provenance.time.substr(0, 10)},
                             {"origins", list_of(origins, origin_data)},
                             {"codes", codes_data(codes, document)},
                             {"text_width", fmt::format("{:g}", two_columns(column))},
                             {"page_width", fmt::format("{:g}", two_columns(column) + margins)},
                             {"absent", list_of(words_on_absent(document.absent()),
                                                [](const std::string& w) { return data(latex_text(w)); })},
                             {"parts", list_of(parts, set)}}));
}

constexpr std::string_view first_line = "% Figures and tables of mpmvv ";

void require_own_document(const fs::path& main) {
  if (const auto text = support::read_file(main); text && text->find(first_line) == std::string::npos)
    throw support::UsageError(
        fmt::format("{} is none of ours and would be overwritten (another folder, or move it away)", main.string()));
}

}  // namespace

PaperSummary write_paper(const std::vector<StudyResult>& studies, const Provenances& provenances,
                         const fs::path& out_dir, const Sheet& column, const std::vector<std::string>& names,
                         const std::vector<store::CodeSeries>& codes) {
  require_own_document(out_dir / "main.tex");
  const PaperDocument document(studies, column, names);
  const auto plots = plots_of(document.parts(), column);
  PaperSummary summary;
  support::make_folder(out_dir / "figures");
  support::make_folder(out_dir / "tables");
  summary.figures = static_cast<int>(plots.size());
  summary.figures_drawn = draw(plots, out_dir / "figures");
  for (const PaperPart& part : document.parts()) {
    summary.without.insert(summary.without.end(), part.missing.begin(), part.missing.end());
    for (const auto& [name, text] : part.tables) {
      support::write_if_changed(out_dir / "tables" / (name + ".tex"), text);
      ++summary.tables;
    }
  }
  for (const StudyResult& study : studies)
    if (const std::string trial = trial_sentence(study); !trial.empty() && document.shows(study.name))
      summary.trials.push_back(fmt::format("{}: {}", study.name, trial));
  const auto absent = words_on_absent(document.absent());
  summary.without.insert(summary.without.end(), absent.begin(), absent.end());
  support::write_if_changed(out_dir / "main.tex",
                            main_text(document, origins_of_shown(document, provenances), column, codes));
  summary.remarks = remarks_on(document.parts());
  return summary;
}

}  // namespace mpmvv::reports
