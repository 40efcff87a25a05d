// The sinks of all files of a project, for those who look at all of them at once.
#pragma once

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::step7 {

/// Of a block without statements: it may write any memory by its address, so nothing is proved beside it.
inline constexpr const char* standInHelp =
    "nothing is proved of a program that runs it, since it may write any memory; name its source, or a stand-in of the "
    "same number and interface that does what you know of it, with L PIW 1000 for a word of any value: verdicts are "
    "about that";

class Reports {
 public:
  explicit Reports(Program& program) : program_(program) {}

  Program& program() { return program_; }
  /// The finding goes to the file of the span.
  void report(Syntax code, Span span, std::string message) { sinkOf(span).report(code, span, std::move(message)); }
  /// The same, in a block and a network. `help`: in place of that of the rule.
  void report(Syntax code, Span span, std::string message, const std::string& block, int network,
              const std::string& help = {}) {
    const std::size_t before = program_.findings.size();
    SyntaxSink& sink = sinkOf(span);
    sink.setPlace(block, network);
    sink.report(code, span, std::move(message));
    sink.setPlace({}, 0);
    if (!help.empty() && program_.findings.size() > before) program_.findings.back().help = help;
  }
  /// The same of something that may be missed at many places: the first one gets the finding, which counts the others.
  void reportOnce(Syntax code, Span span, std::string message, const std::string& block, int network,
                  const std::string& help = {}) {
    const auto [known, isNew] = missed_.try_emplace({code, message}, Missed{program_.findings.size(), {}});
    known->second.uses.emplace(span.file, span.offset);
    if (!isNew) return;
    report(code, span, std::move(message), block, network, help);
    if (program_.findings.size() == known->second.finding) missed_.erase(known);  // too many findings
  }
  /// Writes the counts into the findings; call when all is read.
  void countUses() {
    for (const auto& [what, missed] : missed_) {
      if (missed.uses.size() > 1)
        program_.findings[missed.finding].message += fmt::format(" ({} uses, this is the first)", missed.uses.size());
    }
  }
  /// A second place for the finding reported last.
  void relate(Span span, std::string message) {
    if (!program_.findings.empty()) program_.findings.back().related.push_back({span, std::move(message)});
  }

 private:
  SyntaxSink& sinkOf(Span span) { return sinks_.try_emplace(span.file, program_, span.file).first->second; }

  struct Missed {
    std::size_t finding;                                     ///< index in Program::findings
    std::set<std::pair<std::uint32_t, std::uint32_t>> uses;  ///< file and first byte
  };

  Program& program_;
  std::map<std::uint32_t, SyntaxSink> sinks_;
  std::map<std::pair<Syntax, std::string>, Missed> missed_;
};

}  // namespace rungproof::step7
