#include "tests/reports/written_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

#include "reports/latex_table.hpp"
#include "reports/text.hpp"

namespace mpmvv::reports::read_back {

namespace {

using HtmlNode = boost::property_tree::ptree;

/// What stands between two texts, with these, each time.
std::vector<std::string> parts_of(const std::string& text, const std::string& start, const std::string& end) {
  std::vector<std::string> parts;
  for (auto at = text.find(start); at != std::string::npos; at = text.find(start, at + 1))
    parts.push_back(text.substr(at, text.find(end, at + start.size()) + end.size() - at));
  return parts;
}

/// The texts of an element and of what it holds.
std::string flat(const HtmlNode& node) {
  std::string text = node.data();
  for (const auto& [name, child] : node)
    if (name != "<xmlattr>") text += (text.empty() ? "" : " ") + flat(child);
  return text;
}

/// Rows with one cell over all columns begin a group.
void add_html_row(Table& table, const HtmlNode& row) {
  std::vector<std::string> cells;
  bool is_title = false;
  for (const auto& [name, cell] : row) {
    if (name != "th" && name != "td") continue;
    cells.push_back(flat(cell));
    is_title = cell.get("<xmlattr>.scope", "") == "rowgroup";
  }
  if (is_title)
    table.groups.back().title = cells.at(0);
  else
    table.groups.back().rows.push_back(cells);
}

/// With the ends of cells that HTML leaves out, as the next cell or the end of the row says them, and XML does not.
std::string with_ends_of_cells(std::string table) {
  for (const std::string tag : {"th", "td"})
    for (auto at = table.find("<" + tag); at != std::string::npos; at = table.find("<" + tag, at + 1)) {
      const auto next = std::min(table.find("<td", at + 1), table.find("</tr>", at));
      if (table.find("</" + tag + ">", at) > next) table.insert(next, "</" + tag + ">");
    }
  return table;
}

std::vector<Table> html_tables(const std::string& page) {
  std::vector<Table> tables;
  for (const std::string& part : parts_of(page, "<table", "</table>")) {
    std::istringstream in(with_ends_of_cells(part));
    HtmlNode root;
    boost::property_tree::read_xml(in, root, boost::property_tree::xml_parser::trim_whitespace);
    Table& table = tables.emplace_back();
    for (const auto& [name, child] : root.get_child("table")) {
      if (name == "thead")
        for (const auto& [cell_name, cell] : child.get_child("tr")) table.columns.push_back(flat(cell));
      if (name != "tbody") continue;
      table.groups.emplace_back();
      for (const auto& [row_name, row] : child)
        if (row_name == "tr") add_html_row(table, row);
    }
    if (table.columns.empty()) table.columns.resize(table.groups.at(0).rows.at(0).size());
  }
  return tables;
}

std::vector<std::string> latex_cells(std::string line) {
  std::vector<std::string> cells;
  line.erase(line.rfind(" \\\\"));
  for (std::size_t end = line.find(" & "); end != std::string::npos; end = line.find(" & "))
    cells.push_back(line.substr(0, end)), line.erase(0, end + 3);
  cells.push_back(line);
  return cells;
}

std::vector<Table> latex_tables_in(const std::string& text) {
  std::vector<Table> tables;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("\\begin{tabular"))
      tables.emplace_back();
    else if (tables.empty())
      continue;
    else if (line == "\\midrule")
      tables.back().groups.emplace_back();
    else if (const auto title = line.find("\\emph{"); line.starts_with("\\multicolumn") && title != std::string::npos)
      tables.back().groups.back().title = line.substr(title + 6, line.rfind("}}") - title - 6);
    else if (line.ends_with(" \\\\") && tables.back().groups.empty())
      tables.back().columns = latex_cells(line);
    else if (line.ends_with(" \\\\"))
      tables.back().groups.back().rows.push_back(latex_cells(line));
  }
  return tables;
}

/// Lines of a file of comma-separated values whose fields hold no ends of lines.
std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[i++];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  return fields;
}

Table csv_table(const std::string& text) {
  Table table{"", {}, {{}}};
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (table.columns.empty())
      table.columns = csv_fields(line);
    else
      table.groups[0].rows.push_back(csv_fields(line));
  }
  return table;
}

void expect_row(const std::vector<std::string>& read, const std::vector<std::string>& expected, const Table& table) {
  ASSERT_EQ(read.size(), table.columns.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    EXPECT_EQ(read[i], expected[i]) << "under '" << table.columns[i] << "' in the row of '" << expected[0] << "'";
}

/// The one of these tables with the expected columns has the expected rows.
void expect_among(const std::vector<Table>& tables, const Table& expected) {
  const auto table = std::ranges::find(tables, expected.columns, &Table::columns);
  ASSERT_NE(table, tables.end()) << "no table of " << testing::PrintToString(expected.columns);
  EXPECT_EQ(std::ranges::count(tables, expected.columns, &Table::columns), 1);
  ASSERT_EQ(table->groups.size(), expected.groups.size());
  for (std::size_t g = 0; g < expected.groups.size(); ++g) {
    EXPECT_EQ(table->groups[g].title, expected.groups[g].title);
    ASSERT_EQ(table->groups[g].rows.size(), expected.groups[g].rows.size()) << expected.groups[g].title;
    for (std::size_t r = 0; r < expected.groups[g].rows.size(); ++r)
      expect_row(table->groups[g].rows[r], expected.groups[g].rows[r], expected);
  }
}

Table as_latex(Table table) {
  for (std::string& column : table.columns) column = latex_text(column);
  for (Table::Group& group : table.groups) {
    group.title = latex_text(group.title);
    for (auto& row : group.rows)
      for (std::string& cell : row) cell = latex_cell(cell);
  }
  return table;
}

/// What a link on a page leads to, as a file of the report; empty for a place on the same page.
std::string target_of(const std::string& page, const std::string& link) {
  const std::string file = link.substr(0, link.find('#'));
  return file.empty() ? "" : (std::filesystem::path(page).parent_path() / file).lexically_normal().string();
}

std::vector<std::string> links_of(const std::string& text, const std::string& attribute) {
  std::vector<std::string> links;
  for (const std::string& part : parts_of(text, " " + attribute + "=\"", "\""))
    links.push_back(part.substr(attribute.size() + 3, part.size() - attribute.size() - 4));
  return links;
}

}  // namespace

void ExpectedTable::add(const std::string& group, const Row& row) {
  if (table_.groups.empty() || table_.groups.back().title != group) table_.groups.push_back({group, {}});
  std::vector<std::string> columns, cells;
  for (const auto& [column, cell] : row) columns.push_back(column), cells.push_back(cell);
  if (table_.columns.empty()) table_.columns = columns;
  if (table_.columns != columns) throw std::runtime_error("rows of different columns");
  table_.groups.back().rows.push_back(cells);
}

ReportInput input_of(const records::StudyResult& study) {
  ReportInput input;
  input.studies = {study};
  return input;
}

WrittenReport::WrittenReport(const ReportInput& input) {
  write_report(input, folder_ / "out", [](const std::string&) {});
  read_pages("index.html");
}

void WrittenReport::read_pages(const std::string& file) {
  const std::string text = content(folder_ / "out" / file);
  pages_[file] = text;
  for (const std::string& link : links_of(text, "href"))
    if (const std::string next = target_of(file, link); next.ends_with(".html") && !pages_.contains(next))
      read_pages(next);
}

const std::string& WrittenReport::page(const std::string& file) const {
  if (!pages_.contains(file)) throw std::runtime_error("no link leads to " + file);
  return pages_.at(file);
}

void WrittenReport::expect_html(const ExpectedTable& expected) const {
  SCOPED_TRACE("HTML");
  std::vector<Table> tables;
  for (const auto& [file, text] : pages_)
    for (Table& table : html_tables(text)) tables.push_back(std::move(table));
  expect_among(tables, expected.table());
}

void WrittenReport::expect_html_on(const std::string& file, const ExpectedTable& expected) const {
  SCOPED_TRACE(file);
  expect_among(html_tables(page(file)), expected.table());
}

void WrittenReport::expect_latex(const ExpectedTable& expected) const {
  SCOPED_TRACE("LaTeX");
  std::vector<Table> tables;
  for (const std::string& text : linked_texts(".tex"))
    for (Table& table : latex_tables_in(text)) tables.push_back(std::move(table));
  expect_among(tables, as_latex(expected.table()));
}

void WrittenReport::expect_csv(const ExpectedTable& expected) const {
  SCOPED_TRACE("CSV");
  std::vector<Table> tables;
  for (const std::string& text : linked_texts(".csv")) tables.push_back(csv_table(text));
  expect_among(tables, expected.table());
}

void WrittenReport::expect_html_and_latex(const ExpectedTable& expected) const {
  expect_html(expected);
  expect_latex(expected);
}

Drawing WrittenReport::drawing(const std::string& caption) const {
  std::vector<std::string> pictures;
  for (const auto& [file, text] : pages_) {
    if (file.starts_with("claims/")) continue;
    for (const std::string& figure : parts_of(text, "<figure", "</figure>"))
      if (figure.substr(figure.find("<figcaption")).find(caption) != std::string::npos)
        pictures.push_back(target_of(file, links_of(figure, "src").at(0)));
  }
  if (pictures.size() != 1) throw std::runtime_error("no picture, or several: " + caption);
  return read_drawing(content(folder_ / "out" / pictures[0]));
}

/// The texts of the files with this ending that the pages lead to.
std::vector<std::string> WrittenReport::linked_texts(const std::string& ending) const {
  std::set<std::string> files;
  for (const auto& [file, text] : pages_)
    for (const std::string& link : links_of(text, "href"))
      if (link.ends_with(ending)) files.insert(target_of(file, link));
  std::vector<std::string> texts;
  for (const std::string& file : files) texts.push_back(content(folder_ / "out" / file));
  return texts;
}

}  // namespace mpmvv::reports::read_back
