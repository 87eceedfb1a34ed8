#pragma once
#include <optional>
#include <string>
#include <vector>

namespace mpmvv::reports {

/// The y axis of a quantity that a paper draws in another unit than the studies.
struct OriginalAxis {
  std::string quantity, label;
  double factor = 1;  ///< by which the studies' numbers are multiplied
};

/// A figure of a paper, and which figures of studies show the same.
struct PaperFigure {
  std::string number;
  std::vector<std::string> panels;
  std::string differs;    ///< from the original; may be empty
  std::string without;    ///< why there are no panels
  bool wide = false;      ///< takes the width of two columns
  bool to_scale = false;  ///< one unit is as long along x as along y
  std::optional<OriginalAxis> upwards = {};
  std::vector<std::vector<std::string>> groups = {};  ///< series that share colour and marker in the original
};

struct Paper {
  std::string key;  ///< S; its studies' names begin with `s-`
  std::string source;
  std::vector<PaperFigure> figures;
  std::vector<std::string> series = {};  ///< that have the same look in all studies of the paper

  bool has(const std::string& study) const;
};

/// The papers of reports/papers.toml.
const std::vector<Paper>& papers();

/// The same from text; `name` stands for the file in messages. Throws UsageError where a field is missing, unknown or
/// of another type, or a figure has neither panels nor a reason.
std::vector<Paper> read_papers(const std::string& text, const std::string& name);

}  // namespace mpmvv::reports
