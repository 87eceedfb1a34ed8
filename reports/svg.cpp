#include "reports/svg.hpp"

#include "reports/text.hpp"

namespace mpmvv::reports {

namespace {

void remove_elements(std::string& svg, const std::string& tag) {
  const std::string opening = "<" + tag + ">", closing = "</" + tag + ">";
  for (auto start = svg.find(opening); start != std::string::npos; start = svg.find(opening, start)) {
    const auto end = svg.find(closing, start);
    if (end == std::string::npos) return;
    svg.erase(start, end + closing.size() - start);
  }
}

}  // namespace

std::string inline_svg(const std::string& file, const std::string& name, const std::string& prefix) {
  const auto start = file.find("<svg");
  if (start == std::string::npos) return "";
  std::string svg = file.substr(start);
  remove_elements(svg, "title");
  remove_elements(svg, "desc");
  for (const char* reference : {" id='", " id=\"", "href='#", "href=\"#", "url(#"})
    svg = replace_all(svg, reference, reference + prefix);
  return svg.replace(0, 4, "<svg role=\"img\" aria-label=\"Figure " + name + "\"");
}

}  // namespace mpmvv::reports
