// Following what the compiler does between the two BLD of a call.
#include "frontend/mc7/call_recovery.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/mc7/structure_places.hpp"
#include "frontend/step7/constant_spelling.hpp"
#include "ir/s7300/any_elements.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof::mc7 {

namespace {

using s7300::Field;
using s7300::Structure;
using s7300::TypeKind;
using step7::BlockKey;
using step7::BlockKind;
using step7::Place;

enum class CallShape : std::uint8_t { Function, Instance, MultiInstance };
struct FrameRow {
  unsigned open;
  BlockKind kind;
  CallShape shape;
};
constexpr std::array<FrameRow, 6> callFrames = {{{1, BlockKind::Fc, CallShape::Function},
                                                 {7, BlockKind::Sfc, CallShape::Function},
                                                 {3, BlockKind::Fb, CallShape::Instance},
                                                 {9, BlockKind::Sfb, CallShape::Instance},
                                                 {14, BlockKind::Fb, CallShape::MultiInstance},
                                                 {16, BlockKind::Sfb, CallShape::MultiInstance}}};

constexpr unsigned areaDb = 4, areaDi = 5, areaL = 6;

/// Where a statement reads or writes: enough to compare two.
struct PlaceOfItem {
  unsigned area = 7;  ///< 7: none of memory
  bool byAr2 = false;
  Size size = Size::Bit;
  std::uint32_t address = 0;  ///< byte * 8 + bit
};

PlaceOfItem placeOfAccess(const CodeItem& item) {
  const unsigned area = item.b1() >> 4 & 7U;
  switch (item.opcode->form) {
    case Form::Bit: return {area, false, Size::Bit, item.word() * 8U + (item.b1() & 7U)};
    case Form::Sized: return {area, false, item.opcode->size, item.word() * 8U};
    case Form::BitByRegister:
    case Form::SizedByRegister:
      if ((item.b1() & 8U) == 0) return {};
      return {area, true, item.opcode->size, item.word()};
    default: return {};
  }
}

/// One value that the compiler hands from a place to another.
struct Transfer {
  std::string source;
  std::string target;
  PlaceOfItem from, to;
  std::optional<std::uint32_t> constant;        ///< of the source
  std::optional<std::uint32_t> instanceOffset;  ///< the source is a pointer to that bit of the block's own instance
  bool isUsed = false;
};

class CallFollower {
 public:
  CallFollower(const CallContext& context, std::size_t index, std::size_t end)
      : context_(context), at_(index), end_(end) {}

  std::optional<RecoveredCall> follow() {
    const CodeItem& open = context_.items[at_];
    const auto frame = std::ranges::find(callFrames, open.b1(), &FrameRow::open);
    if (!open.is("BLD") || frame == callFrames.end()) return std::nullopt;
    frame_ = &*frame;
    ++at_;
    if (isNext("=") && placeOfAccess(item()).area == areaL) {
      // The statement stays where somebody reads the bit later.
      const std::uint32_t address = placeOfAccess(item()).address;
      if (readsSavedBit(context_.items, address / 8, address % 8))
        result_.lines.push_back(textOf(item(), context_.names));
      ++at_;
    }
    const bool isFound = frame_->shape == CallShape::Function ? function() : instance();
    if (!isFound || !isNext("BLD") || item().b1() != frame_->open + 1) return std::nullopt;
    if (!std::ranges::all_of(before_, &Transfer::isUsed) || !std::ranges::all_of(after_, &Transfer::isUsed))
      return std::nullopt;
    result_.end = at_ + 1;
    for (std::size_t i = begin_ + 1; i < result_.end; ++i) {
      if (context_.targets.contains(context_.items[i].at)) return std::nullopt;
    }
    return std::move(result_);
  }

  /// The list of a call by itself.
  std::optional<std::string> byList(const CodeItem& item) {
    const BlockKind kind = item.opcode->operand == "SFC" ? BlockKind::Sfc : BlockKind::Fc;
    if (!item.is("UC") || (item.opcode->form != Form::Number8 && item.opcode->form != Form::Number16))
      return std::nullopt;
    return callText(item, {kind, numberOf(item)});
  }

 private:
  bool atEnd() const { return at_ >= end_; }
  const CodeItem& item() const { return context_.items[at_]; }
  bool isNext(std::string_view mnemonic) const { return !atEnd() && item().is(mnemonic); }
  static std::uint32_t numberOf(const CodeItem& item) {
    return item.opcode->form == Form::Number16 ? item.word() : item.b1();
  }
  static bool isDirectNumber(const CodeItem& item) {
    return item.opcode->form == Form::Number8 || item.opcode->form == Form::Number16;
  }

  // Transfers -------------------------------------------------------------------------------------------------------

  /// Loads and stores up to something else. In the call of an FB the registers of data blocks are swapped: what the
  /// caller has in DI is reached as DB, and OPN DI opens its data blocks.
  void transfers(std::vector<Transfer>& into) {
    Transfer open;
    bool isLoaded = false;
    while (!atEnd()) {
      const CodeItem& one = item();
      if (one.is("OPN")) {
        if (!isDirectNumber(one) && !isOwnInstance(one)) return;
        const std::string block = isDirectNumber(one) ? fmt::format("DB{}", numberOf(one)) : "";
        if (one.opcode->operand == "DI")
          openDi_ = block;
        else if (frame_->shape == CallShape::Function)
          openDb_ = block;
        else
          return;
      } else if (one.is("A") || one.is("L")) {
        const std::optional<std::string> text = placeText(one);
        if (!text) return;
        open = {*text, {}, placeOfAccess(one), {}, {}, {}};
        if (one.opcode->form >= Form::Pointer) open.constant = one.opcode->bytes == 6 ? one.dword() : one.word();
        if (one.opcode->form == Form::HexByte) open.constant = one.b1();
        isLoaded = true;
      } else if (one.is("CLR") || one.is("SET")) {
        open = {one.is("SET") ? "TRUE" : "FALSE", {}, {}, {}, {}, {}};
        isLoaded = true;
      } else if (const auto own = ownPlace()) {
        open = {{}, {}, {}, {}, {}, own->first};
        isLoaded = true;
        at_ += own->second - 1;
      } else if ((one.is("=") || one.is("T")) && isLoaded) {
        const std::optional<std::string> text = placeText(one);
        if (!text) return;
        open.target = *text;
        open.to = placeOfAccess(one);
        open.from.size = open.from.area == 7 ? open.to.size : open.from.size;
        into.push_back(open);
        isLoaded = false;
      } else {
        return;
      }
      ++at_;
    }
  }

  /// +AR2 P#16.0; TAR2; LAR2 LD 52: a pointer to data of the block's own instance, with the instructions it takes.
  std::optional<std::pair<std::uint32_t, std::size_t>> ownPlace() const {
    const auto isTar2 = [&](std::size_t index) {
      return index < end_ && context_.items[index].is("TAR2") && context_.items[index].opcode->form == Form::None;
    };
    if (!savedAr2_) return std::nullopt;
    if (isTar2(at_)) return std::pair(0U, std::size_t{1});
    if (!item().is("+AR2") || item().opcode->form != Form::Offset || !isTar2(at_ + 1) || at_ + 2 >= end_)
      return std::nullopt;
    const CodeItem& back = context_.items[at_ + 2];
    if (!back.is("LAR2") || back.opcode->form != Form::Holder || back.word() != *savedAr2_) return std::nullopt;
    return std::pair(std::uint32_t{item().word()}, std::size_t{3});
  }

  bool isOwnInstance(const CodeItem& item) const {
    return frame_->shape == CallShape::MultiInstance && item.opcode->form == Form::NumberByMemory &&
           item.opcode->operand == "DI";
  }

  /// The operand as the caller names it; nothing where its data block is not known.
  std::optional<std::string> placeText(const CodeItem& one) const {
    const PlaceOfItem place = placeOfAccess(one);
    const bool isFunction = frame_->shape == CallShape::Function;
    if (place.area == areaDb && !place.byAr2) {
      if (isFunction) return openDb_.empty() ? std::nullopt : std::optional(addressOf(openDb_, place));
      return fmt::format("{}", operandOf(areaDi, place));
    }
    if (place.area == areaDb && !isFunction) {
      if (!context_.names.local) return std::nullopt;
      const auto name = context_.names.local(Place::DI, place.size, place.address / 8, place.address % 8);
      return name;
    }
    if (place.area == areaDi && !place.byAr2 && !isFunction && !openDi_.empty() && openDi_ != instanceBlock_)
      return addressOf(openDi_, place);
    return operandText(one, context_.names);
  }

  static std::string operandOf(unsigned area, const PlaceOfItem& place) {
    return place.size == Size::Bit
               ? fmt::format("{} {}.{}", areaLetters(area, place.size, true), place.address / 8, place.address % 8)
               : fmt::format("{} {}", areaLetters(area, place.size, true), place.address / 8);
  }
  static std::string addressOf(const std::string& block, const PlaceOfItem& place) {
    return fmt::format("{}.{}", block, operandOf(areaDb, place));
  }

  Transfer* transferTo(std::vector<Transfer>& list, unsigned area, bool byAr2, Size size, std::uint32_t address) {
    for (Transfer& one : list) {
      if (one.to.area == area && one.to.byAr2 == byAr2 && one.to.size == size && one.to.address == address) return &one;
    }
    return nullptr;
  }
  Transfer* transferFrom(std::vector<Transfer>& list, unsigned area, bool byAr2, Size size, std::uint32_t address) {
    for (Transfer& one : list) {
      if (one.from.area == area && one.from.byAr2 == byAr2 && one.from.size == size && one.from.address == address)
        return &one;
    }
    return nullptr;
  }

  // Functions -------------------------------------------------------------------------------------------------------

  /// In a function block AR2 is kept around a call that hands pointers over.
  bool function() {
    if (isNext("TAR2") && item().opcode->form == Form::Holder) {
      savedAr2_ = item().word();
      ++at_;
    }
    transfers(before_);
    if (atEnd() || !item().hasList || !item().is("UC") || !isDirectNumber(item())) return false;
    const CodeItem& call = item();
    const bool isOfKind = (call.opcode->operand == "SFC") == (frame_->kind == BlockKind::Sfc);
    if (!isOfKind) return false;
    ++at_;
    if (savedAr2_ && (!isNext("LAR2") || item().opcode->form != Form::Holder || item().word() != *savedAr2_))
      return false;
    if (savedAr2_) ++at_;
    openDb_.clear();
    transfers(after_);
    std::optional<std::string> text = callText(call, {frame_->kind, numberOf(call)});
    if (!text) return false;
    result_.editorLines = 1 + static_cast<std::uint32_t>(call.list.size());
    result_.lines.push_back(std::move(*text));
    return true;
  }

  std::optional<std::string> callText(const CodeItem& call, BlockKey key) {
    const Structure* interface = context_.interface(key);
    if (interface == nullptr || interface->fields.size() != call.list.size()) return std::nullopt;
    std::string text = fmt::format("CALL  {} {}", step7::blockKindName(key.kind), key.number);
    for (std::size_t i = 0; i < call.list.size(); ++i) {
      const std::optional<std::string> actual = actualOf(interface->fields[i], call.list[i]);
      if (!actual) return std::nullopt;
      text += fmt::format("{}{} := {}", i == 0 ? " (" : ", ", interface->fields[i].name, *actual);
    }
    return call.list.empty() ? text : text + ")";
  }

  std::optional<std::string> actualOf(const Field& formal, std::uint32_t entry) {
    if (const std::string_view kind = numberKind(formal.type.kind); !kind.empty())
      return fmt::format("{} {}", kind, entry >> 16);
    const unsigned area = entry >> 24 & 7U;
    const std::uint32_t address = entry & 0x7FFFFU;
    if ((entry & 0x80F80000U) != 0x80000000U) return std::nullopt;
    constexpr unsigned callersLocal = 7;
    if (isHandedByPointer(formal.type)) {
      if (area != callersLocal) return std::nullopt;
      return pointerActual(formal.type, address, areaL, false);
    }
    const Size size = sizeOfType(formal.type);
    if (size != Size::Bit && address % 8 != 0) return std::nullopt;
    if (area == callersLocal) return localActual(formal, size, address);
    if (area == 0) {
      if (size == Size::Bit) return std::nullopt;
      return operandWithLetters(areaLetters(0, size, formal.section == step7::Section::Input), size, address);
    }
    if (area > 3) return std::nullopt;
    return operandWithLetters(areaLetters(area, size, true), size, address);
  }

  static std::string operandWithLetters(std::string_view letters, Size size, std::uint32_t address) {
    return size == Size::Bit ? fmt::format("{} {}.{}", letters, address / 8, address % 8)
                             : fmt::format("{} {}", letters, address / 8);
  }

  static bool isFinestBase(std::uint32_t word) {
    const bool hasDigits = (word & 15U) <= 9 && (word >> 4 & 15U) <= 9 && (word >> 8 & 15U) <= 9 && word >> 14 == 0;
    return hasDigits && ((word >> 12) == 0 || (word >> 8 & 15U) != 0);
  }
  /// The compiler loads every constant as a number; the parameter says what it means.
  static std::string sourceText(const Transfer& transfer, const s7300::Type& type) {
    static constexpr std::array<std::pair<TypeKind, s7300::ConstantKind>, 4> typed = {
        {{TypeKind::S5Time, s7300::ConstantKind::S5Time},
         {TypeKind::Time, s7300::ConstantKind::Time},
         {TypeKind::Date, s7300::ConstantKind::Date},
         {TypeKind::TimeOfDay, s7300::ConstantKind::TimeOfDay}}};
    const auto row = std::ranges::find(typed, type.kind, &std::pair<TypeKind, s7300::ConstantKind>::first);
    if (!transfer.constant || row == typed.end()) return transfer.source;
    s7300::Constant constant;
    // An S5TIME in a coarser base than its time needs has no spelling of its own.
    const bool isExact = type.kind != TypeKind::S5Time || isFinestBase(*transfer.constant);
    constant.kind = isExact ? row->second : s7300::ConstantKind::Word;
    constant.value = *transfer.constant;
    return step7::spellingOf(constant);
  }

  std::optional<std::string> localActual(const Field& formal, Size size, std::uint32_t address) {
    Transfer* const in = transferTo(before_, areaL, false, size, address);
    Transfer* const out = transferFrom(after_, areaL, false, size, address);
    const bool isInput = formal.section == step7::Section::Input, isInOut = formal.section == step7::Section::InOut;
    if (in != nullptr && (isInput || isInOut)) in->isUsed = true;
    if (out != nullptr && !isInput) out->isUsed = true;
    if (isInOut && (in != nullptr || out != nullptr)) {
      if (in == nullptr || out == nullptr || in->source != out->target) return std::nullopt;
      return in->source;
    }
    if (isInput && in != nullptr) return sourceText(*in, formal.type);
    if (!isInput && out != nullptr) return out->target;
    if (context_.names.local) {
      if (const auto name = context_.names.local(Place::L, size, address / 8, address % 8)) return *name;
    }
    return operandWithLetters(areaLetters(areaL, size, true), size, address);
  }

  /// A POINTER of six or an ANY of ten bytes that the caller has put together, as what it points to.
  std::optional<std::string> pointerActual(const s7300::Type& type, std::uint32_t address, unsigned area, bool byAr2) {
    const bool isAny = type.kind == TypeKind::Any;
    s7300::Constant constant;
    constant.kind = isAny ? s7300::ConstantKind::Any : s7300::ConstantKind::Pointer;
    const auto part = [&](Size size, std::uint32_t offset) {
      Transfer* const one = transferTo(before_, area, byAr2, size, address + offset * 8);
      if (one != nullptr) one->isUsed = true;
      return one;
    };
    std::uint32_t at = 0;
    if (isAny) {
      const Transfer *const head = part(Size::Word, 0), *const count = part(Size::Word, 2);
      if (head == nullptr && count == nullptr && area == areaL) return ownPointer(address);
      const bool isWhole = head != nullptr && count != nullptr && head->constant && count->constant;
      if (!isWhole || *head->constant >> 8 != 0x10) return std::nullopt;
      constant.anyType = static_cast<std::uint8_t>(*head->constant);
      constant.anyCount = static_cast<std::uint16_t>(*count->constant);
      at = 4;
    }
    const Transfer *const block = part(Size::Word, at), *const pointer = part(Size::DWord, at + 2);
    if (block == nullptr || pointer == nullptr) return std::nullopt;
    if (pointer->instanceOffset) return ownData(type, constant, block->source, *pointer->instanceOffset);
    if (!block->constant || !pointer->constant || (*pointer->constant & 0x80000000U) == 0) return std::nullopt;
    constant.block = static_cast<std::uint16_t>(*block->constant);
    constant.value = *pointer->constant;
    const unsigned pointed = *pointer->constant >> 24 & 7U;
    constexpr unsigned callersLocal = 7;
    if (constant.block != 0) return pointed == areaDb ? std::optional(step7::spellingOf(constant)) : std::nullopt;
    if (pointed == callersLocal) return localData(type, constant);
    // Without a number a DBX or DIX means the block that is open.
    const bool isInOpenBlock = pointed == areaDb || pointed == areaDi;
    if (pointed == areaL || (isInOpenBlock && s7300::isComplex(type))) return std::nullopt;
    return step7::spellingOf(constant);
  }

  /// Whether a pointer to a part is what the compiler makes for the parameter.
  static bool isPointedPart(const s7300::Type& formal, const s7300::Constant& pointer, const s7300::Type& part) {
    if (formal.kind == TypeKind::Any)
      return anyElementsOf(part) == s7300::AnyElements{static_cast<AnyType>(pointer.anyType), pointer.anyCount};
    if (formal.kind == TypeKind::Pointer) return true;
    return formal.kind == TypeKind::String ? part.kind == TypeKind::String : isSameType(formal, part);
  }

  /// A variable of type ANY that the block has filled itself.
  std::optional<std::string> ownPointer(std::uint32_t address) const {
    if (context_.temporary == nullptr || address % 8 != 0) return std::nullopt;
    const auto name =
        partAt(*context_.temporary, address / 8, [](const s7300::Type& part) { return part.kind == TypeKind::Any; });
    return name ? std::optional("#" + *name) : std::nullopt;
  }

  /// Local data of the block itself, by name where a part of the type begins there.
  std::optional<std::string> localData(const s7300::Type& formal, s7300::Constant pointer) const {
    const auto bits = static_cast<std::uint32_t>(pointer.value) & 0x7FFFFU;
    if (context_.temporary != nullptr && bits % 8 == 0) {
      const auto isPart = [&](const s7300::Type& part) { return isPointedPart(formal, pointer, part); };
      if (const auto name = partAt(*context_.temporary, bits / 8, isPart)) return "#" + *name;
    }
    pointer.value = 0x80000000U | areaL << 24 | bits;
    return step7::spellingOf(pointer);
  }

  /// Data of the block's own instance, whose number stands in the register that `block` names.
  std::optional<std::string> ownData(const s7300::Type& formal, const s7300::Constant& pointer, std::string_view block,
                                     std::uint32_t bits) const {
    const bool isFunction = frame_->shape == CallShape::Function;
    const bool isOwn = block == (isFunction ? "DINO" : "DBNO") && (!isFunction || openDi_.empty());
    if (!isOwn || context_.instance == nullptr || bits % 8 != 0) return std::nullopt;
    const auto isPart = [&](const s7300::Type& part) { return isPointedPart(formal, pointer, part); };
    const auto name = partAt(*context_.instance, bits / 8, isPart);
    return name ? std::optional("#" + *name) : std::nullopt;
  }

  // Blocks with instances -------------------------------------------------------------------------------------------

  bool take(std::string_view mnemonic) {
    if (!isNext(mnemonic)) return false;
    ++at_;
    return true;
  }

  bool instance() {
    const bool isMulti = frame_->shape == CallShape::MultiInstance;
    std::uint32_t holder = 0;
    if (isMulti) {
      if (!isNext("L") || item().opcode->operand != "DINO") return false;
      ++at_;
      if (!isNext("T") || placeOfAccess(item()).area != areaL || placeOfAccess(item()).size != Size::Word) return false;
      holder = item().word();
      ++at_;
    }
    if (!take("CDB") || !isNext("OPN") || item().opcode->operand != "DI") return false;
    if (isMulti ? item().opcode->form != Form::NumberByMemory || item().word() != holder : !isDirectNumber(item()))
      return false;
    if (!isMulti) instanceBlock_ = openDi_ = fmt::format("DB{}", numberOf(item()));
    ++at_;
    if (!isNext("TAR2") || item().opcode->form != Form::Holder) return false;
    savedAr2_ = item().word();
    ++at_;
    transfers(before_);
    std::uint32_t offset = 0;
    if (isMulti) {
      if (!isNext("+AR2") || item().opcode->form != Form::Offset) return false;
      offset = item().word();
    } else if (!isNext("LAR2") || item().opcode->form != Form::Pointer || (item().dword() & 0x00FFFFFFU) != 0) {
      return false;
    }
    ++at_;
    if (!isNext("UC") || item().opcode->operand != step7::blockKindName(frame_->kind) || !isDirectNumber(item()))
      return false;
    const BlockKey key{frame_->kind, numberOf(item())};
    ++at_;
    if (!isNext("LAR2") || item().opcode->form != Form::Holder || item().word() != *savedAr2_) return false;
    ++at_;
    openDi_ = instanceBlock_;
    transfers(after_);
    if (!take("CDB")) return false;
    return instanceText(key, offset);
  }

  bool instanceText(BlockKey key, std::uint32_t offset) {
    const bool isMulti = frame_->shape == CallShape::MultiInstance;
    const Structure* interface = context_.interface(key);
    if (interface == nullptr) return false;
    std::string text;
    if (isMulti) {
      const Field* own = context_.instance == nullptr ? nullptr : fieldAt(*context_.instance, offset / 8, offset % 8);
      if (own == nullptr || own->type.kind != TypeKind::Struct) return false;
      if (own->type.name != fmt::format("{} {}", step7::blockKindName(key.kind), key.number)) return false;
      text = fmt::format("CALL  #{}", own->name);
    } else {
      text = fmt::format("CALL  {} {}, {}", step7::blockKindName(key.kind), key.number, instanceBlock_);
    }
    bool isFirst = true;
    for (const Field& formal : interface->fields) {
      if (formal.section > step7::Section::InOut) continue;
      ++result_.editorLines;
      const std::uint32_t address = offset + formal.byte * 8 + formal.bit;
      const std::optional<std::string> actual = instanceActual(formal, address, isMulti);
      if (!actual) return false;
      if (actual->empty()) continue;
      text += fmt::format("{}{} := {}", isFirst ? " (" : ", ", formal.name, *actual);
      isFirst = false;
    }
    result_.lines.push_back(isFirst ? text : text + ")");
    return true;
  }

  /// Empty: the call names none.
  std::optional<std::string> instanceActual(const Field& formal, std::uint32_t address, bool byAr2) {
    const bool isInput = formal.section == step7::Section::Input, isInOut = formal.section == step7::Section::InOut;
    if (isHandedByPointer(formal.type)) {
      if (transferTo(before_, areaDi, byAr2, Size::Word, address) == nullptr) return std::string();
      if (!formal.byReference && s7300::isComplex(formal.type)) return std::nullopt;
      return pointerActual(formal.type, address, areaDi, byAr2);
    }
    const std::string_view kind = numberKind(formal.type.kind);
    const Size size = kind.empty() ? sizeOfType(formal.type) : Size::Word;
    Transfer* const in = transferTo(before_, areaDi, byAr2, size, address);
    Transfer* const out = transferFrom(after_, areaDi, byAr2, size, address);
    if (in != nullptr && (isInput || isInOut)) in->isUsed = true;
    if (out != nullptr && !isInput) out->isUsed = true;
    if (!kind.empty()) {
      if (in == nullptr) return std::string();
      if (!in->constant) return std::nullopt;
      return fmt::format("{} {}", kind, *in->constant);
    }
    if (isInput) return in == nullptr ? std::string() : sourceText(*in, formal.type);
    if (!isInOut) return out == nullptr ? std::string() : out->target;
    if (in == nullptr && out == nullptr) return std::string();
    if (in == nullptr || out == nullptr || in->source != out->target) return std::nullopt;
    return in->source;
  }

  const CallContext& context_;
  std::size_t at_, end_;
  std::size_t begin_ = at_;
  const FrameRow* frame_ = &callFrames[0];
  std::string openDb_, openDi_, instanceBlock_;
  std::optional<std::uint32_t> savedAr2_;  ///< double word of local data that keeps AR2 during the call
  std::vector<Transfer> before_, after_;
  RecoveredCall result_;
};

}  // namespace

bool readsSavedBit(const std::vector<CodeItem>& items, std::uint32_t byte, unsigned bit) {
  constexpr unsigned callersLocal = 7;
  const std::uint32_t saved = byte * 8 + bit;
  return std::ranges::any_of(items, [&](const CodeItem& item) {
    for (const std::uint32_t entry : item.list) {
      if ((entry >> 24 & 7U) == callersLocal && (entry & 0x7FFFFU) == saved) return true;
    }
    const unsigned high = item.b1() >> 4 & 7U, low = item.b1() & 7U;
    switch (item.opcode->form) {
      case Form::Bit: return high == areaL && !item.is("=") && item.word() * 8U + low == saved;
      case Form::Sized: {
        const std::uint32_t bytes = 1U << (static_cast<unsigned>(item.opcode->size) - 1U);
        return high == areaL && item.is("L") && item.word() <= byte && byte < item.word() + bytes;
      }
      case Form::Holder:
        return high == areaL && !item.opcode->mnemonic.starts_with('T') && item.word() <= byte &&
               byte < item.word() + 4U;
      case Form::BitByMemory:
      case Form::SizedByMemory: return low == areaL;
      case Form::BitByRegister:
      case Form::SizedByRegister: return high == areaL;
      case Form::AnyByRegister: return true;
      default: return false;
    }
  });
}

std::optional<RecoveredCall> recoverCall(const CallContext& context, std::size_t index, std::size_t networkEnd) {
  return CallFollower(context, index, networkEnd).follow();
}

std::optional<std::string> callOf(const CallContext& context, const CodeItem& item) {
  return CallFollower(context, 0, 0).byList(item);
}

}  // namespace rungproof::mc7
