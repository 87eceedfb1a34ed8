#include "reports/claim_picture.hpp"

#include <algorithm>

#include "reports/text.hpp"
#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::reports {

using records::Figure;

namespace {

/// What a criterion of a study file compares.
struct Compared {
  std::vector<std::string> series;  ///< empty: all
  std::string norm;
  bool is_cost = false;
};

/// What the criteria of a claim compare that have a norm, as the study's file says. An older store may keep a file that
/// is read no more.
std::vector<Compared> compared_for(const std::string& claim, const records::StudyResult& study) try {
  std::vector<Compared> all;
  for (const auto& criterion : support::TomlTable::parse(study.text, study.name).tables("criterion")) {
    Compared one{criterion.texts("series"), criterion.text("norm", ""), criterion.text("measure", "") == "cost-ratio"};
    if (criterion.text("claim", "") != claim || one.norm.empty()) continue;
    if (const std::string over = criterion.text("over", ""); !over.empty()) one.series.push_back(over);
    all.push_back(std::move(one));
  }
  return all;
} catch (const support::UsageError&) {
  return {};
}

bool shows_all(const Figure& figure, const Compared& compared) {
  const auto has = [&](const std::string& name) {
    return figure.series.empty() || std::ranges::find(figure.series, name) != figure.series.end();
  };
  const auto kind = compared.is_cost ? Figure::Kind::work_precision : Figure::Kind::curves;
  return figure.kind == kind && figure.quantity == compared.norm && std::ranges::all_of(compared.series, has);
}

/// The figure's picture; null where it has none. Where studies share a figure's name the picture bears the study's,
/// too.
const Picture* find_picture(const Section& section, const Figure& figure) {
  const auto found = std::ranges::find_if(section.pictures, [&](const Picture& picture) {
    return picture.name == figure.name || picture.name == section.study->name + "~" + figure.name;
  });
  return found == section.pictures.end() ? nullptr : &*found;
}

}  // namespace

const Picture* picture_of(const claims::Claim& claim, const std::vector<Section>& sections) {
  const Picture *first = nullptr, *best = nullptr;
  std::ptrdiff_t most = 0;
  for (const Section& section : sections) {
    const auto& named = section.study->claims;
    if (std::ranges::find(named, claim.id) == named.end()) continue;
    for (const Picture& picture : section.pictures) {
      if (picture.name == lower_case(claim.id)) return &picture;
      if (first == nullptr) first = &picture;
    }
    const auto compared = compared_for(claim.id, *section.study);
    for (const Figure& figure : section.study->figures) {
      const auto shown = std::ranges::count_if(compared, [&](const Compared& one) { return shows_all(figure, one); });
      const Picture* const picture = find_picture(section, figure);
      if (picture != nullptr && shown > most) most = shown, best = picture;
    }
  }
  return best == nullptr ? first : best;
}

}  // namespace mpmvv::reports
