// Derives the access lists from descriptors and operands.
#include "analysis/access.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>

#include "analysis/instruction_kind.hpp"
#include "ir/library_block.hpp"

namespace rungproof {

namespace {

constexpr int tableWords = 102;   // TL, EC and at most 100 entries (001:6260)
constexpr int findWords = 101;    // FND starts at EC (001:6441)
constexpr int stringBytes = 255;  // length byte and at most 254 characters (001:1414)

/// How many elements an operand covers: at least, at most.
struct Extent {
  int least = 1;
  int most = 1;
};

class AccessCollector {
 public:
  AccessCollector(const Program& program, std::vector<Access>& accesses) : accesses_(accesses) {
    for (const Pou& pou : program.pous) {
      if (pou.kind == PouKind::Subroutine) subroutines_.emplace(pou.number, &pou);
    }
  }

  void collect(const Flow& flow, const FlowStep& step) {
    instruction_ = step.instruction;
    desc_ = instruction_->desc;
    kind_ = kindOf(*desc_);
    conditional_ = desc_->execution == Execution::Conditional ||
                   (desc_->execution == Execution::Control && desc_->stack.needs > 0);
    if (desc_->control == Control::Call) return call();
    const std::size_t count = std::min<std::size_t>(instruction_->operands.size(), desc_->operandCount);
    for (std::size_t i = 0; i < count; ++i) operand(i);
    if (desc_->control == Control::Scrt && step.partner != noPartner) leaveStep(*flow.steps[step.partner].instruction);
  }

 private:
  const Operand& op(std::size_t i) const { return instruction_->operands[i]; }
  std::optional<int> constantAt(std::size_t i) const {
    return i < instruction_->operands.size() ? constantCount(op(i)) : std::nullopt;
  }

  /// Count operand `i` with its upper limit, scaled to elements by `scale` (numerator, denominator).
  Extent counted(std::size_t i, int limit, int divisor = 1) const {
    if (const auto n = constantAt(i)) {
      const int elements = (std::min(*n, limit) + divisor - 1) / divisor;
      return {elements, elements};
    }
    return {1, limit / divisor};
  }

  Extent extentOf(std::size_t i) const {
    const OperandDesc& d = desc_->operands[i];
    switch (kind_) {
      case Kind::Set:
      case Kind::Reset: return i == 0 ? counted(1, 255) : Extent{};
      case Kind::SetImmediate:
      case Kind::ResetImmediate: return i == 0 ? counted(1, 128) : Extent{};
      case Kind::BlockByte:
      case Kind::BlockWord:
      case Kind::BlockDWord: return i < 2 ? counted(2, 255) : Extent{};
      case Kind::Fill: return i == 1 ? counted(2, 255) : Extent{};
      case Kind::Shrb: return i == 1 ? shiftRegister() : Extent{};
      case Kind::Att: return i == 1 ? Extent{2, tableWords} : Extent{};
      case Kind::Lifo:
      case Kind::Fifo: return i == 0 ? Extent{2, tableWords} : Extent{};
      case Kind::Find: return i == 0 ? Extent{1, findWords} : Extent{};
      case Kind::AsciiToHex: return i == 0 ? counted(2, 255) : i == 1 ? counted(2, 255, 2) : Extent{};
      case Kind::HexToAscii: return i == 0 ? counted(2, 255, 2) : i == 1 ? counted(2, 255) : Extent{};
      default: break;
    }
    if (d.type == Type::String) return stringExtent(d);
    if (d.buffer.high == 0) return {std::max(d.buffer.low, 1), 255};
    return {std::max(d.buffer.low, 1), std::max(d.buffer.high, 1)};
  }

  /// A string written from a text constant has a known length.
  Extent stringExtent(const OperandDesc& d) const {
    if (kind_ == Kind::StringCopy && d.direction == Direction::Out && op(0).kind == OperandKind::Text) {
      const int length = static_cast<int>(op(0).text.size()) + 1;
      return {length, length};
    }
    return {1, stringBytes};
  }

  /// N of SHRB is signed, -64 to 64 (001:6024).
  Extent shiftRegister() const {
    if (instruction_->operands.size() < 3 || op(2).kind != OperandKind::Constant) return {1, 64};
    std::int64_t n = op(2).value;
    if (n > 127) n -= 256;
    const int length = static_cast<int>(std::clamp<std::int64_t>(std::abs(n), 1, 64));
    return {length, length};
  }

  void operand(std::size_t i) {
    const OperandDesc& d = desc_->operands[i];
    const Operand& o = op(i);
    const Extent extent = extentOf(i);
    switch (d.type) {
      case Type::Timer:
      case Type::Counter: return box(i, o);
      case Type::Label:
      case Type::Subroutine:
      case Type::Interrupt: return;
      default: break;
    }
    const bool reads = d.direction != Direction::Out, writes = d.direction != Direction::In;
    const Width width = widthOf(d.type);
    if (reads && isLowWordOnly(i)) {
      lowWord(i, o);
    } else if (reads) {
      add(i, o, width, extent, false);
    }
    if (writes) add(i, o, width, extent, true);
    if (writes && isReset(kind_) && i == 0 && o.kind == OperandKind::Direct &&
        (o.area == Area::T || o.area == Area::C)) {
      add(i, o, Width::Word, extent, true);
    }
  }

  bool isLowWordOnly(std::size_t i) const { return i == 1 && (kind_ == Kind::Mul || kind_ == Kind::Div); }
  void lowWord(std::size_t i, const Operand& o) {
    Operand low = o;
    if (o.kind == OperandKind::Direct && o.area != Area::AC) low.offset += 2;
    add(i, low, Width::Word, {}, false);
  }

  /// The box of a timer or counter owns its bit and its value.
  void box(std::size_t i, const Operand& o) {
    if (o.kind != OperandKind::Direct) return;
    for (const Width width : {Width::Bit, Width::Word}) {
      add(i, o, width, {}, true);
      if (!accesses_.empty()) accesses_.back().isBox = true;
    }
  }

  void add(std::size_t i, const Operand& o, Width width, Extent extent, bool write, bool maybe = false) {
    if (o.kind != OperandKind::Direct && o.kind != OperandKind::Indirect) return;
    Access access;
    access.instruction = instruction_->id;
    access.operand = static_cast<std::uint8_t>(i);
    access.area = o.area;
    access.offset = o.offset;
    access.bit = o.bit;
    access.width = width;
    access.count = static_cast<std::uint16_t>(extent.least);
    access.most = static_cast<std::uint16_t>(extent.most);
    access.conditional = conditional_;
    access.maybe = maybe;
    if (o.kind == OperandKind::Indirect) {
      Access pointer = access;
      pointer.width = Width::DWord;
      pointer.count = pointer.most = 1;
      pointer.maybe = false;
      accesses_.push_back(pointer);
      access.viaPointer = true;
    }
    access.write = write;
    accesses_.push_back(access);
  }

  void leaveStep(const Instruction& segment) {
    if (segment.operands.empty() || segment.operands[0].kind != OperandKind::Direct) return;
    add(impliedOperand, segment.operands[0], Width::Bit, {}, true);
  }

  /// Parameters in the order of the callee's table (001:6815, 001:6823); of an unknown block: either direction.
  void call() {
    const std::size_t count = instruction_->operands.size();
    const auto found = count == 0 ? subroutines_.end() : subroutines_.find(static_cast<int>(op(0).value));
    std::size_t i = 1;
    if (found != subroutines_.end()) {
      for (const LocalVariable& local : found->second->locals) {
        if (local.section == VarSection::Temp || i >= count) continue;
        const Width width = widthOf(local.type);
        if (local.section != VarSection::Output) add(i, op(i), width, {}, false);
        if (local.section != VarSection::Input) add(i, op(i), width, {}, true);
        ++i;
      }
    }
    const LibraryBlock* library =
        count > 0 && op(0).kind == OperandKind::Symbol ? libraryBlockNamed(op(0).text) : nullptr;
    for (; library != nullptr && i < count && i <= library->parameters.size(); ++i) {
      const LibraryParameter& parameter = library->parameters[i - 1];
      add(i, op(i), widthOf(parameter.type), {}, parameter.direction == Direction::Out);
    }
    for (; i < count; ++i) {
      const bool isFixed = op(i).kind == OperandKind::Direct && (op(i).area == Area::T || op(i).area == Area::C);
      const Width width = isFixed ? Width::Bit : op(i).width;
      add(i, op(i), width, {}, false, true);
      add(i, op(i), width, {}, true, true);
    }
  }

  std::vector<Access>& accesses_;
  std::map<int, const Pou*> subroutines_;
  const Instruction* instruction_ = nullptr;
  const Desc* desc_ = nullptr;
  Kind kind_ = Kind::Other;
  bool conditional_ = false;
};

}  // namespace

AccessTable::AccessTable(const Program& program, const Plan& plan) {
  const std::size_t count = program.instructionCount();
  accesses_.reserve(count * 2);
  first_.reserve(count + 1);
  AccessCollector collector(program, accesses_);
  for (const Flow& flow : plan.flows) {
    for (const FlowStep& step : flow.steps) {
      first_.resize(step.id + 1, static_cast<std::uint32_t>(accesses_.size()));
      collector.collect(flow, step);
    }
  }
  first_.resize(count + 1, static_cast<std::uint32_t>(accesses_.size()));
}

std::optional<int> constantCount(const Operand& operand) {
  if (operand.kind != OperandKind::Constant) return std::nullopt;
  return static_cast<int>(std::clamp<std::int64_t>(operand.value, 0, 255));
}

std::string accessName(const Access& access) {
  const std::string name = addressName(access.area, access.width, access.offset, access.bit);
  return access.viaPointer ? "*" + addressName(access.area, Width::DWord, access.offset) : name;
}

std::string accessRange(const Access& access) {
  if (access.count < 2 || access.viaPointer) return accessName(access);
  const std::uint32_t last = access.count - 1U;
  const bool isBits = access.width == Width::Bit && !access.byNumber();
  const std::uint32_t step = access.byNumber() ? 1 : static_cast<std::uint32_t>(bytes(access.width));
  const std::uint32_t offset = isBits ? access.offset + (access.bit + last) / 8 : access.offset + last * step;
  return accessName(access) + " to " +
         addressName(access.area, access.width, offset, isBits ? (access.bit + last) % 8 : 0);
}

}  // namespace rungproof
