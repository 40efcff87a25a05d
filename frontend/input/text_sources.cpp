// Sources are read in place of the blocks that they define.
#include "frontend/input/text_sources.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/equivalence/network_match.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/input/stored_reader.hpp"
#include "frontend/step7/source_parser.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/desc.hpp"
#include "ir/s7300/pointer_code.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

using step7::BlockKey;
using step7::BlockSyntax;

/// The bits of a pointer that P##name loads: local data, or the block's own instance. Nothing: another operand.
std::optional<std::uint32_t> loadedPointer(const Operand& operand) {
  if (operand.kind != OperandKind::Address) return std::nullopt;
  const bool isLocal = operand.reach == nullptr && operand.area == Area::L;
  const bool isOwn = operand.reach != nullptr && operand.reach->way == Way::Instance;
  if (!isLocal && !isOwn) return std::nullopt;
  const auto area = static_cast<std::uint32_t>(isLocal ? PointerArea::L : PointerArea::Di);
  return 0x80000000U | area << 24 | (operand.offset * 8 + operand.bit);
}

bool isLabelled(const Instruction& instruction) {
  const Control control = instruction.desc->control;
  return control == Control::LabelMark || control == Control::Jump || control == Control::Branch;
}

/// The statements of a network as both a source and machine code have them: labels by their order, pointers by their
/// bits, and without the bit that the compiler saves in front of a call.
std::vector<std::string> statementsOf(const Network& network) {
  std::vector<std::string> lines;
  std::map<std::int64_t, std::size_t> labels;
  const std::vector<Instruction>& all = network.instructions;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Instruction& instruction = all[i];
    const bool isCall = i + 1 < all.size() && all[i + 1].desc->control == Control::BlockCall;
    const bool isSaved = isCall && statementRole(instruction) == StatementRole::Assign &&
                         instruction.operands.size() == 1 && instruction.operands[0].area == Area::L &&
                         instruction.operands[0].reach == nullptr;
    if (isSaved) continue;
    std::string line = textInOld(instruction, {});
    if (isLabelled(instruction) && !instruction.operands.empty()) {
      const auto number = labels.emplace(instruction.operands[0].value, labels.size()).first->second;
      line = fmt::format("{} label {}", instruction.desc->stl, number);
    } else if (instruction.operands.size() == 1) {
      if (const auto pointer = loadedPointer(instruction.operands[0]))
        line = fmt::format("{} {}", instruction.desc->stl, *pointer);
      else if (instruction.desc->control == Control::BlockCall)
        line = "CALL" + line.substr(instruction.desc->stl.size());  // UC without parameters is the same
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Numbers of the networks of the source that the stored block does not have as they are; empty: none.
std::vector<int> unlikeNetworks(const Pou& stored, const Pou& source) {
  std::vector<int> unlike;
  const std::size_t most = std::max(stored.networks.size(), source.networks.size());
  for (std::size_t i = 0; i < most; ++i) {
    const bool isInBoth = i < stored.networks.size() && i < source.networks.size();
    if (!isInBoth || statementsOf(stored.networks[i]) != statementsOf(source.networks[i]))
      unlike.push_back(static_cast<int>(i) + 1);
  }
  return unlike;
}

class SourceComparer {
 public:
  SourceComparer(const Program& program, const s7project::S7Project& project, const std::string& path,
                 const Settings& settings)
      : program_(program),
        project_(project),
        path_(path),
        name_(project.file.empty() ? path : fmt::format("{}/{}", project.file, path)),
        settings_(settings) {}

  std::vector<Finding> compare() {
    const auto own = std::ranges::find(project_.programs, path_, &s7project::ProjectProgram::path);
    if (own == project_.programs.end()) return {};
    for (const s7project::TextSource& source : own->sources) {
      if (!source.isScl) place(source, own->symbols);
    }
    for (const Group& group : groups_) compare(group);
    return std::move(findings_);
  }

 private:
  /// Sources that define no block twice: the project is read once with all of them.
  struct Group {
    std::vector<const s7project::TextSource*> sources;
    std::set<BlockKey> keys;
  };

  void place(const s7project::TextSource& source, const std::vector<s7project::Symbol>& symbols) {
    const std::vector<BlockKey> keys = blocksOf(source, symbols);
    if (keys.empty()) return;
    auto group = std::ranges::find_if(groups_, [&](const Group& each) {
      return std::ranges::none_of(keys, [&](BlockKey key) { return each.keys.contains(key); });
    });
    if (group == groups_.end()) group = groups_.emplace(groups_.end());
    group->sources.push_back(&source);
    group->keys.insert(keys.begin(), keys.end());
  }

  void compare(const Group& group) {
    s7project::S7Project with = project_;
    const auto own = std::ranges::find(with.programs, path_, &s7project::ProjectProgram::path);
    std::erase_if(own->blocks, [&](const mc7::StoredBlock& block) { return group.keys.contains(block.key); });
    Program other;
    step7::Step7Project step7;
    StoredReader reader(other, step7);
    reader.addProgram(with, path_, "", settings_.text(Opt::Protected) == "contract");
    std::map<std::uint32_t, const s7project::TextSource*> sources;
    for (const s7project::TextSource* source : group.sources) {
      const std::uint32_t file = other.sources->add(source->name, source->text);
      step7.sources.push_back({file, TextEncoding::Utf8});
      sources[file] = source;
    }
    step7::buildStep7Project(other, step7, readOptionsOf(settings_));
    std::map<std::uint32_t, std::uint32_t> shown;  // files of the program itself, by those beside it
    for (const Pou& pou : other.pous) {
      const auto source = sources.find(pou.span.file);
      const Pou* stored = pou.isBuiltIn || source == sources.end() ? nullptr : storedOf(pou);
      if (stored == nullptr) continue;
      const bool isWhole = std::ranges::all_of(pou.networks, &Network::complete) &&
                           std::ranges::all_of(stored->networks, &Network::complete);
      const std::vector<int> unlike = isWhole ? unlikeNetworks(*stored, pou) : std::vector<int>{};
      if (unlike.empty()) continue;
      const auto [place, isNew] = shown.emplace(source->first, 0);
      if (isNew)
        place->second =
            program_.sources->add(fmt::format("{}/Sources/{}", name_, source->second->name), source->second->text);
      note(pou, unlike, place->second, source->second->name);
    }
  }

  /// The blocks that the text heads, by number or by symbol.
  std::vector<BlockKey> blocksOf(const s7project::TextSource& source, const std::vector<s7project::Symbol>& symbols) {
    Program scratch;
    const std::uint32_t file = scratch.sources->add(source.name, source.text);
    SyntaxSink sink(scratch, file);
    const step7::SourceSyntax read = step7::readSource(scratch.sources->file(file).text(),
                                                       {step7::MnemonicSet::International, TextEncoding::Utf8}, sink);
    std::vector<BlockKey> keys;
    for (const BlockSyntax& block : read.blocks) {
      if (block.name.kind) keys.push_back({*block.name.kind, block.name.number});
      for (const s7project::Symbol& symbol : symbols) {
        if (block.name.kind || !s7300::isSameName(symbol.name, block.name.symbol)) continue;
        step7::Cursor cursor(symbol.address, file);
        if (const auto name = step7::readBlockName(cursor); name && name->kind)
          keys.push_back({*name->kind, name->number});
      }
    }
    return keys;
  }

  const Pou* storedOf(const Pou& pou) const {
    const auto found = std::ranges::find_if(program_.pous, [&](const Pou& stored) {
      return stored.type == pou.type && stored.number == pou.number && !stored.isBuiltIn;
    });
    return found == program_.pous.end() || found->protectedBlock ? nullptr : &*found;
  }

  void note(const Pou& pou, const std::vector<int>& unlike, std::uint32_t file, const std::string& source) {
    const SyntaxMessage& message = syntaxMessage(Syntax::SourceUnlike);
    Finding finding;
    finding.rule = message.id;
    finding.severity = message.severity;
    finding.help = message.help;
    finding.pou = pou.name;
    finding.span = {file, pou.span.offset, std::min<std::uint32_t>(pou.span.length, 1)};
    finding.message = fmt::format("{} is another one in the source {} than the block that runs: network{} {}", pou.name,
                                  source, unlike.size() == 1 ? "" : "s", fmt::join(unlike, ", "));
    findings_.push_back(std::move(finding));
  }

  const Program& program_;
  const s7project::S7Project& project_;
  const std::string& path_;
  const std::string name_;  ///< of the program in findings
  const Settings& settings_;
  std::vector<Group> groups_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> findUnlikeSources(const Program& program, const s7project::S7Project& project,
                                       const std::string& path, const Settings& settings) {
  return SourceComparer(program, project, path, settings).compare();
}

std::vector<Finding> findUnlikeSources(const Program& program, const std::vector<std::string>& files,
                                       const Settings& settings) {
  std::vector<Finding> findings;
  for (const std::string& file : files) {
    const std::optional<ProjectArgument> argument = projectArgument(file);
    if (!argument || argument->program.empty()) continue;
    const auto project = s7project::s7ProjectOf(argument->file, *encodingNamed(settings.text(Opt::Encoding)));
    for (Finding& finding : findUnlikeSources(program, *project, argument->program, settings))
      findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace rungproof
