#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "studies/codes/readers.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/codes/written_run.hpp"

namespace mpmvv::csv_reader_test {

using namespace codes;

struct WrittenFile {
  std::filesystem::path path;

  ~WrittenFile() { std::filesystem::remove(path); }
};

Snapshot read(const std::string& text, const std::string& names = "", std::size_t dimensions = 0) {
  const WrittenFile file{written_run::write("csv_reader_test.csv", text)};
  Columns columns{.dimensions = dimensions};
  if (!names.empty()) columns.names = parse_columns(names, "--columns");
  return read_snapshot(file.path, columns);
}

std::string message_of(const std::string& text, const std::string& names = "", std::size_t dimensions = 0) {
  try {
    read(text, names, dimensions);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "";
}

TEST(CsvReader, TakesColumnsByUsualNames) {
  const Snapshot s = read("id,x,y,v_x,v_y,m\n2,0.5,0.25,1,2,3\n1,1.5,-2e-3,4,5,6\n");
  EXPECT_EQ(s.id, (std::vector<std::int64_t>{2, 1}));
  EXPECT_EQ(s.x, (std::vector<Point>{{0.5, 0.25, 0}, {1.5, -2e-3, 0}}));
  EXPECT_EQ(s.v, (std::vector<Point>{{1, 2, 0}, {4, 5, 0}}));
  EXPECT_EQ(s.mass, (std::vector<double>{3, 6}));
  EXPECT_TRUE(s.X.empty());
}

TEST(CsvReader, TakesColumnsByNameAndNumber) {
  EXPECT_EQ(read("7 0.5\n8 0.25\n", "id=1,x=2").id, (std::vector<std::int64_t>{7, 8}));
  EXPECT_EQ(read("a;b\n7;0.5\n", "x=b").x.front()[0], 0.5);
  EXPECT_EQ(read("p:0,p:1\n1.5,2.5\n", "x=p").x.front(), (Point{1.5, 2.5, 0}));
  EXPECT_EQ(read("px,y\n1.5,2.5\n", "x=px", 2).x.front(), (Point{1.5, 2.5, 0})) << "one component, and not all of x";
}

/// As of a table whose positions have capital names: they are no reference positions, too.
TEST(CsvReader, TakesNoColumnTwiceThatWasNamed) {
  for (const char* names : {"id=ID,x=X,y=Y", "x=2,y=3"}) {
    const Snapshot s = read("ID,X,Y\n1,0.5,0.25\n", names, 2);
    EXPECT_EQ(s.x.front(), (Point{0.5, 0.25, 0})) << names;
    EXPECT_TRUE(s.X.empty()) << names;
  }
  EXPECT_TRUE(read("X:0,X:1\n1,2\n", "x=X", 2).X.empty());
  EXPECT_EQ(read("X,Y\n1,2\n", "x=X,X=X,y=Y,Y=Y", 2).X.front(), (Point{1, 2, 0})) << "where it is said";
}

TEST(CsvReader, TakesOneTime) {
  EXPECT_THAT(message_of("# time = 0.008\nx,time\n1,0.004\n"),
              testing::AllOf(testing::HasSubstr("time 0.008 in "),
                             testing::HasSubstr(", and 0.004 in its column 'time' (one time)")));
  EXPECT_THAT(message_of("x,time\n1,0.004\n2,0.008\n"), testing::HasSubstr("several times in "));
  EXPECT_EQ(read("# time = 0.008333\nx,time\n1,0.00833333\n").time, 0.008333);
  EXPECT_EQ(read("# time = 0.008\nx,t\n1,300\n").time, 0.008) << "t may be a temperature";
  EXPECT_EQ(read("x,t\n1,0.25\n").time, 0.25);
}

TEST(CsvReader, SeesDecimalCommas) {
  const auto seen = testing::HasSubstr("(decimal commas? Write points)");
  EXPECT_THAT(message_of("id;x;y\n1;0,25;0,5\n"), testing::AllOf(testing::HasSubstr("'1;0' between commas in "), seen));
  EXPECT_THAT(message_of("id x\n1 0,25\n"), seen);
  EXPECT_THAT(message_of("id;x\n1;0,25\n"), seen);
}

TEST(CsvReader, CommentsSayTimeAndNames) {
  const Snapshot s = read("# problem = bar\n# time = 0.5\n# id x\n1 1.25\n");
  EXPECT_EQ(s.time, 0.5);
  EXPECT_EQ(s.says.at("problem"), "bar");
  EXPECT_EQ(s.x.front()[0], 1.25);
}

TEST(CsvReader, CommentsSaySeveralThings) {
  using Says = std::map<std::string, std::string>;
  EXPECT_EQ(read("# cells = 8, ppc = 2\nx\n1\n").says, (Says{{"cells", "8"}, {"ppc", "2"}}));
  EXPECT_EQ(read("# cells=8;ppc: 2\nx\n1\n").says, (Says{{"cells", "8"}, {"ppc", "2"}}));
  EXPECT_EQ(read("# boundary = xmin=wall,xmax=free\nx\n1\n").says, (Says{{"boundary", "xmin=wall,xmax=free"}}));
  EXPECT_EQ(read("# title = bar, with 8 cells\nx\n1\n").says, (Says{{"title", "bar, with 8 cells"}}));
}

/// In a file whose unit is the millisecond.
TEST(CsvReader, TakesSecondsBehindATimeForSeconds) {
  const auto time_of = [](const std::string& comment) {
    const WrittenFile file{written_run::write("csv_reader_test.csv", "# " + comment + "\nx\n1\n")};
    return read_snapshot(file.path, {.time = 1e-3}).time.value();
  };
  EXPECT_NEAR(time_of("time = 8"), 0.008, 1e-15);
  EXPECT_NEAR(time_of("time = 8 s"), 8, 1e-12);
}

TEST(CsvReader, CommentsStateTimeAndStepInAnyCase) {
  for (const char* comment : {"time = 0.008", "Time = 0.008", "TIME: 0.008", "TIME 0.008", "time=8e-3 s",
                              "Time 0.008 sec", "t = 0.008", "t:0.008", "time [s] = 0.008", "time (seconds): 0.008",
                              "step = 32, time = 0.008", "t = 7; time = 0.008", "time = 0.008, t = 7"})
    EXPECT_EQ(read(fmt::format("# {}\nx\n1\n", comment)).time, 0.008) << comment;
  for (const char* comment : {"step = 32", "Step: 32", "STEP 32", "time = 0.008 s, step = 32"})
    EXPECT_EQ(read(fmt::format("# {}\nx\n1\n", comment)).step, 32) << comment;
  for (const char* comment : {"end_time = 0.008", "end time = 0.008", "Time: 12:03:55", "Time: 5 Jan 2025", "t 0.008",
                              "id x time", "time = 0,008", "steps = 32", "step = 0.1", "time step = 32", "t = 2 mm"}) {
    const Snapshot s = read(fmt::format("# {}\nx\n1\n", comment));
    EXPECT_FALSE(s.time) << comment;
    EXPECT_FALSE(s.step) << comment;
  }
  EXPECT_EQ(read("# Time = 0.008 s\nx\n1\n").says, (std::map<std::string, std::string>{{"Time", "0.008 s"}}));
  EXPECT_THAT(message_of("x\n# time = 8 ms\n1\n"),
              testing::AllOf(testing::HasSubstr("'time = 8 ms' in "), testing::HasSubstr("csv_reader_test.csv:2 (in s, "
                                                                                         "or the number alone")));
  EXPECT_THAT(message_of("# TIME [h]: 8\nx\n1\n"), testing::HasSubstr("'TIME = 8 h' in "));
}

TEST(CsvReader, ACommentBeginsWithAHashOrPercentSign) {
  const Snapshot s = read("% made by a code\n% time = 0.5\n%\n% x y\n% cells = 8\n0.5 0.25\n1.5 1.25\n");
  EXPECT_EQ(s.x, (std::vector<Point>{{0.5, 0.25, 0}, {1.5, 1.25, 0}}));
  EXPECT_EQ(s.time, 0.5);
  EXPECT_EQ(s.says.at("cells"), "8");
  EXPECT_EQ(read("# x y\n# TIME 0.5\n0.5 0.25\n").x.front(), (Point{0.5, 0.25, 0})) << "two words, but one is a number";
}

TEST(CsvReader, KnowsTheFilesOfAStateAndTheirUnits) {
  const WrittenFile a{written_run::write("a.csv", "x\n1\n2\n")}, b{written_run::write("b.csv", "x\n3\n")};
  const Snapshot s = read_snapshot(std::vector{a.path, b.path}, {.length = 1e-3});
  EXPECT_EQ(s.file, a.path.string() + " and 1 more");
  ASSERT_EQ(s.parts.size(), 2U);
  EXPECT_EQ(s.parts[1].file, b.path.string());
  EXPECT_EQ(s.parts[0].rows, 2U);
  EXPECT_TRUE(s.has_own_units);
  const Snapshot alone = read_snapshot(std::vector{a.path}, {});
  EXPECT_EQ(alone.file, a.path.string());
  EXPECT_FALSE(alone.has_own_units);
}

TEST(CsvReader, ReadsNumbersBeyondTheRangeOfDoubles) {
  const Snapshot s = read("x,y,v_x,v_y\n1e-400,0,-1e400,inf\n", "", 2);
  EXPECT_EQ(s.x.front()[0], 0);
  EXPECT_EQ(s.v.front()[0], -std::numeric_limits<double>::infinity());
}

/// As spreadsheets write it.
TEST(CsvReader, SkipsAByteOrderMark) {
  EXPECT_EQ(read("\xEF\xBB\xBFx,y\n0.5,0.25\n").x, (std::vector<Point>{{0.5, 0.25, 0}}));
}

TEST(CsvReader, SaysWhatItCannotRead) {
  EXPECT_THAT(message_of("X,x\n0.5,0.5\nnan,0.25\n"), testing::HasSubstr("the reference position of row 2 in"));
  EXPECT_THAT(message_of("x,y,x\n1,2,3\n"), testing::HasSubstr("2 columns 'x' in"));
  EXPECT_THAT(message_of("x,y\n1\n"), testing::HasSubstr("1 numbers in"));
  EXPECT_THAT(message_of("x,y\n1,b\n"), testing::HasSubstr("'b' for 'y' in"));
  EXPECT_THAT(message_of("x,y\n"), testing::HasSubstr("no lines of numbers"));
  EXPECT_THAT(message_of("p,q\n1,2\n"), testing::HasSubstr("no positions in"));
  EXPECT_THAT(message_of("p,q\n1,2\n", "x=r"), testing::HasSubstr("csv, named by --columns (known: p, q)"));
  EXPECT_THAT(message_of("p,q\n1,2\n", "w=p"), testing::HasSubstr("unknown quantity 'w' in --columns"));
}

TEST(CsvReader, AsksForEachComponentThatTheCaseHas) {
  EXPECT_THAT(message_of("tag,pos_x,v_x\n1,2,3\n", "", 2),
              testing::AllOf(testing::HasSubstr("no column for y in "),
                             testing::HasSubstr("which has one for x (its columns: tag, pos_x, v_x; --columns, or")));
  EXPECT_THAT(message_of("x,y,v_y\n1,2,3\n", "", 2), testing::HasSubstr("no column for v_x in "));
  EXPECT_THAT(message_of("x,y,s_xx,s_yy\n1,2,3,4\n", "", 2), testing::HasSubstr("no column for s_xy in "));
  EXPECT_EQ(read("x,y,s_xx,s_yy,s_xy\n1,2,3,4,5\n", "", 2).stress.front()[3], 5) << "a symmetric one";
  EXPECT_EQ(read("qx,y\n1,2\n", "x=qx,y=qy", 1).x.front(), (Point{1, 0, 0})) << "of others it takes none";
}

TEST(CsvReader, SeesTheDigitsOfTexts) {
  EXPECT_EQ(read("x,y\n0.123456,0.5\n0.0123457,0.25\n").digits, 6);
  const Snapshot fixed = read("x,y\n0.1234,1.5000\n0.0123,0.2500\n");
  EXPECT_DOUBLE_EQ(fixed.rounding, 1e-4 * std::sqrt(2.0));
  EXPECT_EQ(read("x,y,m\n0.125,0.375,1\n0.125,0.625,0.33333333333333331\n").digits, 17);
  EXPECT_EQ(read("x,y,m\n0.5,1.5,1\n1.0,0.5,0.33333333333333331\n").digits, 17)
      << "1.0 is the shortest that some write";
}

/// As `%.3e` writes them beside masses of 17 digits.
TEST(CsvReader, SeesThatHundredsOfCoordinatesAreShort) {
  std::string few = "x,y,m\n", many = few, padded = few;
  for (int p = 1; p <= 150; ++p) {
    const std::string row = fmt::format("{:.4g},{:.4g},0.33333333333333331\n", p / 151.7, p / 77.7);
    many += row;
    if (p <= 50) few += row;
    if (p <= 50) padded += fmt::format("{:.3e},{:.3e},0.33333333333333331\n", p / 151.7, p / 77.7);
  }
  EXPECT_EQ(read(few).digits, 17);
  EXPECT_EQ(read(many).digits, 4);
  EXPECT_EQ(read(padded).digits, 4) << "as 1.250e-01 is";
  EXPECT_NEAR(read(many).rounding, 1e-3, 9e-4);
}

/// Whatever the other columns show.
TEST(CsvReader, SeesFixedDecimalsByTheirZeros) {
  const Snapshot fixed = read("x,y,m\n0.125000,0.374391,1\n0.130432,0.625119,3.33333333333333315e-01\n");
  EXPECT_EQ(fixed.digits, 6);
  EXPECT_DOUBLE_EQ(fixed.rounding, 1e-6 * std::sqrt(2.0));
}

}  // namespace mpmvv::csv_reader_test
