// Applying safe fixes.
#include "frontend/page/fix.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <ostream>

namespace rungproof {

std::vector<FixedFile> fixedFiles(const Report& report) {
  std::map<std::uint32_t, std::vector<const Fix*>> byFile;
  for (const Finding& finding : report.findings) {
    if (finding.fix && finding.fix->safe) byFile[finding.fix->span.file].push_back(&*finding.fix);
  }
  std::vector<FixedFile> files;
  for (auto& [index, fixes] : byFile) {
    std::stable_sort(fixes.begin(), fixes.end(),
                     [](const Fix* a, const Fix* b) { return a->span.offset < b->span.offset; });
    const std::string_view source = report.sources->file(index).text();
    FixedFile file{report.sources->file(index).name(), {}, 0};
    std::size_t done = 0;  // bytes of the source that are in the text already
    for (const Fix* fix : fixes) {
      if (fix->span.offset < done || (file.count > 0 && fix->span.offset == done && fix->span.length == 0)) continue;
      file.text += source.substr(done, fix->span.offset - done);
      file.text += fix->replacement;
      done = fix->span.offset + fix->span.length;
      ++file.count;
    }
    file.text += source.substr(std::min(done, source.size()));
    files.push_back(std::move(file));
  }
  return files;
}

bool applyFixes(const Context& context, const Report& report) {
  bool written = true;
  for (const FixedFile& file : fixedFiles(report)) {
    const std::string path = pathInProject(file.name, context.settings.root());
    const std::optional<std::string> bytes = bytesOfInput(path);
    const auto& sources = *report.sources;
    bool isAsRead = false;
    for (std::uint32_t i = 0; bytes && i < sources.size(); ++i)
      isAsRead |= sources.file(i).name() == file.name && sources.file(i).text() == *bytes;
    if (!isAsRead) {
      print(context.err, {fmt::format("'{}' was not fixed: its text was converted when it was read", file.name),
                          {},
                          "save it as UTF-8 without a byte order mark first"});
      written = false;
      continue;
    }
    if (!context.write({"text", path}, file.text, InputFile::Replace)) {
      written = false;
      continue;
    }
    if (!context.settings.flag(Opt::Quiet))
      context.err << fmt::format("fixed {} place{} in {}\n", file.count, file.count == 1 ? "" : "s", file.name);
  }
  return written;
}

}  // namespace rungproof
