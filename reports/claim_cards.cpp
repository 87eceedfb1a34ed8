#include "reports/claim_cards.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "reports/claim_picture.hpp"
#include "reports/criteria.hpp"
#include "reports/verdicts.hpp"

namespace mpmvv::reports {

using namespace template_data;

namespace {

/// The first criteria of a claim, which stand in place of a figure.
data asked_list(const claims::Claim& claim) {
  constexpr std::size_t most = 6;
  const std::size_t shown = std::min(most, claim.parts.size());
  const std::vector<claims::JudgedPart> first(claim.parts.begin(),
                                              claim.parts.begin() + static_cast<std::ptrdiff_t>(shown));
  return list_of(first, [](const claims::JudgedPart& line) {
    return object({{"statement", line.part.statement}, {"verdict", to_string(line.part.verdict)}});
  });
}

data card(const claims::Claim& claim, const std::vector<Section>& sections) {
  const Picture* picture = picture_of(claim, sections);
  return object({{"id", claim.id},
                 {"claim_file", anchor(claim.id)},
                 {"statement", claim.statement},
                 {"where", claim.where},
                 {"has_where", !claim.where.empty()},
                 {"has_deciding", !deciding_text(claim).empty()},
                 {"verdict", to_string(claim.verdict)},
                 {"deciding", deciding_text(claim)},
                 {"count", count_text(claim)},
                 {"has_no_picture", picture == nullptr && !claim.parts.empty()},
                 {"criteria", asked_list(claim)},
                 {"pictures", list_of(picture ? std::vector{*picture} : std::vector<Picture>{}, picture_data)}});
}

struct PaperClaims {
  std::string name;
  int year = 0;
  std::vector<claims::Claim> claims;
};

/// The year of a source: its last number of four digits; later than all years where there is none.
int year_of(const std::string& source) {
  constexpr std::string_view digits = "0123456789";
  int year = 9999;
  for (std::size_t at = source.find_first_of(digits); at != std::string::npos;) {
    const std::size_t end = std::min(source.find_first_not_of(digits, at), source.size());
    if (end - at == 4) year = std::stoi(source.substr(at, 4));
    at = source.find_first_of(digits, end);
  }
  return year;
}

/// The claims by paper; the papers by year, then by name.
std::vector<PaperClaims> papers_of(const std::vector<claims::Claim>& claims) {
  std::vector<PaperClaims> papers;
  for (const claims::Claim& claim : claims) {
    auto paper = std::ranges::find(papers, claim.source, &PaperClaims::name);
    if (paper == papers.end()) paper = papers.insert(papers.end(), {claim.source, year_of(claim.source), {}});
    paper->claims.push_back(claim);
  }
  std::ranges::stable_sort(papers, {}, [](const PaperClaims& paper) { return std::pair(paper.year, paper.name); });
  return papers;
}

}  // namespace

data claim_cards(const std::vector<claims::Claim>& claims, const std::vector<Section>& sections) {
  return list_of(papers_of(claims), [&](const PaperClaims& paper) {
    return object({{"paper", paper.name.empty() ? "Claims without a source" : paper.name},
                   {"paper_counts", claim_counts(paper.claims)},
                   {"cards", list_of(paper.claims, [&](const claims::Claim& c) { return card(c, sections); })}});
  });
}

}  // namespace mpmvv::reports
