#pragma once
#include <string>
#include <vector>

#include "reports/chart.hpp"
#include "reports/sheet.hpp"

namespace mpmvv::reports {

/// The texts that a picture of the chart has: labels of the axes, keys and names.
std::vector<std::string> drawn_texts(const Chart& chart);

/// What in these texts will not look as it was meant, in sentences: `$`, which is no markup here, and for LaTeX the
/// characters that it cannot set.
std::vector<std::string> text_remarks(const std::vector<std::string>& texts, Format format);

}  // namespace mpmvv::reports
