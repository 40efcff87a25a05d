// A STEP 7 project of 500 blocks is linted in at most one second of processor time.
#include <gtest/gtest.h>

#include "tests/machine_pace.hpp"
#include "tests/measured_process.hpp"
#include "tests/s7project/block_compiler.hpp"
#include "tests/s7project/project_writer.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::testing {
namespace {

/// 399 FCs of 40 statements, each called; 50 FBs with 50 instances.
std::string fiveHundredBlocks() {
  std::string text, calls;
  for (int i = 1; i <= 50; ++i) {
    text += fmt::format(
        "DATA_BLOCK DB {0}\nFB {0}\nBEGIN\nEND_DATA_BLOCK\nFUNCTION_BLOCK FB {0}\nVAR_INPUT\n In : BOOL ;\nEND_VAR\n"
        "VAR_OUTPUT\n Out : BOOL ;\nEND_VAR\nVAR\n Count : INT ;\nEND_VAR\nBEGIN\nNETWORK\n A #In;\n = #Out;\n"
        " L #Count;\n + 1;\n T #Count;\nEND_FUNCTION_BLOCK\n",
        i);
    calls += fmt::format(" CALL FB {0}, DB {0} (In := I {1}.0, Out := M {1}.1);\n", i, i % 100);
  }
  for (int i = 1; i <= 399; ++i) {
    text +=
        fmt::format("FUNCTION FC {} : VOID\nVAR_INPUT\n A : INT ;\nEND_VAR\nVAR_TEMP\n W : INT ;\nEND_VAR\nBEGIN\n", i);
    for (int network = 0; network < 5; ++network) {
      const int byte = (i * 5 + network) % 2000;
      text +=
          fmt::format("NETWORK\n A I 0.{1};\n AN M {0}.1;\n = M {0}.2;\n L #A;\n L {2};\n >I ;\n = M {0}.3;\n T #W;\n",
                      byte, network, i);
    }
    text += "END_FUNCTION\n";
    calls += fmt::format(" CALL FC {} (A := {});\n", i, i);
  }
  return text + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + calls + "END_ORGANIZATION_BLOCK\n";
}

TEST(S7ProjectPace, FiveHundredBlocksAreLintedInASecond) {
  test::ProjectPart part;
  const test::CompiledSource compiled = test::compileSource(fiveHundredBlocks());
  ASSERT_EQ(compiled.fault, "");
  part.blocks = compiled.blocks;
  EXPECT_EQ(part.blocks.size(), 500U);
  const test::TemporaryFolder folder;
  for (const auto& [path, contents] : test::writeProject({part}, 1252)) folder.file(path, contents);
  const std::string program = std::string(RUNGPROOF_BINARY_DIR) + "/rungproof";
  double least = 1e9;
  for (int i = 0; i < 3; ++i) {
    const double before = test::machinePace(test::processorSeconds);
    const test::ProcessRun run =
        test::runProcess({program, "lint", "--isolated", "--exit-zero", folder.path("Plant.s7p")}, 60);
    EXPECT_FALSE(run.isCut);
    EXPECT_NE(run.output.find("no findings in"), std::string::npos) << run.output.substr(0, 2000);
    least = std::min(least, run.seconds / before);
  }
  std::printf("lint of 500 blocks: %.2f s\n", least);
  EXPECT_LT(least, 1.0);
}

}  // namespace
}  // namespace rungproof::testing
