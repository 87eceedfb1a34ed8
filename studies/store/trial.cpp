#include "studies/store/trial.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "studies/support/printable.hpp"

namespace mpmvv::store {

namespace {

constexpr std::string_view mark = "# mpmvv study --set: ", mark_in_older_stores = "# Run with ";

/// Reads a text from its beginning, by hand: std::regex calls itself for each character.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  bool is_at_end() const { return rest_.empty(); }

  bool skip(std::string_view word) {
    const bool is_there = rest_.starts_with(word);
    if (is_there) rest_.remove_prefix(word.size());
    return is_there;
  }

  std::optional<std::size_t> number() {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (error != std::errc()) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return number;
  }

  /// What stands before `word`, which is skipped; none where it is not there.
  std::optional<std::string> before(std::string_view word) {
    const std::size_t at = rest_.find(word);
    if (at == std::string_view::npos) return std::nullopt;
    std::string text(rest_.substr(0, at));
    rest_.remove_prefix(at + word.size());
    return text;
  }

 private:
  std::string_view rest_;
};

/// Reads "2 of 3 series" to the end, or with the "; " behind it; whether it is 3 of 3.
std::optional<bool> read_counts(Reader& reader) {
  const auto some = reader.number();
  if (!some || !reader.skip(" of ")) return std::nullopt;
  const auto all = reader.number();
  if (!all || !reader.skip(" series") || !(reader.is_at_end() || reader.skip("; "))) return std::nullopt;
  return *some == *all;
}

/// Reads "shuffle = 3 in 2 of 2 series". A value may hold " in ", too.
std::optional<TrialSetting> read_setting(Reader& reader) {
  auto key = reader.before(" = ");
  if (!key || key->empty() || key->find(' ') != std::string::npos) return std::nullopt;
  constexpr std::string_view between = " in ";
  std::string value;
  while (auto more = reader.before(between)) {
    value += *more;
    Reader behind = reader;
    if (const auto in_all = read_counts(behind)) {
      reader = behind;
      return TrialSetting{std::move(*key), std::move(value), *in_all};
    }
    value += between;
  }
  return std::nullopt;
}

/// What a line says that this program has put under a study; nothing where the line is the study's own. People write
/// the older mark themselves ("# Run with care"), so there the whole line has to be as the program wrote it.
std::optional<std::string> trial_in(const std::string& line) {
  if (line.starts_with(mark)) return line.substr(mark.size());
  if (!line.starts_with(mark_in_older_stores)) return std::nullopt;
  std::string said = line.substr(mark_in_older_stores.size());
  return settings_of(said).empty() ? std::nullopt : std::optional(std::move(said));
}

/// The marked lines at the end of a text.
struct MarkedLines {
  std::size_t begin = 0;  ///< where they begin; without any the end of the text
  std::string trial;      ///< what they say
};

MarkedLines marked_lines_of(const std::string& text) {
  MarkedLines marked{text.size(), ""};
  while (marked.begin > 0) {
    const std::size_t end = text[marked.begin - 1] == '\n' ? marked.begin - 1 : marked.begin;
    const std::size_t newline = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    const auto trial = trial_in(text.substr(begin, end - begin));
    if (!trial) break;
    marked = {begin, *trial + (marked.trial.empty() ? "" : "; " + marked.trial)};
  }
  return marked;
}

}  // namespace

std::string with_trial(std::string text, const std::string& what) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text + fmt::format("{}{}\n", mark, support::printable(what));
}

std::string without_trial(const std::string& text) {
  return text.substr(0, marked_lines_of(text).begin);
}

std::string trial_of(const std::string& text) {
  return marked_lines_of(text).trial;
}

std::vector<TrialSetting> settings_of(const std::string& trial) {
  std::vector<TrialSetting> settings;
  for (Reader reader(trial); !reader.is_at_end();) {
    auto setting = read_setting(reader);
    if (!setting) return {};
    settings.push_back(std::move(*setting));
  }
  return settings;
}

}  // namespace mpmvv::store
