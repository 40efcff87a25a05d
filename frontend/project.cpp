// Files to a program.
#include "frontend/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

#include "frontend/disk_file.hpp"
#include "frontend/drawn/drawn_build.hpp"
#include "frontend/file_block.hpp"
#include "frontend/file_reader.hpp"
#include "frontend/stl/resolve.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/stl_likeness.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

bool endsInAny(std::string_view name, std::initializer_list<std::string_view> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) {
    return name.size() >= ending.size() && equalsIgnoringCase(name.substr(name.size() - ending.size()), ending);
  });
}

namespace {

/// Spans count bytes in 32 bits, and U+FFFD may triple a text.
constexpr std::size_t largestFile = std::size_t{1} << 30;

bool readBytes(const std::string& path, std::string& bytes) {
  if (path == "-") {
    bytes.assign(std::istreambuf_iterator<char>(std::cin), {});
    return true;
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return false;
  noteInput(path);
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  stream.seekg(0, std::ios::beg);
  if (size < 0 || !stream) {  // a pipe, or a directory
    stream.clear();
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
    return !stream.bad() && !bytes.empty();
  }
  if (static_cast<std::size_t>(size) > largestFile) return false;
  bytes.resize(static_cast<std::size_t>(size));
  stream.read(bytes.data(), size);
  return static_cast<bool>(stream) || size == 0;
}

class ProjectReader {
 public:
  explicit ProjectReader(const ReadOptions& options) : options_(options) { program_.target = options.target; }

  void addFile(const std::string& path, bool isSymbolFile) {
    std::string bytes;
    const std::string name = path == "-" ? options_.stdinName : nameInProject(path, options_.root);
    if (readBytes(path, bytes)) return addText(name, bytes, isSymbolFile);
    const std::uint32_t file = program_.sources->add(name, "");
    SyntaxSink(program_, file).report(Syntax::FileUnreadable, {file, 0, 0}, fmt::format("cannot read {}", name));
  }

  void addText(std::string name, std::string_view bytes, bool isSymbolFile) {
    DecodedText decoded = decode(bytes, options_.encoding);
    const bool isEmpty = decoded.text.find_first_not_of(" \t\r\n") == std::string::npos;
    const std::size_t length = decoded.text.size();
    const std::uint32_t file = program_.sources->add(std::move(name), std::move(decoded.text));
    SyntaxSink sink(program_, file);
    const std::string& shown = program_.sources->file(file).name();
    if (isEmpty) return sink.report(Syntax::NoText, {file, 0, 0}, fmt::format("{} is empty", shown));
    if (decoded.controls > 0) {
      const auto at = static_cast<std::uint32_t>(decoded.firstControl);
      sink.report(Syntax::ControlCharacters, {file, at, 1},
                  fmt::format("{} control character{} in the text, the first here", decoded.controls,
                              decoded.controls == 1 ? "" : "s"));
      if (decoded.controls * 50 > length) {
        return sink.report(Syntax::FileUnknown, {file, 0, 0}, fmt::format("{} is not a text", shown));
      }
    }
    if (decoded.wasUtf16) sink.report(Syntax::Converted, {file, 0, 0}, "UTF-16 text was converted");
    if (decoded.badBytes > 0) {
      const auto at = static_cast<std::uint32_t>(decoded.firstBad);
      sink.report(Syntax::BadCharacters, {file, at, 3},
                  fmt::format("{} place{} not valid in {}, the first here", decoded.badBytes,
                              decoded.badBytes == 1 ? " is" : "s are", encodingName(decoded.encoding)));
    }
    const std::size_t before = program_.pous.size();
    read({file, decoded.encoding, isSymbolFile, &drawn_});
    const bool isBlock = program_.pous.size() == before + 1 && program_.pous[before].kind == PouKind::Main;
    if (isBlock && !program_.olderDialect && !stlLikeness(program_.sources->file(file).text()).hasHeading)
      headless_.push_back({before, program_.sources->file(file).name()});
  }

  Program finish() {
    buildDrawnProject(program_, drawn_);
    nameFromFiles(program_, headless_);
    mainFirst();
    reportTwins();
    resolveNames(program_);
    program_.number();
    const bool isProtected =
        std::any_of(program_.pous.begin(), program_.pous.end(), [](const Pou& pou) { return pou.protectedBlock; });
    if (program_.instructionCount() == 0 && !isProtected && !hasReadErrors(program_)) {
      if (program_.sources->size() == 0) program_.sources->add("", "");
      SyntaxSink(program_, 0).report(Syntax::NoInstruction, {0, 0, 0}, "no instruction found");
    }
    return std::move(program_);
  }

 private:
  void read(const InputText& input) {
    const SourceFile& source = program_.sources->file(input.file);
    const FileReader* best = nullptr;
    int bestSureness = 0;
    for (const FileReader* reader : fileReaders()) {
      const int sure = reader->sureness(source, input, options_);
      if (sure > bestSureness) {
        best = reader;
        bestSureness = sure;
      }
    }
    if (best != nullptr) return best->read(program_, input, options_);
    SyntaxSink(program_, input.file)
        .report(Syntax::FileUnknown, {input.file, 0, 0},
                fmt::format("{} is not a program text, data block or symbol table that can be read", source.name()));
  }

  /// Moves the main program to the front; directives follow their blocks.
  void mainFirst() {
    const auto main = std::find_if(program_.pous.begin(), program_.pous.end(),
                                   [](const Pou& pou) { return pou.kind == PouKind::Main; });
    if (main == program_.pous.end() || main == program_.pous.begin()) return;
    const int old = static_cast<int>(main - program_.pous.begin());
    std::rotate(program_.pous.begin(), main, main + 1);
    for (Directive& directive : program_.directives) {
      if (directive.pou == old) {
        directive.pou = 0;
      } else if (directive.pou >= 0 && directive.pou < old) {
        ++directive.pou;
      }
    }
  }

  /// Two blocks of one kind and number, two main programs, or two blocks of one name.
  void reportTwins() {
    std::set<std::pair<PouKind, int>> numbers;
    std::set<std::string> names;
    for (const Pou& pou : program_.pous) {
      const bool isNew = numbers.emplace(pou.kind, pou.kind == PouKind::Main ? 0 : pou.number).second;
      const bool isNewName = names.insert(pou.name).second;
      if (isNew && isNewName) continue;
      SyntaxSink sink(program_, pou.span.file);
      sink.setPlace(pou.name, 0);
      const Span heading{pou.span.file, pou.span.offset, std::min<std::uint32_t>(pou.span.length, 1)};
      if (!isNew) {
        sink.report(Syntax::BlockTwice, heading,
                    pou.kind == PouKind::Main ? std::string("second main program")
                                              : fmt::format("number {} of {} is used twice", pou.number, pou.name));
      } else {
        sink.report(Syntax::BlockTwice, heading, fmt::format("two blocks are named {}", pou.name));
      }
    }
  }

  const ReadOptions& options_;
  Program program_;
  DrawnProject drawn_;
  std::vector<HeadlessBlock> headless_;
};

}  // namespace

Program readProgram(const std::vector<std::string>& files, const ReadOptions& options) {
  ProjectReader reader(options);
  for (const std::string& file : files) reader.addFile(file, false);
  for (const std::string& file : options.symbolFiles) reader.addFile(file, true);
  return reader.finish();
}

Program readText(std::string name, std::string text, const ReadOptions& options) {
  ProjectReader reader(options);
  reader.addText(std::move(name), text, false);
  for (const std::string& file : options.symbolFiles) reader.addFile(file, true);
  return reader.finish();
}

}  // namespace rungproof
