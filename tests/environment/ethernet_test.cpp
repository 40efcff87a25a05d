// GET and PUT of the S7-200 SMART as devices: when the status changes, where an answer may be written and where not. A
// request ends before any later scan or never; GET fills the own data that its table named when the request was made.
// What the CPU refuses at once is not stated: any request may be, with any code of 1 to 5.
#include "ir/s7200/cpu.hpp"
#include "tests/engine/rig.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

constexpr Target ethernetCpu{s7200Cpu("ST40"), Edition::Smart28};

ProgramInput ethernetInput(const std::string& properties, const std::string& networks, Target target) {
  ProgramInput input;
  input.program = readText(
      "test.awl", "ORGANIZATION_BLOCK MAIN:OB1\n" + properties + "BEGIN\n" + networks + "END_ORGANIZATION_BLOCK\n",
      {.target = target});
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  return input;
}

/// The verdicts by name, of properties that are one line each.
std::map<std::string, Outcome> requestOutcomes(const std::string& properties, const std::string& networks,
                                               const char* again = nullptr, double timeout = 20,
                                               Target target = ethernetCpu) {
  const ProgramInput input = ethernetInput(properties, networks, target);
  ProverOptions options = usualOptions(timeout);
  if (again != nullptr) {
    EXPECT_TRUE(options.choices.set("network-again", again));
  }
  const ProofRun run = prove(input.program, input.properties, options);
  EXPECT_TRUE(run.disagreements.empty()) << networks;
  std::map<std::string, Outcome> outcomes;
  for (const ProofResult& result : run.results) outcomes[result.property.name] = result.outcome;
  return outcomes;
}

/// A table at VB780 whose own data are `length` bytes from VB200 on, and the request at a rising edge of I0.1.
std::string requestOf(const std::string& request, int length, const std::string& rest = "") {
  return "Network 1\nLD SM0.1\nMOVB 192, VB781\nMOVB 168, VB782\nMOVB 2, VB783\nMOVB 10, VB784\nMOVW 0, VW785\n"
         "MOVD &VB100, VD787\nMOVB " +
         std::to_string(length) + ", VB791\nMOVD &VB200, VD792\nNetwork 2\nLD I0.1\nEU\n" + request + "\nINCB VB0\n" +
         rest;
}

// As many bytes as the table asks for, not before the request, nothing else.
TEST(EthernetRequest, AnAnswerFillsItsBytes) {
  const auto verdicts = requestOutcomes(
      "//@ prove other: Q0.0 = I0.0\n//@ reach first: VB200 = 9\n//@ reach last: VB202 = 200\n"
      "//@ prove behind: VB203 = 0\n//@ prove front: VB199 = 0\n//@ prove before: VB200 <> 0 implies once(I0.1)\n"
      "//@ prove head: VB791 = 3\n",
      requestOf("GET VB780", 3, "Network 3\nLD I0.0\n= Q0.0\n"));
  EXPECT_EQ(verdicts.at("other"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("first"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("last"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("behind"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("front"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("before"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("head"), Outcome::Proved);
}

// D A E 0 and the code: done, or an error of 1 to 5; what has ended stays until the next request.
TEST(EthernetRequest, TheStatusFollowsTheRequest) {
  for (const char* request : {"GET VB780", "PUT VB780"}) {
    const auto verdicts = requestOutcomes(
        "//@ reach active: VB780 = 16#40\n//@ reach done: VB780 = 16#80\n//@ reach error: V780.5\n"
        "//@ reach again: VB0 = 3\n//@ prove code: VB780 <> 16#26 and VB780 <> 16#20\n//@ prove zero: not V780.4\n"
        "//@ prove both: not (V780.6 and V780.7)\n//@ prove asked: VB780 <> 0 implies once(I0.1)\n"
        "//@ prove sure: not rises(I0.1) or V780.6\n",
        requestOf(request, 3));
    for (const char* name : {"active", "done", "error", "again"})
      EXPECT_EQ(verdicts.at(name), Outcome::Reachable) << request << name;
    for (const char* name : {"code", "zero", "both", "asked"})
      EXPECT_EQ(verdicts.at(name), Outcome::Proved) << request << name;
    EXPECT_EQ(verdicts.at("sure"), Outcome::Violated) << request << ": it may be refused at once";
    // Not where a request for a table that is active is queued: the second one ends later.
    const std::string stays = "//@ prove stays: prev(V780.7) and not rises(I0.1) implies V780.7\n";
    EXPECT_EQ(requestOutcomes(stays, requestOf(request, 3), "ignored").at("stays"), Outcome::Proved) << request;
  }
}

// A request for a table that is active. Ignored: one answer for one acceptance, so that D, once set, stays until the
// next edge of the input. Queued: the second answer comes later, without D where it tells an error, and nothing asks in
// that scan. The same of all four instructions: no manual says that one of them is another.
TEST(NetworkAgain, TheSecondOfTwoRequestsForOneTableEndsByItself) {
  const std::string station =
      "Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVB 3, VB786\nNetwork 2\nLD I0.1\nEU\n";  // PPI master, 3 bytes
  struct Case {
    Target target;
    std::string networks;
  };
  const std::vector<Case> cases = {{ethernetCpu, requestOf("GET VB780", 3)},
                                   {ethernetCpu, requestOf("PUT VB780", 3)},
                                   {Target{}, station + "NETR VB780, 0\n"},
                                   {Target{}, station + "NETW VB780, 0\n"}};
  for (const Case& each : cases) {
    const std::string question =
        "//@ reach later: prev(V780.7) and not V780.7 and not rises(I0.1)\n//@ prove unasked: VB780 <> 0 implies "
        "once(I0.1)\n";
    const auto ignored = requestOutcomes(question, each.networks, "ignored", 20, each.target);
    const auto queued = requestOutcomes(question, each.networks, "queued", 20, each.target);
    EXPECT_EQ(ignored.at("later"), Outcome::Unreachable) << each.networks;
    EXPECT_EQ(queued.at("later"), Outcome::Reachable) << each.networks;
    EXPECT_EQ(ignored.at("unasked"), Outcome::Proved) << each.networks;
    EXPECT_EQ(queued.at("unasked"), Outcome::Proved) << each.networks;
  }
}

// Queued, requests for one table fill the queue; ignored, one table takes one entry however often it asks. Codes of a
// full queue: 2 of GET and PUT, 4 of NETR and NETW (001:3052-3065).
TEST(NetworkAgain, QueuedRequestsForOneTableFillTheQueue) {
  const auto statusAfter = [](const std::string& request, const std::string& setUp, int times, const char* again,
                              Target target) {
    std::string lines = "LD SM0.1\n" + setUp + "LD SM0.0\n";
    for (int i = 0; i < times; ++i) lines += request + "\n";
    Choices choices;
    EXPECT_TRUE(choices.set("network-again", again));
    SimulatorOptions options;
    options.choices = choices;
    Rig rig(lines, options, target);
    rig.scans(1);
    return std::pair(rig.get("VB780"), rig.simulator->store().get(Reg::NetActive, 0));
  };
  using Status = std::pair<std::int64_t, std::uint64_t>;
  const std::string own = "MOVB 3, VB791\nMOVD &VB200, VD792\n", master = "MOVB 2, SMB30\nMOVB 3, VB786\n";
  for (const char* request : {"GET VB780", "PUT VB780"}) {
    EXPECT_EQ(statusAfter(request, own, 16, "queued", ethernetCpu), Status(0x40, 16)) << request;
    EXPECT_EQ(statusAfter(request, own, 17, "queued", ethernetCpu), Status(0x22, 16)) << request;
    EXPECT_EQ(statusAfter(request, own, 17, "ignored", ethernetCpu), Status(0x40, 1)) << request;
  }
  for (const char* request : {"NETR VB780, 0", "NETW VB780, 0"}) {
    EXPECT_EQ(statusAfter(request, master, 8, "queued", Target{}), Status(0x40, 8)) << request;
    EXPECT_EQ(statusAfter(request, master, 9, "queued", Target{}), Status(0x24, 8)) << request;
    EXPECT_EQ(statusAfter(request, master, 9, "ignored", Target{}), Status(0x40, 1)) << request;
  }
}

// PUT reads its own data; a table with a length of 0, or beyond 222, or without a pointer, moves nothing.
TEST(EthernetRequest, WhatIsNeverWritten) {
  EXPECT_EQ(requestOutcomes("//@ prove kept: VB200 = 0\n", requestOf("PUT VB780", 3)).at("kept"), Outcome::Vacuous)
      << "nothing writes it";
  for (const int length : {0, 223, 255})
    EXPECT_EQ(requestOutcomes("//@ prove kept: VB200 = 0\n", requestOf("GET VB780", length)).at("kept"),
              Outcome::Proved)
        << length;
  EXPECT_EQ(requestOutcomes("//@ reach last: VB421 = 1\n", requestOf("GET VB780", 222)).at("last"), Outcome::Reachable);
  EXPECT_EQ(requestOutcomes("//@ prove kept: VB0 = 0\n",
                            "Network 1\nLD SM0.1\nMOVB 4, VB791\nNetwork 2\nLD I0.1\nEU\nGET VB780\n")
                .at("kept"),
            Outcome::Proved);
  // Own data in M and Q; SM is no place for them.
  const std::string elsewhere = "Network 3\nLD SM0.1\nMOVD &$, VD792\nNetwork 4\nLD I0.2\nEU\nGET VB780\n";
  const auto at = [&](const std::string& place) {
    std::string text = elsewhere;
    return "Network 1\nLD SM0.1\nMOVB 2, VB791\n" + text.replace(text.find('$'), 1, place);
  };
  EXPECT_EQ(requestOutcomes("//@ reach some: MB9 = 7\n", at("MB8")).at("some"), Outcome::Reachable);
  EXPECT_EQ(requestOutcomes("//@ reach some: QB1 = 7\n", at("QB0")).at("some"), Outcome::Reachable);
  EXPECT_EQ(requestOutcomes("//@ prove none: SMB34 = 0\n", at("SMB34")).at("none"), Outcome::Proved);
}

// The data go where the table pointed when the request was made. A place that an input decides is not known: nothing
// is proved of what it may reach.
TEST(EthernetRequest, WhereTheTablePoints) {
  const std::string moves =
      "Network 1\nLD SM0.1\nMOVB 2, VB791\nMOVD &VB200, VD792\nNetwork 2\nLD I0.2\nMOVD &VB300, VD792\n"
      "Network 3\nLD I0.1\nEU\nGET VB780\n";
  const auto verdicts = requestOutcomes(
      "//@ reach one: VB201 = 5\n//@ reach two: VB301 = 5\n//@ prove between: VB202 = 0 and VB302 = 0\n"
      "//@ prove later: VB300 <> 0 implies once(I0.2)\n",
      moves);
  EXPECT_EQ(verdicts.at("one"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("two"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("between"), Outcome::Proved);
  EXPECT_EQ(verdicts.at("later"), Outcome::Proved);
  const auto unknown = requestOutcomes("//@ prove kept: VB400 = 0\n",
                                       "Network 1\nLD SM0.0\nMOVB 2, VB791\nMOVD &VB200, VD792\n+D ID0, VD792\n"
                                       "Network 2\nLD I4.1\nEU\nGET VB780\n",
                                       nullptr, 2);
  EXPECT_NE(unknown.at("kept"), Outcome::Proved);
}

// The table itself behind a pointer that is known where it stands.
TEST(EthernetRequest, ATableBehindAPointer) {
  const auto verdicts =
      requestOutcomes("//@ reach done: V780.7\n//@ reach data: VB201 = 5\n//@ prove behind: VB202 = 0\n",
                      "Network 1\nLD SM0.1\nMOVB 2, VB791\nMOVD &VB200, VD792\n"
                      "Network 2\nLD I0.1\nEU\nMOVD &VB780, VD0\nGET *VD0\n");
  EXPECT_EQ(verdicts.at("done"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("data"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("behind"), Outcome::Proved);
}

// Two requests beside each other: one may end while the other waits.
TEST(EthernetRequest, RequestsEndApart) {
  const auto verdicts = requestOutcomes(
      "//@ reach first: V780.7 and V880.6\n//@ reach second: V780.6 and V880.7\n"
      "//@ prove kept: VB300 = 0\n",
      requestOf("GET VB780", 3,
                "Network 3\nLD SM0.1\nMOVB 3, VB891\nMOVD &VB300, VD892\nNetwork 4\nLD I0.2\nEU\nPUT VB880\n"));
  EXPECT_EQ(verdicts.at("first"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("second"), Outcome::Reachable);
  EXPECT_EQ(verdicts.at("kept"), Outcome::Proved);
}

// In a run a request ends with the scan after the one that made it, and a column of the stimulus gives the answer.
TEST(EthernetRequest, TheEngineEndsARequest) {
  Rig rig(requestOf("GET VB780", 3), {}, ethernetCpu);
  rig.scans(1);
  rig.set("I0.1", 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("VB780"), 0x40);
  EXPECT_EQ(rig.simulator->store().get(Reg::NetBuffer, 0), pointer::encode(Area::V, 200));
  rig.scans(1);
  EXPECT_EQ(rig.get("VB780"), 0x80);
  EXPECT_EQ(rig.simulator->store().get(Reg::NetBuffer, 0), 0U);
  EXPECT_EQ(rig.simulator->store().get(Reg::NetActive, 0), 0U);
}

// Sixteen at one time; the next is refused with code 2 (of the table of error codes), a wrong length with 1.
TEST(EthernetRequest, SixteenAtATime) {
  std::string lines = "LD SM0.1\n", requests = "LD I0.1\n";
  for (int i = 0; i < 17; ++i) {
    const int table = 1000 + 20 * i;
    lines += "MOVB 1, VB" + std::to_string(table + 11) + "\nMOVD &VB200, VD" + std::to_string(table + 12) + "\n";
    requests += "GET VB" + std::to_string(table) + "\n";
  }
  Rig rig(lines + requests + "GET VB2000\n", {}, ethernetCpu);
  rig.scans(1);
  rig.set("I0.1", 1);
  rig.scans(1);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(rig.get("VB" + std::to_string(1000 + 20 * i)), 0x40) << i;
  EXPECT_EQ(rig.get("VB1320"), 0x22);
  EXPECT_EQ(rig.get("VB2000"), 0x22);
  Rig wrong("LD I0.1\nGET VB2000\n", {}, ethernetCpu);
  wrong.set("I0.1", 1);
  wrong.scans(1);
  EXPECT_EQ(wrong.get("VB2000"), 0x21);
}

}  // namespace
}  // namespace rungproof::test
