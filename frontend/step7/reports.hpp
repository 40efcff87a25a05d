// The sinks of all files of a project, for those who look at all of them at once.
#pragma once

#include <map>
#include <string>

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
  /// A second place for the finding reported last.
  void relate(Span span, std::string message) {
    if (!program_.findings.empty()) program_.findings.back().related.push_back({span, std::move(message)});
  }

 private:
  SyntaxSink& sinkOf(Span span) { return sinks_.try_emplace(span.file, program_, span.file).first->second; }

  Program& program_;
  std::map<std::uint32_t, SyntaxSink> sinks_;
};

}  // namespace rungproof::step7
