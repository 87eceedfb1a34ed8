#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "studies/codes/field_names.hpp"
#include "studies/codes/fields.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/codes/mover.hpp"

namespace mpmvv::codes::template_fields_test {

using support::UsageError;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class TemplateFieldsOfCases : public testing::Test {
 protected:
  /// The text of the adapter with `part` in the place of `line`.
  static std::string with(const std::string& line, const std::string& part) {
    std::string text = Mover::text;
    return text.replace(text.find(line), line.size(), part);
  }
  std::string filled(const std::string& content, const cases::Case& c = settings::make_case(Mover::settings())) const {
    mover_.write("input.mustache", content);
    return input_texts(c, mover_.code()).at(0);
  }
  /// A square between two walls that move, with periodic sides.
  static cases::Case swing() {
    auto settings = Mover::settings();
    settings[0].value = "swing";
    settings.push_back({"force_form", "none", "test"});
    return settings::make_case(settings);
  }

  const Mover mover_;
};

TEST_F(TemplateFieldsOfCases, ToldByFacesWhereAllAreAlike) {
  EXPECT_EQ(filled("{{boundary_xmin}} {{boundary_ymax}}{{#xmax_is_periodic}}, periodic{{/xmax_is_periodic}}"
                   "{{#ymin_is_wall}}, wall{{/ymin_is_wall}}{{^ymin_is_free}}, not free{{/ymin_is_free}}"),
            "periodic periodic, periodic, not free");
  EXPECT_THAT([&] { filled("\n{{#zmin_is_wall}}wall{{/zmin_is_wall}}"); },
              ThrowsMessage<UsageError>(HasSubstr("/input.mustache:2 (the case has fewer dimensions")));
}

/// A periodic cube moves as one between planes of symmetry.
TEST_F(TemplateFieldsOfCases, AreOfTheBoundaryThatTheCodeHas) {
  auto settings = Mover::settings();
  settings[0].value = "cube";
  settings.push_back({"force_form", "none", "test"});
  const cases::Case cube = settings::make_case(settings);
  const char* content =
      "{{boundary}} {{boundary_zmax}} {{#is_symmetry}}1{{/is_symmetry}}{{#is_periodic}}2{{/is_periodic}}"
      "{{#xmin_is_symmetry}}3{{/xmin_is_symmetry}}";
  EXPECT_EQ(filled(content, cube), "periodic periodic 2");
  mover_.adapter(with("[\"periodic\"]", "[\"symmetry\", \"free\"]"));
  EXPECT_EQ(filled(content, cube), "symmetry symmetry 13");
  EXPECT_EQ(filled("{{boundary}}"), "periodic") << "the square that translates has no planes of symmetry";
}

TEST_F(TemplateFieldsOfCases, ToldByFacesWhereTheyDiffer) {
  EXPECT_EQ(filled("{{#xmin_is_wall}}1{{/xmin_is_wall}}{{#xmax_is_wall}}2{{/xmax_is_wall}}"
                   "{{#ymin_is_wall}}3{{/ymin_is_wall}}{{#ymax_is_periodic}}4{{/ymax_is_periodic}}"
                   "{{#is_wall}}no{{/is_wall}} {{boundary_xmax}} {{boundary_ymin}}",
                   swing()),
            "124 wall periodic");
}

/// At X = 1 the wall swings against the one at X = 0, by 0.05 m at π 100/s.
TEST_F(TemplateFieldsOfCases, SayHowWallsMove) {
  mover_.adapter(Mover::text + std::string("[expressions]\ndialect = \"python\"\n"));
  std::istringstream texts(filled("{{xmin_position}}\n{{xmax_position}}\n{{xmax_velocity}}\n", swing()));
  std::string left, right, speed;
  std::getline(texts, left), std::getline(texts, right), std::getline(texts, speed);
  EXPECT_EQ(left, "0.05*sin(314.1592653589793*t)");
  EXPECT_EQ(right, "1 - 0.05*sin(314.1592653589793*t)");
  EXPECT_EQ(speed, "-15.707963267948967*cos(314.1592653589793*t)");
  EXPECT_THAT([&] { filled("{{ymin_position}}", swing()); },
              ThrowsMessage<UsageError>(AllOf(HasSubstr("'ymin_position'"), HasSubstr("{{#ymin_is_wall}}"))));
  EXPECT_THAT([&] { filled("{{zmin_position}}", swing()); }, ThrowsMessage<UsageError>(HasSubstr("fewer dimensions")));
}

/// In a cube, or between walls, which no problem has along y or z.
TEST_F(TemplateFieldsOfCases, AreAllThatAreKnown) {
  mover_.adapter(Mover::text + std::string("[expressions]\ndialect = \"python\"\n"));
  auto settings = Mover::settings();
  settings[0].value = "cube";
  const std::regex motion("(.)(min|max)_(position|velocity)");
  std::string of_cube = "{{#particles}}{{#is_first}}", of_walls;
  for (const std::string& name : names_of_fields()) {
    if (std::smatch axis; !std::regex_match(name, axis, motion))
      of_cube += "{{" + name + "}}\n";
    else if (axis[1] == "x")
      of_walls += "{{" + name + "}}\n";
  }
  EXPECT_NO_THROW(filled(of_cube + "{{/is_first}}{{/particles}}", settings::make_case(settings)));
  EXPECT_NO_THROW(filled(of_walls, swing()));
}

TEST_F(TemplateFieldsOfCases, OfTheWholeBoundaryAreNotEnoughWhereFacesDiffer) {
  mover_.adapter(with("[\"periodic\"]", "[\"periodic\", \"wall\"]"));
  const auto require = [&](const std::string& content) {
    mover_.write("input.mustache", content);
    require_able(read_adapter(mover_.folder() / "adapter.toml"), swing());
  };
  EXPECT_THAT([&] { require("{{^is_wall}}open{{/is_wall}}"); },
              ThrowsMessage<UsageError>(HasSubstr("its faces differ, xmin=wall,xmax=wall,ymin=periodic,ymax=periodic, "
                                                  "and the templates of ")));
  EXPECT_THAT([&] { require("{{#is_periodic}}around{{/is_periodic}}"); },
              ThrowsMessage<UsageError>(HasSubstr("ask is_periodic but nothing of a face")));
  EXPECT_NO_THROW(require("{{#is_wall}}closed{{/is_wall}} {{boundary_ymin}}"));
  EXPECT_NO_THROW(require("{{#xmin_is_wall}}closed{{/xmin_is_wall}}"));
  EXPECT_NO_THROW(require("{{h}}")) << "it may have boundaries of its own";
}

TEST_F(TemplateFieldsOfCases, TellTheFirstAndTheLastParticle) {
  const auto json = nlohmann::json::parse(filled("[{{#particles}}{{^is_first}},{{/is_first}}{{id}}{{/particles}}]"));
  EXPECT_EQ(json.size(), 64U);
  EXPECT_EQ(nlohmann::json::parse(filled("[{{#particles}}{{id}}{{^is_last}},{{/is_last}}{{/particles}}]")), json);
}

TEST_F(TemplateFieldsOfCases, StandBesideBracesWithOtherDelimiters) {
  EXPECT_EQ(filled("{{=<% %>=}}{<%ppc%>, {<%cells%>}}"), "{2, {4}}");
  const auto complaint = [&](const std::string& line) {
    try {
      filled("a\nb\n" + line + "\n");
    } catch (const UsageError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string hint = "{{{ begins a tag of its own: other delimiters, {{=<% %>=}}, where a { stands before a tag";
  EXPECT_THAT(complaint("x = {{{h}};"), HasSubstr("/input.mustache:3 is no template (Unclosed tag; " + hint));
  EXPECT_THAT(complaint("x = {{{h}}, {{dt}}};"), HasSubstr("/input.mustache:3 (" + hint));
  EXPECT_THAT(complaint("x = {{{{h}}}};"), HasSubstr("unknown field '{h' in "));
  EXPECT_THAT(complaint("x = {{{{h}}}};"), HasSubstr("/input.mustache:3 (" + hint));
  EXPECT_THAT(complaint("{{#particles}}"),
              HasSubstr("/input.mustache:3 is no template (Unclosed section \"particles\";"));
  EXPECT_THAT(complaint("{{= <% %> =}}\n<% hh %>"), HasSubstr("unknown field 'hh' in "));
  EXPECT_THAT(complaint("{{= <% %> =}}\n<% hh %>"), HasSubstr("/input.mustache:4 (docs/adapters.md lists them"));
}

/// The library calls itself for each section that stands in another.
TEST_F(TemplateFieldsOfCases, RefusedWhereSectionsAreTooDeep) {
  const auto nested = [](int depth, const std::string& open, const std::string& close) {
    std::string text;
    for (int k = 0; k < depth; ++k) text += open;
    text += "2";
    for (int k = 0; k < depth; ++k) text += close;
    return text;
  };
  EXPECT_EQ(filled(nested(64, "{{#is_plane}}", "{{/is_plane}}")), "2");
  EXPECT_EQ(filled(nested(1, "{{! {{# }}", "") + nested(100, "{{#is_plane}}2{{/is_plane}}", "{{! # }}")),
            std::string(102, '2'));
  const auto refused = ThrowsMessage<UsageError>(
      AllOf(HasSubstr("sections too deep in one another in "), HasSubstr("/input.mustache:2 (at most 64)")));
  for (const char* before : {"\n", "{{! {{=<% %>=}}\n", "{{{ppc}} {{=<% %>=}} }}}\n"})
    EXPECT_THAT([&] { filled(before + nested(65, "{{ # is_plane }}", "{{/is_plane}}")); }, refused) << before;
  EXPECT_THAT([&] { filled("{{^is_solid}}\n" + nested(100'000, "{{^is_solid}}", "")); }, refused);
  for (const char* before : {"{{=<% %>=}}\n", "{{= <%  %>\t=\t}}\n"})
    EXPECT_THAT([&] { filled(before + nested(65, "<%#is_plane%>", "<%/is_plane%>")); }, refused) << before;
}

/// In mm, s and t: 1 MPa is 1 t/(mm s²), 1 kg/m³ is 1e-12 t/mm³.
TEST_F(TemplateFieldsOfCases, AreInTheUnitsOfTheOutputWhereThatIsAskedFor) {
  const std::string numbers =
      "{{h}} {{end_time}} {{youngs_modulus}} {{density}} {{wave_speed}} {{upper_x}} {{poissons_ratio}} {{cells}}\n"
      "{{#particles}}{{#is_last}}{{X}} {{x}} {{v_x}} {{m}} {{V}} {{x_above}} {{F_xx}}{{/is_last}}{{/particles}}\n";
  const auto read = [&](const std::string& adapter) {
    mover_.adapter(adapter);
    std::istringstream text(filled(numbers));
    std::vector<double> all;
    for (double number; text >> number;) all.push_back(number);
    return all;
  };
  const std::vector<double> plain = read(Mover::text);
  const std::vector<double> converted =
      read(with("[output]\n", "[output]\nunits = { length = 1e-3, time = 1, mass = 1e3 }\n")
               .replace(std::string(Mover::text).find("template ="), 0, "in_units = true\n"));
  const std::vector<double> factors{1e3, 1, 1e-6, 1e-12, 1e3, 1e3, 1, 1, 1e3, 1e3, 1e3, 1e-3, 1e9, 1e3, 1};
  ASSERT_EQ(plain.size(), factors.size());
  ASSERT_EQ(converted.size(), factors.size());
  const std::vector<double> thin =
      read(with("[output]\n", "[output]\nunits = { thickness = 0.25 }\n")
               .replace(std::string(Mover::text).find("template ="), 0, "in_units = true\n"));
  EXPECT_EQ(thin.at(11), plain.at(11) / 4) << "mass";
  EXPECT_EQ(thin.at(12), plain.at(12) / 4) << "volume";
  for (std::size_t k = 0; k < factors.size(); ++k)
    EXPECT_NEAR(converted[k], factors[k] * plain[k], 1e-14 * std::abs(factors[k] * plain[k])) << k;
}

/// They are functions of m and s.
TEST_F(TemplateFieldsOfCases, HaveNoExpressionsInOtherUnits) {
  std::string text = with("[output]\n", "[expressions]\ndialect = \"c\"\n[output]\nunits = { length = 1e-3 }\n");
  mover_.adapter(text);
  EXPECT_EQ(filled("{{b_x}}"), "0.0");
  mover_.adapter(text.replace(text.find("template ="), 0, "in_units = true\n"));
  EXPECT_THAT([&] { filled("{{b_x}}"); }, ThrowsMessage<UsageError>(HasSubstr("unknown field 'b_x' in ")));
}

TEST_F(TemplateFieldsOfCases, OfAVariantOverrideThoseOfTheAdapter) {
  mover_.adapter(Mover::text + std::string("[fields]\nis_odd = true\nmethod = \"usl\"\n"));
  auto settings = Mover::settings();
  settings.push_back({"variant", "plain", "test"});
  EXPECT_EQ(filled("{{^is_odd}}even{{/is_odd}} {{method}}", settings::make_case(settings)), "even usl");
}

}  // namespace mpmvv::codes::template_fields_test
