// Shorthand of the reader's tests: read a text, show what came out on one line.
#pragma once

#include <fmt/format.h>

#include <string>

#include "frontend/input/project.hpp"
#include "ir/desc.hpp"

namespace rungproof {

inline std::string show(const Instruction& instruction) {
  std::string result(instruction.desc->stl);
  for (std::size_t i = 0; i < instruction.operands.size(); ++i)
    result += (i == 0 ? " " : ",") + toString(instruction.operands[i]);
  return result;
}

inline std::string show(const Network& network) {
  std::string result;
  for (const Instruction& instruction : network.instructions)
    result += (result.empty() ? "" : "; ") + show(instruction);
  return result;
}

/// Networks of a block separated by " | "; "!" marks incomplete ones.
inline std::string show(const Pou& pou) {
  std::string result;
  for (const Network& network : pou.networks) {
    if (&network != pou.networks.data()) result += " | ";
    result += (network.complete ? "" : "!") + show(network);
  }
  return result;
}

/// Rules of the findings with the text they point at: "SYN010<FOO> STY004<10.0>".
inline std::string findings(const Program& program) {
  std::string result;
  for (const Finding& finding : program.findings) {
    if (!result.empty()) result += ' ';
    result += fmt::format("{}<{}>", finding.rule, program.sources->text(finding.span));
  }
  return result;
}

/// Reads statement lines of a main program.
inline Program readLines(const std::string& lines, const ReadOptions& options = {}) {
  return readText("test.awl",
                  "ORGANIZATION_BLOCK MAIN:OB1\nTITLE=\nBEGIN\nNetwork 1\n" + lines + "\nEND_ORGANIZATION_BLOCK\n",
                  options);
}

}  // namespace rungproof
