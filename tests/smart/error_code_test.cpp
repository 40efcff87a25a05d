// GERR: which code it reads, in `sim`, in proofs and in their witnesses, and that it rests on every error of a program.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

/// A pointer to nothing is error 0006 (001:13954); GERR stands in a network that names none of its places.
constexpr const char* pointsNowhere =
    "LD I0.0\nMOVD 16#0FFFFFFF, VD100\nMOVB *VD100, VB20\nLD SM0.0\nGERR VW0\nLD I0.1\nMOVW VW0, VW2\n";

struct GerrEnd {
  int code;
  std::string out, err;
};

GerrEnd commandOnSmart(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--cpu", "ST60", "--isolated"});
  std::istringstream in;
  std::ostringstream out, err;
  const int code = runProgram(arguments, {in, out, err});
  return {code, out.str(), err.str()};
}

TEST(ErrorCode, SimGivesThatOfTheErrorThatWasMet) {
  const test::TemporaryFolder folder;
  const std::string program = folder.file("gerr.awl", pointsNowhere);
  for (const char* engine : {"reference", "compiled"}) {
    const GerrEnd run = commandOnSmart({"sim", program, "--set", "I0.0=1", "--engine", engine, "--expect",
                                        folder.file("expected.csv", "scan,VW0\n1,6\n2,6\n")});
    EXPECT_EQ(run.code, 0) << engine << run.out << run.err;
  }
  // Nothing is read where nothing was met.
  EXPECT_EQ(commandOnSmart({"sim", program, "--expect", folder.file("none.csv", "scan,VW0\n1,0\n2,0\n")}).code, 0);
}

// 16#5D is no code of the table; the network with the error writes nothing that GERR names.
TEST(ErrorCode, ProofsTakeAnyCodeAndNothingElse) {
  const test::TemporaryFolder folder;
  const std::string program = folder.file("gerr.awl", std::string("//@ prove never read: VW0 = 0\n"
                                                                  "//@ prove no code: VW0 <> 93\n"
                                                                  "//@ prove pointer: VW0 <> 6\n") +
                                                          pointsNowhere);
  const std::string traces = folder.path("traces");
  const GerrEnd proof = commandOnSmart({"prove", program, "--traces", traces});
  EXPECT_NE(proof.out.find("VIOLATED  never read"), std::string::npos) << proof.out;
  EXPECT_NE(proof.out.find("PROVED  no code"), std::string::npos) << proof.out;
  EXPECT_NE(proof.out.find("VIOLATED  pointer"), std::string::npos) << proof.out;
  int repeated = 0;
  for (const char* name : {"never_read.csv", "pointer.csv"}) {
    const std::string witness = (std::filesystem::path(traces) / name).string();
    const GerrEnd run = commandOnSmart({"sim", program, "--stimulus", witness, "--expect", witness});
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    ++repeated;
  }
  EXPECT_EQ(repeated, 2);
}

}  // namespace
}  // namespace rungproof
