#pragma once
#include <vector>

#include "reports/page.hpp"
#include "reports/template_data.hpp"

namespace mpmvv::reports {

/// The studies that judge no claim, as cards: a figure, the title, the first of what was fitted.
template_data::data study_cards(const std::vector<Section>& sections);

}  // namespace mpmvv::reports
