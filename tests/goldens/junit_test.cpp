#include "goldens/junit.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>
#include <string>

namespace mpmvv::goldens::junit_test {

using boost::property_tree::ptree;

const GateReport mixed{{{"s-fig10", "order of 'linear' in l2", Verdict::pass, "2", "2.01", ""},
                        {"s-one", "value 'gap'", Verdict::inconclusive, "at most 1", "", "missing: no \"gap\""},
                        {"s-fig10", "error of 'l < h' in l2", Verdict::fail, "1 ± 10 %", "3 & more", "a < b\n\x01"}}};

ptree parsed(const std::string& xml) {
  std::istringstream in(xml);
  ptree document;
  read_xml(in, document);
  return document.get_child("testsuites");
}

TEST(Junit, CountsEveryVerdict) {
  const ptree suites = parsed(junit_xml(mixed));
  EXPECT_EQ(suites.get<std::string>("<xmlattr>.tests"), "3");
  EXPECT_EQ(suites.get<std::string>("<xmlattr>.failures"), "1");
  ASSERT_EQ(suites.count("testsuite"), 2U);
  const ptree& fig10 = suites.get_child("testsuite");
  EXPECT_EQ(fig10.get<std::string>("<xmlattr>.name"), "s-fig10");
  EXPECT_EQ(fig10.get<std::string>("<xmlattr>.tests"), "2");
  EXPECT_EQ(fig10.get<std::string>("<xmlattr>.failures"), "1");
  EXPECT_EQ(fig10.get<std::string>("<xmlattr>.skipped"), "0");
  const ptree& one = suites.rbegin()->second;
  EXPECT_EQ(one.get<std::string>("<xmlattr>.skipped"), "1");
  EXPECT_EQ(one.count("testcase"), 1U);
}

TEST(Junit, PassFailAndInconclusiveDiffer) {
  const ptree suites = parsed(junit_xml(mixed));
  const ptree& fig10 = suites.get_child("testsuite");
  const ptree& passed = fig10.get_child("testcase");
  EXPECT_EQ(passed.get<std::string>("<xmlattr>.classname"), "s-fig10");
  EXPECT_EQ(passed.count("failure") + passed.count("skipped"), 0U);
  const ptree& skipped = suites.rbegin()->second.get_child("testcase.skipped");
  EXPECT_EQ(skipped.get<std::string>("<xmlattr>.message"), "inconclusive: missing: no \"gap\"");
}

TEST(Junit, AFailureWithoutANumberSaysSo) {
  const GateReport report{
      {{"s", "error of 'a' in l2 at 8", Verdict::fail, "1 ± 10 %", "", "the run at 8 failed: no mesh"}}};
  const ptree failure = parsed(junit_xml(report)).get_child("testsuite.testcase.failure");
  EXPECT_EQ(failure.get<std::string>("<xmlattr>.message"), "the run at 8 failed: no mesh");
  EXPECT_EQ(failure.data(), "expected 1 ± 10 %, not measured");
}

TEST(Junit, EscapesWhatXmlCannotHold) {
  const ptree failed = parsed(junit_xml(mixed)).get_child("testsuite").rbegin()->second;
  EXPECT_EQ(failed.get<std::string>("<xmlattr>.name"), "error of 'l < h' in l2");
  EXPECT_EQ(failed.get<std::string>("failure"), "expected 1 ± 10 %, measured 3 & more");
  EXPECT_EQ(failed.get<std::string>("failure.<xmlattr>.message"), "a < b\\n\\x01");
}

TEST(Junit, HoldsNoCharacterThatXmlForbids) {
  const std::string forbidden =
      "\x1b[31m \x07 \xEF\xBF\xBE \xEF\xBF\xBF \xC2\x9B \xFF \xED\xA0\x80 ]]> '\"& ok ± ∞ \xF0\x9F\x98\x80";
  const std::string said = "\\x1b[31m \\x07 ? ? \\xc2\\x9b \\xff \\xed\\xa0\\x80 ]]> '\"& ok ± ∞ \xF0\x9F\x98\x80";
  const std::string xml = junit_xml({{{forbidden, forbidden, Verdict::fail, forbidden, forbidden, forbidden}}});
  const ptree suite = parsed(xml).get_child("testsuite");
  EXPECT_EQ(suite.get<std::string>("<xmlattr>.name"), said);
  EXPECT_EQ(suite.get<std::string>("testcase.<xmlattr>.name"), said);
  EXPECT_EQ(suite.get<std::string>("testcase.failure"), "expected " + said + ", measured " + said);
  EXPECT_EQ(suite.get<std::string>("testcase.failure.<xmlattr>.message"), said);
  EXPECT_EQ(xml.find(']' + std::string("]>")), std::string::npos);
}

}  // namespace mpmvv::goldens::junit_test
