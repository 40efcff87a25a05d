// The run that shows a difference is written as a trace, and the trace is a stimulus: played to either program by
// `sim`, each does what the trace says of it.
#include <gtest/gtest.h>

#include "tests/equivalence/pairs.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

class DifferentPairs : public testing::TestWithParam<Pair> {};

TEST_P(DifferentPairs, HaveATraceThatEitherProgramRepeats) {
  const Pair& pair = GetParam();
  const TemporaryFolder folder;
  const std::string before = folder.file("old.awl", exportOf(pair.before)),
                    after = folder.file("new.awl", exportOf(pair.after));
  const std::string map = folder.file("moved.map", lines(pair.map)),
                    props = folder.file("a.prop", lines(pair.properties));
  const std::string trace = folder.path("difference.csv");
  std::vector<std::string> arguments = {
      "equiv",       "--isolated",
      before,        after,
      "--map",       map,
      "--props",     props,
      "--trace",     trace,
      "--show",      "none",
      "--scan-time", std::to_string(pair.low) + "ms.." + std::to_string(pair.high) + "ms",
      "--latency",   std::to_string(pair.latency),
      "--settle",    std::to_string(pair.settleMs) + "ms"};
  const ProgramRun found = run(arguments);
  ASSERT_EQ(found.exit, 1) << found.err << found.out;
  for (const auto& [side, program] : {std::pair{"old", before}, std::pair{"new", after}}) {
    std::vector<std::string> replay = {"sim",      "--isolated", program,  "--stimulus", trace,
                                       "--expect", trace,        "--side", side};
    const std::string option = "(sim: --choice ";  // readings of open points that the run needs
    for (std::size_t at = found.out.find(option); at != std::string::npos; at = found.out.find(option, at + 1)) {
      const std::size_t begin = at + option.size();
      replay.insert(replay.end(), {"--choice", found.out.substr(begin, found.out.find(')', begin) - begin)});
    }
    const ProgramRun played = run(replay);
    EXPECT_EQ(played.exit, 0) << side << '\n' << contentOf(trace) << played.err << played.out;
  }
}

/// An interrupt between two reads of M0.0 shows in OLD; NEW has one instruction less, so that its lines are others.
TEST(DifferenceTrace, HasTheEventsOfEitherProgramAtItsOwnPlaces) {
  const std::string start = "LD SM0.1;ATCH INT0,0;ENI|LD I1.0;A I1.1;= M9.0|", routine = "@INT0:LD SM0.0;S M0.0,1";
  const TemporaryFolder folder;
  const std::string before = folder.file("old.awl", exportOf(start + "LD M0.0;= Q0.0|LD M0.0;= Q0.1" + routine)),
                    after = folder.file("new.awl", exportOf("LD M0.0;= Q0.0;= Q0.1|" + start + routine));
  const std::string trace = folder.path("difference.csv");
  const ProgramRun found = run({"equiv", "--isolated", before, after, "--interrupts", "anywhere", "--trace", trace});
  ASSERT_EQ(found.exit, 1) << found.err << found.out;
  EXPECT_NE(contentOf(trace).find("old.event,new.event"), std::string::npos) << contentOf(trace);
  for (const auto& [side, program] : {std::pair{"old", before}, std::pair{"new", after}}) {
    const ProgramRun played =
        run({"sim", "--isolated", program, "--stimulus", trace, "--expect", trace, "--side", side});
    EXPECT_EQ(played.exit, 0) << side << '\n' << contentOf(trace) << played.err << played.out;
  }
}

/// What no address tells is given to each side in columns of its own.
TEST(DifferenceTrace, HasWhatTheSurroundingsDidToEitherProgram) {
  struct Case {
    const char *name, *before, *after;
  };
  const Case cases[] = {
      // The immediate read may find another input than the image (001:2843).
      {"immediate", "LDI I0.0;= Q0.0", "LD I0.0;= Q0.0|LDNI I0.0;A I0.0;= Q0.1"},
      // The clock shows any time, the same one to both.
      {"clock", "LD SM0.0;TODR VB20|LDB= VB20,16#05;= Q0.0", "LD SM0.0;TODR VB20|LDB= VB20,16#06;= Q0.0"},
      {"interval", "LD SM0.0;BITIM VD0|LDD= VD0,77;= Q0.0", "LD SM0.0;BITIM VD0|LDD= VD0,78;= Q0.0"},
      {"character", "LDB= SMB2,77;= Q0.0", "LDB= SMB2,78;= Q0.0"},
      // Q0.3 is driven through a pointer alone: it has a column all the same.
      {"pointed", "LD I0.0;MOVD &QB0,AC1;MOVB 8,*AC1", "LD I0.0;MOVD &QB0,AC1;MOVB 0,*AC1"},
      // An input that OLD alone reads.
      {"one side", "LD I0.5;= Q0.0", "LD I0.4;= Q0.0"}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const TemporaryFolder folder;
    const std::string before = folder.file("old.awl", exportOf(c.before)),
                      after = folder.file("new.awl", exportOf(c.after)), trace = folder.path("difference.csv");
    const ProgramRun found = run({"equiv", "--isolated", before, after, "--trace", trace});
    ASSERT_EQ(found.exit, 1) << found.err << found.out;
    EXPECT_EQ(found.out.find("does not hold"), std::string::npos) << found.out;
    for (const auto& [side, program] : {std::pair{"old", before}, std::pair{"new", after}}) {
      const ProgramRun played =
          run({"sim", "--isolated", program, "--stimulus", trace, "--expect", trace, "--side", side});
      EXPECT_EQ(played.exit, 0) << side << '\n' << contentOf(trace) << played.err << played.out;
    }
  }
}

std::vector<Pair> differentPairs() {
  std::vector<Pair> found;
  std::ranges::copy_if(pairs, std::back_inserter(found), [](const Pair& pair) { return pair.truth == different; });
  return found;
}

INSTANTIATE_TEST_SUITE_P(Pairs, DifferentPairs, testing::ValuesIn(differentPairs()),
                         [](const testing::TestParamInfo<Pair>& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rungproof::test
