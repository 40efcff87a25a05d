// The end of every command that judges a program: reports in all requested forms, and the exit code.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

#include "frontend/command/command.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace fs = std::filesystem;

Exit Context::fail(const Failure& failure) const {
  out.flush();
  print(err, failure);
  return Exit::Failed;
}

bool Context::write(const OutputRequest& output, std::string_view text) const {
  if (output.file.empty() || output.file == "-") {
    out << text;
    return static_cast<bool>(out);
  }
  // A reader of the file never sees half of it: it is written beside its place and then renamed.
  const fs::path target(output.file);
  fs::path part = target;
  part += fmt::format(".{}.part", ::getpid());
  std::error_code error;
  {
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.close();
    if (!stream) error = std::make_error_code(std::errc::io_error);
  }
  if (!error) fs::rename(part, target, error);
  if (!error) return true;
  std::error_code ignored;
  fs::remove(part, ignored);
  print(err, {fmt::format("'{}' cannot be written", output.file)});
  return false;
}

Exit finish(const Context& context, Report report) {
  std::erase_if(report.findings, [&](const Finding& finding) { return finding.severity < context.settings.level(); });
  sortFindings(report);
  Exit exit = exitOf(report);
  for (const OutputRequest& output : context.outputs) {
    const Reporter* reporter = reporterNamed(output.name);
    CHECK(reporter != nullptr, "formats are checked when the command line is read");
    std::ostringstream text;
    reporter->write(report, {context.color && output.file.empty(), context.settings.flag(Opt::Quiet)}, text);
    if (!context.write(output, text.view())) exit = Exit::Failed;
  }
  return exit;
}

}  // namespace rungproof
