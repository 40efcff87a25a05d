// What devices write while a request of the program runs: messages, answers of other stations, ends of transmissions
// and pulse trains, saved values. Proofs let it come at any time that the request allows, and nothing else; the run
// that breaks a property is repeated by the reference engine, and its trace is a stimulus that repeats it again.
#include <sstream>

#include "analysis/lint/lint.hpp"
#include "engine/stimulus.hpp"
#include "frontend/linting/solver_rules.hpp"
#include "frontend/simulation/stimulus_reader.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/trace_format.hpp"
#include "tests/engine/rig.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

using Outcomes = std::map<std::string, Outcome>;

Outcomes deviceOutcomes(const std::string& properties, const std::string& networks, const std::string& blocks = "") {
  const ProgramInput input = inputOf(properties, networks, blocks);
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  Outcomes outcomes;
  for (const ProofResult& result : run.results) outcomes[result.property.name] = result.outcome;
  return outcomes;
}

/// Freeport, RCV with a start and an end character into VB100, at most 100 characters (000:1524-1548).
std::string receiver(const std::string& rest, int limit = 100) {
  return "Network 1\nLD SM0.1\nMOVB 9, SMB30\nMOVB 16#E0, SMB87\nMOVB 2, SMB88\nMOVB 10, SMB89\nMOVB " +
         std::to_string(limit) + ", SMB94\nNetwork 2\nLD I0.0\nEU\nRCV VB100, 0\n" + rest;
}

// ---- RCV -------------------------------------------------------------------------------------------------

TEST(Devices, ReceivedBytesMayBeAnything) {
  const Outcomes verdicts = deviceOutcomes("//@ prove off: never Q0.0\n",
                                           receiver("Network 3\nLDB= VB101, 16#53\nAB= VB102, 16#54\nS Q0.0, 1\n"));
  EXPECT_EQ(verdicts.at("off"), Outcome::Violated);
}

// Not before the request, not behind the buffer, no count above the limit (001:3195-3207, 001:14294).
TEST(Devices, ReceptionKeepsToItsRequest) {
  const Outcomes verdicts = deviceOutcomes(
      "//@ prove before: VB101 <> 0 implies once(I0.0)\n//@ prove behind: VB111 = 0\n//@ prove count: VB100 <= 10\n"
      "//@ reach last: VB110 = 77\n//@ reach full: VB100 = 10\n//@ prove front: VB99 = 0\n",
      receiver("", 10));
  EXPECT_EQ(verdicts.at("before"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("behind"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("count"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("last"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("full"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("front"), Outcome::Vacuous);  // no instruction or device writes it
}

// The status is 0 while the reception runs and shows e, t, c or p at its end; what has ended stays as it is
// (001:3207, 001:3217-3223).
TEST(Devices, StatusOfReceptionFollowsIt) {
  const Outcomes verdicts = deviceOutcomes(
      "//@ reach ended: prev(SMB86) = 0 and SMB86 = 16#20\n"
      "//@ prove own: prev(SMB86) = 0 and SMB86 <> 0 implies SMB86 <= 16#27 and not SM86.3 and not SM86.4\n"
      "//@ prove stays: prev(SMB86) <> 0 and not rises(I0.0) and not first_scan implies VB101 = prev(VB101)\n",
      receiver("Network 3\nLDB= SMB86, 0\n= Q0.0\n"));
  EXPECT_EQ(verdicts.at("ended"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("own"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("stays"), Outcome::Proved);
}

// The second request runs only when the first has ended (001:3141): both rounds are reached.
TEST(Devices, ReceptionMayBeAskedForAgain) {
  const Outcomes verdicts =
      deviceOutcomes("//@ reach again: VB0 = 2\n",
                     "Network 1\nLD SM0.1\nMOVB 9, SMB130\nMOVB 16#E0, SMB187\nMOVB 2, SMB188\nMOVB 10, SMB189\n"
                     "MOVB 20, SMB194\nR M0.0, 1\nNetwork 2\nLDN M0.0\nRCV VB100, 1\nS M0.0, 1\nINCB VB0\n"
                     "Network 3\nLD M0.0\nAB<> SMB186, 0\nR M0.0, 1\n");
  EXPECT_EQ(verdicts.at("again"), Outcome::Reachable);
}

// A buffer that a pointer names: where the pointer can be followed, the bytes are known.
TEST(Devices, BufferBehindAPointer) {
  const std::string start =
      "Network 1\nLD SM0.1\nMOVB 9, SMB30\nMOVB 16#E0, SMB87\nMOVB 2, SMB88\nMOVB 10, SMB89\nMOVB 4, SMB94\n";
  const Outcomes followed = deviceOutcomes(
      "//@ reach first: VB201 = 9\n//@ reach second: VB301 = 9\n//@ prove between: VB205 = 0 and VB401 = 0\n",
      start +
          "Network 2\nLD SM0.0\nMOVD &VB200, VD0\nLD I0.1\nMOVD &VB300, VD0\nNetwork 3\nLD I0.0\nEU\nRCV *VD0, 0\n");
  EXPECT_EQ(followed.at("first"), Outcome::Reachable);
  EXPECT_EQ(followed.at("second"), Outcome::Reachable);
  EXPECT_EQ(followed.at("between"), Outcome::Proved);
  // An address that comes from an input cannot be followed: nothing is proved of what it may reach.
  const Outcomes unknown =
      deviceOutcomes("//@ prove kept: VB205 = 0\n", start +
                                                        "Network 2\nLD SM0.0\nMOVD &VB200, VD0\n+D ID0, VD0\n"
                                                        "Network 3\nLD I4.0\nEU\nRCV *VD0, 0\n");
  EXPECT_NE(unknown.at("kept"), Outcome::Proved);
}

// A table behind a pointer whose value is known where it is used: what arrives is written as well.
TEST(Devices, TablesBehindAPointerThatIsKnown) {
  const std::string start =
      "Network 1\nLD SM0.1\nMOVB 9, SMB30\nMOVB 16#E0, SMB87\nMOVB 2, SMB88\nMOVB 10, SMB89\nMOVB 4, SMB94\n";
  const Outcomes received =
      deviceOutcomes("//@ prove none: VB201 = 0\n//@ reach some: VB201 = 9\n//@ prove behind: VB205 = 0\n",
                     start + "Network 2\nLD I0.0\nEU\nMOVD &VB200, VD0\nRCV *VD0, 0\n");
  EXPECT_EQ(received.at("none"), Outcome::Violated);
  EXPECT_EQ(received.at("some"), Outcome::Reachable);
  EXPECT_EQ(received.at("behind"), Outcome::Proved);
  for (const char* pointer : {"VD0", "AC1", "LD0"}) {
    const Outcomes answered = deviceOutcomes(
        "//@ reach data: VB208 = 9\n//@ reach done: V200.7\n//@ prove behind: VB209 = 0\n",
        std::string("Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVB 2, VB206\nNetwork 2\nLD I0.0\nEU\nMOVD &VB200, ") +
            pointer + "\nNETR *" + pointer + ", 0\n");
    EXPECT_EQ(answered.at("data"), Outcome::Reachable) << pointer;
    EXPECT_EQ(answered.at("done"), Outcome::Reachable) << pointer;
    EXPECT_EQ(answered.at("behind"), Outcome::Proved) << pointer;
  }
  // In a block that is called, and in an interrupt routine.
  const Outcomes called =
      deviceOutcomes("//@ reach data: VB208 = 9\n",
                     "Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVB 2, VB206\nNetwork 2\nLD I0.0\nCALL SBR_0\n",
                     "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\nMOVD &VB200, VD0\nNETR *VD0, 0\n"
                     "END_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(called.at("data"), Outcome::Reachable);
  const Outcomes interrupted = deviceOutcomes(
      "//@ prove none: VB208 = 0\n", "Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVB 2, VB206\nATCH INT_0, 0\nENI\n",
      "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nMOVD &VB200, VD0\nNETR *VD0, 0\nEND_INTERRUPT_BLOCK\n");
  EXPECT_NE(interrupted.at("none"), Outcome::Proved);
}

// ---- XMT, PLS, saved values --------------------------------------------------------------------------------

// SM4.5 is 0 from XMT on until the transmission has ended (001:14109); the table is only read.
TEST(Devices, TransmissionEnds) {
  const Outcomes verdicts = deviceOutcomes(
      "//@ reach ends: prev(Q1.0) and not Q1.0\n//@ prove asked: Q1.0 implies once(I0.0)\n"
      "//@ prove kept: VB100 = 3\n//@ reach again: VB0 = 2\n",
      "Network 1\nLD SM0.1\nMOVB 9, SMB30\nMOVB 3, VB100\nNetwork 2\nLD I0.0\nA SM4.5\nXMT VB100, 0\nINCB VB0\n"
      "Network 3\nLDN SM4.5\n= Q1.0\n");
  EXPECT_EQ(verdicts.at("ends"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("asked"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("kept"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("again"), Outcome::Reachable);
}

// A train ends and a waiting one begins without a gap (001:4584); the idle bit shows the end (001:4643).
TEST(Devices, PulseTrainsEnd) {
  const Outcomes verdicts = deviceOutcomes(
      "//@ reach ends: prev(Q1.0) and not Q1.0\n//@ prove asked: Q1.0 implies once(I0.0)\n//@ reach again: VB0 = 3\n"
      "//@ prove aborted: not SM66.4\n",
      "Network 1\nLD SM0.1\nMOVB 16#8D, SMB67\nMOVW 500, SMW68\nMOVD 4, SMD72\nNetwork 2\nLD I0.0\nA SM66.7\nPLS 0\n"
      "INCB VB0\nNetwork 3\nLDN SM66.7\n= Q1.0\n");
  EXPECT_EQ(verdicts.at("ends"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("asked"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("again"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("aborted"), Outcome::Proved);  // only a profile can (001:4649)
}

// The manual's own program (001:1651-1677): a second value is saved when the first is through.
TEST(Devices, SavedValueClearsItsRequest) {
  const Outcomes verdicts = deviceOutcomes(
      "//@ reach second: VB0 = 2\n//@ prove asked: SM31.7 implies once(I0.0)\n//@ reach waits: prev(SM31.7) and "
      "SM31.7\n"
      "//@ prove size: SM31.0 implies once(I0.0)\n",
      "Network 1\nLD I0.0\nEU\nAN SM31.7\nMOVW +100, SMW32\nMOVB 1, SMB31\nS SM31.7, 1\nINCB VB0\n");
  EXPECT_EQ(verdicts.at("second"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("asked"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("waits"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("size"), Outcome::Proved);
}

// Outside its interrupt routine a counter's status means nothing (001:4344); before HDEF there is none.
TEST(Devices, CounterStatusNeedsADefinition) {
  const std::string rest = "Network 2\nLD SM36.6\n= Q0.0\nNetwork 3\nLD SM46.6\n= Q0.1\nNetwork 4\nLD SM36.2\n= Q0.2\n";
  const Outcomes verdicts =
      deviceOutcomes("//@ reach own: Q0.0\n//@ prove other: never Q0.1\n//@ prove unused: never Q0.2\n",
                     "Network 1\nLD SM0.1\nMOVB 16#F8, SMB37\nHDEF 0, 0\nHSC 0\n" + rest);
  EXPECT_EQ(verdicts.at("own"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("other"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("unused"), Outcome::Proved);
}

// ---- NETR, NETW ------------------------------------------------------------------------------------------

/// PPI master that reads 3 bytes from station 2 into VB200, guarded as in the manual's example (000:1400).
std::string networkMaster(const std::string& name, const std::string& rest) {
  return "Network 1\nLD SM0.1\nMOVB 2, SMB30\nFILL 0, VW200, 10\nNetwork 2\nLDN SM0.1\nAN V200.6\nAN V200.5\nMOVB 2, "
         "VB201\n"
         "MOVD &VB100, VD202\nMOVB 3, VB206\n" +
         name + " VB200, 0\nINCB VB0\n" + rest;
}

TEST(Devices, NetworkRequestEndsWithOrWithoutAnError) {
  const Outcomes verdicts = deviceOutcomes(
      "//@ reach again: VB0 = 3\n//@ reach error: Q0.1\n//@ reach timeout: VB200 = 16#A1\n//@ prove code: VB200 <> "
      "16#A0\n"
      "//@ prove zero: not V200.4\n//@ prove reserved: not V200.5 or VB200 <> 16#AF\n//@ reach done: Q0.0\n",
      networkMaster("NETR", "Network 3\nLD V200.7\n= Q0.0\nNetwork 4\nLD V200.5\n= Q0.1\n"));
  EXPECT_EQ(verdicts.at("again"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("error"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("timeout"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("code"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("zero"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("reserved"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("done"), Outcome::Reachable);
}

// As many bytes as were asked for, and none of a NETW (000:1113-1157).
TEST(Devices, AnswerFillsItsBytes) {
  const std::string rest = "Network 3\nLDB= VB207, 9\n= Q0.2\n";
  const Outcomes read = deviceOutcomes(
      "//@ reach first: Q0.2\n//@ reach last: VB209 = 200\n//@ prove behind: VB210 = 0\n"
      "//@ prove head: VB201 = 0 or VB201 = 2\n",
      networkMaster("NETR", rest));
  EXPECT_EQ(read.at("first"), Outcome::Reachable);
  EXPECT_EQ(read.at("last"), Outcome::Reachable);
  EXPECT_EQ(read.at("behind"), Outcome::Proved);
  EXPECT_EQ(read.at("head"), Outcome::Proved);
  const Outcomes write =
      deviceOutcomes("//@ prove first: never Q0.2\n//@ reach again: VB0 = 2\n", networkMaster("NETW", rest));
  EXPECT_EQ(write.at("first"), Outcome::Proved);
  EXPECT_EQ(write.at("again"), Outcome::Reachable);
}

// Two requests run beside each other; one may end while the other waits.
TEST(Devices, RequestsEndApart) {
  const Outcomes verdicts = deviceOutcomes(
      "//@ reach first: not V200.6 and V300.6 and M0.0\n//@ reach second: V200.6 and not V300.6 and M0.0\n"
      "//@ reach both: V200.6 and V300.6\n//@ prove apart: VB307 = 0 or once(M0.0)\n",
      "Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVB 1, VB206\nMOVB 1, VB306\nNetwork 2\nLD I0.0\nEU\nNETR VB200, 0\n"
      "NETR VB300, 0\nS M0.0, 1\n");
  EXPECT_EQ(verdicts.at("first"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("second"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("both"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("apart"), Outcome::Proved);
}

// The answer of one request would fall on the status byte of another: what comes of that is not followed.
TEST(Devices, RequestsThatLieInEachOther) {
  const Outcomes verdicts = deviceOutcomes(
      "//@ prove idle: not V208.5\n//@ prove apart: VB300 = 0\n",
      "Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVB 3, VB206\nMOVB 2, VB214\nNetwork 2\nLD I0.0\nNETR VB200, 0\n"
      "Network 3\nLD I0.1\nNETW VB208, 0\n");
  EXPECT_NE(verdicts.at("idle"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("apart"), Outcome::Proved);
}

// ---- Runs ------------------------------------------------------------------------------------------------

/// The stimulus that the witness's trace is, played by the engine: values of a signal at the end of each scan.
std::string replayed(const ProgramInput& input, const ProofResult& result, const std::string& name) {
  const Choices choices = usualOptions().choices;
  const Trace trace = traceOf(input.program, choices, *result.witness, signalsThatMatter(input.program, result));
  std::ostringstream text;
  traceFormatOf("witness.csv")->write(trace, "", text);
  std::vector<Failure> failures;
  const Stimulus stimulus = readStimulus("witness.csv", text.str(), input.program, failures);
  for (const Failure& failure : failures) ADD_FAILURE() << failure.message << "\n" << text.str();
  Simulator simulator(input.program);
  StimulusPlayer player(simulator, stimulus);
  std::string wave;
  while (!player.isDone()) {
    const ScanRequest request = player.next();
    simulator.scan(request);
    wave += std::to_string(simulator.read(operandNamed(name)));
  }
  return wave;
}

TEST(Devices, WitnessIsAStimulusThatRepeatsIt) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"//@ prove off: never Q0.0\n", receiver("Network 3\nLDB= VB101, 16#53\nAB= VB102, 16#54\n= Q0.0\n")},
      {"//@ prove off: never Q0.0\n", networkMaster("NETR", "Network 3\nLDB= VB207, 9\nA V200.5\n= Q0.0\n")},
      {"//@ prove off: never Q0.0\n",
       "Network 1\nLD SM0.1\nMOVB 9, SMB30\nMOVB 3, VB100\nNetwork 2\nLD I0.0\nA SM4.5\nXMT VB100, 0\nINCB VB0\n"
       "Network 3\nLDB= VB0, 3\n= Q0.0\n"},
      {"//@ prove off: never Q0.0\n", "Network 1\nLDN SM0.3\nAN SM0.2\n= Q0.0\n"},
      {"//@ prove off: never Q0.0\n", "Network 1\nLDW= SMW200, 16#0102\nA SM5.0\n= Q0.0\n"}};
  for (const auto& [properties, networks] : cases) {
    const ProgramInput input = inputOf(properties, networks);
    const ProofRun run = prove(input.program, input.properties, usualOptions());
    const ProofResult* result = resultNamed(run, "off");
    ASSERT_TRUE(result != nullptr && result->witness) << networks;
    EXPECT_EQ(replayed(input, *result, "Q0.0").back(), '1') << networks;
  }
}

// A script cannot let a device write what no request asked for.
TEST(Devices, EngineRefusesWritesWithoutARequest) {
  Rig rig(receiver("", 10));
  ScanScript script;
  script.writes = {{{ScanPlace::startOfScan}, operandNamed("VB101"), 83}};
  rig.simulator->scan({.lengthUs = 10000, .script = &script});
  EXPECT_EQ(rig.get("VB101"), 0);
  rig.set("I0.0", 1);
  rig.simulator->scan({.lengthUs = 10000, .script = &script});
  rig.simulator->scan({.lengthUs = 10000, .script = &script});
  EXPECT_EQ(rig.get("VB101"), 83);
  script.writes = {{{ScanPlace::startOfScan}, operandNamed("VB111"), 1},
                   {{ScanPlace::startOfScan}, operandNamed("VB100"), 11},
                   {{ScanPlace::startOfScan}, operandNamed("SMB86"), 0x20}};
  rig.simulator->scan({.lengthUs = 10000, .script = &script});
  EXPECT_EQ(rig.get("VB111"), 0);
  EXPECT_EQ(rig.get("VB100"), 0);
  EXPECT_EQ(rig.get("SMB86"), 0x20);
  script.writes = {{{ScanPlace::startOfScan}, operandNamed("VB101"), 1}};
  rig.simulator->scan({.lengthUs = 10000, .script = &script});
  EXPECT_EQ(rig.get("VB101"), 83);  // the reception has ended
}

// Without a script the columns of a stimulus may give what arrives: the status ends the reception and its event comes.
TEST(Devices, StimulusMayEndAReception) {
  const std::string program =
      "LD SM0.1\nMOVB 9, SMB30\nMOVB 16#E0, SMB87\nMOVB 2, SMB88\nMOVB 10, SMB89\nMOVB 20, SMB94\nATCH 0, 23\nENI\n"
      "RCV VB100, 0\nMEND\nINT 0\nLD SM0.0\nINCB VB0\nRETI\n";
  Rig rig(program);
  std::vector<Failure> failures;
  const Stimulus stimulus = readStimulus("in.csv", "scan,VB101,SMB86\n1,,\n3,65,32\n5,,\n", rig.program, failures);
  ASSERT_TRUE(failures.empty());
  StimulusPlayer player(*rig.simulator, stimulus);
  for (int scan = 0; scan < 5; ++scan) {
    const ScanRequest request = player.next();
    rig.simulator->scan(request);
  }
  EXPECT_EQ(rig.get("VB101"), 65);
  EXPECT_EQ(rig.get("SMB86"), 32);
  EXPECT_EQ(rig.get("VB0"), 1);
  EXPECT_EQ(rig.simulator->store().get(Reg::PortBusy, 0), 0U);
}

// Rules that the solver confirms no longer call conditions on received bytes dead, and keep what they can really do.
TEST(Devices, RulesKnowWhatArrives) {
  const auto rulesOf = [](const std::string& networks) {
    const ProgramInput input = inputOf("", networks);
    const Facts facts(input.program, input.properties.externals);
    std::vector<Finding> findings = runRules(facts, RuleSelection(), {});
    settleBySolver(
        input, usualOptions(5), [](std::string_view) { return true; }, findings);
    std::set<std::string> rules;
    for (const Finding& finding : findings) {
      if (finding.confirmation != Confirmation::Unconfirmed) rules.insert(finding.rule);
    }
    return rules;
  };
  const std::set<std::string> message =
      rulesOf(receiver("Network 3\nLDB= VB101, 16#53\n= Q0.0\nNetwork 4\nLDB<> SMB86, 0\nTON T37, 10\nLD T37\n= Q0.1\n"
                       "Network 5\nLDB<> VB101, 0\nMOVB VB102, VB1\n/I VW0, VW10\n"));
  EXPECT_FALSE(message.contains("LOG001"));
  EXPECT_FALSE(message.contains("TIM008"));
  EXPECT_TRUE(message.contains("ARI001"));
  const std::set<std::string> answer = rulesOf(
      networkMaster("NETR",
                    "Network 3\nLDB= VB207, 9\nA V200.5\n= Q0.2\nNetwork 4\nLD V200.6\nTON T37, 10\nLD T37\n= Q0.1\n"
                    "Network 5\nLDB<> VB207, 0\nMOVB VB208, VB21\n/I VW20, VW30\n"));
  EXPECT_FALSE(answer.contains("LOG001"));
  EXPECT_FALSE(answer.contains("TIM008"));
  EXPECT_TRUE(answer.contains("ARI001"));
}

// The value is saved at the end of the scan (001:1649): the next scan finds the request cleared.
TEST(Devices, SimulationSavesAValueInOneScan) {
  Rig rig("LD I0.0\nEU\nAN SM31.7\nMOVB 1, SMB31\nS SM31.7, 1\nINCB VB0\nLD SM31.7\n= Q0.0\n");
  rig.scans(1);
  rig.set("I0.0", 1);
  EXPECT_EQ(rig.wave("Q0.0", 3), "100");
}

}  // namespace
}  // namespace rungproof::test
