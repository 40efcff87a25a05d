// From files to blocks.
#include "frontend/step7/step7_project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "frontend/step7/library_source.hpp"
#include "frontend/step7/mnemonic_vote.hpp"
#include "frontend/step7/scl_lowering.hpp"
#include "frontend/step7/source_check.hpp"
#include "frontend/step7/source_parser.hpp"
#include "frontend/step7/statement_binder.hpp"
#include "frontend/step7/symbol_list.hpp"
#include "frontend/xml/xml_text.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/declarations.hpp"
#include "ir/s7300/dialect.hpp"
#include "ir/s7300/library_contract.hpp"
#include "ir/s7300/pointer_parameter.hpp"
#include "ir/subroutine_index.hpp"

namespace rungproof::step7 {

using s7300::Field;
using s7300::Structure;
using s7300::Type;
using s7300::TypeKind;

namespace {

DataType dataTypeOf(const Type& type) {
  switch (type.kind) {
    case TypeKind::Bool: return DataType::Bool;
    case TypeKind::Byte: return DataType::Byte;
    case TypeKind::Char: return DataType::Char;
    case TypeKind::Word: return DataType::Word;
    case TypeKind::Int: return DataType::Int;
    case TypeKind::S5Time: return DataType::S5Time;
    case TypeKind::Date: return DataType::Date;
    case TypeKind::DWord: return DataType::DWord;
    case TypeKind::DInt: return DataType::DInt;
    case TypeKind::Real: return DataType::Real;
    case TypeKind::Time: return DataType::Time;
    case TypeKind::TimeOfDay: return DataType::TimeOfDay;
    case TypeKind::DateAndTime: return DataType::DateAndTime;
    case TypeKind::String: return DataType::String;
    case TypeKind::Array: return DataType::Array;
    case TypeKind::Struct: return DataType::Struct;
    case TypeKind::Timer: return DataType::Timer;
    case TypeKind::Counter: return DataType::Counter;
    case TypeKind::BlockDb:
    case TypeKind::BlockSdb: return DataType::BlockDb;
    case TypeKind::BlockFc: return DataType::BlockFc;
    case TypeKind::BlockFb: return DataType::BlockFb;
    case TypeKind::Pointer: return DataType::Pointer;
    case TypeKind::Any: return DataType::Any;
    default: return DataType::Void;
  }
}

VarSection varSectionOf(Section section) {
  switch (section) {
    case Section::Input: return VarSection::Input;
    case Section::Output:
    case Section::Return: return VarSection::Output;
    case Section::InOut: return VarSection::InOut;
    case Section::Static: return VarSection::Static;
    default: return VarSection::Temp;
  }
}

/// "FB 2", "SFB 4": the block whose instance the type is, or 0.
int instanceBlock(const Type& type) {
  if (type.kind != TypeKind::Struct) return 0;
  const bool isSystem = type.name.starts_with("SFB ");
  if (!isSystem && !type.name.starts_with("FB ")) return 0;
  const auto number = static_cast<std::uint32_t>(std::stoul(type.name.substr(type.name.find(' ') + 1)));
  return irNumber({isSystem ? BlockKind::Sfb : BlockKind::Fb, number});
}

LocalVariable localVariable(const Field& field, bool isInstance, std::uint32_t parameter) {
  LocalVariable local;
  local.name = field.name;
  local.section = varSectionOf(field.section);
  local.type = dataTypeOf(field.type);
  local.span = field.span;
  local.instanceOf = instanceBlock(field.type);
  if (local.instanceOf != 0) local.type = DataType::Instance;
  local.size = field.type.kind == TypeKind::Bool ? 0 : static_cast<std::uint32_t>(s7300::sizeOf(field.type));
  const Width width = s7300::accessWidth(field.type).value_or(Width::Byte);
  local.address = direct(field.section == Section::Temp ? Area::L : Area::DB, width, field.byte, field.bit);
  local.address.span = field.span;
  if (field.section == Section::Temp) return local;
  local.pointerByte = field.byte;
  local.address.kind = OperandKind::Indirect;
  Reach reach{};
  reach.way = Way::Instance;
  if (!isInstance || field.byReference || isNumberType(field.type.kind)) {
    reach.way = Way::Parameter;
    reach.parameter = parameter;
    local.address.offset = 0;
    local.address.bit = 0;
    if (field.type.kind == TypeKind::Timer) local.address.area = Area::T;
    if (field.type.kind == TypeKind::Counter) local.address.area = Area::C;
  }
  local.address.reach = Shared<Reach>(std::move(reach));
  return local;
}

class ProjectBuilder {
 public:
  ProjectBuilder(Program& program, const ReadOptions& options)
      : program_(program), options_(options), reports_(program) {}

  void build(const Step7Project& project) {
    chooseTarget();
    declarations_ = std::make_shared<s7300::Declarations>();
    readFiles(project);
    declarations_->absentInstances = settleInstances(sources_, symbols_, project.drawnInstances);
    catalogue_.emplace(sources_, symbols_, reports_);
    types_.emplace(*catalogue_, reports_);
    addSymbols();
    for (const CatalogueEntry& entry : catalogue_->entries()) {
      if (entry.key.kind == BlockKind::Udt) types_->structure(entry.key);
      if (entry.key.kind == BlockKind::Db) dataBlock(entry);
    }
    std::ranges::sort(program_.dataBlocks, {}, &DataBlock::number);
    StatementBinder statements(*catalogue_, *types_, reports_);
    for (const CatalogueEntry& entry : catalogue_->entries()) {
      const BlockKind kind = entry.key.kind;
      if (kind == BlockKind::Ob || kind == BlockKind::Fc || kind == BlockKind::Fb) codeBlock(entry, statements);
    }
    addLibraryBlocks(statements);
    placeHandedPointers(program_);
    addDirectivesOutside();
    noteBounds();
    reports_.countUses();
    program_.declarations = declarations_;
  }

 private:
  void chooseTarget() {
    if (isStep7(program_.target)) return;
    program_.target = options_.dialect == s7400Dialect.name ? s7400Dialect.usual : s7300Dialect.usual;
  }

  void readFiles(const Step7Project& project) {
    std::vector<std::string_view> texts;
    std::vector<std::string_view> open;  // those whose mnemonics are not known beforehand
    for (const PendingFile& file : project.sources) {
      texts.push_back(file.hidden ? std::string_view(*file.hidden) : program_.sources->file(file.file).text());
      open.push_back(file.set ? std::string_view() : texts.back());
    }
    const MnemonicVote vote(open, options_.mnemonics);
    for (std::size_t i = 0; i < project.sources.size(); ++i) {
      const PendingFile& pending = project.sources[i];
      SyntaxSink sink(program_, pending.file);
      if (!pending.set && vote.isTied(i)) {
        sink.report(Syntax::FamilyUndecided, {pending.file, 0, 0},
                    fmt::format("{} has as many international mnemonics as German ones: --mnemonics international or "
                                "german says which they are",
                                program_.sources->file(pending.file).name()));
        continue;
      }
      const MnemonicSet set = pending.set.value_or(vote.of(i));
      sets_[pending.file] = set;
      if (pending.hidden) hidden_.insert(pending.file);
      if (pending.image) images_[pending.file] = pending.image;
      sources_.push_back(readSource(texts[i], {set, pending.encoding}, sink));
      const bool isText = !pending.set.has_value();  // and not statements that were decoded
      if (isText) checkSource(sources_.back(), texts[i], declarations_->sourceFaults);
    }
    for (const PendingFile& pending : project.tables) {
      SyntaxSink sink(program_, pending.file);
      const std::string_view text = program_.sources->file(pending.file).text();
      std::vector<SymbolRow> rows =
          looksLikeXml(text) ? readTagTable(program_.sources->file(pending.file), sink)
                             : readSymbolList(text, pending.set.value_or(setOfTable(text, vote.ofProject())), sink);
      std::ranges::move(rows, std::back_inserter(symbols_));
    }
    sources_.insert(sources_.end(), project.drawn.begin(), project.drawn.end());
    symbols_.insert(symbols_.end(), project.drawnSymbols.begin(), project.drawnSymbols.end());
    const auto nameTitle = [&](std::string& title) {
      if (const auto text = project.texts.find(title); text != project.texts.end()) title = text->second;
    };
    for (BlockSyntax& block : sources_ | std::views::transform(&SourceSyntax::blocks) | std::views::join) {
      nameTitle(block.title);
      for (NetworkSyntax& network : block.networks) nameTitle(network.title);
    }
  }

  /// Tables are written in the mnemonics of the machine that exported them.
  MnemonicSet setOfTable(std::string_view text, MnemonicSet ofProject) const {
    if (options_.mnemonics != Mnemonics::Auto) return ofProject;
    const int german = symbolListShare(text, MnemonicSet::German);
    const int international = symbolListShare(text, MnemonicSet::International);
    if (german == international) return ofProject;
    return german > international ? MnemonicSet::German : MnemonicSet::International;
  }

  void addSymbols() {
    BlockScope nowhere;
    OperandBinder binder(*catalogue_, *types_);
    for (const SymbolRow& row : symbols_) {
      if (row.address.form != OperandForm::Address) continue;
      BoundOperand bound = binder.bind(row.address, nowhere);
      if (!bound.fault.empty()) continue;  // told where the symbol is used
      if (const std::optional<s7300::Type> type = s7300::typeNamed(row.type); type && bound.operand.isMemory()) {
        const auto [known, isNew] =
            declarations_->symbolTypes.emplace(std::pair(bound.operand.area, bound.operand.offset), type->kind);
        if (!isNew && known->second != type->kind) known->second = s7300::TypeKind::Unknown;
      }
      program_.symbols.push_back({row.name.text, std::move(bound.operand), row.comment, row.name.span});
    }
  }

  // Data ------------------------------------------------------------------------------------------------------------

  void dataBlock(const CatalogueEntry& entry) {
    const BlockSyntax& syntax = *entry.syntax;
    const std::uint32_t number = entry.key.number;
    const std::shared_ptr<const Structure> structure = types_->structure(entry.key);
    if (number == 0 || number > lastDataBlock) {
      reports_.report(Syntax::NotModelled, syntax.heading,
                      fmt::format("{} is not between DB1 and DB{}", entry.name, lastDataBlock), entry.name, 0);
      return;
    }
    const TypeTable::Doubt doubt = types_->doubtOf(entry.key);
    if (doubt.type && !types_->isOpaque(entry.key)) {
      declarations_->openBlocks.emplace(number, doubt.cause);
    } else if (doubt.value) {
      declarations_->openValues.push_back({number, 0, 0, doubt.cause});
    }
    if (structure == nullptr) return;
    DataBlock block;
    block.number = number;
    if (entry.name != toString(entry.key)) block.name = entry.name;
    block.bytes = s7300::initialBytes(*structure);
    if (!types_->isOpaque(entry.key))
      for (const Assignment& assignment : syntax.assignments)
        assign(entry, *structure, assignment, doubt.type, block.bytes);
    if (const auto image = images_.find(syntax.heading.file); image != images_.end())
      takeImage(*image->second, block.bytes);
    if (const std::optional<BlockKey> instance = types_->instanceOf(syntax)) block.instanceOf = irNumber(*instance);
    block.readOnly = syntax.readOnly;
    block.unlinked = syntax.unlinked;
    block.nonRetain = syntax.nonRetain;
    block.span = syntax.heading;
    declarations_->dataBlocks[number] = structure;
    if (!block.name.empty()) declarations_->dataBlockNames[s7300::foldedName(block.name)] = number;
    program_.dataBlocks.push_back(std::move(block));
  }

  /// The bytes that are stored, which may lack or have one that fills the block up.
  static void takeImage(std::string_view image, std::vector<std::uint8_t>& bytes) {
    if (image.size() > bytes.size() + 1 || bytes.size() > image.size() + 1) return;
    std::copy_n(image.begin(), std::min(image.size(), bytes.size()), bytes.begin());
  }

  /// A start value. Where the type of the block is not known, one finding has said so.
  void assign(const CatalogueEntry& entry, const Structure& structure, const Assignment& assignment, bool isTypeInDoubt,
              std::vector<std::uint8_t>& bytes) {
    const s7300::PathResult found = lookUp(structure, assignment.path);
    if (found.fault != s7300::PathFault::None || found.byReference) {
      if (isTypeInDoubt) return;
      const PathStep& step = assignment.path[std::min(found.step, assignment.path.size() - 1)];
      const bool isIndex = found.fault == s7300::PathFault::IndexRange || found.fault == s7300::PathFault::IndexCount;
      reports_.report(Syntax::NameUndefined, step.span,
                      isIndex ? fmt::format("{} has no such element", step.name)
                              : fmt::format("{} declares no {}", entry.name, step.name),
                      entry.name, 0);
      declarations_->openValues.push_back({entry.key.number, 0, 0, step.span});
      return;
    }
    if (found.type->kind == TypeKind::Unknown) return;
    const auto fault = s7300::writeValues(*found.type, assignment.values, found.byte, found.bit, bytes);
    if (!fault) return;
    const Constant& value = assignment.values[std::min(fault->value, assignment.values.size() - 1)];
    declarations_->openValues.push_back({entry.key.number, found.byte,
                                         std::max(1U, static_cast<std::uint32_t>(s7300::sizeOf(*found.type))),
                                         value.span});
    reports_.report(Syntax::ValueOfType, value.span,
                    fault->tooMany ? fmt::format("{} has fewer elements than values", assignment.path.back().name)
                                   : fmt::format("the value is no {}", s7300::toString(*found.type)),
                    entry.name, 0);
  }

  // Code ------------------------------------------------------------------------------------------------------------

  /// The block with statements in place of what is written in SCL.
  const BlockSyntax& withStatements(const BlockSyntax& written, BlockScope& scope, BlockSyntax& lowered) {
    const auto isScl = [](const NetworkSyntax& network) { return network.scl != nullptr; };
    if (std::ranges::none_of(written.networks, isScl)) return written;
    lowered = written;
    SclLowering lowering(*catalogue_, *types_, reports_, scope);
    if (written.isScl) {
      lowered.networks = lowering.lower(*written.networks[0].scl, written.networks[0]);
      for (DirectiveSyntax& directive : lowered.directives) {
        for (const NetworkSyntax& network : lowered.networks) {
          if (directive.network != 0 && directive.span.offset >= network.span.offset)
            directive.network = network.number;
        }
      }
      return lowered;
    }
    for (NetworkSyntax& network : lowered.networks) {
      if (isScl(network)) lowering.lowerInto(*network.scl, network);
    }
    return lowered;
  }

  void codeBlock(const CatalogueEntry& entry, StatementBinder& statements) {
    const BlockSyntax& written = *entry.syntax;
    const bool isInstance = entry.key.kind == BlockKind::Fb;
    BlockScope scope;
    scope.key = entry.key;
    scope.name = entry.name;
    scope.parameters = isInstance ? types_->structure(entry.key) : types_->parameters(written);
    scope.temporary = types_->temporary(written);
    scope.constants = types_->constants(written);
    BlockSyntax lowered;
    const BlockSyntax& syntax = withStatements(written, scope, lowered);
    Pou pou;
    pou.type = blockTypeOf(irNumber(entry.key));
    pou.kind = entry.key.kind != BlockKind::Ob ? PouKind::Subroutine
               : entry.key.number == 1         ? PouKind::Main
                                               : PouKind::Interrupt;
    pou.number = irNumber(entry.key);
    pou.name = entry.name;
    pou.title = syntax.title;
    pou.span = syntax.span;
    if (isInstance) pou.instanceBytes = static_cast<std::uint32_t>(scope.parameters->size);
    std::uint32_t index = 0;
    for (const Field& field : scope.parameters->fields) pou.locals.push_back(localVariable(field, isInstance, index++));
    for (const Field& field : scope.temporary->fields) pou.locals.push_back(localVariable(field, isInstance, 0));
    for (const Remark& remark : syntax.remarks) pou.comments.push_back({remark.span});
    const bool isEmpty =
        std::ranges::all_of(syntax.networks, [](const NetworkSyntax& network) { return network.statements.empty(); });
    if (isEmpty && (syntax.knowHowProtected || (!syntax.hasBody && entry.key.kind != BlockKind::Ob))) {
      pou.protectedBlock = true;
      reports_.report(Syntax::ProtectedBlock, syntax.heading,
                      fmt::format("{} is there as an interface only", entry.name), entry.name, 0, standInHelp);
    }
    statements.findLabels(syntax, scope);
    const MnemonicSet set = sets_[syntax.heading.file];
    // Where a type is not known, nobody knows where what is declared behind it lies.
    const bool isInDoubt = types_->doubtOf(written).type || (isInstance && types_->doubtOf(entry.key).type);
    for (const NetworkSyntax& each : syntax.networks) {
      Network& network = pou.networks.emplace_back();
      network.number = each.number;
      network.title = each.title;
      network.span = each.span;
      network.form = each.form;
      network.isStructured = each.isStructured;
      for (const Remark& remark : each.remarks) network.comments.push_back({remark.span});
      statements.bind(each, set, scope, network);
      if (each.isUnread) network.mayWrite.reset();
      if (each.keepsStores) network.mayWrite.emplace();
      if (isInDoubt && network.complete && !each.isUnread) network.mayWrite.emplace();
      if (each.isUnread || isInDoubt) network.complete = false;
    }
    if (syntax.isOpen && !pou.networks.empty()) {  // statements may be missing behind the last one
      pou.networks.back().complete = false;
      pou.networks.back().mayWrite.reset();
    }
    std::uint32_t local = std::max(static_cast<std::uint32_t>(scope.temporary->size), scope.localBytes);
    if (entry.key.kind == BlockKind::Ob) local = std::max(local, startInformationBytes);
    pou.localBytes = local + (local & 1U);
    const int pouIndex = static_cast<int>(program_.pous.size());
    const bool isHidden = hidden_.contains(syntax.heading.file);
    if (isHidden) declarations_->protectedBlocks.insert(pou.number);
    for (const DirectiveSyntax& directive : syntax.directives) {
      if (!isHidden) program_.directives.push_back({directive.text, directive.span, pouIndex, directive.network});
    }
    declarations_->parameters[pou.number] = scope.parameters;
    declarations_->temporary[pou.number] = scope.temporary;
    program_.pous.push_back(std::move(pou));
  }

  /// Blocks of the CPU and the libraries that are called and not the program's own, as far as their statements are
  /// known. They stand in a file of their own, named after them.
  void addLibraryBlocks(StatementBinder& statements) {
    std::set<int> wanted;
    for (const Pou& pou : program_.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          const bool isCall = instruction.desc->control == Control::BlockCall && !instruction.operands.empty();
          if (isCall && instruction.operands[0].kind == OperandKind::Constant)
            wanted.insert(static_cast<int>(instruction.operands[0].value));
        }
      }
    }
    const SubroutineIndex own(program_);
    std::erase_if(wanted, [&](int number) { return own[number] != nullptr; });
    for (const int number : wanted) {
      const auto in = static_cast<std::uint32_t>(numberOfBlock(number));
      if (const s7300::LibraryBlock* block = s7300::libraryBlock(blockTypeOf(number), in)) {
        const std::string text = librarySource(*block, step7Row(program_.target.cpu).image);
        if (!text.empty())
          libraryBlock(number, s7300::standInName(*block), interfaceOf(*block), text, block->isBuiltIn, statements);
        continue;
      }
      const bool isFunction = blockTypeOf(number) == BlockType::Sfc;
      if (!isFunction && blockTypeOf(number) != BlockType::Sfb) continue;
      const BlockKey key{isFunction ? BlockKind::Sfc : BlockKind::Sfb, in};
      if (const auto parameters = statements.undescribedInterface(key); parameters != nullptr) {
        libraryBlock(number, blockName(number) + " of the system", parameters, std::string(emptyBody), true,
                     statements);
        declarations_->parameters[number] = parameters;
      }
    }
  }

  void libraryBlock(int number, const std::string& name, std::shared_ptr<const Structure> interface,
                    const std::string& text, bool isBuiltIn, StatementBinder& statements) {
    const std::uint32_t file =
        program_.sources->add(name, fmt::format("FUNCTION FC 1 : VOID\n{}\nEND_FUNCTION\n", text));
    SyntaxSink sink(program_, file);
    librarySources_.push_back(std::make_unique<SourceSyntax>(
        readSource(program_.sources->file(file).text(), {MnemonicSet::International, TextEncoding::Utf8}, sink)));
    const BlockSyntax& syntax = librarySources_.back()->blocks.at(0);
    Pou pou;
    pou.type = blockTypeOf(number);
    pou.kind = PouKind::Subroutine;
    pou.number = number;
    pou.name = name;
    pou.span = syntax.span;
    pou.isBuiltIn = isBuiltIn;
    BlockScope scope;
    scope.key = {pou.type == BlockType::Sfb   ? BlockKind::Sfb
                 : pou.type == BlockType::Sfc ? BlockKind::Sfc
                                              : BlockKind::Fc,
                 static_cast<std::uint32_t>(numberOfBlock(number))};
    scope.name = name;
    scope.parameters = std::move(interface);
    scope.temporary = types_->temporary(syntax);
    const bool isInstance = pou.type == BlockType::Sfb;
    if (isInstance) pou.instanceBytes = static_cast<std::uint32_t>(scope.parameters->size);
    std::uint32_t index = 0;
    for (const Field& field : scope.parameters->fields) pou.locals.push_back(localVariable(field, isInstance, index++));
    statements.findLabels(syntax, scope);
    for (const NetworkSyntax& each : syntax.networks) {
      Network& network = pou.networks.emplace_back();
      network.number = each.number;
      network.span = each.span;
      statements.bind(each, MnemonicSet::International, scope, network);
    }
    pou.localBytes = static_cast<std::uint32_t>(scope.temporary->size + 1) & ~1U;
    program_.pous.push_back(std::move(pou));
  }

  /// Whether a finding outside of networks, in that block, leaves open no more than its data, or than its networks
  /// that are not complete then. What a damaged heading names, and what a file that ends in the midst has lost, may be
  /// anything.
  static bool isBounded(const Finding& finding, const BlockSyntax& block, bool isLast) {
    constexpr Syntax ofDeclarations[] = {Syntax::Declaration7, Syntax::Assignment7,   Syntax::TypeUndefined,
                                         Syntax::ValueOfType,  Syntax::NameUndefined, Syntax::BlockHeading7,
                                         Syntax::NotModelled};
    if (finding.network != 0 || !finding.span.beginsIn(block.span)) return false;
    if (finding.rule == syntaxMessage(Syntax::BlockOpen).id) return !isLast;
    const bool isOfHeading =
        finding.rule == syntaxMessage(Syntax::BlockHeading7).id && finding.span.beginsIn(block.heading);
    return !isOfHeading &&
           std::ranges::any_of(ofDeclarations, [&](Syntax code) { return finding.rule == syntaxMessage(code).id; });
  }

  void noteBounds() {
    for (const SourceSyntax& source : sources_) {
      for (const BlockSyntax& block : source.blocks) {
        const bool isLast = &block == &source.blocks.back();
        for (const Finding& finding : program_.findings) {
          if (isBounded(finding, block, isLast)) declarations_->bounded.emplace(finding.span.file, finding.span.offset);
        }
      }
    }
  }

  void addDirectivesOutside() {
    const auto add = [&](const DirectiveSyntax& directive) {
      program_.directives.push_back({directive.text, directive.span, -1, 0});
    };
    for (const SourceSyntax& source : sources_) {
      std::ranges::for_each(source.directives, add);
      for (const BlockSyntax& block : source.blocks) {
        if (block.kind == BlockKind::Db || block.kind == BlockKind::Udt) std::ranges::for_each(block.directives, add);
      }
    }
  }

  Program& program_;
  const ReadOptions& options_;
  Reports reports_;
  std::vector<SourceSyntax> sources_;
  std::map<std::uint32_t, MnemonicSet> sets_;                           ///< by file
  std::set<std::uint32_t> hidden_;                                      ///< files whose statements are shown to nobody
  std::map<std::uint32_t, std::shared_ptr<const std::string>> images_;  ///< by file
  std::vector<SymbolRow> symbols_;
  std::vector<std::unique_ptr<SourceSyntax>> librarySources_;
  std::optional<BlockCatalogue> catalogue_;
  std::optional<TypeTable> types_;
  std::shared_ptr<s7300::Declarations> declarations_;
};

}  // namespace

void buildStep7Project(Program& program, const Step7Project& project, const ReadOptions& options) {
  ProjectBuilder(program, options).build(project);
}

}  // namespace rungproof::step7
