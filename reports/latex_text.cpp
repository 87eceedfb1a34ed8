#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "reports/text.hpp"
#include "reports/utf8.hpp"

namespace mpmvv::reports {

namespace {

using Sign = std::pair<std::string_view, std::string_view>;  // a character, and how it is set

constexpr Sign signs_of_text[] = {{"\\", "\\textbackslash{}"},
                                  {"{", "\\{"},
                                  {"}", "\\}"},
                                  {"$", "\\$"},
                                  {"&", "\\&"},
                                  {"#", "\\#"},
                                  {"%", "\\%"},
                                  {"_", "\\_"},
                                  {"^", "\\textasciicircum{}"},
                                  {"~", "\\textasciitilde{}"},
                                  {"\"", "''"},
                                  {"\n", " "},
                                  {"\r", " "},
                                  {"\t", " "},
                                  {"§", "\\S{}"},
                                  {"–", "--"},
                                  {"—", "---"},
                                  {"\u2010", "-"},
                                  {"\u2011", "-"},
                                  {"…", "\\ldots{}"},
                                  {"‘", "`"},
                                  {"’", "'"},
                                  {"“", "``"},
                                  {"”", "''"},
                                  {"\u00A0", "~"},
                                  {"\u2009", "\\,"},
                                  {"\u202F", "\\,"},
                                  {"†", "\\dag{}"},
                                  {"‡", "\\ddag{}"},
                                  {"•", "$\\bullet$"},
                                  {"№", "No."}};

/// What stands in mathematics, all in plain LaTeX.
constexpr Sign signs_of_mathematics[] = {{"<", "<"},
                                         {">", ">"},
                                         {"|", "|"},
                                         {"α", "\\alpha"},
                                         {"β", "\\beta"},
                                         {"γ", "\\gamma"},
                                         {"δ", "\\delta"},
                                         {"ε", "\\varepsilon"},
                                         {"ϵ", "\\epsilon"},
                                         {"ζ", "\\zeta"},
                                         {"η", "\\eta"},
                                         {"θ", "\\theta"},
                                         {"ϑ", "\\vartheta"},
                                         {"ι", "\\iota"},
                                         {"κ", "\\kappa"},
                                         {"λ", "\\lambda"},
                                         {"μ", "\\mu"},
                                         {"\u00B5", "\\mu"},
                                         {"ν", "\\nu"},
                                         {"ξ", "\\xi"},
                                         {"π", "\\pi"},
                                         {"ρ", "\\rho"},
                                         {"σ", "\\sigma"},
                                         {"ς", "\\varsigma"},
                                         {"τ", "\\tau"},
                                         {"υ", "\\upsilon"},
                                         {"φ", "\\varphi"},
                                         {"ϕ", "\\phi"},
                                         {"χ", "\\chi"},
                                         {"ψ", "\\psi"},
                                         {"ω", "\\omega"},
                                         {"Γ", "\\Gamma"},
                                         {"Δ", "\\Delta"},
                                         {"\u2206", "\\Delta"},
                                         {"Θ", "\\Theta"},
                                         {"Λ", "\\Lambda"},
                                         {"Ξ", "\\Xi"},
                                         {"Π", "\\Pi"},
                                         {"Σ", "\\Sigma"},
                                         {"Φ", "\\Phi"},
                                         {"Ψ", "\\Psi"},
                                         {"\u2126", "\\Omega"},
                                         {"‖", "\\|"},
                                         {"\u2225", "\\|"},
                                         {"ℓ", "\\ell"},
                                         {"∂", "\\partial"},
                                         {"∇", "\\nabla"},
                                         {"∫", "\\int"},
                                         {"∑", "\\sum"},
                                         {"∏", "\\prod"},
                                         {"∞", "\\infty"},
                                         {"±", "\\pm"},
                                         {"∓", "\\mp"},
                                         {"×", "\\times"},
                                         {"·", "\\cdot"},
                                         {"⋅", "\\cdot"},
                                         {"∘", "\\circ"},
                                         {"⊗", "\\otimes"},
                                         {"⊕", "\\oplus"},
                                         {"≤", "\\le"},
                                         {"≥", "\\ge"},
                                         {"≪", "\\ll"},
                                         {"≫", "\\gg"},
                                         {"≈", "\\approx"},
                                         {"≃", "\\simeq"},
                                         {"∼", "\\sim"},
                                         {"≅", "\\cong"},
                                         {"≡", "\\equiv"},
                                         {"≠", "\\ne"},
                                         {"∝", "\\propto"},
                                         {"∈", "\\in"},
                                         {"∉", "\\notin"},
                                         {"⊂", "\\subset"},
                                         {"∪", "\\cup"},
                                         {"∩", "\\cap"},
                                         {"∀", "\\forall"},
                                         {"∃", "\\exists"},
                                         {"→", "\\to"},
                                         {"←", "\\leftarrow"},
                                         {"↔", "\\leftrightarrow"},
                                         {"⇒", "\\Rightarrow"},
                                         {"↑", "\\uparrow"},
                                         {"↓", "\\downarrow"},
                                         {"↦", "\\mapsto"},
                                         {"√", "\\surd"},
                                         {"⟨", "\\langle"},
                                         {"⟩", "\\rangle"},
                                         {"⌈", "\\lceil"},
                                         {"⌉", "\\rceil"},
                                         {"⌊", "\\lfloor"},
                                         {"⌋", "\\rfloor"},
                                         {"′", "'"},
                                         {"⊥", "\\perp"},
                                         {"∧", "\\wedge"},
                                         {"∨", "\\vee"},
                                         {"∣", "\\mid"},
                                         {"−", "-"},
                                         {"°", "^\\circ"},
                                         {"½", "\\frac12"},
                                         {"¼", "\\frac14"},
                                         {"¾", "\\frac34"},
                                         {"″", "''"}};

/// How a table sets the character; empty where it does not have it.
std::string_view set_by(std::span<const Sign> signs, std::string_view character) {
  const auto sign = std::ranges::find(signs, character, &Sign::first);
  return sign == signs.end() ? "" : sign->second;
}

/// The sign that a small raised or lowered one is of; empty for other characters.
std::string_view full_sign(std::string_view character, std::string_view small, std::string_view full) {
  for (std::size_t at = 0, k = 0; at < small.size(); at += first_character(small.substr(at)).size(), ++k)
    if (first_character(small.substr(at)) == character) return full.substr(k, 1);
  return "";
}

/// ASCII, and the Latin-1 letters that every text font has.
bool latex_prints(std::string_view character) {
  const unsigned code = code_point(character);
  if (character.size() == 1) return code >= 0x20 && code < 0x7F;
  return code >= 0xC0 && code <= 0xFF && std::string_view("×÷ÐðÞþ").find(character) == std::string_view::npos;
}

/// The character in LaTeX; empty where it has no form there.
std::string latex_character(std::string_view character) {
  if (const auto text = set_by(signs_of_text, character); !text.empty()) return std::string(text);
  if (const auto sign = set_by(signs_of_mathematics, character); !sign.empty()) return fmt::format("${}$", sign);
  if (const auto raised = full_sign(character, "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿⁱ", "0123456789+-ni"); !raised.empty())
    return fmt::format("$^{}$", raised);
  if (const auto lowered = full_sign(character, "₀₁₂₃₄₅₆₇₈₉₊₋ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", "0123456789+-aehijklmnoprstuvx");
      !lowered.empty())
    return fmt::format("$_{}$", lowered);
  return latex_prints(character) ? std::string(character) : "";
}

}  // namespace

std::string latex_text(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto character = first_character(std::string_view(text).substr(i));
    const std::string set = latex_character(character);
    if (text.compare(i, 2, "--") == 0)
      result += "-{}";  // or LaTeX makes a dash of the two
    else
      result += set.empty() ? fmt::format("[U+{:04X}]", code_point(character)) : set;
    i += character.size();
  }
  return result;
}

std::vector<std::string> without_latex(const std::string& text) {
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < text.size();) {
    const auto character = first_character(std::string_view(text).substr(i));
    if (latex_character(character).empty()) missing.emplace_back(character);
    i += character.size();
  }
  return missing;
}

std::string latex_file(const std::string& name) {
  return replace_all(name, "~", "\\string~");
}

}  // namespace mpmvv::reports
