// From a call and what it gives to what its block may write.
#include "ir/s7200/call_contract.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_set>

namespace rungproof {

namespace {

constexpr std::uint32_t longestMessage = 240;     ///< bytes: 120 words or 1,920 bits (001:10711-10718)
constexpr std::uint32_t longestReception = 1024;  ///< bytes of a message of the open communication
constexpr std::int64_t firstRegister = 30001;     ///< Modbus addresses from here on are words (001:10641-10680)

bool isMissing(const Instruction& call, const Program& program) {
  if (call.desc->control != Control::Call || call.operands.empty()) return false;
  const Operand& callee = call.operands[0];
  if (callee.kind == OperandKind::Symbol) return true;
  if (callee.kind != OperandKind::Constant) return false;
  const Pou* pou = program.subroutine(static_cast<int>(callee.value));
  return pou == nullptr || pou->protectedBlock;
}

/// The protected block of that call, or nullptr.
const Pou* protectedBlock(const Instruction& call, const Program& program) {
  const Operand& callee = call.operands[0];
  if (callee.kind == OperandKind::Constant) return program.subroutine(static_cast<int>(callee.value));
  const auto found = std::ranges::find_if(program.pous, [&](const Pou& pou) {
    return pou.kind == PouKind::Subroutine && pou.protectedBlock && pou.name == callee.text;
  });
  return found == program.pous.end() ? nullptr : &*found;
}

std::string nameOf(const Instruction& call, const Pou* block) {
  if (block != nullptr) return block->name;
  const Operand& callee = call.operands[0];
  const bool isName = callee.kind == OperandKind::Symbol || libraryBlockNamed(callee.text) != nullptr;
  return isName ? std::string(callee.text) : "SBR" + std::to_string(callee.value);
}

std::optional<std::int64_t> constantAt(const Instruction& call, std::size_t place) {
  if (place == 0 || place >= call.operands.size() || call.operands[place].kind != OperandKind::Constant)
    return std::nullopt;
  return call.operands[place].value;
}

/// Which bytes the instructions of a program touch by their addresses, generously.
class TouchedBytes {
 public:
  explicit TouchedBytes(const Program& program) : target_(program.target) {
    for (std::size_t a = 0; a < areaCount; ++a) marks_[a].resize(areaSize(target_, static_cast<Area>(a)));
    for (const Pou& pou : program.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) add(instruction);
      }
    }
  }

  /// The parts of the row in such bytes; outputs are few and count as touched.
  void part(const MemoryRow& row, std::vector<MemoryRow>& parts) const {
    if (followsPointers_ || row.area == Area::Q) return parts.push_back(row);
    const std::vector<bool>& marks = marks_[static_cast<std::size_t>(row.area)];
    for (std::uint32_t bit = row.first; bit < row.first + row.count;) {
      const std::uint32_t end = std::min(row.first + row.count, (bit / 8 + 1) * 8);
      const bool isTouched = bit / 8 < marks.size() && marks[bit / 8];
      const bool isNext =
          !parts.empty() && parts.back().area == row.area && parts.back().first + parts.back().count == bit;
      if (isTouched && isNext) parts.back().count += end - bit;
      if (isTouched && !isNext) parts.push_back({row.area, bit, end - bit});
      bit = end;
    }
  }

 private:
  static constexpr std::uint32_t longestRow = 1100;  ///< bytes behind an operand that stands for several elements

  void add(const Instruction& instruction) {
    const Desc& desc = *instruction.desc;
    const bool isCall = desc.control == Control::Call;
    followsPointers_ = followsPointers_ || desc.group == "communication";
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      followsPointers_ = followsPointers_ || operand.kind == OperandKind::Indirect;
      if (operand.kind != OperandKind::Direct || addressedByNumber(operand.area)) continue;
      const bool isOne = isCall || (i < desc.operandCount && desc.operands[i].count.operand < 0 &&
                                    desc.operands[i].type != Type::String && desc.operands[i].buffer.low <= 1 &&
                                    desc.operands[i].buffer.high == 1);
      std::vector<bool>& marks = marks_[static_cast<std::size_t>(operand.area)];
      const std::uint32_t length = isOne ? 4 : longestRow;  // MUL and DIV reach a word further than their type
      for (std::uint32_t k = 0; k < length && operand.offset + k < marks.size(); ++k) marks[operand.offset + k] = true;
    }
  }

  const Target target_;
  std::array<std::vector<bool>, areaCount> marks_;
  bool followsPointers_ = false;
};

class ContractBuilder {
 public:
  ContractBuilder(const Program& program, const Instruction& call) : program_(program), call_(call) {
    const Pou* block = protectedBlock(call, program);
    contract_.name = nameOf(call, block);
    contract_.given = call.operands.size() - 1;
    const LibraryBlock* named = libraryBlockNamed(contract_.name);
    const LibraryBlock* known = libraryBlockWith(contract_.name, call.operands.size() - 1);
    if (named != nullptr) {
      contract_.source = CallContract::Source::Library;
      contract_.keepsAccumulators = contract_.name.size() > 1 &&
                                    (contract_.name[0] == 'M' || contract_.name[0] == 'm') &&
                                    (contract_.name[1] == 'B' || contract_.name[1] == 'b');
    }
    if (known != nullptr)
      byManual(*known);
    else if (block != nullptr && hasParameters(*block))
      byTable(*block);
    else
      byOperands(named);
    const bool writesNothing = contract_.outputs.empty() && contract_.memory.empty() && !contract_.fillsAnyV;
    contract_.mayDoAnything = contract_.source != CallContract::Source::Library && writesNothing;
    contract_.isUndefined = named == nullptr && block == nullptr && call.operands[0].kind == OperandKind::Symbol;
    if (named != nullptr) placeOwn(*named);
  }
  CallContract take() { return std::move(contract_); }

 private:
  static bool hasParameters(const Pou& block) {
    return std::ranges::any_of(block.locals,
                               [](const LocalVariable& local) { return local.section != VarSection::Temp; });
  }

  void byManual(const LibraryBlock& block) {
    for (std::uint32_t place = 1; place < call_.operands.size(); ++place) {
      const LibraryParameter& parameter = block.parameters[place - 1];
      if (parameter.direction == Direction::Out) output(place, parameter.type);
    }
    switch (block.reach) {
      case LibraryReach::Nothing: break;
      case LibraryReach::Message: message(block); break;
      case LibraryReach::Holding: holding(block, call_); break;
      case LibraryReach::Slave: slave(); break;
      case LibraryReach::Scratch: buffer(placeOf(block, "DB_Ptr"), ussScratchBytes); break;
      case LibraryReach::Received: break;
      case LibraryReach::Record: contract_.fillsAnyV = true; break;
    }
  }

  void byTable(const Pou& block) {
    contract_.source =
        contract_.source == CallContract::Source::Library ? contract_.source : CallContract::Source::Table;
    std::uint32_t place = 1;
    for (const LocalVariable& local : block.locals) {
      if (local.section == VarSection::Temp || place >= call_.operands.size()) continue;
      if (local.section != VarSection::Input) output(place, local.type);
      address(place++);
    }
    for (; place < call_.operands.size(); ++place) operand(place);
  }

  void byOperands(const LibraryBlock* library) {
    contract_.fillsAnyV = library != nullptr && library->reach == LibraryReach::Record;
    longest_ = library != nullptr && library->reach == LibraryReach::Received ? longestReception : ~0U;
    const auto countOf = [&](Direction direction) {
      if (library == nullptr || !library->isOpen) return std::ptrdiff_t{0};
      return std::ranges::count(library->parameters, direction, &LibraryParameter::direction);
    };
    // Of an open list the inputs come first and the outputs last.
    const std::ptrdiff_t inputs = countOf(Direction::In), outputs = countOf(Direction::Out);
    const auto end = static_cast<std::ptrdiff_t>(call_.operands.size());
    for (std::ptrdiff_t place = outputs > 0 ? std::max(inputs + 1, end - outputs) : inputs + 1; place < end; ++place)
      operand(static_cast<std::uint32_t>(place));
  }

  /// An operand that may be an output: what a block may write at all (table 6-78, 001:6752-6757).
  void operand(std::uint32_t place) {
    const Operand& o = call_.operands[place];
    address(place);
    const bool isPlace = o.kind == OperandKind::Indirect || (o.kind == OperandKind::Direct && mayBeGiven(o));
    if (!isPlace) return;
    switch (o.kind == OperandKind::Direct && o.area == Area::AC ? Width::DWord : o.width) {
      case Width::Bit: return output(place, DataType::Bool);
      case Width::Byte: return output(place, DataType::Byte);
      case Width::Word: return output(place, DataType::Word);
      case Width::DWord:
      case Width::LWord: return output(place, DataType::DWord);
    }
  }

  /// Inputs, and the boxes and values of timers and counters, are given to be read.
  static bool mayBeGiven(const Operand& o) {
    if (isInputArea(o.area) || addressedByNumber(o.area)) return o.area == Area::AC;
    return o.area != Area::SM || o.offset > smReadOnlyLast;
  }

  void output(std::uint32_t place, DataType type) {
    const OperandKind kind = call_.operands[place].kind;
    if (kind == OperandKind::Direct || kind == OperandKind::Indirect) contract_.outputs.push_back({place, type});
  }

  /// An address: how much stands there nobody says. A double word may hold any address that the program forms.
  void address(std::uint32_t place) {
    const Operand& o = call_.operands[place];
    if (o.kind == OperandKind::Address) return buffer(o, longest_);
    const bool isPlace = o.kind == OperandKind::Direct || o.kind == OperandKind::Indirect;
    if (!isPlace || (o.area != Area::AC && o.width != Width::DWord)) return;
    for (const Pou& pou : program_.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          for (const Operand& formed : instruction.operands) {
            if (formed.kind == OperandKind::Address) buffer(formed, longest_);
          }
        }
      }
    }
  }

  /// `length` bytes, at most to the end of the area, from what the operand points to.
  void buffer(std::size_t place, std::uint32_t length) {
    if (place == 0 || place >= call_.operands.size() || length == 0) return;
    buffer(call_.operands[place], length);
  }
  void buffer(const Operand& o, std::uint32_t length) {
    std::optional<Area> area;
    std::uint32_t first = 0;
    if (o.kind == OperandKind::Address) {
      area = o.area;
      first = o.offset;
    } else if (o.kind == OperandKind::Constant) {
      const auto value = static_cast<std::uint32_t>(o.value);
      if (pointer::isLegal(program_.target, value, Width::Byte)) area = pointer::areaOf(value);
      first = pointer::offsetOf(value);
    }
    if (!area || addressedByNumber(*area)) {
      contract_.fillsAnyV = true;
      return;
    }
    const std::uint32_t size = areaSize(program_.target, *area);
    if (first < size) contract_.memory.push_back({*area, first * 8, std::min(length, size - first) * 8});
  }

  static std::uint32_t placeOf(const LibraryBlock& block, std::string_view parameter) {
    const auto found = std::ranges::find(block.parameters, parameter, &LibraryParameter::name);
    return found == block.parameters.end() ? 0 : static_cast<std::uint32_t>(found - block.parameters.begin()) + 1;
  }

  /// A message that is read fills its buffer; one that is sent leaves it alone.
  void message(const LibraryBlock& block) {
    if (const auto isSent = constantAt(call_, placeOf(block, "RW")); isSent && *isSent == 1) return;
    const auto count = constantAt(call_, placeOf(block, "Count"));
    const auto address = constantAt(call_, placeOf(block, "Addr"));
    const bool areBits = address && *address < firstRegister;
    std::uint32_t length = longestMessage;
    if (count && *count >= 0 && *count <= (areBits ? longestMessage * 8 : longestMessage / 2))
      length = static_cast<std::uint32_t>(areBits ? (*count + 7) / 8 : *count * 2);
    buffer(placeOf(block, "DataPtr"), length);
  }

  /// What a master may write: MaxHold words from HoldStart, and the first MaxIQ outputs (001:10715-10718).
  void holding(const LibraryBlock& block, const Instruction& call) {
    const auto words = constantAt(call, placeOf(block, "MaxHold"));
    const std::uint32_t place = placeOf(block, "HoldStart");
    if (place < call.operands.size() && (!words || *words != 0)) {
      const Operand& start = call.operands[place];
      const std::uint32_t size = areaSize(program_.target, Area::V);
      if (start.kind == OperandKind::Address && start.area == Area::V && start.offset < size) {
        const std::int64_t length = words && *words > 0 ? std::min<std::int64_t>(*words * 2, size) : size;
        const auto count = std::min<std::uint32_t>(static_cast<std::uint32_t>(length), size - start.offset);
        contract_.memory.push_back({Area::V, start.offset * 8, count * 8});
      } else {
        contract_.fillsAnyV = true;
      }
    }
    const std::uint32_t most = areaSize(program_.target, Area::Q) * 8;
    const auto outputs = constantAt(call, placeOf(block, "MaxIQ"));
    const std::uint32_t count =
        outputs && *outputs >= 0 ? static_cast<std::uint32_t>(std::min<std::int64_t>(*outputs, most)) : most;
    if (count > 0) contract_.memory.push_back({Area::Q, 0, count});
  }

  /// As MBUS_INIT has it. Without one in the text the slave may be initialised anywhere.
  void slave() {
    bool isKnown = false;
    for (const Pou& pou : program_.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          if (!isMissing(instruction, program_)) continue;
          const std::string name = nameOf(instruction, protectedBlock(instruction, program_));
          const LibraryBlock* block = libraryBlockWith(name, instruction.operands.size() - 1);
          if (block == nullptr || block->name != "MBUS_INIT") continue;
          holding(*block, instruction);
          isKnown = true;
        }
      }
    }
    if (isKnown) return;
    contract_.fillsAnyV = true;
    contract_.memory.push_back({Area::Q, 0, areaSize(program_.target, Area::Q) * 8});
  }

  /// The library's own V memory, where the project says where it lies.
  void placeOwn(const LibraryBlock& block) {
    bool isPlaced = false, isNamed = false;
    for (const LibraryMemory& own : program_.libraryMemory) {
      const bool isThis = !own.block.empty() && libraryBlockNamed(own.block) == libraryBlockNamed(contract_.name);
      if (!own.block.empty() && !isThis) continue;
      contract_.memory.push_back({Area::V, own.first * 8, (own.last + 1 - own.first) * 8});
      isPlaced = true;
      isNamed = isNamed || isThis;
    }
    if (isNamed && block.reach == LibraryReach::Record) contract_.fillsAnyV = false;
    contract_.ownBytes = isPlaced ? 0 : block.ownBytes;
  }

  const Program& program_;
  const Instruction& call_;
  CallContract contract_;
  std::uint32_t longest_ = ~0U;
};

}  // namespace

CallContracts::CallContracts(const Program& program) {
  std::unordered_set<std::int64_t> met, withText;  // numbers of blocks
  for (const Pou& pou : program.pous) {
    if (pou.kind == PouKind::Subroutine && met.insert(pou.number).second && !pou.protectedBlock)
      withText.insert(pou.number);
  }
  const auto hasText = [&](const Instruction& one) {
    return !one.operands.empty() && one.operands[0].kind == OperandKind::Constant &&
           withText.contains(one.operands[0].value);
  };
  std::optional<TouchedBytes> touched;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (hasText(instruction) || !isMissing(instruction, program)) continue;
        CallContract contract = ContractBuilder(program, instruction).take();
        if (!contract.memory.empty() && !touched) touched.emplace(program);
        for (const MemoryRow& row : contract.memory) touched->part(row, contract.touched);
        contracts_.emplace(instruction.id, std::move(contract));
      }
    }
  }
}

}  // namespace rungproof
