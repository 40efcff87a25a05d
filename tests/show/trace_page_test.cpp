// The page of a trace with the networks of every scan.
#include <gtest/gtest.h>

#include <sstream>

#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"
#include "frontend/simulation/scan_drawings.hpp"

namespace rungproof {
namespace {

/// Three scans with I0.0 = 0, 1, 1: network 1 is off, then on. Network 2 reads an input that never changes: one look.
TEST(TracePage, NetworksAreDrawnOncePerLook) {
  const Program program = readText("test.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1 // <in>\nLD I0.0\n= Q0.0\nNetwork "
                                   "2\nLD I0.5\n= Q0.1\nEND_ORGANIZATION_BLOCK\n",
                                   {});
  Simulator simulator(program);
  ScanDrawings drawings(program);
  simulator.observe(&drawings.recorder());
  Trace trace;
  trace.signals = touchedSignals(program);
  for (const std::uint64_t input : {0U, 1U, 1U}) {
    simulator.write(direct(Area::I, Width::Bit, 0, 0), input);
    simulator.scan();
    trace.rows.push_back(sampleRow(simulator, trace.signals));
    drawings.add();
  }
  const TraceDrawings drawn = drawings.take();
  ASSERT_EQ(drawn.pagesOf.size(), 3U);
  for (const std::vector<std::size_t>& pages : drawn.pagesOf) EXPECT_EQ(pages.size(), 2U);
  EXPECT_NE(drawn.pagesOf[0][0], drawn.pagesOf[1][0]);
  EXPECT_EQ(drawn.pagesOf[0][1], drawn.pagesOf[2][1]);
  EXPECT_NE(drawn.pages[drawn.pagesOf[1][0]].find("I0.0=1"), std::string::npos);
  EXPECT_NE(drawn.pages[drawn.pagesOf[0][0]].find("&lt;in&gt;"), std::string::npos);
  std::ostringstream page;
  writeTracePage(trace, "run", drawn, page);
  EXPECT_NE(page.str().find("class=\"drawn\""), std::string::npos);
  EXPECT_NE(page.str().find("\"pages\":[["), std::string::npos);
}

}  // namespace
}  // namespace rungproof
