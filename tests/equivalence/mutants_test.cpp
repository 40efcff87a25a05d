// Planted faults of corpus programs as pairs: a fault that changes the outputs is DIFFERENT, with a run that the engine
// has made on both; one that is called EQUAL drives the same outputs in random runs of the engine as well.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <random>
#include <set>

#include "analysis/read_errors.hpp"
#include "analysis/selfcheck/fault.hpp"
#include "analysis/witness/run_space.hpp"
#include "engine/replay.hpp"
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

constexpr int randomScans = 400;
constexpr int randomRuns = 25;

/// What runs of a program and its faults vary: the inputs that it names, and the events that it attaches.
struct Stimuli {
  explicit Stimuli(const Program& program) : inputs(runSpaceOf(program, {}, {}, {1, 500}).inputs) {
    for (const Pou& pou : program.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          if (instruction.desc->stl == "ATCH" && instruction.operands[1].kind == OperandKind::Constant)
            events.insert(static_cast<int>(instruction.operands[1].value));
        }
      }
    }
  }

  std::vector<RunSpace::Input> inputs;
  std::set<int> events;
};

/// The outputs at the end of every scan of one random run, the same stimuli for the same seed.
std::vector<std::uint64_t> randomRun(const Program& program, const Stimuli& stimuli, const Choices& choices,
                                     std::uint32_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint64_t> values(stimuli.inputs.size());
  std::vector<ReplayScan> scans;
  for (int k = 0; k < randomScans; ++k) {
    ReplayScan& scan = scans.emplace_back();
    scan.lengthMs = random() % 4 == 0 ? 500 : 1 + static_cast<std::uint32_t>(random() % 60);
    if (!values.empty() && random() % 3 == 0) {
      const std::size_t i = random() % values.size();
      const bool isSmall = random() % 2 == 0;
      values[i] = stimuli.inputs[i].width == 1 ? values[i] ^ 1U : isSmall ? random() % 64 : random();
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (const ScanInput& input : stimuli.inputs[i].operands)
        scan.inputs.push_back({input.operand, input.valueIn(values[i])});
    }
    scan.script.needsCauses = true;
    for (const int event : stimuli.events) {
      if (random() % 8 == 0) scan.script.events.push_back({{}, event});
    }
  }
  std::vector<std::uint64_t> outputs;
  replay(program, choices, scans, nullptr, [&](const Concrete::Store& state, std::size_t) {
    for (std::uint32_t byte = 0; byte < 16; byte += 4) outputs.push_back(state.load(Area::Q, byte * 8, 32));
    for (std::uint32_t byte = 0; byte < 32; byte += 4) outputs.push_back(state.load(Area::AQ, byte * 8, 32));
    outputs.push_back(state.get(Reg::Running, 0));
    return true;
  });
  return outputs;
}

/// What became of the faults of one program. Those that are open after `seconds` get `patience` seconds.
struct Tally {
  int different = 0, same = 0;
  std::vector<std::string> open;
};

Tally tallyOf(const std::filesystem::path& file, double seconds, double patience, int runs) {
  Tally tally;
  const Program program = readProgram({file.string()});
  const Stimuli stimuli(program);
  EquivalenceOptions options;
  const Choices& choices = options.prover.choices;
  for (const Fault& fault : faultsOf(program)) {
    Program mutant = planted(program, fault);
    mutant.number();
    options.prover.timeout = seconds;
    Equivalence found = compareBehaviour({&program, {}}, {&mutant, {}}, options);
    if (found.equality == Equality::Unknown && patience > seconds) {
      options.prover.timeout = patience;
      found = compareBehaviour({&program, {}}, {&mutant, {}}, options);
    }
    const std::string where =
        fmt::format("{}: {}, {}", file.filename().string(), faultKindName(fault.kind), fault.text);
    EXPECT_TRUE(found.disagreements.empty()) << where;
    if (found.equality == Equality::Unknown)
      tally.open.push_back(fmt::format("{}: {}", where, fmt::join(found.notes, "; ")));
    if (found.equality == Equality::Different) {
      EXPECT_TRUE(found.run.has_value()) << where;
      ++tally.different;
    }
    if (found.equality != Equality::Equal) continue;
    ++tally.same;
    for (int seed = 1; seed <= runs; ++seed) {
      const auto one = static_cast<std::uint32_t>(seed);
      EXPECT_EQ(randomRun(program, stimuli, choices, one), randomRun(mutant, stimuli, choices, one))
          << where << ", seed " << seed;
      if (testing::Test::HasFailure()) break;
    }
  }
  return tally;
}

}  // namespace

class FaultsOf : public testing::TestWithParam<const char*> {};

TEST_P(FaultsOf, AreDifferentOrDoNothing) {
  const std::filesystem::path file = std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/" + GetParam();
  ASSERT_TRUE(std::filesystem::exists(file));
  const Tally tally = tallyOf(file, 30, 30, randomRuns);
  EXPECT_GT(tally.different, 0);
  for (const std::string& fault : tally.open) ADD_FAILURE() << "undecided: " << fault;
}

INSTANTIATE_TEST_SUITE_P(Corpus, FaultsOf,
                         testing::Values("interlocks/star_delta.awl", "interlocks/reversing.awl",
                                         "interlocks/press_two_hand.awl"),
                         [](const testing::TestParamInfo<const char*>& info) {
                           return std::filesystem::path(info.param).stem().string();
                         });

/// RUNGPROOF_FAULTS=all: the faults of every program of the corpus, each one that is called EQUAL with 100,000 random
/// scans; RUNGPROOF_FAULTS=NAME of one program. Otherwise of a few small ones.
TEST(FaultsOfTheCorpus, AreDifferentOrDoNothing) {
  const char* given = std::getenv("RUNGPROOF_FAULTS");
  const std::string wanted = given == nullptr ? "" : given;
  const bool isFull = !wanted.empty();
  const std::vector<std::string> few = {"guard_door.awl", "blinker.awl", "hoist.awl"};
  std::set<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(RUNGPROOF_SOURCE_DIR) + "/corpus")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().parent_path().filename() == "s7300") continue;  // the faults are those of S7-200 instructions
    const bool isWanted = isFull ? (wanted == "all" || wanted == name) && entry.path().extension() == ".awl"
                                 : std::ranges::find(few, name) != few.end();
    if (isWanted) files.insert(entry.path());
  }
  int different = 0, same = 0, programs = 0;
  std::size_t open = 0;
  for (const std::filesystem::path& file : files) {
    if (hasReadErrors(readProgram({file.string()}))) continue;
    const Tally tally = tallyOf(file, isFull ? 4 : 10, isFull ? 20 : 10, isFull ? 100'000 / randomScans : randomRuns);
    ++programs;
    different += tally.different;
    same += tally.same;
    open += tally.open.size();
    fmt::print("{}: {} different, {} equal, {} undecided\n", file.filename().string(), tally.different, tally.same,
               tally.open.size());
    for (const std::string& fault : tally.open) fmt::print("  undecided: {}\n", fault);
    std::fflush(stdout);
  }
  fmt::print("{} programs: {} different, {} equal, {} undecided\n", programs, different, same, open);
  EXPECT_GE(programs, isFull ? 1 : 3);
  if (!isFull) {
    EXPECT_GT(different, 0);
    EXPECT_EQ(open, 0U);
  }
}

}  // namespace rungproof::test
