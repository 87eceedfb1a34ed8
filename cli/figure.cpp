#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "cli/checks.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/length.hpp"
#include "cli/numbers.hpp"
#include "cli/outputs.hpp"
#include "cli/results.hpp"
#include "reports/figure_choice.hpp"
#include "reports/picture_file.hpp"
#include "reports/plot.hpp"
#include "reports/text.hpp"
#include "reports/text_remarks.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/process.hpp"

namespace mpmvv::cli {

namespace {

namespace fs = std::filesystem;
using reports::Chart;
using reports::Format;
using reports::Sheet;

struct FigureOptions {
  std::string name, db, of, format, width = "84mm", height, font, font_size = "8pt", out;
};

std::optional<Format> format_of_ending(const fs::path& file) {
  for (const Format format : {Format::pdf, Format::svg, Format::tex})
    if (file.extension() == reports::ending_of(format)) return format;
  return std::nullopt;
}

/// The format that --format names, else that of the ending of --out, else PDF.
Format format_of(const FigureOptions& options) {
  const auto of_file = format_of_ending(options.out);
  if (options.format.empty()) return of_file.value_or(Format::pdf);
  const auto format = support::from_word<Format>(options.format, "--format");
  if (of_file && *of_file != format)
    throw support::UsageError(fmt::format("--format {} with --out {} (a file that ends with {})", options.format,
                                          options.out, ending_of(format)));
  return format;
}

Sheet sheet_of(const FigureOptions& options) {
  Sheet sheet;
  sheet.format = format_of(options);
  sheet.width = figure_width(options.width);
  if (!options.height.empty()) sheet.height = figure_height(options.height);
  sheet.font_size = figure_font_size(options.font_size);
  if (options.font.empty()) return sheet;
  if (sheet.format == Format::tex)
    throw support::UsageError("--font with --format tex (LaTeX sets the document's own font; leave it out)");
  if (!std::ranges::all_of(options.font, [](unsigned char c) { return std::isalnum(c) || c == ' ' || c == '-'; }))
    throw support::UsageError(fmt::format("--font '{}' (a family's name, such as 'Liberation Serif')", options.font));
  sheet.font = options.font;
  return sheet;
}

/// Notes in which font the machine draws when it lacks the family. A machine without fontconfig is not asked.
void note_other_font(const Sheet& sheet) {
  const auto match =
      support::run_process({"fc-match", "--format=%{family}", sheet.font}, ".", {}, std::chrono::seconds(10));
  static const std::set<std::string> generic{"sans", "serif", "monospace"};
  const std::string font = reports::lower_case(sheet.font);  // names of fonts have no case
  const bool is_known = reports::lower_case(match.output).find(font) != std::string::npos;
  if (!match.good() || generic.contains(font) || is_known) return;
  note("this machine has no font '{}' and draws in {} (`fc-list : family` names those that it has)\n", sheet.font,
       match.output);
}

/// Throws on an ending that no picture has. A folder that is not there yet must have no ending.
void require_known_ending(const fs::path& out) {
  if (out.has_extension() && !format_of_ending(out) && !fs::is_directory(out))
    throw support::UsageError(fmt::format("--out {} (a file that ends with .pdf, .svg or .tex, or a folder: {}/)",
                                          out.string(), out.string()));
}

/// The file of each figure: --out itself for one, in the folder of that name for more.
std::vector<fs::path> files_of(const FigureOptions& options, const std::vector<Chart>& charts, Format format) {
  if (charts.size() == 1 && format_of_ending(options.out) && !fs::is_directory(options.out)) return {options.out};
  if (format_of_ending(options.out)) {
    std::vector<std::string> names;
    for (const Chart& chart : charts) names.push_back(chart.name);
    throw support::UsageError(fmt::format("--out {} for {}, {} (a folder, or the name of one of them)", options.out,
                                          count_text(charts.size(), "figure"), fmt::join(names, ", ")));
  }
  std::vector<fs::path> files;
  for (const Chart& chart : charts) files.push_back(fs::path(options.out) / (chart.name + ending_of(format)));
  return files;
}

/// Throws where LaTeX could not read a file of this name.
void require_name_for(Format format, const std::string& name) {
  const auto at = name.find_first_of("%#{}\\");
  if (format == Format::tex && at != std::string::npos)
    throw support::UsageError(fmt::format("--out {} (LaTeX reads no file with {} in its name)", name, name[at]));
}

/// Prints the files, and for LaTeX how to take the figure into a document.
void print_drawn(const std::vector<fs::path>& drawn, const Sheet& sheet) {
  for (const fs::path& file : drawn) print("{}\n", file.string());
  if (sheet.format != Format::tex) return;
  const fs::path folder = drawn[0].parent_path();
  const std::string path = folder.empty() ? "" : fmt::format("\\graphicspath{{{{{}/}}}}", reports::latex_file(folder));
  print("  {}\\input{{{}}} with \\usepackage{{graphicx,xcolor}}\n", path,
        reports::latex_file(folder / drawn[0].stem()));
}

/// A width in whole mm, above the sheet's, at which the chart has room while it has none at one mm less.
std::optional<int> width_with_room(const Chart& chart, Sheet sheet) {
  const auto fits = [&](double width) {
    sheet.width = width;
    return reports::has_room(chart, sheet);
  };
  int without = static_cast<int>(sheet.width), with = static_cast<int>(greatest_width);
  if (!fits(with)) return std::nullopt;
  while (with - without > 1) {
    const int middle = (without + with) / 2;
    (fits(middle) ? with : without) = middle;
  }
  return with;
}

std::string lack_of_room(const Chart& chart, Sheet sheet, const FigureOptions& options) {
  if (std::exchange(sheet.height, 0) > 0 && reports::has_room(chart, sheet))
    return fmt::format(
        "--height {} leaves too little for the axes of '{}' (a larger one, or a smaller --font-size than {})",
        options.height, chart.name, options.font_size);
  const auto width = width_with_room(chart, sheet);
  return fmt::format("--width {} leaves too little for the axes of '{}' ({}a smaller --font-size than {})",
                     options.width, chart.name, width ? fmt::format("{}mm would do, or ", *width) : "",
                     options.font_size);
}

/// Throws where --height is given and the height of a figure follows from its scale or rows.
void require_open_height(const std::vector<Chart>& charts, const FigureOptions& options) {
  const auto fixed = std::ranges::find_if(charts, reports::has_own_height);
  if (!options.height.empty() && fixed != charts.end())
    throw support::UsageError(
        fmt::format("--height for '{}', whose height follows from its scale or its rows (leave it out)", fixed->name));
}

/// What the picture itself does not say: what its marks mean, that it is of a trial, what it leaves out, and which
/// texts will not look as they were meant.
void note_remarks(const Chart& chart, Format format) {
  for (const std::string& meaning : chart.notes) note("{}: {}\n", chart.name, meaning);
  if (!chart.trial.empty()) note("{}: {}\n", chart.name, chart.trial);
  for (const std::string& omission : chart.omissions) note("{}: {}\n", chart.name, omission);
  for (const std::string& remark : reports::text_remarks(reports::drawn_texts(chart), format))
    note("{}: {}\n", chart.name, remark);
}

void draw(const Chart& chart, const Sheet& sheet, const fs::path& file) {
  if (file.has_parent_path()) support::make_folder(file.parent_path());
  reports::draw_picture(chart, sheet, file);
  print_drawn(reports::picture_files(file, sheet.format), sheet);
  note_remarks(chart, sheet.format);
}

/// The results to draw: of the version that --of names, else of this program.
std::vector<records::StudyResult> results_to_draw(const FigureOptions& options) {
  const store::Store store(options.db, store::Store::Mode::read);
  if (!options.of.empty()) return results_of(store, store::find_version(store.versions(), options.of).digest);
  auto studies = own_results(options.db);
  require_own_results(studies, options.db);
  return studies;
}

int figure(const FigureOptions& options) {
  require_known_ending(options.out);
  const Sheet sheet = sheet_of(options);
  require_name_for(sheet.format, options.out);
  const auto [charts, others] = reports::choose_figures(results_to_draw(options), options.name, letter_on(sheet));
  require_open_height(charts, options);
  const auto files = files_of(options, charts, sheet.format);
  for (const fs::path& file : files)
    for (const fs::path& part : reports::picture_files(file, sheet.format)) {
      require_apart("--out", part, {options.db});
      require_writable_at_once("--out", part);
    }
  std::vector<std::string> without_room;
  for (const Chart& chart : charts)
    if (!reports::has_room(chart, sheet)) without_room.push_back(lack_of_room(chart, sheet, options));
  if (without_room.size() == charts.size()) throw support::UsageError(fmt::format("{}", fmt::join(without_room, "; ")));
  if (sheet.format == Format::pdf) note_other_font(sheet);
  for (std::size_t i = 0; i < charts.size(); ++i)
    if (reports::has_room(charts[i], sheet)) draw(charts[i], sheet, files[i]);
  for (const std::string& lack : without_room) note("not drawn: {}\n", lack);
  if (!others.empty()) note("{}\n", fmt::format("more figures of {}: {}", options.name, fmt::join(others, ", ")));
  return 0;
}

}  // namespace

void add_figure(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<FigureOptions>();
  CLI::App* command = app.add_subcommand("figure", "Draw a figure for a paper");
  command->add_option("name", options->name, "figure, claim or study, such as s-fig10 or S-fig10")
      ->required()
      ->type_name("NAME");
  command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
  command
      ->add_option("--of", options->of,
                   "version of mpmvv in the store, by the first letters of its commit or digest (default: this "
                   "program)")
      ->type_name("VERSION");
  command->add_option("--format", options->format, "pdf, svg, tex (default: as --out ends, else pdf)")
      ->type_name(word_of({"pdf", "svg", "tex"}));
  command->add_option("--width", options->width, "of the whole figure, with its key (default: 84mm)")
      ->type_name("LENGTH");
  command->add_option("--height", options->height, "of the same (default: follows from the width)")
      ->type_name("LENGTH");
  command->add_option("--font", options->font, "family of pdf and svg (default: Sans)")->type_name("FAMILY");
  command->add_option("--font-size", options->font_size, "of all texts (default: 8pt)")->type_name("LENGTH");
  command
      ->add_option("--out", options->out,
                   "file that ends with .pdf, .svg or .tex, or folder (default: here, under the figure's name)")
      ->type_name("FILE");
  add_examples(*command, {"mpmvv figure S-fig10 --db results.db --width 84mm --font-size 8pt",
                          "mpmvv figure splines --db results.db --out figures/splines.tex"});
  command->callback([options, &exit_code] { exit_code = figure(*options); });
}

}  // namespace mpmvv::cli
