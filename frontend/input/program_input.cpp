// From arguments to programs and reports.
#include "frontend/input/program_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <unordered_map>

#include "analysis/drawing/editor_verdict.hpp"
#include "analysis/rule.hpp"
#include "engine/platform/names.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/input/program_text.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/input/protected_findings.hpp"
#include "frontend/input/tag_list.hpp"
#include "frontend/mc7/upload.hpp"
#include "frontend/property/external_range.hpp"
#include "frontend/step7/name_lookup.hpp"
#include "frontend/step7/symbol_list.hpp"
#include "frontend/stl/file_block.hpp"
#include "frontend/stl/missing_address.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/stl_likeness.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/iec/syntax.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/organization_block.hpp"

namespace rungproof {

namespace {

Mnemonics mnemonicsOf(std::string_view name) {
  if (name == "international") return Mnemonics::International;
  return name == "german" ? Mnemonics::German : Mnemonics::Auto;
}

}  // namespace

ReadOptions readOptionsOf(const Settings& settings) {
  ReadOptions options;
  options.target = settings.target();
  options.dialect = settings.text(Opt::Dialect);
  options.mnemonics = mnemonicsOf(settings.text(Opt::Mnemonics));
  options.encoding = *encodingNamed(settings.text(Opt::Encoding));
  options.symbolFiles = settings.list(Opt::Symbols);
  options.root = settings.root();
  options.hidesProtected = settings.text(Opt::Protected) == "contract";
  if (settings.isSet(Opt::StdinFilename)) options.stdinName = std::string(settings.text(Opt::StdinFilename));
  return options;
}

namespace {

/// Where nothing says which of both families is meant, organization blocks that the largest S7-300 does not start do:
/// the first of them. OB102 is part of many sources and runs where a cold restart is asked for only.
const Pou* blockOfS7400(const Settings& settings, const Program& program) {
  if (settings.isSet(Opt::Cpu) || settings.text(Opt::Dialect) != "auto" || !isStep7(program.target)) return nullptr;
  const auto isMet = [&](const Pou& pou) {
    const int number = numberOfBlock(pou.number);
    return pou.type == BlockType::Ob && number != 102 && !s7300::startsOn(number, program.target.cpu);
  };
  const auto found = std::ranges::find_if(program.pous, isMet);
  return found == program.pous.end() ? nullptr : &*found;
}

}  // namespace

void guessFamily(const Context& context, std::initializer_list<std::pair<const Settings*, Program*>> programs) {
  for (const auto& [settings, program] : programs) {
    const Pou* block = blockOfS7400(*settings, *program);
    if (block == nullptr) continue;
    if (!settings->flag(Opt::Quiet))
      context.err << fmt::format("rungproof: no S7-300 starts {}: taken for a CPU 417; --cpu names another\n",
                                 blockName(block->number));
    for (const auto& [itsSettings, each] : programs) {
      const bool isOpen = !itsSettings->isSet(Opt::Cpu) && itsSettings->text(Opt::Dialect) == "auto";
      if (isOpen && isStep7(each->target)) each->target.cpu = step7Cpu("417");
    }
    return;
  }
}

namespace {

/// Without --cpu, a program with instructions that only the S7-200 SMART has is taken for its largest CPU. A CPU of
/// another family than the program's is none for it.
void guessCpu(const Context& context, const Settings& settings, Program& program) {
  if (isIec(program.target)) return;
  if (settings.isSet(Opt::Cpu)) {
    const Cpu named = settings.target().cpu;
    if (isStep7(named) != isStep7(program.target) && !settings.flag(Opt::Quiet))
      context.err << fmt::format("rungproof: {} is no CPU of the {}: the program is taken for a CPU {}\n",
                                 cpuName(named), dialectOf(program.target).title, cpuName(program.target.cpu));
    return;
  }
  if (isStep7(program.target)) return guessFamily(context, {{&settings, &program}});
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if ((instruction.desc->cpus & s7200Cpus) != 0) continue;
        program.target = {s7200Cpu("ST60"), usualEdition(s7200Cpu("ST60"))};
        if (!settings.flag(Opt::Quiet))
          context.err << fmt::format(
              "rungproof: {} exists on the S7-200 SMART only: taken for a CPU {}; --cpu names another\n",
              instruction.desc->stl, cpuName(program.target.cpu));
        return;
      }
    }
  }
}

}  // namespace

namespace {

/// A name in quotation marks is a symbol in every family, never an address.
std::string_view withoutQuotes(std::string_view text) {
  const bool isQuoted = text.size() > 2 && text.front() == '"' && text.find('"', 1) == text.size() - 1;
  return isQuoted ? text.substr(1, text.size() - 2) : text;
}

/// Variables of IEC 61131-3 by their names, in any case of letters.
OperandLookup lookupOfVariables(const Program& program) {
  auto names = std::make_shared<std::unordered_map<std::string, Operand>>();
  for (const Symbol& symbol : program.symbols) {
    names->emplace(iec::foldedName(symbol.name), symbol.address);
  }
  return [names](std::string_view text) -> std::optional<Operand> {
    const std::string_view name = text.starts_with('%') ? text.substr(1) : withoutQuotes(text);
    const auto found = names->find(iec::foldedName(name));
    return found == names->end() ? std::nullopt : std::optional(found->second);
  };
}

}  // namespace

OperandLookup lookupIn(const Program& program) {
  if (isIec(program.target)) return lookupOfVariables(program);
  return [&program](std::string_view text) -> std::optional<Operand> {
    if (program.declarations != nullptr) return step7::placeNamed(program, text);
    Operand operand;
    const std::string_view name = withoutQuotes(text);
    if (name == text && readAddress(text, Spelling::International, operand)) return operand;
    if (const Symbol* symbol = program.symbolNamed(name)) {
      operand = symbol->address;
      operand.text = symbol->name;
      return operand;
    }
    if (name == text && readAddress(text, Spelling::German, operand)) return operand;
    return std::nullopt;
  };
}

namespace {

/// Whether a CPU is named that has no cold restart; the largest CPUs, which stand for any, are not named.
bool lacksColdStart(const Settings& settings) {
  const Cpu cpu = settings.target().cpu;
  return settings.isSet(Opt::Cpu) && isStep7(cpu) && !s7300::startsOn(102, cpu);
}

}  // namespace

std::optional<std::string> applyProjectSettings(const Settings& settings, Program& program) {
  program.libraryMemory = settings.libraryMemory();
  program.cyclicPeriods = settings.cyclicPeriods();
  program.coldStart = settings.text(Opt::Start) == "cold" && isStep7(program.target) && !lacksColdStart(settings);
  program.cycleMonitoringMs = settings.cycleMonitoringMs();
  const std::optional<std::uint32_t> clock = settings.clockMemory();
  if (!clock || !isStep7(program.target)) return std::nullopt;
  std::optional<std::string> missing = missingFrom(program.target, direct(Area::M, Width::Byte, *clock));
  if (!missing) program.clockMemory = clock;
  return missing;
}

namespace {

Program readFilesBy(const Context& context, const Settings& given, const std::vector<std::string>& files) {
  Settings settings = given;
  applyHardware(files, settings);
  Program program = readProgram(expandFolders(files, settings), readOptionsOf(settings));
  hideProtected(program, program.findings);
  guessCpu(context, settings, program);
  const std::optional<std::string> missing = applyProjectSettings(settings, program);
  if (settings.flag(Opt::Quiet)) return program;
  if (missing) context.err << fmt::format("rungproof: no clock memory: {}\n", *missing);
  if (isStep7(program.target) && settings.text(Opt::Start) == "cold" && !program.coldStart)
    context.err << fmt::format("rungproof: a CPU {} has no cold restart: runs begin with a warm restart\n",
                               cpuName(program.target.cpu));
  return program;
}

}  // namespace

Program readFiles(const Context& context, const std::vector<std::string>& files) {
  return readFilesBy(context, context.settings, files);
}

ProgramInput readInput(const Context& context, const Settings& settings, const std::vector<std::string>& files,
                       const std::vector<std::string>& propertyFiles) {
  ProgramInput input;
  input.program = readFilesBy(context, settings, files);
  std::vector<std::string> all = settings.propertyFiles();
  all.insert(all.end(), propertyFiles.begin(), propertyFiles.end());
  input.properties = readProperties(input.program, all, lookupIn(input.program), settings.root());
  addSurroundings(settings, input);
  return input;
}
ProgramInput readInput(const Context& context, const std::vector<std::string>& files,
                       const std::vector<std::string>& propertyFiles) {
  return readInput(context, context.settings, files, propertyFiles);
}

void addSurroundings(const Settings& settings, ProgramInput& input) {
  std::vector<ExternalRange>& externals = input.properties.externals;
  for (const std::string& text : settings.list(Opt::External)) externals.push_back(*externalRangeNamed(text));
  for (const std::string& file : settings.list(Opt::Tags)) {
    for (PanelTag& tag : readTagList(input.program, file, *encodingNamed(settings.text(Opt::Encoding)))) {
      const bool isThere = !missingFrom(input.program.target, tag.address);
      if (isThere && tag.access != TagAccess::Reads && mayBeExternal(tag.address.area))
        externals.push_back({tag.address, tag.address, tag.span, true});
      input.surroundings.tags.push_back(std::move(tag));
    }
  }
  input.surroundings.portTo = settings.portTo();
}

std::vector<std::string> leaveOut(Program& program) {
  std::vector<std::string> lines;
  for (const NetworkVerdict& verdict : leaveOutInvalid(program)) {
    const Pou& pou = program.pous[verdict.place.block];
    lines.push_back(
        fmt::format("{}, network {} ({}:{}) is not in the download: {}; mend it, or give no --as-downloaded", pou.name,
                    pou.networks[verdict.place.network].number, program.sources->file(verdict.span.file).name(),
                    program.sources->position(verdict.span).line, verdict.reason));
  }
  return lines;
}

Report startReport(std::string_view command, const Program& program, const std::vector<std::string>& files) {
  Report report;
  report.command = std::string(command);
  report.sources = program.sources;
  report.findings = program.findings;
  report.files = files;
  report.coverage.understood = program.instructionCount();
  const auto lost = std::count_if(program.findings.begin(), program.findings.end(),
                                  [](const Finding& finding) { return isReadError(finding) && finding.network != 0; });
  report.coverage.instructions = report.coverage.understood + static_cast<std::size_t>(lost);
  return report;
}

void addUnread(Report& report, const Program& program, const UnreadCode& unread) {
  report.findings.insert(report.findings.end(), unread.findings().begin(), unread.findings().end());
  const PlaceIndex places(program);
  for (Finding& finding : report.findings) places.complete(finding);
  report.coverage.understood -= std::min(report.coverage.understood, unread.instructions());
  for (std::string& text : unread.texts()) report.coverage.approximated.push_back(std::move(text));
}

void printUnread(const Context& context, std::string_view command, const Program& program, const UnreadCode& unread,
                 const std::vector<std::string>& files) {
  Report report = startReport(command, program, files);
  std::erase_if(report.findings, [](const Finding& finding) { return finding.severity != Severity::Error; });
  addUnread(report, program, unread);
  sortFindings(report);
  reporterNamed("human")->write(report, {false, context.settings.flag(Opt::Quiet)}, context.err);
}

namespace {

bool isProgramName(const std::string& name) {
  return endsInAny(name, {".awl", ".stl", ".xml", ".udt", ".db", ".s7dcl", ".s7res", ".scl", ".st", ".iecst", ".il"}) ||
         areUploads({name});  // those have any ending
}

/// By its ending, or by its content where the ending says nothing.
bool isProgramFile(const std::string& name) {
  return isProgramName(name) || (hasSharedEnding(name) && isProgramText(name));
}

/// Whether a file beside programs is a symbol table or a data block; traces and stimuli are none.
bool isTableOfProject(const std::string& path, bool isStep7) {
  const Program alone = readProgram({path});
  const std::string_view text = alone.sources->file(0).text();
  if (isStep7) return step7::isSymbolList(text);
  if (text.starts_with("scan") || text.starts_with("time_ms")) return false;  // the heading of a trace
  return (!alone.symbols.empty() || !alone.data.empty()) && alone.instructionCount() == 0 &&
         std::ranges::none_of(alone.findings, [](const Finding& finding) {
           return finding.severity == Severity::Error && finding.rule != syntaxMessage(Syntax::NoInstruction).id;
         });
}

/// Whether the file, read alone, holds a main program. One without a head is a block of the program whose file is
/// called MAIN or OB1.
bool holdsMain(const Program& alone, const std::string& file, const std::vector<std::string>& files) {
  if (alone.syntax != nullptr)  // a function block alone is run for the sake of its text
    return std::ranges::any_of(alone.syntax->blocks, [](const iec::BlockSyntax& block) {
      return block.kind == iec::BlockKind::Program && !block.isLibrary;
    });
  if (alone.main() == nullptr) return false;
  if (fileBlock(file).kind || stlLikeness(alone.sources->file(0).text()).hasHeading) return true;
  const auto folderOf = [](const std::string& name) { return std::filesystem::path(name).parent_path(); };
  return std::ranges::none_of(files, [&](const std::string& other) {
    return fileBlock(other).kind == PouKind::Main && folderOf(other) == folderOf(file);
  });
}

/// Whether a configuration in the file runs programs that stand in other files: then all of them are one project.
bool runsProgramsOfOthers(const Program& alone) {
  if (alone.syntax == nullptr)  // a file with a configuration alone
    return alone.pous.empty() &&
           iec::foldedName(alone.sources->file(0).text()).find("END_CONFIGURATION") != std::string::npos;
  return std::ranges::any_of(alone.syntax->instances, [&](const iec::InstanceSyntax& instance) {
    return std::ranges::none_of(alone.syntax->blocks, [&](const iec::BlockSyntax& block) {
      return equalsIgnoringCase(block.name, instance.type);
    });
  });
}

/// What a file of a command is, read alone. All that are of an S7-300/400 are one program.
enum class FilePart : std::uint8_t { Main, Beside, OfProject };

/// A file that is named twice, or stands in a folder that is named too, is one file.
void keepEachOnce(std::vector<std::string>& files) {
  if (files.size() < 2) return;
  std::set<std::filesystem::path> known;
  std::erase_if(files, [&](const std::string& file) {
    std::error_code error;
    const std::filesystem::path place = std::filesystem::weakly_canonical(file, error);
    return !known.insert(error ? std::filesystem::path(file) : place).second;
  });
}

std::uintmax_t lengthOf(const std::string& file) {
  std::error_code error;
  const std::uintmax_t length = std::filesystem::file_size(file, error);
  return error ? 0 : length;
}

}  // namespace

std::vector<std::string> expandFolders(const std::vector<std::string>& names) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> found, others;
    for (fs::recursive_directory_iterator entry(name, fs::directory_options::skip_permission_denied, error), end;
         !error && entry != end; entry.increment(error)) {
      const std::string file = pathName(entry->path());
      if (!entry->is_regular_file(error)) continue;
      if (isProgramFile(file))
        found.push_back(file);
      else if (hasSharedEnding(file))
        others.push_back(file);
    }
    // Tables belong to the one program of the folder; which of several they would belong to, nobody says.
    const auto isMain = [&](const std::string& file) { return holdsMain(readProgram({file}), file, found); };
    if (!others.empty()) {
      const bool isStep7 = std::ranges::any_of(
          found, [](const std::string& file) { return readProgram({file}).declarations != nullptr; });
      if (isStep7 || std::ranges::count_if(found, isMain) == 1)
        std::ranges::copy_if(others, std::back_inserter(found),
                             [&](const std::string& file) { return isTableOfProject(file, isStep7); });
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

std::optional<Failure> folderFailure(const std::vector<std::string>& names) {
  namespace fs = std::filesystem;
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::is_directory(name, error)) continue;
    bool holdsProgram = !projectsIn(name).empty();
    for (fs::recursive_directory_iterator entry(name, fs::directory_options::skip_permission_denied, error), end;
         !error && entry != end && !holdsProgram; entry.increment(error)) {
      holdsProgram = entry->is_regular_file(error) && isProgramFile(pathName(entry->path()));
    }
    if (!holdsProgram)
      return Failure{"the folder holds no program", name, "programs end in .awl, .stl, .txt, .scl, .st, .il or .xml"};
  }
  return std::nullopt;
}

std::set<std::string> keepOnly(const std::vector<std::string>& only, PropertySet& set) {
  std::set<std::string> met;
  if (only.empty()) return met;
  std::erase_if(set.properties, [&](const Property& property) {
    if (!property.isGoal()) return false;
    bool isKept = false;
    for (const std::string& pattern : only) {
      if (!fitsPattern(property.name, pattern)) continue;
      met.insert(pattern);
      isKept = true;
    }
    return !isKept;
  });
  return met;
}

Failure noSuchProperty(const std::string& pattern) {
  return {fmt::format("no property is called '{}'", pattern), {}, "--only takes the names of properties"};
}

std::vector<std::string> expandFolders(const std::vector<std::string>& given, const Settings& settings) {
  const std::vector<std::string> names = expandProjects(given, settings);
  std::vector<std::string> files = expandFolders(names);
  std::erase_if(files, [&](const std::string& file) {
    if (std::ranges::find(names, file) != names.end()) return false;
    const std::string name = nameInProject(file, settings.root());
    return std::ranges::any_of(settings.list(Opt::Exclude),
                               [&](const std::string& pattern) { return fitsPattern(name, pattern); });
  });
  keepEachOnce(files);
  return files;
}

std::vector<std::vector<std::string>> groupByProgram(const Context& context, const std::vector<std::string>& given) {
  std::vector<std::vector<std::string>> ofProjects;
  std::vector<std::string> files = expandProjects(given, context.settings);
  keepEachOnce(files);
  std::erase_if(files, [&](const std::string& file) {
    if (!isProjectProgram(file)) return false;
    ofProjects.push_back({file});
    return true;
  });
  if (!ofProjects.empty()) {
    if (!files.empty()) std::ranges::move(groupByProgram(context, files), std::back_inserter(ofProjects));
    return ofProjects;
  }
  if (files.size() < 2 || std::find(files.begin(), files.end(), "-") != files.end()) return {files};
  ReadOptions options = readOptionsOf(context.settings);
  options.symbolFiles.clear();
  std::vector<FilePart> parts(files.size(), FilePart::Beside);
  bool isOneProject = false;
  const auto partOf = [&](const std::string& file) {
    const Program alone = readProgram({file}, options);
    isOneProject = isOneProject || runsProgramsOfOthers(alone);
    if (alone.declarations != nullptr) return FilePart::OfProject;
    return holdsMain(alone, file, files) ? FilePart::Main : FilePart::Beside;
  };
  // Where all files but one stand beside a program, that one makes no second program, whatever it holds: the longest is
  // spared a reading of its own.
  const auto longest = static_cast<std::size_t>(std::ranges::max_element(files, {}, lengthOf) - files.begin());
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i != longest) parts[i] = partOf(files[i]);
  }
  if (std::ranges::all_of(parts, [](FilePart part) { return part == FilePart::Beside; })) return {files};
  parts[longest] = partOf(files[longest]);
  if (isOneProject) return {files};
  std::vector<std::string> mains;
  std::vector<std::string> others;
  std::vector<std::string> ofOneProject;
  for (std::size_t i = 0; i < files.size(); ++i) {
    (parts[i] == FilePart::Main ? mains : parts[i] == FilePart::Beside ? others : ofOneProject).push_back(files[i]);
  }
  // A symbol table of STEP 7 may look like a program of the S7-200: INT in its type column is a heading there.
  if (!ofOneProject.empty()) {
    const auto isTable = [](const std::string& file) { return isTableOfProject(file, true); };
    std::ranges::copy_if(mains, std::back_inserter(ofOneProject), isTable);
    std::erase_if(mains, isTable);
  }
  if (mains.empty() || (mains.size() < 2 && ofOneProject.empty())) return {files};
  std::vector<std::vector<std::string>> groups;
  for (const std::string& file : mains) {
    std::vector<std::string>& group = groups.emplace_back(others);
    group.insert(group.begin(), file);
  }
  if (!ofOneProject.empty()) groups.push_back(std::move(ofOneProject));
  return groups;
}

void ReportMerger::add(const Report& part) {
  std::vector<std::uint32_t> places;  // index in sources_ of each file of the part
  for (std::uint32_t i = 0; i < part.sources->size(); ++i) {
    const SourceFile& file = part.sources->file(i);
    const auto [entry, isNew] = indices_.emplace(file.name(), static_cast<std::uint32_t>(sources_->size()));
    if (isNew) sources_->add(file.name(), std::string(file.text()));
    places.push_back(entry->second);
  }
  const auto addFindings = [&](const std::vector<Finding>& from, std::vector<Finding>& to) {
    for (Finding finding : from) {
      finding.span.file = places[finding.span.file];
      for (RelatedPlace& related : finding.related) related.span.file = places[related.span.file];
      if (finding.fix) {
        Fix fix = *finding.fix;
        fix.span.file = places[fix.span.file];
        finding.fix = Shared<Fix>(std::move(fix));
      }
      to.push_back(std::move(finding));
    }
  };
  addFindings(part.findings, report_.findings);
  addFindings(part.lintFindings, report_.lintFindings);
  report_.programs.insert(report_.programs.end(), part.programs.begin(), part.programs.end());
  for (PropertyResult property : part.properties) {
    if (property.span) property.span->file = places[property.span->file];
    report_.properties.push_back(std::move(property));
  }
  if (part.selfCheck) {
    if (!report_.selfCheck) report_.selfCheck.emplace();
    report_.selfCheck->insert(report_.selfCheck->end(), part.selfCheck->begin(), part.selfCheck->end());
  }
  for (const std::string& assumption : part.assumptions) {
    if (std::find(report_.assumptions.begin(), report_.assumptions.end(), assumption) == report_.assumptions.end())
      report_.assumptions.push_back(assumption);
  }
  if (isEmpty_) report_.command = part.command;
  isEmpty_ = false;
  report_.coverage.instructions += part.coverage.instructions;
  report_.coverage.understood += part.coverage.understood;
  for (const std::string& place : part.coverage.approximated) report_.coverage.approximated.push_back(place);
  for (const std::string& line : part.coverage.leftOut) report_.coverage.leftOut.push_back(line);
  report_.coverage.open += part.coverage.open;
  for (const std::string& defect : part.defects) report_.defects.push_back(defect);
  report_.reasons.insert(report_.reasons.end(), part.reasons.begin(), part.reasons.end());
  for (const std::string& file : part.files) {
    if (std::find(report_.files.begin(), report_.files.end(), file) == report_.files.end())
      report_.files.push_back(file);
  }
  if (part.techniques) {
    if (!report_.techniques) report_.techniques.emplace();
    ::rungproof::add(*report_.techniques, *part.techniques);
  }
  report_.suppressed += part.suppressed;
  report_.baselined += part.baselined;
}

Report ReportMerger::take() {
  report_.sources = sources_;
  return std::move(report_);
}

}  // namespace rungproof
