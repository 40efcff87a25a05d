// Findings of the readers.
#include "frontend/stl/syntax_sink.hpp"

#include <fmt/format.h>

namespace rungproof {

std::string excerpt(std::string_view text) {
  constexpr std::size_t limit = 40;
  std::size_t length = std::min(text.size(), limit);
  while (length < text.size() && length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  std::string result(text.substr(0, length));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  if (length < text.size()) result += "...";
  return result;
}

void SyntaxSink::countOnly(Span span) {
  const SyntaxMessage& row = syntaxMessage(Syntax::TooMany);
  if (uncounted_++ == 0) {
    limitFinding_ = program_.findings.size();
    Finding finding;
    finding.rule = row.id;
    finding.severity = row.severity;
    finding.span = span;
    finding.help = row.help;
    program_.findings.push_back(std::move(finding));
  }
  program_.findings[limitFinding_].message = fmt::format("{} further problem{} from here on {} not listed", uncounted_,
                                                         uncounted_ == 1 ? "" : "s", uncounted_ == 1 ? "is" : "are");
}

Finding* SyntaxSink::add(std::string_view rule, Severity severity, Span span, std::string message) {
  if (count_++ >= limit) {
    countOnly(span);
    return nullptr;
  }
  Finding finding;
  finding.rule = rule;
  finding.severity = severity;
  finding.message = std::move(message);
  finding.span = span;
  finding.pou = pou_;
  finding.network = network_;
  return &program_.findings.emplace_back(std::move(finding));
}

void SyntaxSink::report(Syntax code, Span span, std::string message, std::optional<Fix> fix) {
  const SyntaxMessage& row = syntaxMessage(code);
  Finding* finding = add(row.id, row.severity, span, std::move(message));
  if (finding == nullptr) return;
  finding->help = row.help;
  if (fix) finding->fix = Shared<Fix>(std::move(*fix));
}

void SyntaxSink::lookAlike(Span span, std::string_view written, std::string meant) {
  Finding* finding = add("STY004", Severity::Error, span,
                         fmt::format("\"{}\" contains look-alike characters, read as {}", excerpt(written), meant));
  if (finding == nullptr) return;
  finding->help = "replace the characters";
  finding->address = meant;
  finding->fix = Shared<Fix>({span, std::move(meant), true});
}

void SyntaxSink::lenient(Span span, std::string_view written, std::string meant) {
  report(Syntax::LenientSpelling, span, fmt::format("\"{}\" was read as {}", excerpt(written), meant),
         Fix{span, meant, true});
}

}  // namespace rungproof
