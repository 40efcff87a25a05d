// Statements with their stated results, on the engine.
#include "tests/iec/iec_run.hpp"
#include "tests/iec/stated_results.hpp"

namespace rungproof {
namespace {

TEST(IecStated, StatementsGiveWhatTheStandardSays) {
  for (const iec_stated::Result& row : iec_stated::results()) {
    SCOPED_TRACE(row.statements);
    IecRun run(iec_stated::programOf(row));
    run.scan();
    EXPECT_EQ(run.get("r"), row.value);
  }
}

}  // namespace
}  // namespace rungproof
