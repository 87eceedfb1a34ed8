#pragma once
#include <string>

namespace mpmvv::reports {

/// An SVG file's content as an element of an HTML page: from its <svg> tag on, named for people who do not see it,
/// without the tips that a browser would show, and with the prefix before all of its ids so that several fit on one
/// page.
std::string inline_svg(const std::string& file, const std::string& name, const std::string& prefix);

}  // namespace mpmvv::reports
