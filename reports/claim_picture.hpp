#pragma once
#include <vector>

#include "reports/page.hpp"

namespace mpmvv::reports {

/// The figure of a claim's card: the one that bears the claim's name; else, of its studies', the one that shows the
/// series and norms of most of its criteria; else the first. Null where they have none.
const Picture* picture_of(const claims::Claim& claim, const std::vector<Section>& sections);

}  // namespace mpmvv::reports
