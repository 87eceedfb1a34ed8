#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "reports/page.hpp"
#include "reports/template_data.hpp"

namespace mpmvv::reports {

/// A page from its template, with the head, the way back to the other pages and the partial templates that it names.
/// Links of pages in folders of their own begin with `root`.
Page framed_page(const std::string& file, const std::string& title, std::string_view text, const ReportInput& input,
                 template_data::data content);

/// The command that runs these studies once more.
std::string command_of(const ReportInput& input, const std::vector<std::string>& studies);

}  // namespace mpmvv::reports
