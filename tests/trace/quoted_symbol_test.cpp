// Names with blanks and commas go through stimuli, traces, expected traces and lists of signals, and come back.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::ProgramRun;
using test::run;
using test::TemporaryFolder;

TEST(QuotedSymbols, RoundTrip) {
  const TemporaryFolder folder;
  const std::string program =
      folder.file("m.awl",
                  "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA \"Start, now\";\n= \"Motor on\";\n"
                  "END_ORGANIZATION_BLOCK\n");
  const std::string symbols =
      folder.file("m.sdf", "\"Motor on\",\"Q 4.0\",\"BOOL\",\"\"\n\"Start, now\",\"I 0.0\",\"BOOL\",\"\"\n");
  const std::string stimulus = folder.file("in.csv", "time_ms,\"Start, now\"\n0,0\n20,1\n");
  const std::string trace = folder.path("out.csv");
  const ProgramRun made = run({"sim", program, symbols, "--stimulus", stimulus, "--signals",
                               "\"Motor on\",\"Start, now\"", "--names", "symbol", "--trace", trace});
  EXPECT_EQ(made.exit, 0) << made.out << made.err;
  std::ifstream file(trace);
  std::string heading;
  std::getline(file, heading);
  EXPECT_EQ(heading, "scan,time_ms,scan_ms,Motor on,\"Start, now\"");
  // The trace is a stimulus and an expected trace, and agrees with itself.
  const ProgramRun again = run({"sim", program, symbols, "--stimulus", trace, "--expect", trace});
  EXPECT_EQ(again.exit, 0) << again.out << again.err;
  EXPECT_EQ(run({"compare", trace, trace}).exit, 0);
}

}  // namespace
}  // namespace rungproof
