// A drawn program (ladder, FBD or instruction list in XML) against its own statement list: EQUAL for every one of the
// corpus; and DIFFERENT with one contact of the statement list turned round.
#include <filesystem>

#include "analysis/read_errors.hpp"
#include "frontend/stl/stl_writer.hpp"
#include "ir/s7200/isa.hpp"
#include "tests/equivalence/pair.hpp"
#include "tests/graphical/plcopen_text.hpp"

namespace rungproof::test {

namespace {

constexpr std::size_t leastDrawn = 12, leastTurned = 10;

/// Turns the first contact of the program that drives something.
bool turnOneContact(Program& program) {
  for (Pou& pou : program.pous) {
    for (Network& network : pou.networks) {
      for (Instruction& instruction : network.instructions) {
        if (instruction.desc->stl != "LD" || instruction.operands[0].area != Area::I) continue;
        instruction.desc = s7200Instructions().named("LDN");
        return true;
      }
    }
  }
  return false;
}

}  // namespace

TEST(Drawings, AreEqualToTheirStatementLists) {
  std::size_t drawnPrograms = 0, turned = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus")) {
    if (entry.path().extension() != ".xml" || entry.path().parent_path().filename() != "plcopen") continue;
    const Program drawn = readAsS7200(entry.path());
    const bool hasStl = dialectOf(drawn.target).set == dialect::S7200;
    if (hasReadErrors(drawn) || !hasStl) continue;  // the faulty ones, and one with a body in ST
    Program written = readText("written.awl", writeStl(drawn));
    EquivalenceOptions options;
    options.prover.timeout = 20;
    const Equivalence same = compareBehaviour({&drawn, {}}, {&written, {}}, options);
    EXPECT_EQ(equalityText(same.equality), "EQUAL") << entry.path();
    ++drawnPrograms;
    if (!turnOneContact(written)) continue;
    const Equivalence other = compareBehaviour({&drawn, {}}, {&written, {}}, options);
    turned += other.equality == Equality::Different ? 1 : 0;
  }
  EXPECT_GE(drawnPrograms, leastDrawn);
  EXPECT_GE(turned, leastTurned);
}

}  // namespace rungproof::test
