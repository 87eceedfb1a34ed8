#pragma once
#include <vector>

#include "reports/page.hpp"
#include "reports/template_data.hpp"

namespace mpmvv::reports {

/// The claims of each paper as cards: a figure, the claim in a sentence, its verdict, the number that decides.
template_data::data claim_cards(const std::vector<claims::Claim>& claims, const std::vector<Section>& sections);

}  // namespace mpmvv::reports
