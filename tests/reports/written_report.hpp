#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/report.hpp"
#include "reports/table.hpp"
#include "tests/reports/drawing.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::read_back {

/// A row as its reader sees it: what stands under which column.
using Row = std::vector<std::pair<std::string, std::string>>;

/// A table made of rows. Throws std::runtime_error where their columns differ.
class ExpectedTable {
 public:
  void add(const std::string& group, const Row& row);
  const Table& table() const { return table_; }

 private:
  Table table_;
};

ReportInput input_of(const records::StudyResult& study);

/// A report in a folder of its own, read from the files that its pages lead to.
class WrittenReport {
 public:
  explicit WrittenReport(const ReportInput& input);

  /// The one table with these columns, and its rows compared with those expected: on a page, in a LaTeX file, as CSV.
  void expect_html(const ExpectedTable& expected) const;
  void expect_html_on(const std::string& page, const ExpectedTable& expected) const;
  void expect_latex(const ExpectedTable& expected) const;
  void expect_csv(const ExpectedTable& expected) const;
  void expect_html_and_latex(const ExpectedTable& expected) const;

  /// The only picture of all pages but those of claims whose caption has this text.
  Drawing drawing(const std::string& caption) const;

  /// The text of a page that the first one leads to. Throws std::runtime_error where it does not lead there.
  const std::string& page(const std::string& file) const;

 private:
  void read_pages(const std::string& file);
  std::vector<std::string> linked_texts(const std::string& ending) const;

  TempFolder folder_;
  std::map<std::string, std::string> pages_;  ///< by file, all to which links lead from the first one
};

}  // namespace mpmvv::reports::read_back
