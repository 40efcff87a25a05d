// Witnesses are as small as they can be made: no scan too many, and inputs that may have any value are marked.
#include "analysis/witness/witness_minimal.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

const char* const parallel =
    "Network 1\nLD I0.0\n= Q0.0\n"
    "Network 2\nLD I0.1\nO I0.2\n= Q0.1\n"
    "Network 3\nLD I0.3\n= Q0.2\n";

std::map<std::string, bool> lastScanOf(const Witness& witness) {
  std::map<std::string, bool> matters;
  const std::vector<PresetValue>& inputs = witness.scans.back().inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) matters[toString(inputs[i].operand)] = witness.matters.back()[i];
  return matters;
}

TEST(Witness, MarksInputsThatDoNotMatter) {
  const ProgramInput input = inputOf("//@ prove apart: never Q0.0 and Q0.1\n//@ reach third: Q0.2\n", parallel);
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  const ProofResult* result = resultNamed(run, "apart");
  ASSERT_TRUE(result != nullptr && result->witness);
  EXPECT_EQ(result->outcome, Outcome::Violated);
  EXPECT_EQ(result->witness->scanCount, 1U);
  std::map<std::string, bool> matters = lastScanOf(*result->witness);
  EXPECT_TRUE(matters["I0.0"]);
  EXPECT_FALSE(matters["I0.3"]);
  // One of the two contacts in parallel is needed; with it, the other one may be open or closed.
  EXPECT_NE(matters["I0.1"], matters["I0.2"]);
}

TEST(Witness, TableHidesIdleInputs) {
  const ProgramInput input = inputOf("//@ prove apart: never Q0.0 and Q0.1\n", parallel);
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  const ProofResult* result = resultNamed(run, "apart");
  ASSERT_TRUE(result != nullptr && result->witness);
  const std::vector<TraceSignal> signals = signalsThatMatter(input.program, *result);
  // The two inputs that matter, then the outputs of the property.
  ASSERT_EQ(signals.size(), 4U);
  EXPECT_EQ(signals[0].name, "I0.0");
  EXPECT_EQ(signals[2].name, "Q0.0");
  EXPECT_EQ(signals[3].name, "Q0.1");
}

// T32 counts inside the scan that enables it: 300 ms need a scan that lasts as long.
TEST(Witness, AScanLastsAsLongAsTheTimeThatPassesInIt) {
  const ProgramInput input = inputOf("//@ prove late: Q0.0 implies held(I0.0, 200ms)\n",
                                     "Network 1\nLD I0.0\nTON T32, 300\nNetwork 2\nLD T32\n= Q0.0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  const ProofResult* result = resultNamed(run, "late");
  ASSERT_TRUE(result != nullptr && result->witness);
  std::uint32_t length = 0;
  for (const ReplayScan& scan : result->witness->scans) length += scan.repeats * scan.lengthMs;
  EXPECT_GE(length, 300U);
}

// With the input filter an analog input is sampled once a scan (001:1812), so both comparisons see the same value;
// without it the input may rise between them.
TEST(Witness, AnalogInputsAreSampledOnceAScan) {
  const ProgramInput input = inputOf("//@ prove apart: never Q0.0 and Q0.1\n//@ prove low: Q0.0 implies AIW4 < 90\n",
                                     "Network 1\nLDW< AIW4, 100\n= Q0.0\nNetwork 2\nLDW> AIW4, 200\n= Q0.1\n");
  ProverOptions options = usualOptions();
  const ProofRun sampled = prove(input.program, input.properties, options);
  EXPECT_EQ(resultNamed(sampled, "apart")->outcome, Outcome::Proved);
  const ProofResult* low = resultNamed(sampled, "low");
  ASSERT_TRUE(low->outcome == Outcome::Violated && low->witness);
  const std::vector<TraceSignal> signals = signalsThatMatter(input.program, *low);
  const Trace trace = traceOf(input.program, options.choices, *low->witness, signals);
  ASSERT_EQ(trace.signals.at(0).name, "AIW4");
  const double value = trace.rows.back().values.at(0).value_or(0);
  EXPECT_TRUE(value >= 90 && value < 100) << value;

  ASSERT_TRUE(options.choices.set("analog-sampling", "each-read"));
  const ProofRun unfiltered = prove(input.program, input.properties, options);
  EXPECT_EQ(resultNamed(unfiltered, "apart")->outcome, Outcome::Violated);
}

// A built-in check's witness marks every input of its scans, the samples of analog inputs among them.
TEST(Witness, MarksAnalogInputsOfBuiltinChecks) {
  const ProgramInput input =
      inputOf("", "Network 1\nLD I0.0\nMOVW AIW2, VW0\n/I VW0, VW2\nNetwork 2\nLDW> AIW4, 5\n= Q0.0\n");
  ProverOptions options = usualOptions();
  options.checks.builtin = true;
  const ProofRun run = prove(input.program, input.properties, options);
  const auto division = std::find_if(run.results.begin(), run.results.end(),
                                     [](const ProofResult& r) { return r.builtin && r.builtin->rule->id == "ARI001"; });
  ASSERT_TRUE(division != run.results.end() && division->witness);
  ASSERT_EQ(division->witness->matters.size(), division->witness->scans.size());
  for (std::size_t i = 0; i < division->witness->scans.size(); ++i)
    EXPECT_EQ(division->witness->matters[i].size(), division->witness->scans[i].inputs.size());
  std::map<std::string, bool> matters = lastScanOf(*division->witness);
  EXPECT_TRUE(matters["I0.0"]);
  EXPECT_TRUE(matters["AIW2"]);  // 0 is the divisor that is not allowed
  EXPECT_FALSE(matters["AIW4"]);
}

// One interrupt of event 0 is needed, of the many that are given.
TEST(Witness, LeavesOutInterruptsThatAreNotNeeded) {
  const ProgramInput input = inputOf("//@ reach one: M0.0\n", "Network 1\nLD SM0.1\nATCH INT0, 0\nATCH INT1, 2\nENI\n",
                                     "INTERRUPT_BLOCK A:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nS M0.0, 1\n"
                                     "END_INTERRUPT_BLOCK\nINTERRUPT_BLOCK B:INT1\nBEGIN\nNetwork 1\nLD SM0.0\n"
                                     "INCW VW0\nEND_INTERRUPT_BLOCK\n");
  const Property& goal = input.properties.properties[0];
  const std::vector<Property> none;
  const Choices choices;
  const Judge judge(input.program, choices, none, goal);
  std::vector<ReplayScan> scans(1);
  for (const int event : {2, 0, 2, 0, 2}) scans[0].script.events.push_back({ScanPlace{}, event});
  std::optional<Witness> found = judge.witness(scans, std::nullopt);
  ASSERT_TRUE(found.has_value());
  const Witness small = minimised(judge, std::move(*found), 10, 5, 1);
  ASSERT_EQ(small.scans.size(), 1U);
  ASSERT_EQ(small.scans[0].script.events.size(), 1U);
  EXPECT_EQ(small.scans[0].script.events[0].event, 0);
}

// While a timer runs its input stays on and the other inputs do as they like: the scans of the wait are one stretch,
// as many as 4 s need that last 150 ms each at most; before them the input may rise, behind them is the scan that shows
// it.
TEST(Witness, ScansOfAWaitAreAlike) {
  const ProgramInput input = inputOf("//@ reach late: Q0.0\n",
                                     "Network 1\nLD I0.0\nTON T37, 40\nNetwork 2\nLD T37\nA I0.1\n= Q0.0\n"
                                     "Network 3\nLD I0.2\nA I0.3\nO I0.4\n= Q0.1\n");
  const std::vector<Property> none;
  const Choices choices;
  const Judge judge(input.program, choices, none, input.properties.properties[0]);
  std::mt19937 random(5);
  std::vector<ReplayScan> scans(40);
  for (ReplayScan& scan : scans) {
    scan.lengthMs = 100 + random() % 51;
    for (std::uint8_t bit = 0; bit < 5; ++bit) {
      Operand contact;
      contact.kind = OperandKind::Direct;
      contact.area = Area::I;
      contact.width = Width::Bit;
      contact.bit = bit;
      scan.inputs.push_back({contact, bit == 0 ? 1U : random() % 2});
    }
  }
  scans.back().inputs[1].value = 1;
  std::optional<Witness> found = judge.witness(scans, std::nullopt);
  ASSERT_TRUE(found.has_value());
  const Witness small = minimised(judge, std::move(*found), 10, 5, 1);
  EXPECT_LE(small.scans.size(), 3U);
  EXPECT_GE(small.milliseconds, 4000U);
  ASSERT_EQ(small.matters.size(), small.scans.size());
  for (std::size_t scan = 0; scan < small.scans.size(); ++scan) {
    EXPECT_TRUE(small.matters[scan][0]);
    for (const std::size_t other : {2U, 3U, 4U}) EXPECT_FALSE(small.matters[scan][other]) << scan << " " << other;
  }
}

// In the witnesses of programs with interrupts no event can be left out: without any one of them the run shows nothing.
TEST(Witness, EveryInterruptOfACorpusWitnessIsNeeded) {
  std::size_t events = 0;
  for (const char* name :
       {"defects/interrupt_byte.awl", "defects/blip_written_out.awl", "timers/interrupt_count.awl"}) {
    ProgramInput input;
    input.program = readProgram({std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/" + name});
    input.properties = readProperties(input.program, {}, lookupIn(input.program));
    const ProverOptions options = usualOptions();
    const ProofRun run = prove(input.program, input.properties, options);
    std::vector<Property> assumptions;
    for (const Property& property : input.properties.properties) {
      if (property.kind == PropertyKind::Assume) assumptions.push_back(property);
    }
    for (const ProofResult& result : run.results) {
      if (!result.witness) continue;
      const Judge judge(input.program, options.choices, assumptions, result.property);
      const Witness& witness = *result.witness;
      const Concrete::Store* initial = witness.initial ? &*witness.initial : nullptr;
      ASSERT_TRUE(judge.run(witness.scans, initial).shown) << name << " " << result.property.name;
      for (std::size_t scan = 0; scan < witness.scans.size(); ++scan) {
        for (std::size_t k = 0; k < witness.scans[scan].script.events.size(); ++k, ++events) {
          std::vector<ReplayScan> fewer = witness.scans;
          auto& list = fewer[scan].script.events;
          list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
          EXPECT_FALSE(judge.run(fewer, initial).shown) << name << " " << result.property.name << " scan " << scan + 1;
        }
      }
    }
  }
  EXPECT_GE(events, 3U);
}

TEST(Witness, LeavesOutScansThatAreNotNeeded) {
  // One scan off, one scan on; all others are padding.
  const ProgramInput input = inputOf("//@ reach on: Q0.0 and once(not Q0.0)\n", "Network 1\nLD I0.0\nO Q0.0\n= Q0.0\n");
  const Property& goal = input.properties.properties[0];
  const std::vector<Property> none;
  const Choices choices;
  const Judge judge(input.program, choices, none, goal);
  std::vector<ReplayScan> scans(10);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].inputs.push_back({direct(Area::I, Width::Bit, 0, 0), i == 6 ? 1U : 0U});
    scans[i].repeats = 5;
  }
  std::optional<Witness> found = judge.witness(scans, std::nullopt);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->scanCount, 31U);  // six times five scans off, then on
  const Witness small = minimised(judge, std::move(*found), 10, 5, 1);
  EXPECT_EQ(small.scanCount, 2U);
  ASSERT_FALSE(small.matters.empty());
  EXPECT_TRUE(small.matters[0][0]);
  EXPECT_TRUE(small.matters[1][0]);
}

TEST(Witness, ScansHaveAnEverydayLengthUnlessTheLengthMatters) {
  // The 10 ms timer T33 needs 300 ms: its bit comes in the scan that ends there, so the lengths before it must add up
  // to that (a timer started in scan 1 counts the time from then on); the scan in which the bit is read may last 10 ms.
  const ProgramInput input = inputOf("//@ reach late: T33\n//@ reach soon: Q0.0 and once(not Q0.0)\n",
                                     "Network 1\nLD I0.0\nTON T33, 30\nNetwork 2\nLD I0.1\n= Q0.0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  const ProofResult* soon = resultNamed(run, "soon");
  ASSERT_TRUE(soon != nullptr && soon->witness);
  for (const ReplayScan& scan : soon->witness->scans) EXPECT_EQ(scan.lengthMs, 10U);
  const ProofResult* late = resultNamed(run, "late");
  ASSERT_TRUE(late != nullptr && late->witness);
  EXPECT_GE(late->witness->milliseconds, 300U);
}

TEST(Witness, SaysWhichMemoryItStartsFrom) {
  // V0.0 drives the output at once; VW20 must be above 1000, which a high byte of at least
  // 4 does alone (1024), so its low byte is 0 in the end.
  const ProgramInput input = inputOf(
      "//@ initial retentive\n//@ prove bit: not Q0.0\n//@ prove word: not Q0.1 or not first_scan\n//@ prove none: not "
      "Q0.2\n",
      "Network 1\nLD V0.0\n= Q0.0\nNetwork 2\nLDW> VW20, 1000\n= Q0.1\nNetwork 3\nLDB> VB7, 3\nO I0.0\n= Q0.2\n");
  const ProverOptions options = usualOptions();
  const ProofRun run = prove(input.program, input.properties, options);
  const auto startOf = [&](const std::string& name) {
    const ProofResult* result = resultNamed(run, name);
    return result != nullptr && result->witness ? startText(input.program, options.choices, *result->witness)
                                                : "no witness";
  };
  EXPECT_EQ(startOf("bit"), "V0.0 = 1");
  EXPECT_TRUE(startOf("word").starts_with("VW20 = ")) << startOf("word");
  const int word = std::stoi(startOf("word").substr(7));
  EXPECT_GT(word, 1000);
  EXPECT_EQ(word % 256, 0);
}

TEST(Witness, AssumptionsStayKept) {
  // With the two limit switches excluding each other, neither is idle together with the other at any value.
  const ProgramInput input = inputOf("//@ assume limits: I0.1 xor I0.2\n//@ reach on: Q0.0\n",
                                     "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nA I0.2\n= Q0.1\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  const ProofResult* result = resultNamed(run, "on");
  ASSERT_TRUE(result != nullptr && result->witness);
  std::map<std::string, bool> matters = lastScanOf(*result->witness);
  EXPECT_TRUE(matters["I0.1"]);
  EXPECT_TRUE(matters["I0.2"]);
}

}  // namespace
}  // namespace rungproof::test
