// Mutants of every instruction of IEC 61131-3 are tried against random programs beside plain C++, and statements
// with stated results. It fails when an instruction is reached by no test or has no mutant that is noticed, or when
// fewer than 90 % of all mutants are noticed. "test_mutation_iec ADD" tries one mnemonic, or those that fit a pattern,
// and prints each mutant.
#include <fmt/format.h>
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/cell_value.hpp"
#include "engine/start_up.hpp"
#include "engine/trace.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project.hpp"
#include "ir/families/run.hpp"
#include "ir/iec/isa.hpp"
#include "tests/iec/random_block_program.hpp"
#include "tests/iec/random_iec_program.hpp"
#include "tests/iec/stated_results.hpp"
#include "tests/mutation/mutated.hpp"
#include "tests/mutation/trial.hpp"

namespace rungproof::mutation {
namespace {

struct Silent final : Outside {
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};

struct PlainHooks {
  template <class S>
  void before(S&, const FlowStep&) {
    Mutation::instance().beginInstruction();
  }
  template <class S>
  void callWithoutBody(S&, const Instruction&) {}
  template <class S>
  void freshLocal(S&, std::uint32_t, std::uint32_t) {}
};

/// A program on the mutated domain.
class MutatedRun {
 public:
  explicit MutatedRun(const std::string& text)
      : program_(readText("main.st", text)), lookup_(lookupIn(program_)), plan_(program_) {
    EXPECT_TRUE(
        std::ranges::none_of(program_.findings, [](const Finding& f) { return f.severity == Severity::Error; }));
    memory_ = powerUpState(plan_, choicesFor(program_.target, Choices{}));
  }
  void set(const std::string& name, double value) {
    const Operand at = placeOf(name);
    const TraceSignal signal = signalOf(program_, at);
    setCell(memory_, at, valueOf(value, signal.type, signal.width()));
  }
  double get(const std::string& name) const {
    const Operand at = placeOf(name);
    const TraceSignal signal = signalOf(program_, at);
    return numberOf(cellValue(memory_, at), signal.type, signal.width());
  }
  std::string text(const std::string& name) const {
    Operand at = placeOf(name + ".length");
    std::string characters(cellValue(memory_, at), ' ');
    for (char& c : characters) {
      ++at.offset;
      c = static_cast<char>(cellValue(memory_, at));
    }
    return characters;
  }
  /// `ms`: since the start of the scan before.
  void scan(std::uint32_t ms) {
    Silent outside;
    Mutated domain(outside);
    Mutated::Store state(memory_);
    Machine<Mutated> machine(domain, state, plan_);
    memory_.set(Reg::LastScan, 0, ms, true);
    Mutation::instance().watch({&machine.current, &machine.frame, &machine.inInterrupt});
    PlainHooks hooks;
    Scan<Mutated, PlainHooks> scan(machine, hooks, 100000);
    scan.program();
    Mutation::instance().watch({});
  }

 private:
  Operand placeOf(const std::string& name) const {
    const std::optional<Operand> operand = lookup_(name);
    EXPECT_TRUE(operand.has_value()) << name;
    return operand.value_or(direct(Area::V, Width::Bit, 0));
  }

  Program program_;
  OperandLookup lookup_;
  Plan plan_;
  Concrete::Store memory_;
};

class BlockCase : public testing::Test {
 public:
  explicit BlockCase(std::uint64_t seed) : seed_(seed) {}
  void TestBody() override {
    iec_naive::BlockProgram made(seed_);
    MutatedRun run(made.text());
    iec_naive::State state;
    for (const char* const name : {"m0.by", "m1.by"}) state.whole[name] = 2;
    std::uint32_t ms = 0;
    for (int scan = 0; scan < 12; ++scan) {
      for (const char* const name : iec_naive::BlockProgram::inputs) {
        state.whole[name] = made.pick(0, 1);
        run.set(name, static_cast<double>(state.whole[name]));
      }
      run.scan(ms);
      made.scan(state);
      ms = static_cast<std::uint32_t>(made.pick(1, 40));
      state.now += ms;
      for (const char* const name : iec_naive::BlockProgram::truths) ASSERT_EQ(run.get(name), state.whole[name] != 0);
      for (const char* const name : iec_naive::BlockProgram::wholes)
        ASSERT_EQ(run.get(name), static_cast<double>(state.whole[name]));
      for (const char* const name : iec_naive::BlockProgram::texts) ASSERT_EQ(run.text(name), state.text[name]);
      for (const char* const name : iec_naive::BlockProgram::reals) {
        const double ours = run.get(name), theirs = state.real[name];
        ASSERT_TRUE(ours == theirs || (std::isnan(ours) && std::isnan(theirs)));
      }
    }
  }

 private:
  std::uint64_t seed_;
};

class PlainCase : public testing::Test {
 public:
  explicit PlainCase(std::uint64_t seed) : seed_(seed) {}
  void TestBody() override {
    iec_random::IecProgram made(seed_);
    MutatedRun run(made.text());
    iec_random::State state;
    for (int scan = 0; scan < 5; ++scan) {
      for (const auto& [name, type] : made.inputs_) {
        state[name] = iec_random::wrapped(made.pick(-40000, 40000), *type);
        run.set(name, static_cast<double>(state[name]));
      }
      run.scan(10);
      made.scan(state);
      for (const auto& [name, type] : made.variables_) ASSERT_EQ(run.get(name), static_cast<double>(state[name]));
    }
  }

 private:
  std::uint64_t seed_;
};

class StatedResult : public testing::Test {
 public:
  explicit StatedResult(const iec_stated::Result& row) : row_(row) {}
  void TestBody() override {
    MutatedRun run(iec_stated::programOf(row_));
    run.scan(0);
    ASSERT_EQ(run.get("r"), row_.value) << row_.statements;
  }

 private:
  const iec_stated::Result& row_;
};

template <class Case, class What>
void registerCase(const char* suite, std::size_t number, What&& what) {
  testing::RegisterTest(suite, fmt::format("Case{}", number).c_str(), nullptr, nullptr, __FILE__, __LINE__,
                        [what]() -> testing::Test* { return new Case(what()); });
}

/// The sites of the frame that all families share are tried with the others.
bool isFrame(const std::string& file) {
  return file == "guarded_run.hpp" || file == "flow_walk.hpp" || file == "scan.hpp" || file == "machine.hpp";
}

int judge(const std::vector<std::string>& tests, const std::string& only) {
  const std::span<const Desc> all = iecInstructions().all();
  std::vector<Candidate> candidates;
  for (const auto& [site, reachedBy] : Mutation::instance().sites()) {
    const std::string mnemonic(all[site.opcode].stl);
    if (!only.empty() && fnmatch(only.c_str(), mnemonic.c_str(), 0) != 0) continue;
    if (isFrame(Mutation::instance().fileName(site)) && site.op != Op::Whole) continue;
    const int changes = site.op == Op::Whole ? 1 : static_cast<int>(changesOf(site.op).size());
    for (int change = 1; change <= changes; ++change)
      candidates.push_back({{site, static_cast<std::uint8_t>(change)}, &reachedBy});
  }
  const std::vector<Verdict> verdicts =
      only.empty() ? tryChosenMutants(candidates, tests) : tryMutants(candidates, tests);
  std::vector<int> noticedOf(all.size(), 0);
  int noticed = 0, tried = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (verdicts[i] == Verdict::LeftOut) continue;
    ++tried;
    const Site& site = candidates[i].mutant.site;
    const bool isNoticed = verdicts[i] == Verdict::Noticed;
    noticed += isNoticed ? 1 : 0;
    noticedOf[site.opcode] += isNoticed ? 1 : 0;
    if (only.empty()) continue;
    const Mutation& mutation = Mutation::instance();
    fmt::print("{}\t{} {} line {}:{}\t{}\t{}: {}\n", all[site.opcode].stl, mutation.fileName(site),
               mutation.functionName(site), site.line, site.column, opName(site.op),
               changesOf(site.op)[static_cast<std::size_t>(candidates[i].mutant.change - 1)],
               isNoticed ? "noticed" : "unnoticed");
  }
  const double share = 100.0 * noticed / std::max(tried, 1);
  fmt::print("{} of {} mutants: {} noticed ({:.2f} %)\n", tried, candidates.size(), noticed, share);
  if (!only.empty()) return 0;
  int problems = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    // A block without text gives what its surroundings say.
    const bool isOutside = all[i].control == Control::LabelMark || all[i].stl.starts_with("ANY");
    if (isOutside || noticedOf[i] > 0) continue;
    fmt::print("{}: no mutant is noticed\n", all[i].stl);
    ++problems;
  }
  return problems + (share < 90 ? 1 : 0);
}

}  // namespace
}  // namespace rungproof::mutation

int main(int argc, char** argv) {
  using namespace rungproof;
  using namespace rungproof::mutation;
  testing::GTEST_FLAG(brief) = true;
  testing::InitGoogleTest(&argc, argv);
  for (std::size_t i = 0; i < 40; ++i) registerCase<BlockCase>("Block", i, [i] { return std::uint64_t{9100 + i}; });
  for (std::size_t i = 0; i < 40; ++i) registerCase<PlainCase>("Plain", i, [i] { return std::uint64_t{9300 + i}; });
  const auto& rows = iec_stated::results();
  for (std::size_t i = 0; i < rows.size(); ++i)
    registerCase<StatedResult>("Stated", i, [&row = rows[i]]() -> const iec_stated::Result& { return row; });
  const std::vector<std::string> tests = recordTests();
  if (tests.empty()) return 1;
  return judge(tests, argc > 1 ? argv[1] : "") == 0 ? 0 : 1;
}
