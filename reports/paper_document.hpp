#pragma once
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "reports/chart.hpp"
#include "reports/papers.hpp"
#include "reports/sheet.hpp"

namespace mpmvv::reports {

/// A figure of a document: charts side by side under one caption, which is LaTeX.
struct PrintedFigure {
  std::vector<const Chart*> panels;
  std::string caption;
  bool wide = false;
};

/// A file of tables in LaTeX.
struct PrintedTables {
  std::string name;  ///< "orders-S"
  std::string text;
};

/// A section of a document.
struct PaperPart {
  std::string title;
  std::vector<PrintedFigure> figures;
  std::vector<std::string> missing;   ///< figures that are not drawn, and why
  std::vector<PrintedTables> tables;  ///< fitted orders, extrapolated values; errors, limits and costs of each study
};

/// Sorts the figures and tables of studies into the parts of a document: the figures of the papers in their order, then
/// those of all other studies. With names of figures, claims or studies (choose_figures) it has one part: their figures
/// and the tables of their studies, in the order of the names. Throws UsageError where a name means nothing. It refers
/// to the studies and to the column.
class PaperDocument {
 public:
  PaperDocument(const std::vector<records::StudyResult>& studies, const Sheet& column,
                const std::vector<std::string>& names);
  PaperDocument(const PaperDocument&) = delete;
  PaperDocument& operator=(const PaperDocument&) = delete;

  const std::vector<PaperPart>& parts() const { return parts_; }

  /// The papers of which there is neither a figure nor a table; none where this is so of all, as in a store of other
  /// studies.
  const std::vector<std::string>& absent() const { return absent_; }

  /// Whether it shows something of this study: with names those that they mean, else all.
  bool shows(const std::string& study) const {
    return std::ranges::find(shown_, study, &records::StudyResult::name) != shown_.end();
  }

 private:
  void add(PaperPart part);
  PaperPart part_of(const Paper& paper);
  PaperPart the_rest() const;
  PaperPart the_named(const std::vector<std::string>& names);
  void add_figure(PaperPart& part, const PaperFigure& figure, const std::string& label);
  PrintedFigure alone(const Chart& chart) const;
  std::vector<std::string> charts_named(const std::string& name) const;

  const std::vector<records::StudyResult>& studies_;
  const Sheet& column_;
  std::vector<std::vector<Chart>> charts_;
  std::map<std::string, const Chart*> by_name_;
  std::map<std::string, const records::StudyResult*> study_of_;  ///< by chart
  std::set<std::string> taken_;                                  ///< charts
  std::vector<PaperPart> parts_;
  std::vector<std::string> absent_;
  std::vector<const records::StudyResult*> shown_;
};

/// "(a)", "(b)".
std::string letter_of(std::size_t panel);

}  // namespace mpmvv::reports
