#include "studies/support/process.hpp"

#include <gtest/gtest.h>

namespace mpmvv::support::process_test {

using std::chrono::seconds;

ProcessEnd shell(const std::string& script, seconds limit, const std::stop_token& stop = {}) {
  return run_process({"sh", "-c", script}, ".", {}, limit, std::nullopt, stop);
}

TEST(Process, WhatItPrintsAndHowItEndsIsKnown) {
  const ProcessEnd end = shell("echo one; echo two >&2; exit 3", seconds(60));
  EXPECT_EQ(end.output, "one\ntwo\n");
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_FALSE(end.good() || end.stopped || end.timed_out);
}

TEST(Process, OneThatIsAskedToStopIsKilledAndSaysSo) {
  std::stop_source stop;
  stop.request_stop();
  const ProcessEnd end = shell("exec sleep 600", seconds(60), stop.get_token());
  EXPECT_TRUE(end.stopped);
  EXPECT_FALSE(end.good() || end.timed_out);
}

TEST(Process, OneThatRunsTooLongIsKilledAndSaysSo) {
  const ProcessEnd end = shell("exec sleep 600", seconds(0));
  EXPECT_TRUE(end.timed_out);
  EXPECT_FALSE(end.good() || end.stopped);
}

}  // namespace mpmvv::support::process_test
