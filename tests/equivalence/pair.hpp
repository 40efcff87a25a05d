// Pairs of programs with a truth that was reasoned out by hand: what the tests of this folder share. Programs are
// written in one line: ';' ends an instruction, '|' begins a network, '@SBR0:' or '@INT0:' begins a block.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "analysis/equivalence/equivalence.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/sides/map_file.hpp"

namespace rungproof::test {

struct Pair {
  const char* name;
  const char* before;
  const char* after;
  Equality truth;
  const char* why;
  const char* map = "";         ///< lines of a map, ';' between them
  const char* properties = "";  ///< of both programs
  std::uint32_t low = 1, high = 500;
  std::uint32_t latency = 0, settleMs = 0;
  bool steady = false;
};

inline std::string lines(std::string text) {
  for (char& c : text) {
    if (c == ';') c = '\n';
  }
  return text + '\n';
}

/// The text of an export.
inline std::string exportOf(const std::string& line) {
  std::string text, end;
  std::size_t begin = 0;
  int network = 0;
  const auto open = [&](const std::string& name) {
    text += end;
    const bool isMain = name.empty(), isInterrupt = name.starts_with("INT");
    const std::string kind = isMain ? "ORGANIZATION_BLOCK" : isInterrupt ? "INTERRUPT_BLOCK" : "SUBROUTINE_BLOCK";
    text += kind + ' ' + (isMain ? "MAIN:OB1" : name.substr(0, 3) + '_' + name.substr(3) + ':' + name) + '\n';
    end = "END_" + kind + '\n';
    network = 0;
  };
  const auto add = [&](const std::string& part) {
    text += "Network " + std::to_string(++network) + '\n' + lines(part);
  };
  open("");
  text += "BEGIN\n";
  while (begin <= line.size()) {
    const std::size_t stop = std::min(line.find_first_of("|@", begin), line.size());
    if (stop > begin) add(line.substr(begin, stop - begin));
    begin = stop + 1;
    if (stop < line.size() && line[stop] == '@') {
      const std::size_t colon = line.find(':', begin);
      open(line.substr(begin, colon - begin));
      text += "BEGIN\n";
      begin = colon + 1;
    }
  }
  return text + end;
}

inline ProgramInput pairSide(const std::string& name, const std::string& text, const std::string& properties) {
  ProgramInput input;
  input.program = readText(name, text);
  const std::uint32_t file = input.program.sources->add(name + ".prop", lines(properties));
  readPropertyText(file, input.program.sources->file(file).text(), 0, lookupIn(input.program), input.properties,
                   input.program.findings);
  for (const Finding& finding : input.program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  return input;
}

inline EquivalenceOptions optionsOf(const Pair& pair, const Program& before, const Program& after) {
  EquivalenceOptions options;
  options.prover.time = {pair.low, pair.high};
  options.prover.timeout = 60;
  options.latency = pair.latency;
  options.settleMs = pair.settleMs;
  options.steadyInputs = pair.steady;
  std::vector<Failure> failures;
  for (const MapLine& line : readMap("map", lines(pair.map), before, after, failures))
    EXPECT_TRUE(line.events ? options.pairs.addEvent(line.events->first, line.events->second)
                            : options.pairs.add(line.before, line.after, line.count))
        << line.line;
  for (const Failure& failure : failures) ADD_FAILURE() << failure.message;
  return options;
}

inline std::string equalityText(Equality equality) {
  return equality == Equality::Equal ? "EQUAL" : equality == Equality::Different ? "DIFFERENT" : "UNKNOWN";
}

}  // namespace rungproof::test
