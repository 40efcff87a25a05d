// Items and start values.
#include "frontend/mc7/compiled_declaration.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "frontend/step7/constant_spelling.hpp"

namespace rungproof::mc7 {

namespace {

using s7300::ConstantKind;

struct ItemType {
  std::uint8_t code;
  std::string_view name;
  std::uint8_t startBytes;  ///< of a start value; 0: none
  ConstantKind constant;
};
constexpr int deepest = 32;
constexpr std::uint8_t arrayType = 0x10, structType = 0x11, stringType = 0x13, fbType = 0x15, sfbType = 0x1B;
constexpr std::array<ItemType, 24> itemTypes = {{{0x01, "BOOL", 1, ConstantKind::Boolean},
                                                 {0x02, "BYTE", 1, ConstantKind::Byte},
                                                 {0x03, "CHAR", 1, ConstantKind::Text},
                                                 {0x04, "WORD", 2, ConstantKind::Word},
                                                 {0x05, "INT", 2, ConstantKind::Integer},
                                                 {0x06, "DWORD", 4, ConstantKind::DWord},
                                                 {0x07, "DINT", 4, ConstantKind::Long},
                                                 {0x08, "REAL", 4, ConstantKind::Real},
                                                 {0x09, "DATE", 2, ConstantKind::Date},
                                                 {0x0A, "TIME_OF_DAY", 4, ConstantKind::TimeOfDay},
                                                 {0x0B, "TIME", 4, ConstantKind::Time},
                                                 {0x0C, "S5TIME", 2, ConstantKind::S5Time},
                                                 {0x0E, "DATE_AND_TIME", 8, ConstantKind::DateAndTime},
                                                 {arrayType, "ARRAY", 0, ConstantKind::Integer},
                                                 {structType, "STRUCT", 0, ConstantKind::Integer},
                                                 {stringType, "STRING", 0, ConstantKind::Text},
                                                 {0x14, "POINTER", 0, ConstantKind::Integer},
                                                 {0x16, "ANY", 0, ConstantKind::Integer},
                                                 {0x17, "BLOCK_FB", 0, ConstantKind::Integer},
                                                 {0x18, "BLOCK_FC", 0, ConstantKind::Integer},
                                                 {0x19, "BLOCK_DB", 0, ConstantKind::Integer},
                                                 {0x1A, "BLOCK_SDB", 0, ConstantKind::Integer},
                                                 {0x1C, "COUNTER", 0, ConstantKind::Integer},
                                                 {0x1D, "TIMER", 0, ConstantKind::Integer}}};

const ItemType* itemTypeOf(std::uint8_t code) {
  for (const ItemType& type : itemTypes) {
    if (type.code == code) return &type;
  }
  return nullptr;
}

struct DeclarationSectionRow {
  unsigned kind;
  std::string_view keyword;
  std::string_view name;
};
constexpr std::array<DeclarationSectionRow, 5> itemSections = {{{1, "VAR_INPUT", "IN"},
                                                                {2, "VAR_OUTPUT", "OUT"},
                                                                {3, "VAR_IN_OUT", "IN_OUT"},
                                                                {4, "VAR", "STAT"},
                                                                {5, "VAR_TEMP", "TEMP"}}};

class DeclarationDecoder {
 public:
  explicit DeclarationDecoder(std::string_view bytes) : bytes_(bytes) {}

  CompiledDeclaration read() {
    if (bytes_.size() < 7) {
      if (!bytes_.empty()) fail("the head of the declaration is cut off");
      return std::move(result_);
    }
    const unsigned kind = byteAt(0);
    if (kind != 1 && kind != 5 && kind != 0x0A && kind != 0x0B) {
      fail(fmt::format("a declaration of kind {} is not known", kind));
      return std::move(result_);
    }
    result_.kind = static_cast<DeclarationKind>(kind);
    result_.number = static_cast<std::uint16_t>(byteAt(1) | byteAt(2) << 8);
    const std::size_t items = byteAt(3) | byteAt(4) << 8, starts = byteAt(5) | byteAt(6) << 8;
    if (bytes_.size() < 7 + items + starts) {
      fail("the declaration is shorter than its head says");
      return std::move(result_);
    }
    at_ = 7;
    end_ = 7 + items;
    startAt_ = end_;
    startEnd_ = end_ + starts;
    if (result_.kind == DeclarationKind::Data)
      dataBlock();
    else
      sections();
    return std::move(result_);
  }

 private:
  unsigned byteAt(std::size_t at) const { return static_cast<std::uint8_t>(bytes_[at]); }
  void fail(std::string reason) {
    if (result_.fault.empty()) result_.fault = fmt::format("declaration, byte {}: {}", at_, reason);
  }
  bool isFine() const { return result_.fault.empty(); }

  unsigned take() {
    if (at_ >= end_) {
      fail("the items end too early");
      return 0;
    }
    return byteAt(at_++);
  }
  unsigned takeWord() {
    const unsigned low = take();
    return low | take() << 8;
  }

  unsigned takeCount() {
    const unsigned count = take();
    return count == 0xFF ? takeWord() : count;
  }

  /// The items of a data block are one structure: the block itself.
  void dataBlock() {
    unsigned section = 0;
    const bool isWhole = at_ < end_ && byteAt(at_) == structType;
    const std::string type = isWhole ? item(section, "", 0) : "STRUCT\nEND_STRUCT";
    if (isFine() && at_ < end_) fail("items stand behind the structure of the block");
    result_.text = type + " ;\n";
  }

  void sections() {
    result_.text = sectionsText([this] { return at_ < end_; });
  }

  /// Declarations as long as more of them are there.
  template <class More>
  std::string sectionsText(More isMore) {
    std::string text;
    unsigned open = 0;
    std::array<int, 5> counts{};
    while (isFine() && isMore()) {
      unsigned section = 0;
      const std::string type = item(section, "  ", 0);
      if (!isFine()) break;
      const bool isReturned = section == 6;
      const unsigned shown = isReturned ? 2 : section;
      if (shown < 1 || shown > 5) {
        fail(fmt::format("section {} is not known", section));
        break;
      }
      const DeclarationSectionRow& row = itemSections[shown - 1];
      if (shown != open) {
        if (open != 0) text += "END_VAR\n";
        text += fmt::format("{}\n", row.keyword);
        open = shown;
      }
      int& count = counts[shown - 1];
      const std::string name = isReturned ? "RET_VAL" : fmt::format("{}{}", row.name, count++);
      text += fmt::format("  {} : {} ;\n", name, type);
    }
    return open != 0 ? text + "END_VAR\n" : text;
  }

  /// The type of the next item as text, with its start value.
  std::string item(unsigned& section, const std::string& indent, int depth) {
    if (depth > deepest) fail("the types are nested too deeply");
    const auto code = static_cast<std::uint8_t>(take());
    if (!isFine()) return {};
    if (code == fbType || code == sfbType) return instance(code, section, depth);
    const ItemType* type = itemTypeOf(code);
    if (type == nullptr) {
      --at_;
      fail(fmt::format("type {:02X} is not known", code));
      return {};
    }
    const unsigned kind = take();
    section = kind & 7U;
    const bool hasStart = (kind & 8U) != 0;
    if ((kind & 16U) != 0) take();
    if (code == arrayType) return array(indent, depth, hasStart);
    if (code == structType) return structure(indent, depth);
    if (code == stringType) {
      const unsigned length = take();
      return fmt::format("STRING [{} ]{}", length, hasStart ? stringStart() : "");
    }
    return std::string(type->name) + (hasStart ? start(*type) : "");
  }

  std::string instance(std::uint8_t code, unsigned& section, int depth) {
    const auto number = static_cast<std::uint16_t>(takeWord());
    section = 4;
    if (isFine() && at_ < end_ && byteAt(at_) == structType) {
      at_ += 2;
      unsigned left = takeCount();
      ++depth_;
      if (depth + depth_ > deepest) fail("the types are nested too deeply");
      std::string text = sectionsText([&left] { return left > 0 && left-- > 0; });
      --depth_;
      result_.instances.push_back({code == sfbType, number, std::move(text)});
    }
    return fmt::format("{} {}", code == fbType ? "FB" : "SFB", number);
  }

  std::string array(const std::string& indent, int depth, bool hasStart) {
    const unsigned dimensions = take();
    if (dimensions < 1 || dimensions > 6) fail(fmt::format("an array has {} dimensions", dimensions));
    std::string bounds;
    for (unsigned i = 0; i < dimensions && isFine(); ++i) {
      const auto low = static_cast<std::int16_t>(takeWord()), high = static_cast<std::int16_t>(takeWord());
      bounds += fmt::format("{}{} .. {} ", i > 0 ? ", " : "", low, high);
    }
    unsigned ignored = 0;
    const ItemType* type = at_ < end_ ? itemTypeOf(static_cast<std::uint8_t>(byteAt(at_))) : nullptr;
    const std::string element = item(ignored, indent, depth + 1);
    return fmt::format("ARRAY  [{}] OF {}{}", bounds, element, hasStart && type != nullptr ? arrayStart(*type) : "");
  }

  /// Values of an array: the number of groups twice, least byte first and last, then repetition and value of each.
  std::string arrayStart(const ItemType& type) {
    constexpr std::size_t headBytes = 4;
    if (hasLostStarts_ || startAt_ + headBytes > startEnd_) return loseStarts();
    const std::size_t groups = byteAt(startAt_) | byteAt(startAt_ + 1) << 8;
    if (groups != (byteAt(startAt_ + 2) << 8 | byteAt(startAt_ + 3))) return loseStarts();
    startAt_ += headBytes;
    std::string text;
    for (std::size_t i = 0; i < groups && !hasLostStarts_; ++i) {
      if (startAt_ + 2 > startEnd_) return loseStarts();
      const unsigned repeated = byteAt(startAt_) | byteAt(startAt_ + 1) << 8;
      startAt_ += 2;
      const std::string value = type.code == stringType ? stringStart() : start(type);
      if (value.empty()) return loseStarts();
      const std::string_view constant = std::string_view(value).substr(std::string_view(" := ").size());
      text += text.empty() ? " := " : ", ";
      text += repeated == 1 ? std::string(constant) : fmt::format("{} ({})", repeated, constant);
    }
    return text;
  }
  std::string loseStarts() {
    hasLostStarts_ = true;
    return {};
  }

  std::string structure(const std::string& indent, int depth) {
    const unsigned count = takeCount();
    std::string text = "STRUCT\n";
    for (unsigned i = 0; i < count && isFine(); ++i) {
      unsigned ignored = 0;
      const std::string type = item(ignored, indent + "  ", depth + 1);
      text += fmt::format("{}  STAT{} : {} ;\n", indent, i, type);
    }
    return text + indent + "END_STRUCT";
  }

  // Start values stand behind the items, least byte first. Behind one that does not fit, no more are told.
  std::string start(const ItemType& type) {
    if (hasLostStarts_ || type.startBytes == 0) return {};
    if (startAt_ + type.startBytes > startEnd_) {
      hasLostStarts_ = true;
      return {};
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.startBytes; ++i) bits |= std::uint64_t{byteAt(startAt_ + i)} << (8 * i);
    startAt_ += type.startBytes;
    s7300::Constant value;
    value.kind = type.constant;
    value.value = static_cast<std::int64_t>(bits);
    if (type.constant == ConstantKind::Integer) value.value = static_cast<std::int16_t>(bits);
    if (type.constant == ConstantKind::Long) value.value = static_cast<std::int32_t>(bits);
    if (type.constant == ConstantKind::Text) return fmt::format(" := '${:02X}'", bits);
    return " := " + step7::spellingOf(value);
  }

  std::string stringStart() {
    if (hasLostStarts_ || startAt_ + 2 > startEnd_ || startAt_ + 2 + byteAt(startAt_ + 1) > startEnd_) {
      hasLostStarts_ = true;
      return {};
    }
    const std::size_t length = byteAt(startAt_ + 1);
    std::string text = " := '";
    for (std::size_t i = 0; i < length; ++i) text += fmt::format("${:02X}", byteAt(startAt_ + 2 + i));
    startAt_ += 2 + length;
    return text + "'";
  }

  std::string_view bytes_;
  std::size_t at_ = 0, end_ = 0, startAt_ = 0, startEnd_ = 0;
  bool hasLostStarts_ = false;
  int depth_ = 0;  ///< of instances
  CompiledDeclaration result_;
};

}  // namespace

CompiledDeclaration readCompiledDeclaration(std::string_view bytes) { return DeclarationDecoder(bytes).read(); }

std::string declaredItems(std::string_view bytes) {
  constexpr std::size_t headBytes = 7;
  if (bytes.size() < headBytes) return std::string(bytes);
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); };
  const auto kind = static_cast<DeclarationKind>(byte(0));
  const bool isInstance = kind == DeclarationKind::InstanceOfFb || kind == DeclarationKind::InstanceOfSfb;
  // The number of another block than that of an instance is stale in half of all.
  const std::string head(bytes.substr(0, isInstance ? 3 : 1));
  return head + std::string(bytes.substr(headBytes, std::size_t{byte(3)} | std::size_t{byte(4)} << 8));
}

}  // namespace rungproof::mc7
