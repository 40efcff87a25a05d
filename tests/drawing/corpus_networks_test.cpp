// Every STL network of the corpus: drawn as ladder and as FBD and lowered again to the same instructions, or with a
// reason why it has no picture. Outside the programs with faults, and of the dialect without networks, the only reason
// is a second rung.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "frontend/input/project.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/drawing/equality.hpp"
#include "tests/drawing/networks.hpp"

namespace rungproof::testing {
namespace {

struct NetworkPlace {
  std::string text;  ///< "timers/blinker.awl MAIN 3"
  const Network* network;
};

/// The programs of the corpus, read once.
const std::vector<std::pair<std::string, Program>>& corpus() {
  static const std::vector<std::pair<std::string, Program>> programs = [] {
    const std::filesystem::path folder = std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus";
    std::vector<std::string> files;
    for (const std::filesystem::path& file : test::corpusFiles()) {
      if (file.extension() != ".xml") files.push_back(file.string());
    }
    std::vector<std::pair<std::string, Program>> result;
    for (const std::string& file : files) {
      result.emplace_back(std::filesystem::relative(file, folder).string(), readProgram(expandFolders({file})));
      result.back().second.number();
    }
    return result;
  }();
  return programs;
}

/// The networks of one family: drawings of the S7-300 are not read back.
std::vector<NetworkPlace> networks(bool ofStep7 = false) {
  std::vector<NetworkPlace> result;
  for (const auto& [file, program] : corpus()) {
    if (file.starts_with("s7300/") != ofStep7) continue;
    for (const Pou& pou : program.pous) {
      for (const Network& network : pou.networks) {
        if (network.isStructured) continue;  // a statement of SCL is shown as its text
        if (network.complete && !network.instructions.empty())
          result.push_back({fmt::format("{} {} {}", file, pou.name, network.number), &network});
      }
    }
  }
  return result;
}

bool mayBeFaulty(std::string_view place) {
  return place.starts_with("faulty/") ||
         place.starts_with("older/");  // faults of the stack; a dialect without networks
}

Target targetOf(std::string_view place) {
  return place.starts_with("smart/") ? Target{s7200Cpu("ST60"), Edition::Smart28} : Target{};
}

TEST(CorpusNetworks, EveryNetworkHasAPictureOrAReason) {
  std::size_t all = 0, ladder = 0, fbd = 0, neither = 0;
  for (const NetworkPlace& place : networks()) {
    const Raised asLadder = raise(*place.network, Form::Ladder, targetOf(place.text)),
                 asFbd = raise(*place.network, Form::Fbd, targetOf(place.text));
    ++all;
    ladder += asLadder.drawing ? 1 : 0;
    fbd += asFbd.drawing ? 1 : 0;
    EXPECT_NE(asLadder.drawing.has_value(), !asLadder.reason.empty()) << place.text;
    EXPECT_NE(asFbd.drawing.has_value(), !asFbd.reason.empty()) << place.text;
    if (asLadder.drawing || asFbd.drawing) continue;
    ++neither;
    if (mayBeFaulty(place.text) || place.text.starts_with("iec/")) continue;  // structured text has no rungs
    EXPECT_NE(asFbd.reason.find("begins a second rung"), std::string::npos) << place.text << ": " << asFbd.reason;
  }
  RecordProperty("networks", static_cast<int>(all));
  fmt::print("{} networks: {} as ladder, {} as FBD, {} as neither\n", all, ladder, fbd, neither);
  EXPECT_GE(all, 200U);
}

TEST(CorpusNetworks, ThoseOfTheSecondFamilyHaveAPictureOrAReason) {
  const Target target{*cpuNamed("319-3"), usualEdition(*cpuNamed("319-3"))};
  std::size_t all = 0, drawn = 0;
  for (const NetworkPlace& place : networks(true)) {
    for (const Form form : {Form::Ladder, Form::Fbd}) {
      const Raised raised = raise(*place.network, form, target);
      ++all;
      drawn += raised.drawing ? 1 : 0;
      EXPECT_NE(raised.drawing.has_value(), !raised.reason.empty()) << place.text;
    }
  }
  fmt::print("{} of {} drawings of the S7-300 exist\n", drawn, all);
  EXPECT_GE(all, 120U);
  EXPECT_GE(drawn * 4, all * 3);
}

TEST(CorpusNetworks, ComeBackAsTheSameInstructions) {
  std::size_t same = 0, other = 0;
  for (const NetworkPlace& place : networks()) {
    for (const Form form : {Form::Ladder, Form::Fbd}) {
      const Raised raised = raise(*place.network, form, targetOf(place.text));
      if (!raised.drawing) continue;
      const Lowered result = lower(*raised.drawing);
      ASSERT_FALSE(result.fault) << place.text;
      const bool joinsAtItsEnd = place.text.starts_with("smart/wide_interlock");  // ladders join where they can
      if (!mayBeFaulty(place.text) && !joinsAtItsEnd) {
        EXPECT_EQ(textOf(result.instructions), textOf(place.network->instructions)) << place.text;
      }
      const std::string differs = difference(result.instructions, place.network->instructions, targetOf(place.text));
      EXPECT_TRUE(differs.empty() || differs == "pointers") << place.text << ": " << differs;
      (textOf(result.instructions) == textOf(place.network->instructions) ? same : other) += 1;
    }
  }
  fmt::print("{} drawings come back as they were, {} otherwise\n", same, other);
}

TEST(CorpusNetworks, DrawingsDoWhatTheNetworksDo) {
  std::size_t proven = 0, pointers = 0;
  for (const NetworkPlace& place : networks()) {
    for (const Form form : {Form::Ladder, Form::Fbd}) {
      const Raised raised = raise(*place.network, form, targetOf(place.text));
      if (!raised.drawing) continue;
      std::vector<std::uint32_t> positions;
      for (const Element& element : raised.drawing->elements) positions.push_back(element.instruction);
      const std::string result =
          difference(*raised.drawing, place.network->instructions, positions, targetOf(place.text));
      if (result == "pointers") {
        ++pointers;
        continue;
      }
      EXPECT_EQ(result, "") << place.text;
      ++proven;
    }
  }
  fmt::print("{} drawings proved equal, {} with pointers not asked\n", proven, pointers);
  EXPECT_GT(proven, 300U);
}

}  // namespace
}  // namespace rungproof::testing
