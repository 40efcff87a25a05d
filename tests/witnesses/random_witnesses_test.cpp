// Random programs with random properties: every run that `prove --traces` writes is repeated by `sim --stimulus`, which
// finds the same values in every column; the run that `equiv --trace` writes is repeated by `sim` of both programs.
// RUNGPROOF_SEED chooses other programs, RUNGPROOF_WITNESSES how many of each family; a campaign of more than the usual
// number runs the executable alone.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/corpus/command_output.hpp"
#include "tests/differential/random_source.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/witnesses/random_sources.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

constexpr int usualPrograms = 20;  ///< of each family

int programsWanted() {
  const char* given = std::getenv("RUNGPROOF_WITNESSES");
  return given == nullptr ? usualPrograms : std::atoi(given);
}

/// Most witnesses are found at once: a campaign does not wait for what a search of half a second adds.
const char* timeoutWanted() { return programsWanted() > usualPrograms ? "100ms" : "500ms"; }

struct CommandEnd {
  int code;
  std::string out, err;
};

CommandEnd inProcess(std::vector<std::string> arguments) {
  std::istringstream in;
  std::ostringstream out, err;
  arguments.emplace_back("--isolated");
  const int code = runProgram(arguments, {in, out, err});
  return {code, out.str(), err.str()};
}

CommandEnd byExecutable(const std::vector<std::string>& arguments) {
  std::string line = std::string(RUNGPROOF_BINARY_DIR) + "/rungproof";
  for (const std::string& argument : arguments) line += " '" + argument + "'";
  const std::string out = outputOf(line + " --isolated; echo \"exit $?\"");
  const std::size_t at = out.rfind("exit ");
  return {std::atoi(out.c_str() + at + 5), out.substr(0, at), ""};
}

/// The programs of one campaign, in a folder of their own.
class Campaign {
 public:
  /// Proves, then repeats what was written.
  void prove(const RandomText& source, bool isByExecutable, bool isBuiltin) {
    const TemporaryFolder folder;
    const std::string program = folder.file(source.name, source.text), traces = folder.path("traces");
    const auto run = [&](std::vector<std::string> arguments) {
      arguments.insert(arguments.end(), source.options.begin(), source.options.end());
      return isByExecutable ? byExecutable(arguments) : inProcess(std::move(arguments));
    };
    std::vector<std::string> proof = {"prove", program, "--timeout", timeoutWanted(), "--traces", traces};
    if (isBuiltin) proof.emplace_back("--builtin");
    const CommandEnd proved = run(proof);
    EXPECT_NE(proved.code, 2) << proved.out << proved.err << source.text;
    ++programs;
    if (!fs::exists(traces)) return;
    for (const auto& entry : fs::directory_iterator(traces)) {
      if (entry.path().extension() != ".csv") continue;
      const std::string witness = entry.path().string();
      expectRepeated(run({"sim", program, "--stimulus", witness, "--expect", witness}), witness, source.text);
    }
  }

  /// Compares two versions, then repeats the run that tells them apart on both.
  void compare(const RandomText& source, const RandomText& other, bool isByExecutable) {
    const TemporaryFolder folder;
    const std::string before = folder.file("old/" + source.name, source.text);
    const std::string after = folder.file("new/" + other.name, other.text), difference = folder.path("difference.csv");
    const auto run = [&](std::vector<std::string> arguments) {
      arguments.insert(arguments.end(), source.options.begin(), source.options.end());
      return isByExecutable ? byExecutable(arguments) : inProcess(std::move(arguments));
    };
    const CommandEnd end = run({"equiv", before, after, "--timeout", timeoutWanted(), "--trace", difference});
    EXPECT_NE(end.code, 2) << end.out << end.err << source.text << other.text;
    ++programs;
    if (!fs::exists(difference)) return;
    for (const std::string side : {"old", "new"}) {
      const std::string& program = side == "old" ? before : after;
      expectRepeated(run({"sim", program, "--side", side, "--stimulus", difference, "--expect", difference}),
                     side + " side", source.text + other.text);
    }
  }

  std::size_t programs = 0, witnesses = 0;

 private:
  void expectRepeated(const CommandEnd& run, const std::string& witness, const std::string& text) {
    ++witnesses;
    // Where an error is what was asked for, the run ends with it, and nothing differs until then.
    const bool endsWithError = run.code == 1 && run.out.find("error[RUN002]") != std::string::npos &&
                               run.out.find("first difference") == std::string::npos;
    EXPECT_TRUE(run.code == 0 || endsWithError) << witness << '\n' << run.out << run.err << text;
    EXPECT_EQ(run.err.find("did not ask for"), std::string::npos) << witness << '\n' << run.err << text;
  }
};

using Make = std::function<RandomText(std::uint64_t)>;

void repeatRandom(const char* family, std::uint64_t first, const Make& make, bool isCompared = true) {
  Campaign proofs, comparisons;
  const std::uint64_t seed = testSeed() + first;
  const int count = programsWanted();
  for (int i = 0; i < count; ++i) {
    const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
    SCOPED_TRACE("RUNGPROOF_SEED=" + std::to_string(own - first));
    if (count > usualPrograms)
      std::fprintf(stderr, "\r%s: RUNGPROOF_SEED=%llu", family,
                   static_cast<unsigned long long>(own - first));  // where it ends
    const RandomText source = make(own);
    const bool isByExecutable = count > usualPrograms || i % 20 == 7;
    proofs.prove(source, isByExecutable, /*isBuiltin=*/i % 5 == 0);
    if (i % 4 == 0 && isCompared) comparisons.compare(source, otherVersion(source, own), isByExecutable);
  }
  std::printf("%s from seed %llu: %zu proofs with %zu witnesses, %zu comparisons with %zu\n", family,
              static_cast<unsigned long long>(seed), proofs.programs, proofs.witnesses, comparisons.programs,
              comparisons.witnesses);
  EXPECT_GE(proofs.witnesses, proofs.programs / 2);
}

TEST(RandomWitnesses, OfTheS7200AreRepeated) {
  repeatRandom("S7-200", 0, [](std::uint64_t seed) { return randomS7200Text(seed, Target{}); });
}

TEST(RandomWitnesses, OfTheSmartAreRepeated) {
  repeatRandom("S7-200 SMART", 500'000, [](std::uint64_t seed) {
    return randomS7200Text(seed, Target{*cpuNamed("ST60"), *editionNamed("smart-2.8")});
  });
}

TEST(RandomWitnesses, OfTheS7300And400AreRepeated) { repeatRandom("S7-300/400", 900'000, randomStep7Text); }

TEST(RandomWitnesses, OfIecProgramsAreRepeated) {
  repeatRandom("IEC 61131-3", 1'300'000, randomIecText, /*isCompared=*/false);
}

}  // namespace
}  // namespace rungproof::test
