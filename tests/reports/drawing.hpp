#pragma once
#include <compare>
#include <string>
#include <vector>

/// A picture of a report as someone reads it who knows nothing but its SVG: values by the texts of the tics, series by
/// the look that the key gives them.
namespace mpmvv::reports::read_back {

struct ReadTic {
  double pixel = 0;
  std::string text;
};

/// Where in the picture, in pixels from its left and upper edge.
struct Spot {
  double x = 0, y = 0;
};

struct ReadAxis {
  std::string label;
  std::vector<ReadTic> tics;
  Spot label_at = {};  ///< of the abscissa's

  /// Whether the numbers at the tics grow by ratios. Throws std::runtime_error where they are too few to tell, or stand
  /// where neither a linear nor a logarithmic axis has them.
  bool is_log() const;
  double value(double pixel) const;
  const std::string& name(double pixel) const;  ///< of the nearest tic
};

/// What tells one series from another.
struct Look {
  std::string colour;
  int shape = 0;
  auto operator<=>(const Look&) const = default;
};

struct ReadMark {
  enum class Kind { filled, hollow, cross };
  Spot at;
  Look look;
  Kind kind = Kind::filled;
};

struct ReadLine {
  std::string colour;
  double width = 1;
  std::vector<Spot> path;
};

struct ReadText {
  Spot at;
  std::string text;  ///< with ^ before what is raised
};

struct KeyEntry {
  std::string text;
  Look look;
  Spot at;
};

struct Drawing {
  ReadAxis x, y;
  double top = 0, bottom = 0;  ///< of the frame
  double band = 0;             ///< middle of the band of unstable runs; 0: none
  std::vector<KeyEntry> key;
  std::vector<ReadMark> marks;  ///< without the white below hollow ones
  std::vector<ReadLine> lines;
  std::vector<ReadLine> boxes;  ///< their corners
  std::vector<ReadText> labels;

  /// The look of the only entry whose text begins so. Throws std::runtime_error unless there is one.
  Look look_of(const std::string& start) const;
  std::vector<ReadMark> marks_of(const Look& look) const;  ///< from left to right
};

/// Of a picture that gnuplot has drawn for us. Throws std::runtime_error on anything else.
Drawing read_drawing(const std::string& svg);

}  // namespace mpmvv::reports::read_back
