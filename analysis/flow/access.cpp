// Derives the access lists from descriptors and operands.
#include "analysis/flow/access.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/error_codes.hpp"
#include "ir/s7200/library_block.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/pointer_code.hpp"

namespace rungproof {

namespace {

constexpr int stringBytes = 255;  // length byte and at most 254 characters (001:1414)

/// How many elements an operand covers: at least, at most.
struct Extent {
  int least = 1;
  int most = 1;
};

class AccessCollector {
 public:
  AccessCollector(const Program& program, std::vector<Access>& accesses)
      : outputImage_(areaSize(program.target, Area::Q)), accesses_(accesses) {
    for (const Pou& pou : program.pous) {
      if (pou.kind == PouKind::Subroutine) subroutines_.emplace(pou.number, &pou);
    }
  }

  void collect(const Flow& flow, const FlowStep& step) {
    instruction_ = step.instruction;
    desc_ = instruction_->desc;
    conditional_ = desc_->execution == Execution::Conditional ||
                   (desc_->execution == Execution::Control && desc_->stack.needs > 0);
    if (desc_->control == Control::Call) return call();
    if (desc_->control == Control::BlockCall) return blockCall();
    const std::size_t count = std::min<std::size_t>(instruction_->operands.size(), desc_->operandCount);
    for (std::size_t i = 0; i < count; ++i) operand(i);
    if (readsErrorStatus(*desc_)) add(impliedOperand, direct(Area::SM, Width::Bit, 4, 3), Width::Bit, {}, false);
    if (desc_->control == Control::Scrt && step.partner != noPartner) leaveStep(*flow.steps[step.partner].instruction);
  }

 private:
  const Operand& op(std::size_t i) const { return instruction_->operands[i]; }
  std::optional<int> constantAt(std::size_t i) const {
    return i < instruction_->operands.size() ? constantCount(op(i)) : std::nullopt;
  }

  /// Elements that the operand which counts them gives: all of them if it is constant, from one up to its limit if not.
  Extent counted(const CountOperand& count) const {
    const auto by = static_cast<std::size_t>(count.operand);
    const bool isSigned = desc_->operands[by].ranges[0].low < 0;  // N of SHRB, -64 to 64 (001:6024)
    const auto n = isSigned ? signedCount(by) : constantAt(by);
    if (!n) return {1, count.limit / count.divisor};
    const int elements = (std::min<int>(*n, count.limit) + count.divisor - 1) / count.divisor;
    return {elements, elements};
  }
  /// Amount of a count of which only the sign tells the direction; at least 1.
  std::optional<int> signedCount(std::size_t i) const {
    if (i >= instruction_->operands.size() || op(i).kind != OperandKind::Constant) return std::nullopt;
    const std::int64_t n = op(i).value > 127 ? op(i).value - 256 : op(i).value;
    return static_cast<int>(std::clamp<std::int64_t>(std::abs(n), 1, 255));
  }

  Extent extentOf(const OperandDesc& d) const {
    if (d.count.operand >= 0) return counted(d.count);
    if (d.type == Type::String) return stringExtent(d);
    if (d.buffer.high == 0) return {std::max(d.buffer.low, 1), 255};
    return {std::max(d.buffer.low, 1), std::max(d.buffer.high, 1)};
  }

  /// A string written from a text constant has a known length.
  Extent stringExtent(const OperandDesc& d) const {
    if (desc_->role == Role::StringCopy && d.direction == Direction::Out && op(0).kind == OperandKind::Text) {
      const int length = static_cast<int>(op(0).text.size()) + 1;
      return {length, length};
    }
    return {1, stringBytes};
  }

  void operand(std::size_t i) {
    const OperandDesc& d = desc_->operands[i];
    const Operand& o = op(i);
    const Extent extent = extentOf(d);
    switch (d.type) {
      case Type::Timer:
      case Type::Counter: return box(i, o);
      case Type::Label:
      case Type::Subroutine:
      case Type::Block:
      case Type::Interrupt: return;
      default: break;
    }
    const bool reads = d.direction != Direction::Out, writes = d.direction != Direction::In;
    const Width width = d.type == Type::Value ? o.width : widthOf(d.type);
    if (reads && d.lowWordRead) {
      lowWord(i, o);
    } else if (reads) {
      add(i, o, width, extent, false);
    }
    if (writes) add(i, o, width, extent, true);
    if (writes && isReset(desc_->role) && i == 0 && o.kind == OperandKind::Direct && hasBitAndWord(o.area)) {
      add(i, o, Width::Word, extent, true);
    }
  }

  void lowWord(std::size_t i, const Operand& o) {
    Operand low = o;
    if (o.kind == OperandKind::Direct && o.area != Area::AC) low.offset += 2;
    add(i, low, Width::Word, {}, false);
  }

  /// The box of a timer or counter owns its bit and its value.
  void box(std::size_t i, const Operand& o) {
    if (o.kind != OperandKind::Direct) return add(i, o, Width::Bit, {}, true);
    for (const Width width : {Width::Bit, Width::Word}) {
      add(i, o, width, {}, true);
      if (!accesses_.empty()) accesses_.back().isBox = true;
    }
  }

  /// A timer or counter as a parameter: the statements of the block may do with it whatever they do.
  void element(std::size_t i) {
    add(i, op(i), Width::Bit, {}, false, true);
    add(i, op(i), Width::Bit, {}, true, true);
  }

  /// What a POINTER or an ANY leads to may be read and written by the block that gets it; a block of the library does
  /// what the section of the parameter says.
  void pointed(std::size_t i, const Operand& o, VarSection section, bool isLibrary) {
    Operand place = o.reach->pointer;
    if (place.kind == OperandKind::Constant) place = direct(o.area, Width::Byte, o.offset, o.bit);
    if (place.area == Area::T || place.area == Area::C) {  // a number for the statements of the block
      add(i, place, Width::Bit, {}, false, true);
      return add(i, place, Width::Bit, {}, true, true);
    }
    const auto type = static_cast<AnyType>(o.reach->anyType);
    const bool isBits = type == AnyType::Bool;
    constexpr std::uint32_t mostElements = std::numeric_limits<std::uint16_t>::max();
    const std::uint32_t all = isBits ? o.reach->anyCount : bytesOfElements(type, o.reach->anyCount);
    const int elements = static_cast<int>(std::min(all, mostElements));
    const Extent extent{std::max(elements, 1), std::max(elements, 1)};
    const Width width = isBits ? Width::Bit : Width::Byte;
    if (!isLibrary || section != VarSection::Output) add(i, place, width, extent, false, !isLibrary);
    if (!isLibrary || section != VarSection::Input) add(i, place, width, extent, true, !isLibrary);
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
    if (o.reach != nullptr) {
      addReached(access, o, write);
      return;
    }
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
    if (write && o.kind == OperandKind::Direct && o.area == Area::PQ) throughToImage(access);
  }

  /// What goes to a module at once goes to the image too, as far as that reaches (002:1273).
  void throughToImage(Access access) {
    access.area = Area::Q;
    if (access.offset + bytes(access.width) > outputImage_) access.width = Width::Byte;
    if (access.offset < outputImage_) accesses_.push_back(access);
  }

  /// S7-300/400: a place that registers or the call decide; a pointer that stands at an address is read.
  void addReached(Access access, const Operand& o, bool write) {
    if (o.reach->way == Way::Pointer && o.reach->pointer.kind == OperandKind::Direct)
      add(access.operand, o.reach->pointer, o.reach->pointer.width, {}, false);
    access.viaPointer = true;
    access.pointed = o.reach->way == Way::Crossing    ? Pointed::Anywhere
                     : o.reach->way == Way::Parameter ? Pointed::OfCall
                                                      : Pointed::InArea;
    access.write = write;
    accesses_.push_back(access);
  }

  /// CALL of an S7-300/400: each actual parameter in the direction of its formal one; of a block without text either.
  void blockCall() {
    const std::size_t count = instruction_->operands.size();
    const auto found = count == 0 ? subroutines_.end() : subroutines_.find(static_cast<int>(op(0).value));
    std::size_t i = found != subroutines_.end() && hasInstance(*found->second) ? 2 : 1;
    if (found != subroutines_.end()) {
      for (const LocalVariable& local : found->second->locals) {
        if (local.section == VarSection::Temp || local.section == VarSection::Static || i >= count) continue;
        if (op(i).reach != nullptr && op(i).reach->way == Way::PointerTo) {
          pointed(i, op(i), local.section, found->second->isBuiltIn);
          ++i;
          continue;
        }
        if (local.type == DataType::BlockDb) {
          ++i;
          continue;
        }
        if (local.type == DataType::Timer || local.type == DataType::Counter) {
          element(i++);
          continue;
        }
        const bool isPointer = local.type == DataType::Any || local.type == DataType::Pointer;
        if (isPointer && found->second->isBuiltIn && op(i).isMemory()) {  // wherever it leads
          Access access;
          access.instruction = instruction_->id;
          access.operand = static_cast<std::uint8_t>(i);
          access.viaPointer = true;
          access.write = local.section != VarSection::Input;
          accesses_.push_back(access);
        }
        const Width width = local.size == 0 ? Width::Bit : Width::Byte;
        // Of a text, the two bytes before the characters for certain.
        constexpr int lengthBytes = 2;
        const int size = std::max(static_cast<int>(local.size), 1);
        const Extent extent{local.type == DataType::String ? std::min(lengthBytes, size) : size, size};
        if (local.section != VarSection::Output) add(i, op(i), width, extent, false);
        if (local.section != VarSection::Input) add(i, op(i), width, extent, true);
        ++i;
      }
    }
    for (; i < count; ++i) {
      add(i, op(i), op(i).width, {}, false, true);
      add(i, op(i), op(i).width, {}, true, true);
    }
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
    const bool isHidden = count > 0 && found == subroutines_.end();
    const LibraryBlock* library = isHidden ? libraryBlockWith(op(0).text, count - 1) : nullptr;
    for (; library != nullptr && i < count && i <= library->parameters.size(); ++i) {
      const LibraryParameter& parameter = library->parameters[i - 1];
      add(i, op(i), widthOf(parameter.type), {}, parameter.direction == Direction::Out);
    }
    for (; i < count; ++i) {
      const bool isFixed = op(i).kind == OperandKind::Direct && hasBitAndWord(op(i).area);
      const Width width = isFixed ? Width::Bit : op(i).width;
      add(i, op(i), width, {}, false, true);
      add(i, op(i), width, {}, true, true);
    }
  }

  std::uint32_t outputImage_;  ///< bytes
  std::vector<Access>& accesses_;
  std::map<int, const Pou*> subroutines_;
  const Instruction* instruction_ = nullptr;
  const Desc* desc_ = nullptr;
  bool conditional_ = false;
};

}  // namespace

AccessTable::AccessTable(const Program& program, const Plan& plan) {
  const std::size_t count = program.instructionCount();
  accesses_.reserve(count * 2 + 1);
  marks_.reserve(count / markEvery + 1);
  AccessCollector collector(program, accesses_);
  for (const Flow& flow : plan.flows) {
    for (const FlowStep& step : flow.steps) {
      marks_.resize(step.id() / markEvery + 1, static_cast<std::uint32_t>(accesses_.size()));
      collector.collect(flow, step);
    }
  }
  marks_.resize(count / markEvery + 1, static_cast<std::uint32_t>(accesses_.size()));
  accesses_.emplace_back().instruction = std::numeric_limits<std::uint32_t>::max();
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
