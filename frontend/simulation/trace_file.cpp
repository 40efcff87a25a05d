// Files of traces.
#include "frontend/simulation/trace_file.hpp"

#include <fmt/format.h>

#include <array>
#include <istream>
#include <ostream>
#include <sstream>

#include "frontend/text/text_stream.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {
constexpr std::size_t mostFailures = 10;
}  // namespace

std::optional<std::string> readFile(const Context& context, const std::string& name, std::vector<Failure>& failures) {
  std::optional<std::string> text;
  if (name == "-") {
    text.emplace();
    std::array<char, 65536> piece;
    while (text->size() <= longestInput && (context.in.read(piece.data(), piece.size()) || context.in.gcount() > 0))
      text->append(piece.data(), static_cast<std::size_t>(context.in.gcount()));
    if (text->size() > longestInput) {
      failures.push_back({"standard input cannot be read: it is too long", {}, "give a shorter table"});
      return std::nullopt;
    }
  } else {
    InputBytes input = inputBytes(name);
    if (!input.bytes) {
      failures.push_back(
          {fmt::format("'{}' cannot be read: {}", name, input.problem), {}, "check the name and the permissions"});
      return std::nullopt;
    }
    text = std::move(input.bytes);
  }
  const bool isUtf16 = text->starts_with("\xFF\xFE") || text->starts_with("\xFE\xFF");
  if (!isUtf16 && text->find('\0') != std::string::npos) {
    failures.push_back({"the file holds zero bytes: it is no text", name, "save the table as CSV in UTF-8"});
    return std::nullopt;
  }
  return text;
}

std::optional<Failure> checkTraceName(const std::string& name) {
  if (traceFormatFor(name) != nullptr) return std::nullopt;
  std::string endings;
  for (const TraceFormat* format : allTraceFormats())
    endings += fmt::format("{}{} ({})", endings.empty() ? "" : ", ", format->ending, format->summary);
  return Failure{fmt::format("'{}' has no ending that names a trace form", name), {}, "endings: " + endings};
}

bool writeTrace(const Context& context, const std::string& name, const Trace& trace, std::string_view title) {
  const TraceFormat* format = traceFormatFor(name);
  TextStream text;
  format->write(trace, title, text);
  return context.write({std::string(format->ending), name}, text.view());
}

bool writePage(const Context& context, const std::string& name, const Trace& trace, std::string_view title,
               const TraceDrawings& drawings, const ExpectedLanes& expected) {
  TextStream text;
  writeTracePage(trace, title, drawings, text, expected);
  return context.write({"html", name}, text.view());
}

Exit failAll(const Context& context, const std::vector<Failure>& failures) {
  for (std::size_t i = 0; i < failures.size() && i < mostFailures; ++i) context.fail(failures[i]);
  if (failures.size() > mostFailures) context.err << fmt::format("and {} more\n", failures.size() - mostFailures);
  return Exit::Failed;
}

}  // namespace rungproof
