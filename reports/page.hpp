#pragma once
#include <string>
#include <vector>

#include "reports/picture.hpp"
#include "reports/report.hpp"

namespace mpmvv::reports {

/// What a report holds of one study.
struct Section {
  const records::StudyResult* study = nullptr;
  std::vector<Picture> pictures;
  std::vector<std::string> tables;  ///< names of its files in tables/
};

/// A file of the report, relative to its folder. Every text in it is escaped.
struct Page {
  std::string file;
  std::string text;
};

/// Four numbers on how it stands, what does not pass, the claims by papers, the studies, the words: index.html.
Page front_page(const ReportInput& input, const std::vector<Section>& sections);

/// All goldens, by study: gate.html.
Page gate_page(const ReportInput& input);

/// A claim with its criteria and figures: claims/ID.html.
Page claim_page(const ReportInput& input, const claims::Claim& claim, const std::vector<Section>& sections);

/// A study: studies/NAME.html.
Page study_page(const ReportInput& input, const Section& section);

/// What the program costs, what other codes gave, what the gate catches: benchmark.html, codes.html, mutants.html,
/// where there are any.
std::vector<Page> program_pages(const ReportInput& input);

/// What the report's script says of the points of a section's figures, which several pages show: points/FIGURE.js.
std::vector<Page> points_pages(const Section& section);

/// The style and the script of all pages.
std::vector<Page> page_aids();

}  // namespace mpmvv::reports
