// Sources of stored blocks.
#include "frontend/input/stored_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <ranges>

#include "frontend/mc7/block_head.hpp"
#include "frontend/mc7/missing_types.hpp"
#include "frontend/step7/source_parser.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof {

namespace {

using mc7::StoredBlock;
using step7::MnemonicSet;

TextEncoding encodingOfPage(unsigned page) {
  return page == 65001  ? TextEncoding::Utf8
         : page == 1251 ? TextEncoding::Cp1251
         : page == 936  ? TextEncoding::Gb18030
                        : TextEncoding::Cp1252;
}

/// A row of an .sdf table: fields padded with blanks.
std::string symbolRow(const s7project::Symbol& symbol) {
  const auto plain = [](std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == '"' || static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text;
  };
  return fmt::format("\"{:<24}\",\"{:<12}\",\"{:<10}\",\"{}\"\n", plain(symbol.name), plain(symbol.address),
                     plain(symbol.type), plain(symbol.comment));
}

}  // namespace

void StoredReader::addProgram(const s7project::S7Project& project, std::string_view path, const std::string& name,
                              bool hidesProtected) {
  const std::uint32_t file = program_.sources->add(project.file, "");
  SyntaxSink sink(program_, file);
  if (project.failure) return sink.report(Syntax::FileUnreadable, {file, 0, 0}, project.failure->message);
  for (const s7project::ProjectFault& fault : project.faults) {
    if (fault.program.empty() || fault.program == path)
      sink.report(fault.isLoss ? Syntax::ProjectLost : Syntax::ProjectDamaged, {file, 0, 0}, fault.text);
  }
  const auto isMeant = [&](const s7project::ProjectProgram& program) {
    return path.empty() ? !program.blocks.empty() : program.path == path;
  };
  const auto program = std::ranges::find_if(project.programs, isMeant);
  if (program == project.programs.end())
    return sink.report(Syntax::FileUnreadable, {file, 0, 0}, fmt::format("{} has no program {}", project.file, path));
  if (path.empty() && std::ranges::count_if(project.programs, isMeant) > 1)
    return sink.report(Syntax::FileUnreadable, {file, 0, 0},
                       fmt::format("{} has several programs: name one with --program", project.file));
  std::vector<std::string> names;
  for (const StoredBlock& block : program->blocks) names.push_back(fmt::format("{}/{}", name, toString(block.key)));
  const TextEncoding encoding = encodingOfPage(project.codePage);
  addBlocks(program->blocks, names, encoding, hidesProtected);
  addSymbols(program->symbols, name, encoding);
}

void StoredReader::addUploads(const std::vector<StoredBlock>& blocks, bool hidesProtected) {
  if (blocks.empty()) return;
  std::vector<std::string> names;
  for (const StoredBlock& block : blocks) names.push_back(block.place);
  addBlocks(blocks, names, TextEncoding::Cp1252, hidesProtected);
}

void StoredReader::addBlocks(std::vector<StoredBlock> blocks, std::vector<std::string> names, TextEncoding encoding,
                             bool hidesProtected) {
  for (StoredBlock& type : mc7::missingTypesOf(blocks)) {
    names.push_back(fmt::format("{} (missing)", toString(type.key)));
    blocks.push_back(std::move(type));
  }
  const std::vector<mc7::BlockSource> sources = mc7::sourcesOf(blocks, hidesProtected);
  std::vector<std::uint32_t> files(blocks.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].key.kind == step7::BlockKind::Sfb) addFrame(blocks[i], names[i]);
    if (next == sources.size() || sources[next].key != blocks[i].key) continue;
    const mc7::BlockSource& source = sources[next++];
    const bool isHidden = !source.shown.empty();
    const std::uint32_t file = files[i] = program_.sources->add(names[i], isHidden ? source.shown : source.text);
    step7::PendingFile& pending = step7_.sources.emplace_back();
    pending = {file, encoding, MnemonicSet::International, {}};
    if (isHidden) pending.hidden = std::make_shared<const std::string>(source.text);
    if (!source.image.empty()) pending.image = std::make_shared<const std::string>(source.image);
    if (!source.damage.empty()) reportDamage(blocks[i], source, file);
  }
  reportConflicts(blocks, files);
}

/// The interface of a system block that the library does not have.
void StoredReader::addFrame(const StoredBlock& block, const std::string& name) {
  if (s7300::libraryBlock(BlockType::Sfb, block.key.number) != nullptr) return;
  const std::string text =
      mc7::headOf(block, false).text + fmt::format("{}\n", mc7::endKeywordOf(step7::BlockKind::Fb));
  const std::uint32_t file = program_.sources->add(name, text);
  SyntaxSink sink(program_, file);
  step7::SourceSyntax source =
      step7::readSource(program_.sources->file(file).text(), {MnemonicSet::International, TextEncoding::Utf8}, sink);
  for (step7::BlockSyntax& each : source.blocks) each.name.kind = step7::BlockKind::Sfb;
  step7_.drawn.push_back(std::move(source));
}

void StoredReader::addSymbols(const std::vector<s7project::Symbol>& symbols, const std::string& name,
                              TextEncoding encoding) {
  if (symbols.empty()) return;
  std::string text;
  for (const s7project::Symbol& symbol : symbols) text += symbolRow(symbol);
  const std::uint32_t file = program_.sources->add(name + "/Symbols", std::move(text));
  step7_.tables.push_back({file, encoding, MnemonicSet::International, {}});
}

void StoredReader::reportDamage(const StoredBlock& block, const mc7::BlockSource& source, std::uint32_t file) {
  if (block.isLostWithOthers) return;
  SyntaxSink sink(program_, file);
  sink.setPlace(toString(block.key), 0);
  sink.report(Syntax::ProjectDamaged, {file, 0, 1},
              fmt::format("{} is not read: {} ({})", toString(block.key), source.damage, block.place));
}

/// Callers keep the time stamp that the interface of a block had when they were compiled. One finding for each block
/// whose interface is another one now.
void StoredReader::reportConflicts(const std::vector<StoredBlock>& blocks, const std::vector<std::uint32_t>& files) {
  std::map<step7::BlockKey, mc7::TimeStamp> stamps;
  for (const StoredBlock& block : blocks) stamps[block.key] = block.interfaceTime;
  std::map<step7::BlockKey, std::vector<std::size_t>> callers;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (const mc7::UsedBlock& used : blocks[i].used) {
      const auto known = stamps.find(used.key);
      if (known == stamps.end() || known->second == 0 || used.interface == 0 || known->second == used.interface)
        continue;
      std::vector<std::size_t>& list = callers[used.key];
      if (list.empty() || list.back() != i) list.push_back(i);
    }
  }
  for (const auto& [key, list] : callers) {
    SyntaxSink sink(program_, files[list.front()]);
    sink.setPlace(toString(blocks[list.front()].key), 0);
    constexpr std::size_t mostNames = 4;
    std::vector<std::string> names;
    for (const std::size_t caller : list | std::views::take(mostNames)) names.push_back(toString(blocks[caller].key));
    const std::string more = list.size() > mostNames ? fmt::format(" and {} more", list.size() - mostNames) : "";
    sink.report(Syntax::TimeStampConflict, {files[list.front()], 0, 1},
                fmt::format("{}{} {} compiled with another interface of {} than the project has",
                            fmt::join(names, ", "), more, list.size() == 1 ? "was" : "were", toString(key)));
  }
}

}  // namespace rungproof
