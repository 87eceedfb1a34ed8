#include "studies/cases/setting_keys.hpp"

#include <fmt/format.h>

#include <tuple>
#include <type_traits>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::cases {

namespace {

Value value_of(bool value) {
  return value;
}
Value value_of(std::int64_t value) {
  return value;
}
Value value_of(int value) {
  return std::int64_t{value};
}
Value value_of(double value) {
  return value + 0.0;  // -0 becomes 0, so that equal numbers have one text
}
Value value_of(const std::string& value) {
  return value;
}
template <support::HasWords Enum>
Value value_of(Enum value) {
  return to_string(value);
}

template <class Whole>
auto parts(Whole& c) {
  return std::tie(c.problem, c.scheme, c.resolution, c.measure);
}

template <class Part>
constexpr CasePart part_of() {
  if (std::is_same_v<Part, ProblemChoice>) return CasePart::problem;
  if (std::is_same_v<Part, Scheme>) return CasePart::scheme;
  return std::is_same_v<Part, Resolution> ? CasePart::resolution : CasePart::measure;
}

/// Returns a member that studies/settings sets by a rule of its own.
template <class Part, class Type>
Member by_rule(Type Part::*member) {
  return {part_of<Part>(), [member](const Case& c) { return value_of(std::get<const Part&>(parts(c)).*member); }, {}};
}

/// Returns a member that is set to `read(setting)`, whatever the rest of the case is.
template <class Part, class Type, class Read>
Member read_by(const Read& read, Type Part::*member) {
  Member result = by_rule(member);
  result.set = [member, read](Case& c, const Setting& setting) {
    std::get<Part&>(parts(c)).*member = static_cast<Type>(read(setting));
  };
  return result;
}

template <class Part>
Member flag(bool Part::*member) {
  Member result = read_by(&parse_flag, member);
  result.is_flag = true;
  return result;
}

/// Returns a member that takes one of the enum's words. `none` cannot be given, except as a ForceForm: no body force.
template <class Part, support::HasWords Enum>
Member word(Enum Part::*member) {
  std::vector<std::string> words;
  for (const std::string_view each : words_of(Enum{}))
    if (each != "none" || std::is_same_v<Enum, ForceForm>) words.emplace_back(each);
  Member result = read_by(
      [words](const Setting& setting) {
        require_word(setting, words);
        return support::from_word<Enum>(setting.value, "word");
      },
      member);
  result.words = words;
  return result;
}

auto whole_from(std::int64_t least, std::int64_t most) {
  return [=](const Setting& setting) { return whole(setting, least, most); };
}

double part_of_a_cell(const Setting& setting) {
  const double value = not_negative(setting);
  if (!(value < 1))
    throw support::UsageError(
        fmt::format("{} = {} in {} (in cells, from 0 to below 1)", setting.key, setting.value, setting.where));
  return value;
}

/// Reads a word of an adapter. In a case's text it stands between spaces, so it must not have any.
std::string word_of_a_code(const Setting& setting) {
  const bool is_word = support::is_file_stem(setting.value);
  if (!is_word)
    throw support::UsageError(
        fmt::format("{} = '{}' in {} ({})", setting.key, setting.value, setting.where, support::file_stem_rule));
  return setting.value;
}

}  // namespace

std::string text_of(const Value& value) {
  return std::visit([](const auto& held) { return fmt::format("{}", held); }, value);
}

const std::vector<SettingKey>& setting_keys() {
  static const Absent required{"required", ""}, the_problems{"default: the problem's", "the problem's"};
  static const std::vector<SettingKey> keys{
      {"problem", "what is solved", {}, KeyOf::every, required},
      {"quarter", "only the part of which mirror images make the whole body", flag(&ProblemChoice::quarter),
       KeyOf::every},
      {"code", "another code that solves it, by its adapter", read_by(&word_of_a_code, &Scheme::code), KeyOf::other,
       Absent{"", "our own solver"}},
      {"variant", "of the code", read_by(&word_of_a_code, &Scheme::variant), KeyOf::other,
       Absent{"", "the only one of the code"}},
      {"force_form", "how the body force reaches the code", word(&Scheme::force_form), KeyOf::other,
       Absent{"default: reference", "`reference`, of a code"}},
      {"code_version", "of the code, where no other will do", read_by(&word_of_a_code, &Scheme::code_version),
       KeyOf::other, Absent{"", "that of the program"}},
      {"adapter", "digest of the adapter's and the program's files, where no others will do",
       read_by(&word_of_a_code, &Scheme::adapter), KeyOf::other, Absent{"", "that of its files"}},
      {"basis", "grid basis functions", by_rule(&Scheme::basis)},
      {"smoothing_length", "of ugimp, in cells", by_rule(&Scheme::smoothing_length), KeyOf::own,
       Absent{"required by it", "required where it counts"}},
      {"integrator", "time integrator: which operations make a step, in which order", by_rule(&Scheme::integrator)},
      {"start", "first step of cd and uvf", word(&Scheme::start)},
      {"velocity_update", "how particle velocities follow the grid", by_rule(&Scheme::velocity_update)},
      {"order", "terms k of xpic and fmpm", by_rule(&Scheme::order), KeyOf::own,
       Absent{"required by these", "required where it counts"}},
      {"cfl_x", "as cfl, of the steps that fmpm takes; flip between them", by_rule(&Scheme::cfl_x), KeyOf::own,
       Absent{"", "every step"}},
      {"position", "how particle positions follow the grid with flip", word(&Scheme::position)},
      {"wall_method", "how walls hold what xpic and fmpm expand", word(&Scheme::wall_method), KeyOf::own,
       Absent{"default: combined", "`combined`"}},
      {"wall_depth", "cells inside a moving wall that it holds", by_rule(&Scheme::wall_depth), KeyOf::own,
       Absent{"default: 1", "1"}},
      {"wall_gradient", "of the velocity that a moving wall holds", word(&Scheme::wall_gradient), KeyOf::own,
       Absent{"default: given", "`given`"}},
      {"mass", "mass matrix", word(&Scheme::mass)},
      {"boundary", "all faces, or per face as xmin=symmetry,xmax=free", by_rule(&Scheme::boundary), KeyOf::own,
       the_problems},
      {"wall_acceleration", "acceleration of held nodes", word(&Scheme::wall_acceleration)},
      {"deformation", "update of F", word(&Scheme::deformation)},
      {"body_force", "where the body force is evaluated", word(&Scheme::body_force)},
      {"fill", "how particles fill the body", word(&Scheme::fill), KeyOf::every},
      {"material", "constitutive law", by_rule(&Scheme::material), KeyOf::every, the_problems},
      {"cells", "cells per length L of the problem", read_by(whole_from(1, 1'000'000), &Resolution::cells),
       KeyOf::every, required},
      {"ppc", "particles per cell and direction", read_by(whole_from(1, 100), &Resolution::ppc), KeyOf::every,
       required},
      {"grid_offset", "shift of the grid against the body where nothing holds it, in cells",
       read_by(&part_of_a_cell, &Resolution::grid_offset)},
      {"shuffle", "seed of another order of the particles",
       read_by(whole_from(0, 1'000'000'000), &Resolution::shuffle)},
      {"cfl",
       "wave speed times time step over cell width",
       {},
       KeyOf::every,
       Absent{"this or --dt is required", "`dt` counts"}},
      {"dt", "time step in s; must divide the end time", by_rule(&Resolution::dt), KeyOf::every,
       Absent{"this or --cfl is required", "`cfl` counts"}},
      {"end_time", "in s", {}, KeyOf::every, the_problems},
      {"steps", "number of steps, each as long as on the way to the default end time", by_rule(&Resolution::steps),
       KeyOf::every, Absent{"", "all"}},
      {"every_step", "errors over all steps, too", flag(&Measure::every_step)},
      {"nodal_error", "error of the nodal accelerations at the end, too", flag(&Measure::nodal_error)},
      {"velocity_error", "mean over all steps of the RMS velocity error, too", flag(&Measure::velocity_error)},
      {"stress_error", "RMS error of the stresses at the end, too", flag(&Measure::stress_error), KeyOf::every},
      {"particle_errors", "displacement errors of the particles at the end by their places, too",
       flag(&Measure::particle_errors), KeyOf::every},
      {"blowup_error", "unstable beyond this error, in displacement amplitudes",
       read_by(&parse_number, &Measure::blowup_error), KeyOf::every},
      {"blowup_energy", "unstable beyond this energy, in initial energies",
       read_by(&parse_number, &Measure::blowup_energy)},
      {"whole", "all of a body, not the part of which images make it", flag(&Measure::whole)},
      {"repeat", "time the steps so often (3 to 99), alone and by turns, and keep the mean cost",
       read_by(whole_from(3, 99), &Measure::repeat), KeyOf::every, Absent{"", "not measured"}},
  };
  return keys;
}

}  // namespace mpmvv::cases
