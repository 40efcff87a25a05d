// Encoding and engine on programs with requests: under random inputs, ends and answers both come to the same state
// after every scan, so that what proofs let devices write is what the engine takes from a script, no more and no less.
#include <random>

#include "analysis/witness/scan_run.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

struct DeviceProgram {
  std::string name, networks;
};

std::string named(const testing::TestParamInfo<DeviceProgram>& info) { return info.param.name; }

class DeviceAgreement : public testing::TestWithParam<DeviceProgram> {};

/// The state that the encoding predicts after each scan, and that of the engine.
void compareRun(const Program& program, std::uint64_t seed) {
  EncoderOptions options;
  options.time.low = options.time.high = 10;
  EncodedScan scan(program, options);
  const TransitionSystem system = scan.system();
  ASSERT_TRUE(scan.approximations().empty());
  std::vector<Place> places;
  std::vector<Node> ends;
  for (const Place& place : scan.places()) {
    const bool isPhase = place.isRegister && (place.reg == Reg::PhaseTen || place.reg == Reg::PhaseHundred ||
                                              place.reg == Reg::PhysicalOutput);
    if (isPhase) continue;
    places.push_back(place);
    ends.push_back(scan.atEnd(place));
  }
  ScanRun run(scan, system, ends);
  std::mt19937_64 random(seed);
  run.start();
  for (const StateVariable& s : system.states) {
    if (s.init == noNode) run.set(s.node, 0);
  }
  std::optional<Concrete::Store> initial;
  std::vector<ReplayScan> script;
  std::vector<std::vector<std::uint64_t>> expected;
  for (int k = 0; k < 30; ++k) {
    bool isScan = false;
    for (int tries = 0; tries < 50 && !isScan; ++tries) {
      for (const Node input : system.inputs) {
        const int width = scan.graph()[input].width;
        const std::uint64_t value = random() % 3 == 0 ? random() : random() % 4;
        run.set(input, value & Graph::maskOf(width));
      }
      isScan = run.evaluate();
    }
    ASSERT_TRUE(isScan);
    if (k == 0) initial = run.initialState();
    script.push_back(run.script());
    std::vector<std::uint64_t>& values = expected.emplace_back();
    for (const Node end : ends) values.push_back(run[end]);
    run.advance();
  }
  const ReplayResult result = replay(program, options.choices, script, &*initial);
  ASSERT_EQ(result.states.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    for (std::size_t i = 0; i < places.size(); ++i)
      ASSERT_EQ(valueAt(places[i], result.states[k]), expected[k][i]) << nameOf(places[i]) << " after scan " << k + 1;
  }
}

TEST_P(DeviceAgreement, EncodingAndEngine) {
  const ProgramInput input = inputOf("", GetParam().networks);
  for (std::uint64_t seed = 1; seed <= 40 && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE(seed);
    compareRun(input.program, seed);
  }
}

const DeviceProgram programs[] = {
    {"Reception",
     "Network 1\nLD SM0.1\nMOVB 9, SMB30\nMOVB 16#E0, SMB87\nMOVB 2, SMB88\nMOVB 10, SMB89\nMOVB 5, SMB94\n"
     "Network 2\nLD I0.0\nRCV VB100, 0\nNetwork 3\nLDB= SMB86, 0\n= Q0.0\nNetwork 4\nLD V101.3\nAB> VB104, 7\n= Q0.1\n"
     "Network 5\nLDW= VW106, 3\nOW= VW99, 7\n= Q0.2\nNetwork 6\nLD I0.1\nMOVB IB2, SMB94\nR SM87.7, 1\nLD I0.2\nS "
     "SM87.7, 1\n"},
    {"TwoBuffers",
     "Network 1\nLD SM0.1\nMOVB 9, SMB130\nMOVB 16#E0, SMB187\nMOVB 3, SMB194\nNetwork 2\nLD I0.0\nRCV VB100, 1\n"
     "Network 3\nLD I0.1\nRCV VB102, 1\nNetwork 4\nLDD= VD100, VD104\n= Q0.0\nNetwork 5\nLD SM0.0\nMOVD &VB110, VD0\n"
     "A I0.2\nMOVD &VB112, VD0\nNetwork 6\nLD I0.3\nRCV *VD0, 1\nNetwork 7\nLDD> VD110, VD114\n= Q0.1\n"},
    {"Transmission",
     "Network 1\nLD SM0.1\nMOVB 9, SMB30\nMOVB 9, SMB130\nMOVB 3, VB100\nNetwork 2\nLD I0.0\nXMT VB100, 0\nNetwork 3\n"
     "LD I0.1\nXMT VB100, 1\nNetwork 4\nLD SM4.5\nA SM4.6\n= Q0.0\nNetwork 5\nLD I0.2\nMOVB 16#80, SMB87\nMOVB 2, "
     "SMB94\n"
     "RCV VB100, 0\n"},
    {"Requests",
     "Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVB 3, VB206\nMOVB 16, VB306\nNetwork 2\nLD I0.0\nNETR VB200, 0\nNetwork 3\n"
     "LD I0.1\nNETW VB300, 0\nNetwork 4\nLD I0.2\nMOVB IB1, VB206\nMOVB 0, VB200\nNetwork 5\nLDB= VB207, VB209\nA "
     "V200.7\n"
     "= Q0.0\nNetwork 6\nLDW= VW322, 5\nOB= VB210, 1\n= Q0.1\nNetwork 7\nLD I0.3\nNETW VB195, 0\n"},
    {"Trains",
     "Network 1\nLD SM0.1\nMOVB 16#8D, SMB67\nMOVW 500, SMW68\nMOVD 4, SMD72\nMOVB 16#A0, SMB77\nMOVW 400, SMW178\n"
     "MOVB 3, VB400\nNetwork 2\nLD I0.0\nPLS 0\nNetwork 3\nLD I0.1\nPLS 1\nNetwork 4\nLDN SM66.7\nA SM76.4\n= Q1.0\n"
     "Network 5\nLDB= SMB176, 2\n= Q1.1\nNetwork 6\nLD I0.2\nMOVB IB1, SMB67\nLD I0.3\nMOVB IB2, SMB77\n"},
    {"Memory",
     "Network 1\nLD I0.0\nAN SM31.7\nMOVB 1, SMB31\nS SM31.7, 1\nINCB VB0\nNetwork 2\nLD SM31.0\nA SM0.2\nO SM0.3\n= "
     "Q0.0\n"
     "Network 3\nLD SM0.1\nA I0.1\nHDEF 0, 0\nNetwork 4\nLD SM36.5\nA SM36.1\nO SM46.7\n= Q0.1\nNetwork 5\nLDW= SMW29, "
     "7\n"
     "OB= SMB6, 16#9A\nO SM0.7\n= Q0.2\nNetwork 6\nLD I0.2\nMOVB IB1, SMB31\nMOVB IB2, SMB98\nNetwork 7\nLDD= SMD97, "
     "3\n= Q0.3\n"}};

INSTANTIATE_TEST_SUITE_P(Programs, DeviceAgreement, testing::ValuesIn(programs), named);

}  // namespace
}  // namespace rungproof::test
