// Files to a program.
#include "frontend/input/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/platform/names.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/graphical/drawn_build.hpp"
#include "frontend/iec/iec_lowering.hpp"
#include "frontend/input/foreign_family.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/input/stored_reader.hpp"
#include "frontend/mc7/upload.hpp"
#include "frontend/step7/step7_likeness.hpp"
#include "frontend/step7/step7_project.hpp"
#include "frontend/step7/symbol_list.hpp"
#include "frontend/stl/file_block.hpp"
#include "frontend/stl/resolve.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/stl_likeness.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "frontend/xml/xml_text.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7300/cpu.hpp"

namespace rungproof {

bool endsInAny(std::string_view name, std::initializer_list<std::string_view> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) {
    return name.size() >= ending.size() && equalsIgnoringCase(name.substr(name.size() - ending.size()), ending);
  });
}

namespace {

class ProjectReader {
 public:
  explicit ProjectReader(const ReadOptions& options) : options_(options) { program_.target = options.target; }

  void addFile(const std::string& path, bool isSymbolFile) {
    if (const auto argument = isSymbolFile ? std::nullopt : projectArgument(path))
      return addProject(*argument, nameInProject(path, options_.root));
    const std::string name = path == "-" ? options_.stdinName : nameInProject(path, options_.root);
    if (const HeldText* held = heldText(path)) return addText(name, *held, isSymbolFile);
    const InputBytes input = inputBytes(path, longestProgram);
    if (input.bytes && mc7::isUpload(*input.bytes)) return uploads_.push_back(mc7::readUpload(*input.bytes, name));
    if (input.bytes) return addText(name, *input.bytes, isSymbolFile);
    const std::uint32_t file = program_.sources->add(name, "");
    SyntaxSink(program_, file)
        .report(Syntax::FileUnreadable, {file, 0, 0}, fmt::format("cannot read {}: {}", name, input.problem));
  }

  void addText(std::string name, std::string_view bytes, bool isSymbolFile) {
    addDecoded(std::move(name), decode(bytes, options_.encoding), isSymbolFile, foreignContainer(bytes));
  }

  void addText(std::string name, const HeldText& held, bool isSymbolFile) {
    DecodedText decoded = decode(held.text, TextEncoding::Utf8);
    decoded.encoding = held.encoding;
    addDecoded(std::move(name), std::move(decoded), isSymbolFile, std::nullopt);
  }

  void addDecoded(std::string name, DecodedText decoded, bool isSymbolFile, std::optional<ForeignFamily> container) {
    const bool isEmpty = decoded.text.find_first_not_of(" \t\r\n") == std::string::npos;
    const std::size_t length = decoded.text.size();
    const std::uint32_t file = program_.sources->add(std::move(name), std::move(decoded.text));
    SyntaxSink sink(program_, file);
    const std::string& shown = program_.sources->file(file).name();
    if (isEmpty) return sink.report(Syntax::NoText, {file, 0, 0}, fmt::format("{} is empty", shown));
    if (container) return reportForeign(file, *container);
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
    read({file, decoded.encoding, isSymbolFile, &drawn_, &step7_, &iec_});
    const bool isBlock = program_.pous.size() == before + 1 && program_.pous[before].kind == PouKind::Main;
    if (isBlock && !program_.olderDialect && !stlLikeness(program_.sources->file(file).text()).hasHeading)
      headless_.push_back({before, program_.sources->file(file).name()});
  }

  Program finish() {
    stored_.addUploads(uploads_, options_.hidesProtected);
    readWaiting();
    const bool isStep7 = step7_.hasBlocks();
    buildDrawnProject(program_, drawn_);
    nameFromFiles(program_, headless_);
    if (isStep7 && !program_.pous.empty()) reportOtherFamily();
    if (isStep7) step7::buildStep7Project(program_, step7_, options_);
    const bool isIecProject = !iec_.isEmpty();
    if (isIecProject && (isStep7 || !program_.pous.empty())) reportBesideIec();
    if (!isStep7 && (rungproof::isStep7(program_.target) || rungproof::isIec(program_.target)))
      program_.target = dialects().front()->usual;
    if (isIecProject) iec::buildIecProgram(program_, iec_);
    mainFirst();
    if (!isStep7 && !isIecProject) {
      reportTwins();
      resolveNames(program_);
    }
    program_.number();
    const bool isProtected =
        std::any_of(program_.pous.begin(), program_.pous.end(), [](const Pou& pou) { return pou.protectedBlock; });
    // Data blocks and types of an S7-300/400 stand in sources of their own.
    const bool isData = isStep7 && program_.pous.empty();
    if (program_.instructionCount() == 0 && !isProtected && !isData && !hasUnreadNetworks() &&
        !hasReadErrors(program_)) {
      if (program_.sources->size() == 0) program_.sources->add("", "");
      SyntaxSink(program_, 0).report(Syntax::NoInstruction, {0, 0, 0}, "no instruction found");
    }
    return std::move(program_);
  }

 private:
  void addProject(const ProjectArgument& argument, const std::string& name) {
    const auto project = s7project::s7ProjectOf(argument.file, options_.encoding);
    stored_.addProgram(*project, argument.program, name, options_.hidesProtected);
  }

  bool hasUnreadNetworks() const {
    return std::ranges::any_of(program_.pous, [](const Pou& pou) {
      return std::ranges::any_of(pou.networks, [](const Network& network) { return !network.complete; });
    });
  }

  void reportForeign(std::uint32_t file, const ForeignFamily& family) {
    SyntaxSink(program_, file)
        .report(Syntax::FileUnknown, {file, 0, 0},
                fmt::format("{} is not read: it seems to be {}", program_.sources->file(file).name(), family.what));
    program_.findings.back().help = family.help;
  }

  struct Rated {
    const FileReader* reader = nullptr;
    int sureness = 0;
  };
  Rated surest(const InputText& input) const {
    const SourceFile& source = program_.sources->file(input.file);
    Rated best;
    for (const FileReader* reader : fileReaders()) {
      const int sure = reader->sureness(source, input, options_);
      if (sure > best.sureness) best = {reader, sure};
    }
    return best;
  }

  void read(const InputText& input) {
    const SourceFile& source = program_.sources->file(input.file);
    const Rated best = surest(input);
    const auto waits = [&](const Rated& rated) {
      return rated.reader != nullptr && rated.reader->waits != nullptr && rated.reader->waits(source);
    };
    InputText asTable = input;
    asTable.isStep7Project = true;
    const bool mayBeTable = best.sureness < sureness::Certain && waits(surest(asTable));
    if (best.sureness < sureness::Certain && !input.isSymbolFile) {
      if (const auto family = foreignText(source.text())) return reportForeign(input.file, *family);
      if (!mayBeTable && isUndecided(source)) return reportUndecided(input.file);
    }
    if (waits(best) || mayBeTable) return waiting_.push_back(input);
    if (best.reader != nullptr) return best.reader->read(program_, input, options_);
    reportUnknown(input.file);
  }

  void readWaiting() {
    for (InputText& input : waiting_) {
      input.isStep7Project = step7_.hasBlocks();
      const Rated best = surest(input);
      if (best.reader != nullptr)
        best.reader->read(program_, input, options_);
      else
        reportUnknown(input.file);
    }
  }

  void reportUnknown(std::uint32_t file) {
    if (step7::hasSymbolListForm(program_.sources->file(file).text())) {
      SyntaxSink(program_, file)
          .report(Syntax::FileUnknown, {file, 0, 0},
                  fmt::format("{} is a symbol table of an S7-300 or S7-400, and no source of its program is there",
                              program_.sources->file(file).name()));
      program_.findings.back().help = "name the sources (.awl) that it belongs to beside it, or their folder";
      return;
    }
    SyntaxSink(program_, file)
        .report(Syntax::FileUnknown, {file, 0, 0},
                fmt::format("{} is not a program text, data block or symbol table that can be read",
                            program_.sources->file(file).name()));
  }

  /// Words of both families, as many of one as of the other.
  bool isUndecided(const SourceFile& source) const {
    return options_.dialect == "auto" && step7::step7Likeness(source.text()).isTied();
  }

  void reportUndecided(std::uint32_t file) {
    SyntaxSink(program_, file)
        .report(Syntax::FamilyUndecided, {file, 0, 0},
                fmt::format("{} has as many words of an S7-200 as of an S7-300: --dialect s7-200 or s7-300 says which "
                            "it is for",
                            program_.sources->file(file).name()));
  }

  void reportOtherFamily() {
    const std::uint32_t file = step7_.sources.empty() ? step7_.drawn.front().file : step7_.sources.front().file;
    SyntaxSink(program_, file)
        .report(Syntax::FamilyUndecided, {file, 0, 0},
                fmt::format("{} is for an S7-300 or S7-400, other files of the program are for an S7-200",
                            program_.sources->file(file).name()));
  }

  void reportBesideIec() {
    const std::uint32_t file = iec_.blocks.empty() ? 0 : iec_.blocks.front().span.file;
    SyntaxSink(program_, file)
        .report(Syntax::FamilyUndecided, {file, 0, 0},
                fmt::format("{} is a program of IEC 61131-3, other files are for another family",
                            program_.sources->file(file).name()));
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
  step7::Step7Project step7_;
  iec::ProjectSyntax iec_;
  StoredReader stored_{program_, step7_};
  std::vector<mc7::StoredBlock> uploads_;
  std::vector<InputText> waiting_;  ///< tables and drawings
  std::vector<HeadlessBlock> headless_;
};

/// Texts of titles that stand beside documents of TIA Portal and are not among the files.
std::vector<std::string> textsBeside(const std::vector<std::string>& files) {
  std::vector<std::string> found;
  for (const std::string& file : files) {
    if (!endsInAny(file, {".s7dcl"})) continue;
    const std::string texts = pathName(std::filesystem::path(file).replace_extension(".s7res"));
    std::error_code error;
    if (std::filesystem::is_regular_file(texts, error) && std::ranges::find(files, texts) == files.end())
      found.push_back(texts);
  }
  return found;
}

/// A table that stands among the files and in the configuration is read once, as the table that it is.
bool isNamedAsSymbols(const std::string& file, const ReadOptions& options) {
  return std::ranges::any_of(options.symbolFiles, [&](const std::string& symbols) {
    std::error_code error;
    return symbols == file || std::filesystem::equivalent(symbols, file, error);
  });
}

}  // namespace

Program readProgram(const std::vector<std::string>& files, const ReadOptions& options) {
  ProjectReader reader(options);
  for (const std::string& file : files) {
    if (!isNamedAsSymbols(file, options)) reader.addFile(file, false);
  }
  for (const std::string& file : textsBeside(files)) reader.addFile(file, false);
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
