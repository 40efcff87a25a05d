// The end of every command that judges a program: reports in all requested forms, and the exit code.
#include <algorithm>
#include <ostream>
#include <sstream>

#include "frontend/command.hpp"
#include "ir/check.hpp"

namespace rungproof {

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
  if (output.file.empty() || output.file == "-")
    return text([&](std::string_view piece) { return static_cast<bool>(out << piece); });
  out.flush();
  const std::optional<Failure> failure = writeOutputFile(output.file, text, input);
  if (!failure) return true;
  if (!failure->message.empty()) print(err, *failure);
  hasLostOutput = true;
  return false;
}

Exit finish(const Context& context, Report report) {
  std::erase_if(report.findings, [&](const Finding& finding) { return finding.severity < context.settings.level(); });
  sortFindings(report);
  if (!report.failLevel || context.settings.isSet(Opt::FailLevel)) report.failLevel = context.settings.failLevel();
  report.exitsZero = context.settings.flag(Opt::ExitZero);
  Exit exit = exitOf(report);
  for (const OutputRequest& output : context.outputs) {
    const Reporter* reporter = reporterNamed(output.name);
    CHECK(reporter != nullptr, "formats are checked when the command line is read");
    std::ostringstream text;
    reporter->write(
        report,
        {context.color && output.file.empty(), context.settings.flag(Opt::Quiet), context.settings.flag(Opt::Verbose)},
        text);
    if (!context.write(output, text.view())) exit = Exit::Failed;
  }
  return exit;
}

}  // namespace rungproof
