#include "tests/reports/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace mpmvv::reports::read_back {

namespace {

using SvgNode = boost::property_tree::ptree;

std::string attribute(const SvgNode& node, const std::string& name) {
  return node.get("<xmlattr>." + name, "");
}

/// A minus sign is a hyphen here.
std::vector<double> numbers_in(std::string text) {
  for (auto sign = text.find("−"); sign != std::string::npos; sign = text.find("−"))
    text.replace(sign, std::string_view("−").size(), "-");
  std::vector<double> numbers;
  for (const char* at = text.c_str(); *at != '\0';) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end == at)
      ++at;
    else
      numbers.push_back(number), at = end;
  }
  return numbers;
}

std::vector<Spot> spots_in(const std::string& path) {
  const auto numbers = numbers_in(path);
  std::vector<Spot> spots;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) spots.push_back({numbers[i], numbers[i + 1]});
  return spots;
}

/// "rgb(  0, 114, 178)" without its spaces.
std::string colour_of(std::string text) {
  std::erase(text, ' ');
  return text;
}

std::string flat_text(const SvgNode& node) {
  std::string text = node.data();
  for (const auto& [name, child] : node)
    if (name == "tspan") text += (attribute(child, "dy").starts_with("-") ? "^" : "") + flat_text(child);
  return text;
}

/// "0.5", "10^-3", "2·10^-3".
std::optional<double> tic_number(const std::string& text) {
  const auto numbers = numbers_in(text);
  const bool is_power = text.find("10^") != std::string::npos;
  if (numbers.size() != (is_power ? text.starts_with("10^") ? 2u : 3u : 1u)) return std::nullopt;
  return is_power ? (numbers.size() == 3 ? numbers[0] : 1) * std::pow(10, numbers.back()) : numbers[0];
}

/// How the pixels of an axis follow from its numbers or their logarithms: through the first and the last tic.
struct Scale {
  bool log = false;
  double slope = 0, start = 0;  ///< in pixels per unit, and where zero is
  double misfit = INFINITY;     ///< in pixels, of the tics between

  Scale(const std::vector<ReadTic>& tics, bool is_log) : log(is_log) {
    std::vector<double> at;
    for (const ReadTic& tic : tics) {
      const auto number = tic_number(tic.text);
      if (!number || (log && *number <= 0)) return;
      at.push_back(log ? std::log10(*number) : *number);
    }
    slope = (tics.back().pixel - tics.front().pixel) / (at.back() - at.front());
    start = tics.front().pixel - slope * at.front();
    misfit = 0;
    for (std::size_t i = 0; i < at.size(); ++i)
      misfit = std::max(misfit, std::abs(start + slope * at[i] - tics[i].pixel));
  }

  double value(double pixel) const {
    const double at = (pixel - start) / slope;
    return log ? std::pow(10, at) : at;
  }
};

Scale scale_of(const ReadAxis& axis) {
  std::string texts;
  for (const ReadTic& tic : axis.tics) texts += " " + tic.text;
  if (axis.tics.size() < 3) throw std::runtime_error("too few tics on the axis '" + axis.label + "':" + texts);
  const Scale even(axis.tics, false), log(axis.tics, true);
  const Scale& better = log.misfit < even.misfit ? log : even;
  if (!(better.misfit < 0.3)) throw std::runtime_error("tics at wrong places on '" + axis.label + "':" + texts);
  return better;
}

/// Goes through a picture once, from its first element to its last.
class Reader {
 public:
  Drawing read(const SvgNode& root) {
    visit(root);
    find_x_label();
    find_key();
    return std::move(drawing_);
  }

 private:
  /// What one element of the `plot` command has drawn.
  struct Element {
    std::vector<ReadMark> marks;
    std::vector<ReadLine> lines, boxes;
  };

  void visit(const SvgNode& node) {
    for (const auto& [name, child] : node) {
      if (name == "defs") continue;
      const bool starts = attribute(child, "id").find("gnuplot_plot_") != std::string::npos;
      if (starts) element_.emplace();
      if (name == "g" && child.count("text") > 0)
        add_text(child);
      else if (name == "path")
        add_path(child, attribute(node, "stroke-width"));
      else if (name == "use")
        add_mark(child);
      else if (name == "polygon" && element_)
        element_->boxes.push_back({colour_of(attribute(child, "fill")), 0, spots_in(attribute(child, "points"))});
      else
        visit(child);
      if (starts) finish_element();
    }
  }

  void add_mark(const SvgNode& use) {
    const std::string href = attribute(use, "xlink:href");
    const int type = std::atoi(href.substr(href.rfind("gpPt") + 4).c_str());
    const auto place = numbers_in(attribute(use, "transform"));
    const std::string colour = colour_of(attribute(use, "color"));
    if (colour == "rgb(255,255,255)") return;
    const auto kind = type < 3        ? ReadMark::Kind::cross
                      : type % 2 == 0 ? ReadMark::Kind::filled
                                      : ReadMark::Kind::hollow;
    (element_ ? element_->marks : samples_).push_back({{place.at(0), place.at(1)}, {colour, (type + 1) / 2}, kind});
  }

  void add_path(const SvgNode& path, const std::string& width) {
    const auto spots = spots_in(attribute(path, "d"));
    if (spots.empty()) return;
    if (element_) {
      element_->lines.push_back({colour_of(attribute(path, "stroke")), std::atof(width.c_str()), spots});
    } else if (attribute(path, "class") == "gridline") {
      grid_line_ = spots;
    } else if (spots.size() == 5) {
      const auto [top, bottom] = std::ranges::minmax(spots, {}, &Spot::y);
      drawing_.top = top.y, drawing_.bottom = bottom.y;
    } else if (spots.size() == 2) {
      samples_.push_back({spots[0], {colour_of(attribute(path, "stroke")), 0}});
    }
  }

  /// A tic's text stands behind its line of the grid. The label of the ordinate alone is turned.
  void add_text(const SvgNode& group) {
    const std::string text = flat_text(group.get_child("text")), place = attribute(group, "transform");
    const auto at = numbers_in(place);
    if (text.empty()) return;
    if (!grid_line_.empty()) {
      const Spot &a = grid_line_.front(), &b = grid_line_.back();
      if (text == "unstable")
        drawing_.band = a.y;
      else if (a.y == b.y)
        drawing_.y.tics.push_back({a.y, text});
      else
        drawing_.x.tics.push_back({a.x, text});
      grid_line_.clear();
    } else if (place.find("rotate") != std::string::npos) {
      drawing_.y.label += (drawing_.y.label.empty() ? "" : " ") + text;
    } else {
      if (attribute(group, "text-anchor") == "middle") centred_.push_back(drawing_.labels.size());
      drawing_.labels.push_back({{at.at(0), at.at(1)}, text});
    }
  }

  void finish_element() {
    const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
    append(drawing_.marks, element_->marks);
    append(drawing_.lines, element_->lines);
    append(drawing_.boxes, element_->boxes);
    element_.reset();
  }

  /// Of the centred texts only the label of the abscissa stands below the frame. Where among all it is drawn depends on
  /// gnuplot's version.
  void find_x_label() {
    const auto is_it = [&](std::size_t label) { return drawing_.labels[label].at.y > drawing_.bottom; };
    const auto found = std::ranges::find_if(centred_, is_it);
    if (found == centred_.end()) return;
    drawing_.x.label = drawing_.labels[*found].text, drawing_.x.label_at = drawing_.labels[*found].at;
    drawing_.labels.erase(drawing_.labels.begin() + static_cast<std::ptrdiff_t>(*found));
  }

  /// The key's samples stand below the frame, each before its text; a marker stands in the middle of its line.
  void find_key() {
    const auto belongs = [&](const ReadMark& sample, const ReadText& text) {
      return sample.at.y > drawing_.bottom && std::abs(sample.at.y - text.at.y) < 8 && sample.at.x < text.at.x;
    };
    std::vector<ReadText> others;
    for (const ReadText& text : drawing_.labels) {
      const ReadMark* best = nullptr;
      for (const ReadMark& sample : samples_) {
        if (belongs(sample, text) && (!best || sample.at.x > best->at.x)) best = &sample;
      }
      if (best)
        drawing_.key.push_back({text.text, best->look, text.at});
      else
        others.push_back(text);
    }
    drawing_.labels = others;
  }

  Drawing drawing_;
  std::optional<Element> element_;
  std::vector<ReadMark> samples_;     ///< markers and beginnings of lines that belong to no element: the key's
  std::vector<Spot> grid_line_;       ///< that waits for its text
  std::vector<std::size_t> centred_;  ///< places of the centred texts among the labels
};

}  // namespace

bool ReadAxis::is_log() const {
  return scale_of(*this).log;
}

double ReadAxis::value(double pixel) const {
  return scale_of(*this).value(pixel);
}

const std::string& ReadAxis::name(double pixel) const {
  const auto nearest =
      std::ranges::min_element(tics, {}, [&](const ReadTic& tic) { return std::abs(tic.pixel - pixel); });
  if (nearest == tics.end()) throw std::runtime_error("no name on the axis '" + label + "'");
  return nearest->text;
}

Look Drawing::look_of(const std::string& start) const {
  std::vector<Look> looks;
  for (const KeyEntry& entry : key)
    if (entry.text.starts_with(start)) looks.push_back(entry.look);
  if (looks.size() != 1) throw std::runtime_error(fmt::format("{} entries of the key '{}'", looks.size(), start));
  return looks[0];
}

std::vector<ReadMark> Drawing::marks_of(const Look& look) const {
  std::vector<ReadMark> result;
  std::ranges::copy_if(marks, std::back_inserter(result), [&](const ReadMark& mark) {
    return mark.look.colour == look.colour && (mark.look.shape == look.shape || mark.kind == ReadMark::Kind::cross);
  });
  std::ranges::sort(result, {}, [](const ReadMark& mark) { return mark.at.x; });
  return result;
}

Drawing read_drawing(const std::string& svg) {
  std::istringstream in(svg);
  SvgNode root;
  boost::property_tree::read_xml(in, root);
  return Reader().read(root);
}

}  // namespace mpmvv::reports::read_back
