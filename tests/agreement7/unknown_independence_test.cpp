// What a program does not depend on is the same whatever it is: random programs with one name or one data block that
// nobody knows are run twice, with other values there, on the same inputs. Every place that the unread code is said not
// to influence has to be the same in both runs after every scan. Prints its seed.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <regex>
#include <sstream>

#include "analysis/unread/unread_code.hpp"
#include "engine/simulator.hpp"
#include "engine/trace.hpp"
#include "frontend/input/project.hpp"
#include "tests/naive7/program_generator.hpp"

namespace rungproof {
namespace {

constexpr int scansOfARun = 12;

struct Case {
  std::string unknown, known;   ///< the text without what is not known, and with it
  std::uint32_t dataBlock = 0;  ///< whose contents are not known; 0: it is the name
};

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Networks begin behind statements that end a logic string.
std::vector<std::string> inNetworks(const std::vector<std::string>& lines, std::mt19937_64& random) {
  std::vector<std::string> result;
  for (const std::string& line : lines) {
    result.push_back(line);
    if ((line.starts_with("  = ") || line.starts_with("  T ")) && random() % 3 == 0) result.emplace_back("NETWORK");
  }
  return result;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// One operand that is read becomes a name: in one text without its row in the table, in the other an input.
std::optional<Case> withUnknownName(std::vector<std::string> lines, std::mt19937_64& random) {
  static const std::regex reads(R"(^  (A|AN|O|ON|X|L) (I|M|Q|IB|MB|QB|IW|MW|QW|ID|MD|QD) [0-9.]+ ;$)");
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (std::regex_match(lines[i], reads)) candidates.push_back(i);
  }
  if (candidates.empty()) return std::nullopt;
  const std::size_t at = candidates[random() % candidates.size()];
  std::smatch parts;
  std::regex_match(lines[at], parts, reads);
  const std::string operand = parts[2].str(), width = operand.substr(1);
  Case result;
  lines[at] = "  " + parts[1].str() + " I" + width + (width.empty() ? " 120.0 ;" : " 120 ;");
  result.known = joined(lines);
  lines[at] = "  " + parts[1].str() + " \"Unknown\" ;";
  result.unknown = joined(lines);
  return result;
}

/// DB2 with a type that no file defines.
Case withUnknownData(const std::vector<std::string>& lines) {
  Case result;
  result.dataBlock = 2;
  result.known = joined(lines);
  static const std::regex body(R"((DATA_BLOCK DB 2\n)(STRUCT[^]*?END_STRUCT ?;?)(\nBEGIN))");
  result.unknown = std::regex_replace(result.known, body, "$1\"Nobody\"$3");
  return result;
}

/// The first place that differs although nothing influences it; counts the places that were compared.
std::string firstDifference(const Case& one, std::uint64_t seed, std::size_t& compared) {
  const Program unknown = readText("x.awl", one.unknown);
  const Program known = readText("x.awl", one.known);
  if (unknown.findings.empty()) return "nothing is unknown:\n" + one.unknown;
  if (std::ranges::any_of(known.findings, [](const Finding& f) { return f.severity == Severity::Error; }))
    return "unreadable: " + known.findings.front().message;
  const UnreadCode unread(unknown);
  if (unread.isUnlimited()) return {};
  std::mt19937_64 random(seed);
  Program other = known;
  for (DataBlock& block : other.dataBlocks) {
    for (std::uint8_t& byte : block.bytes)
      if (block.number == one.dataBlock) byte = static_cast<std::uint8_t>(random());
  }
  std::vector<TraceSignal> signals;
  for (const TraceSignal& signal : touchedSignals(known)) {
    const bool isGiven = signal.operand.area == Area::I || signal.operand.area == Area::PI;
    if (!isGiven && unread.reasons(signal.operand).empty()) signals.push_back(signal);
  }
  compared += signals.size();
  Simulator first(known), second(other);
  for (int scan = 0; scan < scansOfARun; ++scan) {
    for (std::uint32_t byte = 0; byte < 8; ++byte) {
      const std::uint64_t value = random() & 0xFFU;
      first.write(direct(Area::I, Width::Byte, byte), value);
      second.write(direct(Area::I, Width::Byte, byte), value);
    }
    for (std::uint32_t byte = 120; one.dataBlock == 0 && byte < 124; ++byte) {
      first.write(direct(Area::I, Width::Byte, byte), random() & 0xFFU);
      second.write(direct(Area::I, Width::Byte, byte), random() & 0xFFU);
    }
    first.scan();
    second.scan();
    if (!first.isRunning() || !second.isRunning()) return {};  // what is not executed does not stop the CPU
    for (const TraceSignal& signal : signals) {
      if (first.read(signal.operand) != second.read(signal.operand))
        return "scan " + std::to_string(scan + 1) + ": " + toString(signal.operand) + " differs\n" + one.unknown;
    }
  }
  return {};
}

TEST(UnknownIndependence, WhatIsNotInfluencedIsTheSame) {
  const char* const given = std::getenv("RUNGPROOF_SEED");
  const std::uint64_t seed = given == nullptr ? 37150901 : std::strtoull(given, nullptr, 10);
  const char* const count = std::getenv("RUNGPROOF_PROGRAMS");
  const std::uint64_t programs = count == nullptr ? 400 : std::strtoull(count, nullptr, 10);
  std::size_t compared = 0, cases = 0;
  for (std::uint64_t i = 0; i < programs; ++i) {
    naive7::GeneratorChoices choices;
    choices.errors = false;
    choices.snippets = 3 + static_cast<int>(i % 8);
    std::mt19937_64 random(seed + i);
    const std::vector<std::string> lines =
        inNetworks(linesOf(naive7::ProgramGenerator(seed + i, choices).program()), random);
    const std::optional<Case> one = i % 4 == 3 ? std::optional(withUnknownData(lines)) : withUnknownName(lines, random);
    if (!one) continue;
    ++cases;
    const std::string wrong = firstDifference(*one, seed + i, compared);
    ASSERT_EQ(wrong, "") << "seed " << seed + i;
  }
  std::printf("seed %llu: %zu programs, %zu places compared\n", static_cast<unsigned long long>(seed), cases, compared);
  EXPECT_GT(compared, cases);
}

}  // namespace
}  // namespace rungproof
