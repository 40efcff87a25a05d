// Splices replacements into texts and bytes.
#include "frontend/linting/fix.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <ostream>

#include "frontend/input/program_input.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

constexpr std::size_t linesAround = 3;

std::string placesText(std::size_t count) { return fmt::format("{} place{}", count, count == 1 ? "" : "s"); }

/// Whether the encoded text is what stood in the file, but for what decode() evens out: line ends and control
/// characters.
bool isAsRead(std::string_view encoded, std::string_view bytes) {
  return std::ranges::equal(encoded, bytes, [](char now, char before) {
    const bool isControl = static_cast<unsigned char>(before) < 0x20 || before == 0x7F;
    return now == before || (now == '\n' && before == '\r') || (now == ' ' && isControl);
  });
}

std::size_t lineBegin(std::string_view text, std::size_t at) {
  return at == 0 ? 0 : text.rfind('\n', at - 1) == std::string_view::npos ? 0 : text.rfind('\n', at - 1) + 1;
}
std::size_t lineEnd(std::string_view text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == std::string_view::npos ? text.size() : end + 1;
}

/// Where the lines around a change begin.
std::size_t linesBefore(std::string_view text, std::size_t begin) {
  for (std::size_t k = 0; k < linesAround && begin > 0; ++k) begin = lineBegin(text, begin - 1);
  return begin;
}

/// Lines with a sign in front; a last line without its end is marked as other tools mark it.
void appendLines(std::string& out, char sign, std::string_view lines) {
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = lineEnd(lines, at);
    out += sign;
    out += lines.substr(at, end - at);
    if (out.back() != '\n') out += "\n\\ No newline at end of file\n";
    at = end;
  }
}

std::size_t countLines(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n')) + (text.empty() || text.back() == '\n' ? 0 : 1);
}

/// Whole lines that change together, with what they become.
struct ChangedLines {
  std::size_t begin;
  std::size_t end;
  std::string now;
};

std::vector<ChangedLines> changedLines(std::string_view text, const std::vector<const Fix*>& fixes) {
  std::vector<ChangedLines> list;
  for (std::size_t i = 0; i < fixes.size();) {
    ChangedLines lines{lineBegin(text, fixes[i]->span.offset), 0, {}};
    std::size_t done = lines.begin;
    do {
      const Fix& fix = *fixes[i];
      lines.now += text.substr(done, fix.span.offset - done);
      lines.now += fix.replacement;
      done = fix.span.offset + fix.span.length;
      lines.end = lineEnd(text, std::max<std::size_t>(done, 1) - (fix.span.length > 0 ? 1 : 0));
      ++i;
    } while (i < fixes.size() && lineBegin(text, fixes[i]->span.offset) <= lines.end);
    lines.now += text.substr(done, lines.end - done);
    list.push_back(std::move(lines));
  }
  return list;
}

/// A patch or a source goes on byte by byte; only a terminal must not get all of them.
std::string asShown(const Context& context, const std::string& text) {
  return context.outIsTerminal ? visibleText(text) : text;
}

}  // namespace

std::vector<FixedFile> fixedFiles(const Report& report, FixLevel level) {
  std::map<std::uint32_t, std::vector<const Fix*>> byFile;
  for (const Finding& finding : report.findings) {
    if (finding.fix && (finding.fix->safe || level == FixLevel::Unsafe))
      byFile[finding.fix->span.file].push_back(&*finding.fix);
  }
  std::vector<FixedFile> files;
  for (auto& [index, fixes] : byFile) {
    std::stable_sort(fixes.begin(), fixes.end(),
                     [](const Fix* a, const Fix* b) { return a->span.offset < b->span.offset; });
    const std::string_view source = report.sources->file(index).text();
    FixedFile file{index, report.sources->file(index).name(), {}, {}};
    std::size_t done = 0;  // bytes of the source that are in the text already
    for (const Fix* fix : fixes) {
      if (fix->span.offset < done || (!file.applied.empty() && fix->span.offset == done && fix->span.length == 0))
        continue;
      file.text += source.substr(done, fix->span.offset - done);
      file.text += fix->replacement;
      done = fix->span.offset + fix->span.length;
      file.applied.push_back(fix);
    }
    file.text += source.substr(std::min(done, source.size()));
    files.push_back(std::move(file));
  }
  return files;
}

std::optional<std::string> fixedBytes(std::string_view bytes, std::string_view text,
                                      const std::vector<const Fix*>& fixes, TextEncoding encoding) {
  const ByteForm form = byteFormOf(bytes, encoding);
  std::string result(form.mark);
  std::size_t at = form.mark.size(), done = 0;
  const auto pass = [&](std::size_t end) -> std::optional<std::string_view> {
    const std::optional<std::string> encoded = encode(text.substr(done, end - done), form);
    if (!encoded || !isAsRead(*encoded, bytes.substr(std::min(at, bytes.size()), encoded->size()))) return std::nullopt;
    const std::string_view passed = bytes.substr(at, encoded->size());
    at += encoded->size();
    done = end;
    return passed;
  };
  for (const Fix* fix : fixes) {
    const std::optional<std::string_view> before = pass(fix->span.offset);
    const std::optional<std::string> now = encode(fix->replacement, form);
    if (!before || !now || !pass(fix->span.offset + fix->span.length)) return std::nullopt;
    result += *before;
    result += *now;
  }
  const std::optional<std::string_view> rest = pass(text.size());
  if (!rest || at != bytes.size()) return std::nullopt;
  return result + std::string(*rest);
}

std::string unifiedDiff(const std::string& name, std::string_view text, const std::vector<const Fix*>& fixes) {
  const std::vector<ChangedLines> changes = changedLines(text, fixes);
  std::string out = fmt::format("--- {0}\n+++ {0}\n", name);
  std::ptrdiff_t grown = 0;  // lines that the changes before have added
  for (std::size_t i = 0; i < changes.size();) {
    const std::size_t begin = linesBefore(text, changes[i].begin);
    std::size_t end = changes[i].end;
    std::string body;
    std::size_t at = begin;
    std::ptrdiff_t added = 0;
    do {
      appendLines(body, ' ', text.substr(at, changes[i].begin - at));
      const std::string_view before = text.substr(changes[i].begin, changes[i].end - changes[i].begin);
      appendLines(body, '-', before);
      appendLines(body, '+', changes[i].now);
      added += static_cast<std::ptrdiff_t>(countLines(changes[i].now));
      added -= static_cast<std::ptrdiff_t>(countLines(before));
      at = changes[i].end;
      end = at;
      for (std::size_t k = 0; k < linesAround; ++k) end = lineEnd(text, end);
      ++i;
    } while (i < changes.size() && linesBefore(text, changes[i].begin) <= end);
    appendLines(body, ' ', text.substr(at, end - at));
    const auto first = static_cast<std::ptrdiff_t>(countLines(text.substr(0, begin))) + 1;
    const auto lines = static_cast<std::ptrdiff_t>(countLines(text.substr(begin, end - begin)));
    out += fmt::format("@@ -{},{} +{},{} @@\n{}", first, lines, first + grown, lines + added, body);
    grown += added;
  }
  return out;
}

bool applyFixes(const Context& context, const Report& report, FixLevel level, bool readsStandardInput) {
  bool written = true;
  const ReadOptions options = readOptionsOf(context.settings);
  const std::vector<FixedFile> files = fixedFiles(report, level);
  for (const FixedFile& file : files) {
    const bool isStandardInput = readsStandardInput && file.name == options.stdinName;
    const std::string path = pathInProject(file.name, context.settings.root());
    const std::optional<std::string> bytes = isStandardInput ? standardInput() : bytesOfInput(path);
    const std::optional<std::string> fixed =
        bytes ? fixedBytes(*bytes, report.sources->file(file.file).text(), file.applied, options.encoding)
              : std::nullopt;
    if (!fixed) {
      print(context.err, {fmt::format("'{}' was not fixed: some of its bytes do not belong to its encoding", file.name),
                          {},
                          "name the encoding with --encoding, or save the file as UTF-8 first"});
      written = false;
      continue;
    }
    if (isStandardInput) {
      replaceStandardInput(*fixed);
    } else if (!context.write({"source", path}, *fixed, InputFile::Replace)) {
      written = false;
      continue;
    }
    if (!context.settings.flag(Opt::Quiet))
      context.err << fmt::format("fixed {} in {}\n", placesText(file.applied.size()), file.name);
  }
  if (readsStandardInput) context.out << asShown(context, standardInput());
  return written;
}

std::size_t showFixes(const Context& context, const Report& report, FixLevel level) {
  std::size_t count = 0;
  const std::vector<FixedFile> files = fixedFiles(report, level);
  for (const FixedFile& file : files) {
    context.out << asShown(context, unifiedDiff(file.name, report.sources->file(file.file).text(), file.applied));
    count += file.applied.size();
  }
  if (!context.settings.flag(Opt::Quiet)) {
    context.err << (count == 0 ? std::string("no fix would be applied\n")
                               : fmt::format("would fix {} in {} file{}\n", placesText(count), files.size(),
                                             files.size() == 1 ? "" : "s"));
  }
  return count;
}

}  // namespace rungproof
