#include "studies/store/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "studies/support/error.hpp"

namespace mpmvv::store {

namespace {

template <class Matches>
std::vector<const Version*> matching(const std::vector<Version>& versions, Matches matches) {
  std::vector<const Version*> found;
  for (const Version& version : versions)
    if (matches(version.digest) || std::ranges::any_of(version.commits, matches)) found.push_back(&version);
  return found;
}

std::string labels(const std::vector<const Version*>& versions) {
  std::vector<std::string> texts;
  for (const Version* version : versions) texts.push_back(label(*version));
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

std::string in_short(const std::string& commit) {
  constexpr std::size_t letters = 12;
  const auto end = std::min(commit.find_first_of("- "), commit.size());
  const bool is_hash = commit.substr(0, end).find_first_not_of("0123456789abcdef") == std::string::npos;
  return is_hash ? commit.substr(0, std::min(end, letters)) + commit.substr(end) : commit;
}

std::string label(const Version& version) {
  return fmt::format("{} (digest {})", in_short(version.commits.front()), in_short(version.digest));
}

const Version& find_version(const std::vector<Version>& versions, const std::string& prefix, const std::string& code) {
  auto found = matching(versions, [&](const std::string& text) { return text == prefix; });
  if (found.empty()) found = matching(versions, [&](const std::string& text) { return text.starts_with(prefix); });
  if (found.size() == 1) return *found.front();
  if (found.empty())
    throw support::UsageError(
        fmt::format("no results of a version '{}' of {} (there are: {})", prefix, code,
                    versions.empty() ? "none" : labels(matching(versions, [](auto&) { return true; }))));
  throw support::UsageError(
      fmt::format("version '{}' may be {} (a longer prefix, or the digest)", prefix, labels(found)));
}

}  // namespace mpmvv::store
