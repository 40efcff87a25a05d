// STY003: comments that hold program text. Instructions that a comment has swallowed are a warning: they are not in the
// program; what somebody has switched off is a note, one for neighbouring lines. Tested by its examples and
// tests/rules/comment_rules_test.cpp.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/comment/swallowed_text.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// The comment on the line of a network's heading is its title and stands in no list.
std::optional<Comment> titleComment(const SourceSet& sources, const Network& network) {
  if (network.form != Form::Stl || network.span.length == 0) return std::nullopt;
  const SourceFile& file = sources.file(network.span.file);
  const std::string_view text = file.text(network.span);
  const std::string_view line = text.substr(0, text.find('\n'));
  const std::size_t mark = line.find("//");
  if (mark == std::string_view::npos) return std::nullopt;
  return Comment{{network.span.file, network.span.offset + static_cast<std::uint32_t>(mark),
                  static_cast<std::uint32_t>(line.size() - mark)}};
}

class CommentedProgram {
 public:
  CommentedProgram(const Facts& facts, FindingSink& sink)
      : sources_(*facts.program().sources),
        sink_(sink),
        isName_([&facts](std::string_view name) { return facts.symbolNamed(name) != nullptr; }) {}

  void look(const Comment& comment) {
    const std::string_view text = sources_.text(comment.span);
    if (text.starts_with("//@") || text.starts_with("//!")) return;
    const CommentText code = codeInComment(text, isName_);
    if (code.kind == CommentedCode::Swallowed) swallowed(comment, code);
    if (code.kind == CommentedCode::Disabled) disabled(comment);
  }
  /// Reports what `look` has kept back.
  void flush() {
    if (lines_ == 0) return;
    sink_
        .report(first_, lines_ == 1 ? std::string("this comment is program text")
                                    : fmt::format("these {} comments are program text", lines_))
        .help = "remove it; old versions belong into the version control";
    lines_ = 0;
  }

 private:
  void swallowed(const Comment& comment, const CommentText& code) {
    const auto begin = static_cast<std::uint32_t>(code.begin);
    const Span span{comment.span.file, comment.span.offset + begin, comment.span.length - begin};
    Finding& finding = sink_.report(
        span, fmt::format("the comment has swallowed {}: the end of its line was lost, so {} no part of the program",
                          fmt::join(code.instructions, "; "), code.instructions.size() == 1 ? "it is" : "they are"));
    finding.severity = Severity::Warning;
    finding.help = "begin a new line in front of each instruction; if they are only described, write them in quotes";
  }

  void disabled(const Comment& comment) {
    const std::uint32_t line = sources_.position(comment.span).line;
    if (lines_ == 0 || first_.file != comment.span.file || lastLine_ + 1 != line) {
      flush();
      first_ = comment.span;
    }
    lastLine_ = line;
    ++lines_;
  }

  const SourceSet& sources_;
  FindingSink& sink_;
  std::function<bool(std::string_view)> isName_;
  Span first_{};  ///< of the neighbouring comments that are program text, not yet reported
  std::uint32_t lastLine_ = 0;
  int lines_ = 0;
};

void checkSty003(const Facts& facts, FindingSink& sink) {
  CommentedProgram comments(facts, sink);
  const SourceSet& sources = *facts.program().sources;
  for (const Pou& pou : facts.program().pous) {
    for (const Comment& comment : pou.comments) comments.look(comment);
    for (const Network& network : pou.networks) {
      if (const auto title = titleComment(sources, network)) comments.look(*title);
      for (const Comment& comment : network.comments) comments.look(comment);
    }
  }
  comments.flush();
}

}  // namespace

extern constexpr Rule sty003_program_in_comment = {
    .id = "STY003",
    .title = "Program text in a comment",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects =
        "instructions that a comment has swallowed because the end of its line was lost (a warning), and comments that "
        "are nothing but an instruction with its addresses (a note)",
    .why =
        "an instruction behind a comment is not in the program although everybody reads it as one; of one that was "
        "switched off nobody knows whether that had a reason",
    .bad = "Network 1\nLD I0.0\n= Q0.0\n// lamp test LD     I0.3=      Q0.5\n",
    .good = "Network 1\nLD I0.0\n= Q0.0\n// lamp test\nLD I0.3\n= Q0.5\n",
    .falsePositives = "instructions that a comment describes: write them in quotes or behind a colon",
    .peers = "SA0140; C4",
    .dialects = dialect::S7200,
    .standsAlone = true,
    .check = checkSty003,
};

}  // namespace rungproof
