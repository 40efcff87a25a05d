// One line of a corpus program that cannot be read, whatever it was - an instruction, a heading, a declaration, a
// Network line, a row of data: nothing is found elsewhere that the intact program does not have. By default a part of
// the lines; RUNGPROOF_UNREAD=all takes every line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "analysis/lint/lint.hpp"
#include "analysis/read_errors.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

constexpr std::size_t stride = 3;  ///< lines between two that are spoilt in the short form

std::vector<std::filesystem::path> corpusPrograms() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(RUNGPROOF_SOURCE_DIR) + "/corpus")) {
    if (entry.path().extension() == ".awl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Where a rule speaks. Rules that join several places into one finding are told by block: the rest of a joined
/// finding may begin at another line.
std::set<std::string> places(const Linted& linted) {
  static const std::set<std::string> joining{"STK006", "OUT006"};
  const Program& program = linted.program;
  std::set<std::string> result;
  const auto add = [&](const Finding& finding) {
    const std::uint32_t line = program.sources->position(finding.span).line;
    result.insert(joining.contains(finding.rule) ? std::string(finding.rule)
                                                 : finding.rule + " line " + std::to_string(line));
  };
  for (const Finding& finding : program.findings) add(finding);
  for (const Finding& finding : runRules(*linted.facts, RuleSelection(), {})) add(finding);
  return result;
}

/// A source of the S7-300 holds its blocks together by words. Where one of them is lost, what stood in its frame is
/// told as unread: a title without a network, statements without a block, a block without its end.
bool isOfLostFrame(const std::string& place, const std::string& spoilt) {
  const bool isFrame = spoilt.starts_with("NETWORK") || spoilt.starts_with("ORGANIZATION_BLOCK") ||
                       spoilt.starts_with("END_ORGANIZATION_BLOCK");
  return isFrame && (place.starts_with("SYN020") || place.starts_with("SYN021") || place.starts_with("SYN044"));
}

class UnreadProgram : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(UnreadProgram, SetsOffNothingElsewhere) {
  const char* const wish = std::getenv("RUNGPROOF_UNREAD");
  const std::size_t step = wish != nullptr && std::string(wish) == "all" ? 1 : stride;
  const std::string folder = GetParam().parent_path().filename().string();
  const Cpu cpu = *cpuNamed(folder == "smart" ? "ST40" : folder == "s7300" ? "319-3" : "226");
  const Target target{cpu, usualEdition(cpu)};
  std::ifstream stream(GetParam(), std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (bytes.str().find('\0') != std::string::npos) return;  // UTF-16: the lines of its text are those of others
  std::vector<std::string> lines;
  std::istringstream text(bytes.str());
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_FALSE(lines.empty());
  const std::set<std::string> intact = places(Linted(bytes.str(), target));
  for (std::size_t at = std::hash<std::string>()(GetParam().filename().string()) % step; at < lines.size();
       at += step) {
    const std::size_t first = lines[at].find_first_not_of(" \t\r");
    if (first == std::string::npos || lines[at].compare(first, 2, "//") == 0) continue;
    std::string spoilt;
    for (std::size_t i = 0; i < lines.size(); ++i) spoilt += (i == at ? "FROB I0.0" : lines[i]) + "\n";
    const Linted linted(spoilt, target);
    const std::string own = " line " + std::to_string(at + 1);
    EXPECT_TRUE(std::ranges::any_of(linted.program.findings, isProgramReadError)) << own;
    for (const std::string& place : places(linted)) {
      const bool isRead = (place.starts_with("SYN") || place.starts_with("GRF")) && place.ends_with(own);
      EXPECT_TRUE(isRead || intact.contains(place) || isOfLostFrame(place, lines[at]))
          << place << " once '" << lines[at] << "' (" << own << ") cannot be read";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, UnreadProgram, ::testing::ValuesIn(corpusPrograms()), [](const auto& info) {
  std::string name = info.param.parent_path().filename().string() + "_" + info.param.stem().string();
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name + "_" + std::to_string(info.index);
});

}  // namespace
}  // namespace rungproof::testing
