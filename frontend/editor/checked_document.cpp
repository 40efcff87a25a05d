// From a document to what lint says of it.
#include "frontend/editor/checked_document.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "engine/platform/names.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/linting/lint_run.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

bool holds(const std::vector<std::string>& files, const std::string& path) {
  return std::ranges::any_of(files, [&](const std::string& file) { return isSameFile(file, path); });
}

/// Programs that a property file beside them may speak of: press.awl of press.prop.
std::vector<std::string> programBeside(const std::string& path) {
  for (const char* ending : {".awl", ".stl", ".st", ".il", ".scl", ".xml", ".AWL", ".STL", ".ST", ".IL", ".SCL"}) {
    const std::string candidate = pathName(fs::path(path).replace_extension(ending));
    std::error_code error;
    if (fs::is_regular_file(candidate, error) || heldText(candidate) != nullptr) return {candidate};
  }
  return {};
}

}  // namespace

CheckedDocument::CheckedDocument(const Context& context, const Document& document)
    : uri_(document.uri), version_(document.version), hasMark_(document.text.starts_with(byteOrderMark)) {
  // What reading has to say beside findings is not for the editor's log: it would come with every keystroke.
  std::ostringstream nobody;
  failure_ = context.readSettings(document.path, settings_);
  if (failure_) settings_ = {};
  const Context own{settings_, context.in, nobody, nobody, false, false, {}, false, {}, {}, {}, {}};
  read(own, document.path);
  const std::string name = nameInProject(document.path, settings_.root());
  const SourceSet& sources = *input_.program.sources;
  for (std::uint32_t i = 0; i < sources.size(); ++i) {
    if (sources.file(i).name() == name) file_ = i;
  }
}

void CheckedDocument::chooseFiles(const Context& context, const std::string& path) {
  const bool isPropertyFile = endsInAny(path, {".prop"});
  if (isPropertyFile) files_ = programBeside(path);
  if (!isPropertyFile) files_ = {path};
  if (settings_.inputs().empty()) return;
  const std::vector<std::string> inputs = expandFolders(settings_.inputs(), settings_);
  const bool isShared =
      isPropertyFile ? holds(settings_.propertyFiles(), path) : holds(settings_.list(Opt::Symbols), path);
  // A property file that only lies beside a program speaks of all of it.
  const std::string& program = isPropertyFile && !files_.empty() ? files_.front() : path;
  if (!isShared && !holds(inputs, program)) return;
  for (const std::vector<std::string>& group : groupByProgram(context, inputs)) {
    if (!isShared && !holds(group, program)) continue;
    files_ = group;
    return;
  }
}

void CheckedDocument::read(const Context& context, const std::string& path) {
  chooseFiles(context, path);
  if (endsInAny(path, {".prop"}) && !holds(settings_.propertyFiles(), path)) propertyFiles_ = {path};
  if (!files_.empty()) {
    input_ = readInput(context, settings_, files_, propertyFiles_);
    return lint();
  }
  input_.program.target = settings_.target();
  input_.properties = readProperties(input_.program, propertyFiles_, lookupIn(input_.program), settings_.root());
  report_ = startReport("lint", input_.program, {path});
}

void CheckedDocument::lint() {
  report_ = lintProgram(settings_, input_, files_);
  if (auto failure = subtractBaseline(settings_, report_); failure && !failure_) failure_ = failure;
  std::erase_if(report_.findings, [&](const Finding& finding) { return finding.severity < settings_.level(); });
  sortFindings(report_);
}

ClientPlace CheckedDocument::place(std::uint32_t offset) const {
  ClientPlace place = placeOf(source(), offset);
  if (hasMark_ && place.line == 0) ++place.character;
  return place;
}

Json CheckedDocument::range(Span span) const {
  if (isHere(span)) return rangeJson(place(span.offset), place(span.offset + span.length));
  return rangeJson(report_.sources->file(span.file), span);
}

std::string CheckedDocument::uriOf(std::uint32_t file) const {
  if (file == file_) return uri_;
  std::error_code error;
  const std::string path = pathInProject(report_.sources->file(file).name(), settings_.root());
  return uriOfPath(pathName(fs::weakly_canonical(path, error)));
}

std::uint32_t CheckedDocument::offset(ClientPlace place) const {
  if (hasMark_ && place.line == 0 && place.character > 0) --place.character;
  return static_cast<std::uint32_t>(offsetOf(source().text(), place));
}

const Facts& CheckedDocument::facts() const {
  if (!facts_) facts_ = std::make_unique<const Facts>(input_.program, input_.properties.externals, input_.surroundings);
  return *facts_;
}

const Xref& CheckedDocument::xref() const {
  if (!xref_) xref_ = std::make_unique<const Xref>(crossReference(facts()));
  return *xref_;
}

}  // namespace rungproof
