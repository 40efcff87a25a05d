// From the folders of a project to its programs.
#include "frontend/s7project/s7_project.hpp"

#include <fmt/format.h>
#include <unicode/ucnv.h>

#include <algorithm>
#include <charconv>
#include <mutex>
#include <set>

#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/s7project/block_container.hpp"
#include "frontend/s7project/dbase.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::s7project {

namespace {

constexpr std::uint32_t linkToBlocks = 0x116001, linkToSources = 0x112004;
constexpr std::int64_t symbolListOfProgram = 1327361;
constexpr std::int64_t awlSource = 1122309, sclSource = 1122310;

std::uint32_t linkNumber(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

unsigned pageOf(TextEncoding encoding) {
  switch (encoding) {
    case TextEncoding::Utf8: return 65001;
    case TextEncoding::Cp1251: return 1251;
    case TextEncoding::Gb18030: return 936;
    default: return 1252;
  }
}

class ProjectReaderS7 {
 public:
  ProjectReaderS7(const std::string& file, TextEncoding encoding) : encoding_(encoding) { project_.file = file; }

  S7Project read() {
    std::string fault;
    if (isProjectFileName(project_.file))
      files_ = ProjectFiles::inFolder(project_.file);
    else
      files_ = ProjectFiles::inArchive(project_.file, fault);
    if (!fault.empty()) return fail(fmt::format("the archive is not read: {}", fault), "give a .zip made by STEP 7");
    codePage();
    const std::vector<std::string> containers = files_.namesIn("ombstx/offline");
    if (!files_.has("hrs/S7RESOFF.DBF") && containers.empty())
      return fail(fmt::format("{} has no programs beside it: neither hrs/S7RESOFF.DBF nor ombstx/offline is there",
                              files_.projectFile()),
                  "give the whole folder of the project, or the archive that STEP 7 makes of it");
    noteOldLayout(containers);
    if (project_.failure) return std::move(project_);
    hardware_ = readHardware(files_, faults_);
    readPrograms();
    readRest(containers);
    namePaths();
    for (const std::string& text : faults_) project_.faults.push_back({"", text, false});
    for (const ProjectFault& fault : ofContainers_) {
      const auto program = std::ranges::find(project_.programs, fault.program, &ProjectProgram::container);
      const bool isListed = program != project_.programs.end();
      project_.faults.push_back({isListed ? program->path : "", fault.text, fault.isLoss});
    }
    return std::move(project_);
  }

 private:
  S7Project fail(std::string message, std::string help) {
    project_.failure = Failure{std::move(message), project_.file, std::move(help)};
    return std::move(project_);
  }

  std::optional<DbaseTable> table(const std::string& path) {
    std::optional<std::string> bytes = files_.bytes(path);
    if (!bytes) return std::nullopt;
    std::vector<std::string> found;
    const std::string memo = path.substr(0, path.size() - 3) + "DBT";
    DbaseTable table(std::move(*bytes), files_.bytes(memo), found);
    for (const std::string& fault : found) faults_.push_back(fmt::format("{}, {}", files_.spelling(path), fault));
    return table;
  }

  std::string text(std::string_view bytes) const { return textOfCodePage(bytes, project_.codePage); }

  void codePage() {
    const std::string lines = files_.bytes("Global/Language").value_or("");
    std::vector<std::string_view> parts;
    for (std::size_t at = 0; at < lines.size();) {
      const std::size_t end = std::min(lines.find('\n', at), lines.size());
      parts.push_back(trimmed(std::string_view(lines).substr(at, end - at)));
      at = end + 1;
    }
    unsigned page = 0;
    if (parts.size() > 3) std::from_chars(parts[3].data(), parts[3].data() + parts[3].size(), page);
    project_.isCodePageKnown = page != 0;
    if (page != 0) project_.codePage = page;
    if (encoding_ != TextEncoding::Auto) project_.codePage = pageOf(encoding_);
  }

  /// Libraries of STEP 7 V1 and V2 keep the parts of blocks in the table of blocks itself.
  void noteOldLayout(const std::vector<std::string>& containers) {
    bool isOld = false, isNew = false;
    for (const std::string& name : containers) {
      const std::string folder = "ombstx/offline/" + name;
      isNew = isNew || files_.has(folder + "/SUBBLK.DBF");
      isOld = isOld || (files_.has(folder + "/BAUSTEIN.DBF") && !files_.has(folder + "/SUBBLK.DBF"));
    }
    if (isOld && !isNew)
      project_.failure =
          Failure{fmt::format("{} has the old layout of STEP 7 V1 and V2, which is not read", files_.projectFile()),
                  project_.file, "open and save it with STEP 7 V5"};
  }

  // Programs --------------------------------------------------------------------------------------------------------

  void readPrograms() {
    const auto programs = table("hrs/S7RESOFF.DBF");
    if (!programs) return;
    const std::string links = files_.bytes("hrs/linkhrs.lnk").value_or("");
    if (links.empty()) faults_.emplace_back("hrs/linkhrs.lnk: it is missing or empty, so no program has its blocks");
    std::set<std::int64_t> offsets;
    for (std::size_t row = 0; row < programs->rows(); ++row)
      offsets.insert(programs->number(row, "RSRVD4_L").value_or(0));
    for (std::size_t row = 0; row < programs->rows(); ++row) {
      ProjectProgram program;
      program.name = text(programs->text(row, "NAME"));
      const std::int64_t id = programs->number(row, "ID").value_or(-1);
      const std::int64_t offset = programs->number(row, "RSRVD4_L").value_or(0);
      const auto next = offsets.upper_bound(offset);
      const std::size_t end = next == offsets.end() ? links.size() : static_cast<std::size_t>(*next);
      follow(links, offset, std::min(end, links.size()), program,
             fmt::format("hrs/S7RESOFF.DBF, record {}", programs->record(row)));
      symbols(id, program);
      if (const auto cpu = hardware_.find(id); cpu != hardware_.end()) {
        program.cpu = cpu->second;
        program.cpu->name = text(program.cpu->name);
        program.cpu->station = text(program.cpu->station);
      }
      project_.programs.push_back(std::move(program));
    }
  }

  /// The links of one program: entries of 24 bytes, type and ID first.
  void follow(std::string_view links, std::int64_t offset, std::size_t end, ProjectProgram& program,
              const std::string& place) {
    constexpr std::size_t headBytes = 0x18, entryBytes = 24;
    if (links.empty()) return;
    if (offset < 0 || static_cast<std::size_t>(offset) + headBytes > links.size()) {
      faults_.push_back(
          fmt::format("{}: its links begin at byte {}, behind the end of hrs/linkhrs.lnk", place, offset));
      return;
    }
    bool hasBlocks = false, hasSources = false;
    for (std::size_t at = static_cast<std::size_t>(offset) + headBytes; at + entryBytes <= end; at += entryBytes) {
      const std::uint32_t type = linkNumber(links, at), id = linkNumber(links, at + 4);
      if (type == linkToBlocks && !hasBlocks) {
        hasBlocks = true;
        container(fmt::format("{:08x}", id), program);
      }
      if (type == linkToSources && !hasSources) {
        hasSources = true;
        textSources(id, program);
      }
    }
    // Where the entries begin elsewhere, the pair of type and folder tells.
    for (std::size_t at = static_cast<std::size_t>(offset); !hasBlocks && at + 8 <= end; at += 2) {
      if (linkNumber(links, at) != linkToBlocks) continue;
      const std::string name = fmt::format("{:08x}", linkNumber(links, at + 4));
      hasBlocks = files_.has("ombstx/offline/" + name + "/BAUSTEIN.DBF");
      if (hasBlocks) container(name, program);
    }
  }

  void container(const std::string& name, ProjectProgram& program) {
    read_.insert(name);
    const std::string folder = "ombstx/offline/" + name;
    if (!files_.has(folder + "/BAUSTEIN.DBF")) return;
    BlockContainer blocks = readBlockContainer(files_, folder, [this](std::string_view bytes) { return text(bytes); });
    // Paths of programs are not yet known: the name of the container leads there.
    for (const std::string& fault : blocks.faults) ofContainers_.push_back({name, fault, false});
    for (const std::string& loss : blocks.losses) ofContainers_.push_back({name, loss, true});
    program.container = name;
    program.blocks = std::move(blocks.blocks);
    program.variableTables = blocks.variableTables;
  }

  /// Containers that no program leads to: copies, and the blocks of libraries.
  void readRest(const std::vector<std::string>& containers) {
    for (const std::string& name : containers) {
      std::string folded = name;
      std::ranges::transform(folded, folded.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
      if (read_.contains(folded) || !files_.has("ombstx/offline/" + name + "/BAUSTEIN.DBF")) continue;
      ProjectProgram program;
      program.name = "Blocks " + folded;
      container(folded, program);
      if (!program.blocks.empty()) project_.programs.push_back(std::move(program));
    }
  }

  void textSources(std::uint32_t id, ProjectProgram& program) {
    const std::string folder = fmt::format("s7asrcom/{:08x}", id);
    const auto rows = table(folder + "/S7CONTAI.DBF");
    if (!rows) return;
    for (std::size_t row = 0; row < rows->rows(); ++row) {
      const std::int64_t type = rows->number(row, "TYPE").value_or(0);
      const std::string name(rows->text(row, "FILENAME"));
      if (type != awlSource && type != sclSource) continue;
      const std::optional<std::string> bytes = files_.bytes(folder + "/" + name);
      if (!bytes) {
        faults_.push_back(fmt::format("{}/{}: the text source is missing", folder, name));
        continue;
      }
      program.sources.push_back({text(rows->text(row, "NAME")), type == sclSource, text(*bytes)});
    }
  }

  void symbols(std::int64_t program, ProjectProgram& into) {
    if (!isLinkListRead_) {
      isLinkListRead_ = true;
      linkList_ = table("YDBs/YLNKLIST.DBF");
      symbolLists_ = table("YDBs/SYMLISTS.DBF");
    }
    if (!linkList_ || !symbolLists_) return;
    for (std::size_t row = 0; row < linkList_->rows(); ++row) {
      if (linkList_->number(row, "TOT") != symbolListOfProgram || linkList_->number(row, "TOI") != program) continue;
      const std::optional<std::int64_t> list = linkList_->number(row, "SOI");
      for (std::size_t i = 0; i < symbolLists_->rows(); ++i) {
        if (symbolLists_->number(i, "_ID") == list) symbolList(std::string(symbolLists_->text(i, "_DBPATH")), into);
      }
    }
  }

  void symbolList(const std::string& folder, ProjectProgram& into) {
    const auto rows = table(fmt::format("YDBs/{}/SYMLIST.DBF", folder));
    if (!rows) return;
    for (std::size_t row = 0; row < rows->rows(); ++row) {
      Symbol symbol{text(rows->text(row, "_SKZ")), text(rows->text(row, "_OPIEC")), text(rows->text(row, "_DATATYP")),
                    text(rows->text(row, "_COMMENT"))};
      if (!symbol.name.empty()) into.symbols.push_back(std::move(symbol));
    }
  }

  void namePaths() {
    std::set<std::string> taken;
    for (ProjectProgram& program : project_.programs) {
      if (program.name.empty()) program.name = "Program";
      std::string path;
      if (program.cpu) {
        for (const std::string& part : {program.cpu->station, program.cpu->name})
          if (!part.empty()) path += part + "/";
      }
      path += program.name;
      std::string unique = path;
      for (int i = 2; !taken.insert(unique).second; ++i) unique = fmt::format("{} ({})", path, i);
      program.path = std::move(unique);
    }
  }

  TextEncoding encoding_;
  ProjectFiles files_;
  S7Project project_;
  std::vector<std::string> faults_;
  std::vector<ProjectFault> ofContainers_;  ///< with the container in place of the program
  std::map<std::int64_t, CpuConfiguration> hardware_;
  std::set<std::string> read_;  ///< containers
  bool isLinkListRead_ = false;
  std::optional<DbaseTable> linkList_, symbolLists_;
};

struct KeptProjects {
  std::mutex mutex;
  std::map<std::pair<std::string, TextEncoding>, std::shared_ptr<const S7Project>> projects;
};

KeptProjects& keptProjects() {
  static KeptProjects kept;
  return kept;
}

}  // namespace

std::string textOfCodePage(std::string_view bytes, unsigned page) {
  if (std::ranges::none_of(bytes, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }))
    return std::string(bytes);
  // ICU has 936 as GB18030, which contains it, and the Windows pages by their names.
  std::string name = fmt::format("windows-{}", page);
  if (page == 65001) name = "UTF-8";
  if (page == 936) name = "GB18030";
  UErrorCode error = U_ZERO_ERROR;
  std::string text(bytes.size() * 4 + 4, '\0');
  const std::int32_t length = ucnv_convert("UTF-8", name.c_str(), text.data(), static_cast<std::int32_t>(text.size()),
                                           bytes.data(), static_cast<std::int32_t>(bytes.size()), &error);
  if (U_FAILURE(error)) {
    error = U_ZERO_ERROR;
    const std::int32_t plain =
        ucnv_convert("UTF-8", "windows-1252", text.data(), static_cast<std::int32_t>(text.size()), bytes.data(),
                     static_cast<std::int32_t>(bytes.size()), &error);
    return text.substr(0, U_FAILURE(error) ? 0 : static_cast<std::size_t>(plain));
  }
  return text.substr(0, static_cast<std::size_t>(length));
}

S7Project readS7Project(const std::string& file, TextEncoding encoding) {
  return ProjectReaderS7(file, encoding).read();
}

std::shared_ptr<const S7Project> s7ProjectOf(const std::string& file, TextEncoding encoding) {
  KeptProjects& kept = keptProjects();
  const std::lock_guard lock(kept.mutex);
  // What another run has kept may have changed since.
  const std::vector<std::string> names = inputNames();
  std::shared_ptr<const S7Project>& project = kept.projects[{file, encoding}];
  if (project == nullptr || std::ranges::find(names, file) == names.end()) {
    noteInput(file);
    project = std::make_shared<const S7Project>(readS7Project(file, encoding));
  }
  return project;
}

}  // namespace rungproof::s7project
