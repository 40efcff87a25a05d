// Writing sources.
#include "frontend/mc7/block_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frontend/mc7/actual_values.hpp"
#include "frontend/mc7/block_head.hpp"
#include "frontend/mc7/call_recovery.hpp"
#include "frontend/mc7/structure_places.hpp"
#include "frontend/step7/source_parser.hpp"
#include "frontend/step7/type_table.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::mc7 {

namespace {

using step7::BlockKey;
using step7::BlockKind;
using step7::BlockSyntax;

bool isSystemFrame(BlockKind kind) { return kind == BlockKind::Sfc || kind == BlockKind::Sfb; }
bool hasSource(BlockKind kind) {
  return kind == BlockKind::Ob || kind == BlockKind::Fc || kind == BlockKind::Fb || kind == BlockKind::Db ||
         kind == BlockKind::Udt;
}

/// All declarations of the blocks, resolved against each other.
class Declared {
 public:
  explicit Declared(const std::vector<StoredBlock>& blocks) : reports_(scratch_) {
    for (const StoredBlock& block : blocks) {
      const bool isFrame = isSystemFrame(block.key.kind);
      if (!hasSource(block.key.kind) && !isFrame) continue;
      std::string text = headOf(block, true).text;
      text += fmt::format("BEGIN\n{}\n", endKeywordOf(block.key.kind));
      const std::uint32_t file = scratch_.sources->add(toString(block.key), std::move(text));
      SyntaxSink sink(scratch_, file);
      const step7::Spelling7 spelling{step7::MnemonicSet::International, TextEncoding::Utf8};
      step7::SourceSyntax source = readSource(scratch_.sources->file(file).text(), spelling, sink);
      (isFrame ? frames_ : sources_).push_back(std::move(source));
      if (isFrame) frameKeys_.push_back(block.key);
    }
    catalogue_.emplace(sources_, noSymbols_, reports_);
    types_.emplace(*catalogue_, reports_);
    frameCatalogue_.emplace(frames_, noSymbols_, reports_);
    frameTypes_.emplace(*frameCatalogue_, reports_);
  }

  const BlockSyntax* syntax(BlockKey key) const {
    const step7::CatalogueEntry* entry = catalogue_->entry(key);
    return entry == nullptr ? nullptr : entry->syntax;
  }
  step7::TypeTable& types() { return *types_; }

  const s7300::Structure* interface(BlockKey key) {
    const auto [known, isNew] = interfaces_.try_emplace(key);
    if (isNew) known->second = make(key);
    return known->second.get();
  }

 private:
  std::shared_ptr<const s7300::Structure> make(BlockKey key) {
    if (const BlockSyntax* own = syntax(key))
      return key.kind == BlockKind::Fb ? types_->structure(key) : types_->parameters(*own);
    // Of a system block the names that the model has count, then those of its frame in the project.
    const BlockType type = key.kind == BlockKind::Fc    ? BlockType::Fc
                           : key.kind == BlockKind::Fb  ? BlockType::Fb
                           : key.kind == BlockKind::Sfc ? BlockType::Sfc
                                                        : BlockType::Sfb;
    if (isSystemFrame(key.kind)) {
      if (const s7300::LibraryBlock* library = s7300::libraryBlock(type, key.number)) return interfaceOf(*library);
    }
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      if (frameKeys_[i] != key || frames_[i].blocks.empty()) continue;
      return key.kind == BlockKind::Sfb ? frameTypes_->structure({BlockKind::Fb, key.number})
                                        : frameTypes_->parameters(frames_[i].blocks.front());
    }
    return nullptr;
  }

  Program scratch_;
  step7::Reports reports_;
  const std::vector<step7::SymbolRow> noSymbols_;
  std::vector<step7::SourceSyntax> sources_, frames_;
  std::vector<BlockKey> frameKeys_;
  std::optional<step7::BlockCatalogue> catalogue_, frameCatalogue_;
  std::optional<step7::TypeTable> types_, frameTypes_;
  std::map<BlockKey, std::shared_ptr<const s7300::Structure>> interfaces_;
};

bool isLabelOfStep7(std::string_view name) {
  const auto isLetter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; };
  return !name.empty() && name.size() <= 4 && isLetter(name[0]) &&
         std::ranges::all_of(name, [&](char c) { return isLetter(c) || (c >= '0' && c <= '9'); });
}

/// Comments of lines, put behind the statements that they belong to.
class RemarksOfLines {
 public:
  RemarksOfLines() = default;
  explicit RemarksOfLines(const std::vector<StoredBlock::LineText>& lines) : lines_(&lines) {}

  /// Whether the statement that comes next opens a data block by itself.
  bool keepsNextApart() const {
    return next() != nullptr && isCounted_ &&
           std::any_of(lines_->begin() + static_cast<std::ptrdiff_t>(next_), lines_->end(),
                       [&](const StoredBlock::LineText& text) { return text.keepsApart && text.line == line_ + 1; });
  }
  /// A statement of so many lines has been written.
  void follow(std::uint32_t lines, std::string& body) {
    line_ += lines;
    bool isFirst = true;
    while (isCounted_ && next() != nullptr && next()->line <= line_) write(std::exchange(isFirst, false), body);
  }
  /// A call that stays as it is has an unknown number of lines.
  void loseCount(unsigned mark) {
    constexpr std::array<unsigned, 6> opening = {1, 3, 7, 9, 14, 16};
    if (std::ranges::find(opening, mark) != opening.end()) isCounted_ = false;
  }
  void rest(std::string& body) {
    while (next() != nullptr) write(false, body);
  }

 private:
  const StoredBlock::LineText* next() const {
    return lines_ == nullptr || next_ >= lines_->size() ? nullptr : &(*lines_)[next_];
  }
  void write(bool isFirst, std::string& body) {
    const StoredBlock::LineText& text = (*lines_)[next_++];
    if (text.text.empty()) return;
    const bool isBeside = isFirst && text.isOfStatement && isCounted_ && body.ends_with('\n');
    if (isBeside) body.pop_back();
    body += (isBeside ? " " : "") + asRemarks(text.text);
  }

  const std::vector<StoredBlock::LineText>* lines_ = nullptr;
  std::size_t next_ = 0;
  std::uint32_t line_ = 0;
  bool isCounted_ = true;
};

/// The networks of one block.
class BodyWriter {
 public:
  BodyWriter(const StoredBlock& block, Declared& declared) : block_(block), declared_(declared) {}

  /// Nothing: the code has a fault.
  std::optional<std::string> text(BlockSource& into) {
    decoded_ = decodeCode(block_.code);
    into.instructions = decoded_.instructionCount();
    table_ = readNetworkTable(block_.table);
    into.networks = table_.lengths.size();
    if (decoded_.fault) {
      into.damage = fmt::format("byte {} of its code: {}", decoded_.fault->at, decoded_.fault->reason);
      return std::nullopt;
    }
    if (!table_.fault.empty()) {
      into.damage = table_.fault;
      return std::nullopt;
    }
    cutNetworks();
    if (!borderFault_.empty()) {
      into.damage = borderFault_;
      return std::nullopt;
    }
    nameLabels();
    nameLocals();
    std::string body;
    std::size_t item = 0;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const StoredBlock::NetworkText said =
          i < block_.networkTexts.size() ? block_.networkTexts[i] : StoredBlock::NetworkText{};
      body += fmt::format("NETWORK\nTITLE ={}\n{}", asTitle(said.title), asRemarks(said.comment));
      const bool isLast = i + 1 == ends_.size();
      remarks_ = RemarksOfLines(said.lines);
      statements(item, ends_[i], isLast, body);
      item = ends_[i];
    }
    return body;
  }

 private:
  /// The closing BE belongs to no network, unless the source ended with one.
  void cutNetworks() {
    const std::vector<CodeItem>& items = decoded_.items;
    std::vector<std::uint32_t> lengths = table_.lengths;
    if (lengths.empty()) lengths.push_back(static_cast<std::uint32_t>(block_.code.size()));
    std::uint32_t at = 0;
    for (const std::uint32_t length : lengths) {
      at += length;
      const auto end = std::ranges::lower_bound(items, at, {}, &CodeItem::at);
      const bool isBorder = end == items.end() ? at == block_.code.size() : end->at == at;
      if (!isBorder) {
        borderFault_ = fmt::format("a network ends at byte {} of its code, within an instruction or behind it", at);
        return;
      }
      ends_.push_back(static_cast<std::size_t>(end - items.begin()));
    }
    for (std::size_t i = ends_.back(); i < items.size(); ++i) {
      if (items[i].is("BE")) continue;
      borderFault_ = fmt::format("the code behind its networks, at byte {}, is no BE", items[i].at);
      return;
    }
  }

  void nameLabels() {
    std::map<std::uint32_t, std::string> wanted;
    for (std::size_t i = 0; i < table_.jumpPositions.size() && i < block_.labels.size(); ++i) {
      const auto jump = std::ranges::lower_bound(decoded_.items, table_.jumpPositions[i], {}, &CodeItem::at);
      if (jump == decoded_.items.end() || jump->at != table_.jumpPositions[i]) continue;
      if (jump->opcode->form == Form::Jump && isLabelOfStep7(block_.labels[i]))
        wanted.emplace(static_cast<std::uint32_t>(jump->target()), block_.labels[i]);
    }
    std::set<std::string> taken;
    for (const CodeItem& item : decoded_.items) {
      if (item.opcode->form == Form::Jump) targets_.insert(static_cast<std::uint32_t>(item.target()));
    }
    for (const auto& [target, name] : wanted) {
      if (taken.insert(name).second) labels_[target] = name;
    }
    int number = 0;
    for (const std::uint32_t target : targets_) {
      if (labels_.contains(target)) continue;
      do {
        labels_[target] = fmt::format("M{:03}", ++number);
      } while (!taken.insert(labels_[target]).second);
    }
    names_.label = [this](std::uint32_t target) { return labels_[target]; };
  }

  void nameLocals() {
    const BlockSyntax* syntax = declared_.syntax(block_.key);
    if (syntax == nullptr) return;
    temporary_ = declared_.types().temporary(*syntax);
    if (block_.key.kind == BlockKind::Fb) instance_ = declared_.types().structure(block_.key);
    if (block_.key.kind == BlockKind::Fc) parameters_ = declared_.types().parameters(*syntax);
    names_.parameter = [this](unsigned number) {
      return parameters_ != nullptr && number >= 1 && number <= parameters_->fields.size()
                 ? parameters_->fields[number - 1].name
                 : fmt::format("P{}", number);
    };
    names_.local = [this](step7::Place place, Size size, std::uint32_t byte,
                          unsigned bit) -> std::optional<std::string> {
      const s7300::Structure* structure = place == step7::Place::L ? temporary_.get() : instance_.get();
      if (structure == nullptr) return std::nullopt;
      const std::optional<std::string> path = pathAt(*structure, size, byte, bit);
      return path ? std::optional("#" + *path) : std::nullopt;
    };
  }

  void statements(std::size_t from, std::size_t to, bool isLast, std::string& body) {
    const CalleeInterface interface = [this](BlockKey key) { return declared_.interface(key); };
    const CallContext context{decoded_.items, names_, interface, instance_.get(), temporary_.get(), targets_};
    for (std::size_t i = from; i < to;) {
      const CodeItem& item = decoded_.items[i];
      // The closing BE says nothing, unless a jump leads there.
      const bool isClosing = isLast && i + 1 == decoded_.items.size() && item.is("BE");
      if (isClosing && !targets_.contains(item.at)) break;
      if (item.is("BLD")) {
        if (const auto call = recoverCall(context, i, to)) {
          line(item.at, call->lines.front(), body);
          for (std::size_t k = 1; k < call->lines.size(); ++k) line(std::nullopt, call->lines[k], body);
          remarks_.follow(call->editorLines, body);
          i = call->end;
          continue;
        }
        remarks_.loseCount(item.b1());
      }
      const auto access = remarks_.keepsNextApart() ? std::nullopt : accessInBlock(i, to);
      const std::optional<std::string> call = item.hasList ? callOf(context, item) : std::nullopt;
      line(item.at, access ? *access : call ? *call : textOf(item, names_), body);
      remarks_.follow(1, body);
      i += access ? 2 : 1;
    }
    remarks_.rest(body);
    if (!isLast) return;
    for (std::size_t i = to; i < decoded_.items.size(); ++i) {
      if (targets_.contains(decoded_.items[i].at)) line(decoded_.items[i].at, "BE", body);
    }
  }

  /// OPN DB 10 and an access to it are one statement of the language; the block stays open behind it.
  std::optional<std::string> accessInBlock(std::size_t index, std::size_t to) const {
    constexpr unsigned areaOfBlock = 4;
    const CodeItem& open = decoded_.items[index];
    if (!open.is("OPN") || open.opcode->operand != "DB" || index + 1 >= to) return std::nullopt;
    if (open.opcode->form != Form::Number8 && open.opcode->form != Form::Number16) return std::nullopt;
    const unsigned number = open.opcode->form == Form::Number8 ? open.b1() : open.word();
    const CodeItem& access = decoded_.items[index + 1];
    const bool isDirect = access.opcode->form == Form::Bit || access.opcode->form == Form::Sized;
    if (!isDirect || (access.b1() >> 4 & 7U) != areaOfBlock || number == 0 || targets_.contains(access.at))
      return std::nullopt;
    return fmt::format("{:<5} DB{}.{}", access.opcode->mnemonic, number, operandText(access, names_));
  }

  void line(std::optional<std::uint32_t> at, std::string_view statement, std::string& body) const {
    const auto label = at ? labels_.find(*at) : labels_.end();
    body += fmt::format("{:<5} {} ;\n", label == labels_.end() ? "" : label->second + ":", statement);
  }

  const StoredBlock& block_;
  Declared& declared_;
  DecodedCode decoded_;
  NetworkTable table_;
  std::vector<std::size_t> ends_;  ///< index of the item behind each network
  std::string borderFault_;
  std::set<std::uint32_t> targets_;
  std::map<std::uint32_t, std::string> labels_;
  CodeNames names_;
  RemarksOfLines remarks_;
  std::shared_ptr<const s7300::Structure> temporary_, instance_, parameters_;
};

/// Blanks in place of all but line ends.
std::string blankedFrom(std::string text, std::size_t from) {
  std::replace_if(
      text.begin() + static_cast<std::ptrdiff_t>(from), text.end(), [](char c) { return c != '\n'; }, ' ');
  return text;
}

void codeSource(const StoredBlock& block, Declared& declared, bool asInterfaces, BlockSource& source) {
  const BlockHead head = headOf(block, true);
  source.damage = block.damage.empty() ? head.fault : block.damage;
  if (source.damage.empty() && block.checksum && *block.checksum != checksumOf(block.key.kind, block.code))
    source.damage = fmt::format("its checksum is {:04X}, that of its code {:04X}", *block.checksum,
                                checksumOf(block.key.kind, block.code));
  std::optional<std::string> body = BodyWriter(block, declared).text(source);
  if (!source.damage.empty()) body.reset();
  const std::string end = fmt::format("{}\n", endKeywordOf(block.key.kind));
  if (!body || (block.isProtected && asInterfaces)) {
    // An interface without statements is what a protected block leaves in a source.
    const std::size_t line = head.text.find('\n') + 1;
    const bool isSaid = block.isProtected;
    source.text = head.text.substr(0, line) + (isSaid ? "" : "KNOW_HOW_PROTECT\n") + head.text.substr(line) + end;
    return;
  }
  source.text = head.text + "BEGIN\n" + *body + end;
  if (block.isProtected) source.shown = blankedFrom(head.text + "BEGIN\n" + *body, head.text.size() + 6) + end;
}

}  // namespace

std::vector<BlockSource> sourcesOf(const std::vector<StoredBlock>& blocks, bool asInterfaces) {
  Declared declared(blocks);
  std::vector<BlockSource> sources;
  for (const StoredBlock& block : blocks) {
    if (!hasSource(block.key.kind)) continue;
    BlockSource& source = sources.emplace_back();
    source.key = block.key;
    if (block.isCode()) {
      codeSource(block, declared, asInterfaces, source);
      continue;
    }
    const BlockHead head = headOf(block, true);
    source.damage = block.damage.empty() ? head.fault : block.damage;
    source.text = head.text;
    if (block.key.kind == BlockKind::Db) {
      source.text += "BEGIN\n";
      const auto structure = declared.types().structure(block.key);
      if (structure != nullptr && source.damage.empty()) {
        source.text += actualValues(*structure, block.code);
        source.image = block.code;
      }
    }
    source.text += fmt::format("{}\n", endKeywordOf(block.key.kind));
  }
  return sources;
}

}  // namespace rungproof::mc7
