// The end of every command that judges a program: reports in all requested forms, and the exit code.
#include <algorithm>
#include <array>
#include <ostream>
#include <streambuf>

#include "frontend/command.hpp"
#include "frontend/text/safe_text.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// Hands on what is written to a stream piece by piece: the report of a long program is longer than its text.
class PieceBuffer : public std::streambuf {
 public:
  explicit PieceBuffer(const TakePiece& take) : take_(take) { empty(); }

  /// Hands on the rest; whether every piece was taken.
  bool finish() { return handOn(); }

 protected:
  int_type overflow(int_type c) override {
    if (!handOn()) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    if (count <= epptr() - pptr()) return std::streambuf::xsputn(text, count);
    if (!handOn()) return 0;
    if (count <= epptr() - pptr()) return std::streambuf::xsputn(text, count);
    isTaken_ = take_({text, static_cast<std::size_t>(count)});
    return isTaken_ ? count : 0;
  }

 private:
  void empty() { setp(room_.data(), room_.data() + room_.size()); }
  bool handOn() {
    if (isTaken_ && pptr() > pbase()) isTaken_ = take_({pbase(), static_cast<std::size_t>(pptr() - pbase())});
    empty();
    return isTaken_;
  }

  const TakePiece& take_;
  std::array<char, 65536> room_;
  bool isTaken_ = true;
};

/// Bytes of a message beyond which messageText() cuts it, in every form of a report.
constexpr std::size_t longestMessage = 2000;

/// Forms that people read on a terminal or in a log. The others are files, and escape in their own way.
bool isForPeople(std::string_view form) {
  static constexpr std::array<std::string_view, 6> forms = {"human", "concise", "text", "markdown", "github", ""};
  return std::ranges::find(forms, form) != forms.end();
}

}  // namespace

Exit Context::fail(const Failure& failure) const {
  out.flush();
  print(err, failure);
  return Exit::Failed;
}

bool Context::write(const OutputRequest& output, std::string_view text, InputFile input) const {
  return write(
      output, [text](const TakePiece& take) { return take(text); }, input);
}

bool Context::write(const OutputRequest& output, const PiecewiseText& text, InputFile input) const {
  VisiblePieces visible(color && output.file.empty() ? VisiblePieces::Colors::Kept : VisiblePieces::Colors::Hidden);
  const PiecewiseText shown = [&](const TakePiece& take) {
    return text([&](std::string_view piece) { return take(visible.next(piece)); }) && take(visible.rest());
  };
  const PiecewiseText& written = isForPeople(output.name) ? shown : text;
  if (output.file.empty() || output.file == "-")
    return written([&](std::string_view piece) { return static_cast<bool>(out << piece); });
  out.flush();
  const std::optional<Failure> failure = writeOutputFile(output.file, written, input);
  if (!failure) return true;
  if (!failure->message.empty()) print(err, *failure);
  hasLostOutput = true;
  return false;
}

Exit finish(const Context& context, Report report) {
  std::erase_if(report.findings, [&](const Finding& finding) { return finding.severity < context.settings.level(); });
  for (Finding& finding : report.findings) {
    if (finding.message.size() > longestMessage) finding.message = messageText(finding.message);
    if (finding.help.size() > longestMessage) finding.help = messageText(finding.help);
  }
  sortFindings(report);
  if (!report.failLevel || context.settings.isSet(Opt::FailLevel)) report.failLevel = context.settings.failLevel();
  report.exitsZero = context.settings.flag(Opt::ExitZero);
  Exit exit = exitOf(report);
  for (const OutputRequest& output : context.outputs) {
    const Reporter* reporter = reporterNamed(output.name);
    CHECK(reporter != nullptr, "formats are checked when the command line is read");
    const ReportStyle style{context.color && output.file.empty(), context.settings.flag(Opt::Quiet),
                            context.settings.flag(Opt::Verbose)};
    const bool isWritten = context.write(output, [&](const TakePiece& take) {
      PieceBuffer pieces(take);
      std::ostream text(&pieces);
      reporter->write(report, style, text);
      return pieces.finish();
    });
    if (!isWritten) exit = Exit::Failed;
  }
  return exit;
}

}  // namespace rungproof
