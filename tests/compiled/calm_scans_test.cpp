// Calm scans (engine/calm_scan.cpp): whatever ends the calm - somebody outside, or the program by an instruction that
// has no machine code - is seen in the scan in which the reference engine sees it, and clocks go on in between.
#include <gtest/gtest.h>

#include <functional>

#include "frontend/input/project.hpp"
#include "ir/block_event.hpp"
#include "tests/compiled/engine_pair.hpp"

namespace rungproof::test {
namespace {

/// Both engines over a program of the old text form; `act` runs before each scan, from 1, on each of them and gives the
/// scan's request.
std::uint64_t compareRuns(const std::string& text, int scans, const std::function<ScanRequest(Simulator&, int)>& act) {
  const Program program = readText("calm.awl", text);
  EXPECT_TRUE(program.findings.empty()) << program.findings.front().message;
  SimulatorOptions forReference, forCompiled;
  forReference.engine = EngineKind::Reference;
  forCompiled.engine = EngineKind::Compiled;
  Simulator reference(program, forReference), compiled(program, forCompiled);
  for (int scan = 1; scan <= scans; ++scan) {
    reference.scan(act(reference, scan));
    compiled.scan(act(compiled, scan));
    const std::string difference = firstDifference(reference, compiled);
    EXPECT_EQ(difference, "") << "scan " << scan;
    if (!difference.empty()) break;
  }
  return compiled.compiledScans();
}

void setInputs(Simulator& simulator, std::uint64_t byte) { simulator.write(direct(Area::I, Width::Byte, 0, 0), byte); }

TEST(CalmScans, ClocksGoOnForMinutes) {
  // 100 ms a scan: SM0.4 turns every 300 scans, SM0.5 every 5, and the scan times stand in SMW22 to SMW26.
  const std::uint64_t compiled = compareRuns(
      "LD SM0.4\n= Q0.0\nLD SM0.5\n= Q0.1\nLD SM0.6\n= Q0.2\nLD I0.0\nTON T37, 30\nLD T37\nTON T33, 7\nMEND\n", 1500,
      [](Simulator& s, int scan) {
        setInputs(s, scan / 100 % 2);
        return ScanRequest{.lengthUs = scan % 7 == 0 ? 33'300U : 100'000U};
      });
  EXPECT_GE(compiled, 1400U);
}

TEST(CalmScans, TimersOfAnS7300GoOn) {
  // A flicker of 700 ms and 300 ms, twelve seconds seen in LC, a counter; scans of 10 and of 33.3 ms. Local data are the
  // block's alone; behind the scan nothing stands there.
  const std::uint64_t compiled = compareRuns(
      "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [0 .. 19] OF BYTE;\n n : INT;\nEND_VAR\nBEGIN\nNETWORK\n"
      "AN T 2;\nL S5T#700ms;\nSD T 1;\nA T 1;\nL S5T#300ms;\nSE T 2;\nA T 1;\n= Q 0.0;\n"
      "A I 0.0;\nL S5T#12s;\nSF T 3;\nLC T 3;\nT MW 10;\nA T 3;\n= Q 0.1;\n"
      "A Q 0.0;\nCU C 1;\nL C 1;\nT #n;\nL #n;\n+ 3;\nT MW 12;\nEND_ORGANIZATION_BLOCK\n",
      2000, [](Simulator& s, int scan) {
        setInputs(s, scan % 1000 < 50 ? 1 : 0);
        return ScanRequest{.lengthUs = scan % 7 == 0 ? 33'300U : 10'000U};
      });
  EXPECT_GE(compiled, 1900U);
}

TEST(CalmScans, SomebodyOutsideEndsThemInAnS7300) {
  compareRuns(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\n= Q 0.0;\nL MW 0;\n+ 1;\nT MW 0;\nA I 0.1;\n"
      "L S5T#50ms;\nSD T 1;\nA T 1;\n= Q 0.1;\nEND_ORGANIZATION_BLOCK\n",
      200, [](Simulator& s, int scan) {
        setInputs(s, scan % 5 == 0 ? 1 : scan % 20 < 10 ? 2 : 0);
        if (scan == 30) s.force(direct(Area::Q, Width::Bit, 0, 0), 1);
        if (scan == 40) s.unforce(direct(Area::Q, Width::Bit, 0, 0));
        if (scan == 50) s.stop();
        if (scan == 55) s.run();
        if (scan == 70) s.powerCycle();
        if (scan == 100) s.setStore(s.store());
        if (scan == 180) return ScanRequest{.events = {eventOfBlock(40)}};  // nobody takes it: the CPU stops
        return ScanRequest{.lengthUs = scan == 120 ? 140'000U : 10'000U};
      });
}

TEST(CalmScans, AScanThatIsTooLongStopsAnS7300) {
  compareRuns("ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n", 30,
              [](Simulator&, int scan) { return ScanRequest{.lengthUs = scan == 20 ? 700'000U : 10'000U}; });
}

TEST(CalmScans, AnEventThatTheProgramAttachesLaterHasItsEdges) {
  // ATCH has no machine code: the reference engine runs that scan, and the edge of I0.0 comes in a later one. That
  // I0.0 was on when the calm began and went off in it is no edge behind ATCH.
  compareRuns("LD I0.7\nEU\nATCH 0, 0\nATCH 0, 1\nENI\nMEND\nINT 0\nLD SM0.0\nINCW VW0\nCRETI\nRETI\n", 80,
              [](Simulator& s, int scan) {
                setInputs(s, (scan < 20 ? 1U : 0U) | (scan == 30 || scan == 60 ? 0x80U : 0U) |
                                 (scan > 40 && scan % 4 < 2 ? 1U : 0U));
                return ScanRequest{};
              });
}

TEST(CalmScans, AnotherStateWithAnEventFindsTheInputsOfTheScanBefore) {
  // I0.0 goes off in the calm, ten scans before the state comes in which its falling edge is an event: there is none.
  const std::string text = "LD I0.7\nEU\nATCH 0, 1\nENI\nMEND\nINT 0\nLD SM0.0\nINCW VW0\nCRETI\nRETI\n";
  const Program program = readText("calm.awl", text);
  Simulator attached(program);
  setInputs(attached, 0);
  attached.scan();
  setInputs(attached, 0x80);
  attached.scan();
  ASSERT_EQ(attached.store().get(Reg::EventRoutine, 1), 1U);
  Concrete::Store state = attached.store();
  state.set(Reg::PhysicalInput, 7, 0, true);
  compareRuns(text, 40, [&](Simulator& s, int scan) {
    if (scan == 30) s.setStore(state);
    setInputs(s, scan < 20 ? 1 : 0);
    return ScanRequest{};
  });
}

TEST(CalmScans, ACharacterThatArrivesIsSeen) {
  Devices* kept[2] = {nullptr, nullptr};
  int turn = 0;
  compareRuns("LD SM0.1\nMOVB 16#09, SMB30\nLD I0.0\n= Q0.0\nMEND\n", 40, [&](Simulator& s, int scan) {
    Devices*& devices = kept[turn++ % 2];
    if (scan == 1) devices = &s.devices();  // asked for once, used later; the character stands in SMB2
    if (scan == 20) devices->ports.send(0, 'A');
    return ScanRequest{};
  });
}

TEST(CalmScans, SomebodyOutsideEndsThem) {
  compareRuns("LD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\nLD SM0.0\nINCW VW0\nMEND\n", 120, [](Simulator& s, int scan) {
    setInputs(s, scan % 5 == 0 ? 1 : 0);
    if (scan == 20) s.write(direct(Area::SM, Width::Byte, 4, 0), 3);  // bits that the CPU resets
    if (scan == 30) s.force(direct(Area::Q, Width::Bit, 0, 0), 1);
    if (scan == 40) s.unforce(direct(Area::Q, Width::Bit, 0, 0));
    if (scan == 50) s.stop();
    if (scan == 55) s.run();
    if (scan == 70) s.powerCycle();
    if (scan == 80) return ScanRequest{.events = {0}};
    if (scan == 90) s.startClock(Reg::PhaseHundred, 70);
    if (scan == 100) s.setStore(s.store());
    return ScanRequest{};
  });
}

TEST(CalmScans, AScanThatIsTooLongStopsTheCpu) {
  compareRuns("LD SM0.0\nINCW VW0\nMEND\n", 30,
              [](Simulator&, int scan) { return ScanRequest{.lengthUs = scan == 20 ? 700'000U : 10'000U}; });
}

}  // namespace
}  // namespace rungproof::test
