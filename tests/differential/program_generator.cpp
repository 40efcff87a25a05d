// Generation of random programs.
#include "tests/differential/program_generator.hpp"

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {

namespace {

Instruction make(std::string_view mnemonic, Operands operands = {}) {
  Instruction instruction;
  instruction.desc = s7200Instructions().named(mnemonic);
  instruction.operands = std::move(operands);
  return instruction;
}

class Generator {
 public:
  Generator(RandomSource& random, const GeneratorOptions& options) : r_(random), options_(options) {}

  RandomProgram run() {
    RandomProgram program;
    program.target = options_.target;
    program.blocks.push_back({});
    if (options_.subroutines) {
      for (int n = 0; n < 2; ++n) program.blocks.push_back(subroutine(n));
    }
    if (options_.interrupts) program.blocks.push_back({PouKind::Interrupt, 0, {}, {}});
    for (RandomProgram::Block& block : program.blocks) {
      out_ = &block.instructions;
      inLocal_ = block.kind == PouKind::Subroutine;
      level_ = block.kind == PouKind::Main ? 0 : block.number + 1;
      labels_ = 0;
      if (options_.interrupts && block.kind == PouKind::Main) attach();
      const int rungs = block.kind == PouKind::Main ? options_.rungs : 1 + static_cast<int>(r_.below(3));
      for (int i = 0; i < rungs; ++i) rung();
    }
    return program;
  }

 private:
  RandomProgram::Block subroutine(int number) {
    RandomProgram::Block block{PouKind::Subroutine, number, {}, {}};
    const auto local = [&](VarSection section, DataType type, Operand address) {
      LocalVariable variable;
      variable.section = section;
      variable.type = type;
      variable.address = std::move(address);
      block.locals.push_back(std::move(variable));
    };
    local(VarSection::Input, DataType::Bool, direct(Area::L, Width::Bit, 0, 0));
    local(VarSection::Input, DataType::Word, direct(Area::L, Width::Word, 2));
    local(VarSection::InOut, DataType::Byte, direct(Area::L, Width::Byte, 4));
    local(VarSection::Output, DataType::Word, direct(Area::L, Width::Word, 6));
    return block;
  }

  void attach() {
    emit("LD", {direct(Area::SM, Width::Bit, 0, 1)});
    static constexpr std::int64_t edges[] = {0, 2, 35, 38};  // the last two on a SMART alone
    emit("ATCH", {constant(0), constant(edges[r_.below(isSmart(options_.target) ? 4 : 2)])});
    emit("ENI");
    if (r_.chance(30)) {
      emit("LD", {bit()});
      emit(r_.chance(50) ? "DISI" : "ENI");
    }
  }

  void emit(std::string_view mnemonic, Operands operands = {}) { out_->push_back(make(mnemonic, std::move(operands))); }

  Operand bit() {
    switch (r_.below(12)) {
      case 0:
      case 1:
      case 2: return direct(Area::I, Width::Bit, inputByte(), r_.below(6));
      case 3:
      case 4: return direct(Area::Q, Width::Bit, 0, r_.below(4));
      case 5:
      case 6: return direct(Area::M, Width::Bit, r_.below(2), r_.below(3));
      case 7: return direct(Area::V, Width::Bit, r_.below(4), r_.below(8));
      case 8: return timer();
      case 9: return direct(Area::C, Width::Bit, r_.below(3));
      case 10: {
        static constexpr std::uint32_t bits[] = {0, 1, 5, 6};
        return r_.chance(60) ? direct(Area::SM, Width::Bit, 0, bits[r_.below(4)])
                             : direct(Area::SM, Width::Bit, 1, r_.below(8));
      }
      default:
        return inLocal_ ? direct(Area::L, Width::Bit, 0, r_.below(3)) : direct(Area::S, Width::Bit, 0, r_.below(3));
    }
  }
  /// On a SMART also bytes of modules, and of PROFINET devices, which have no terminals.
  std::uint32_t inputByte() {
    static constexpr std::uint32_t bytes[] = {0, 7, 20, 130};
    return isSmart(options_.target) ? bytes[r_.below(4)] : 0;
  }
  /// SMB0 to SMB29 of a SMART are read-only.
  Operand written() {
    Operand target = bit();
    while (isSmart(options_.target) && target.area == Area::SM) target = bit();
    return target;
  }
  bool isOnCpu(CpuSet cpus) const { return (cpus & cpuBit(options_.target.cpu)) != 0; }
  Operand timer() {
    static constexpr std::uint32_t numbers[] = {32, 33, 37, 38, 96, 0, 1, 5};
    return direct(Area::T, Width::Bit, numbers[r_.below(8)]);
  }

  Operand memory(Area area, Width width, std::uint32_t limit) {
    const auto size = static_cast<std::uint32_t>(bytes(width));
    return direct(area, width, r_.below(limit - size + 1));
  }

  /// An operand that the descriptor allows, or nothing.
  std::optional<Operand> operand(const OperandDesc& desc) {
    const Width width = widthOf(desc.type);
    switch (desc.type) {
      case Type::Timer: {
        for (int tries = 0; tries < 30; ++tries) {
          Operand t = timer();
          bool isLegal = !desc.hasRanges();
          for (const ValueRange& range : desc.ranges)
            isLegal = isLegal || (range.cpus != 0 && range.low <= t.offset && t.offset <= range.high);
          if (isLegal) return t;
        }
        return std::nullopt;
      }
      case Type::Counter: return direct(Area::C, Width::Bit, r_.below(3));
      case Type::Label:
      case Type::Subroutine:
      case Type::Interrupt:
      case Type::Parameter: return std::nullopt;
      default: break;
    }
    if (desc.type == Type::Bool && (desc.forms & form::V) != 0)
      return desc.direction == Direction::In ? bit() : written();
    for (int tries = 0; tries < 40; ++tries) {
      const std::uint32_t pick = r_.below(20);
      const auto allows = [&](Forms f) { return (desc.forms & f) != 0; };
      if (pick < 5 && allows(form::V)) return width == Width::Bit ? bit() : memory(Area::V, width, 16);
      if (pick < 7 && allows(form::M)) return width == Width::Bit ? bit() : memory(Area::M, width, 4);
      if (pick < 9 && allows(form::AC)) return direct(Area::AC, Width::DWord, r_.below(4));
      if (pick < 13 && allows(form::Const)) return constantOperand(desc, width);
      if (pick == 13 && allows(form::T) && width == Width::Word) return timer();
      if (pick == 14 && allows(form::C) && width == Width::Word) return direct(Area::C, Width::Bit, r_.below(3));
      if (pick == 15 && allows(form::I))
        return width == Width::Bit ? direct(Area::I, width, 0, r_.below(6)) : memory(Area::I, width, 4);
      if (pick == 16 && allows(form::Q))
        return width == Width::Bit ? direct(Area::Q, width, 0, r_.below(4)) : memory(Area::Q, width, 4);
      if (pick == 17 && allows(form::L) && inLocal_ && width != Width::Bit) return memory(Area::L, width, 10);
      if (pick == 18 && allows(form::AI)) return direct(Area::AI, Width::Word, 2 * r_.below(3));
      if (pick == 19 && allows(form::PtrAC) && options_.pointers) {
        Operand pointer = direct(Area::AC, Width::DWord, 1 + r_.below(3));
        pointer.kind = OperandKind::Indirect;
        return pointer;
      }
    }
    return std::nullopt;
  }

  Operand constantOperand(const OperandDesc& desc, Width width) {
    if (desc.hasRanges()) {
      const ValueRange* found = &desc.ranges[0];
      for (const ValueRange& other : desc.ranges) {
        if (isOnCpu(other.cpus) && !isOnCpu(found->cpus)) found = &other;
      }
      const ValueRange& range = *found;
      const std::int64_t span = std::min<std::int64_t>(range.high - range.low + 1, r_.chance(85) ? 9 : 256);
      return constant(range.low + r_.below(static_cast<std::uint32_t>(span)));
    }
    if (desc.type == Type::Real) {
      static constexpr std::int64_t patterns[] = {0x3F800000, 0x40490FDB, 0xC0000000,
                                                  0x00000000, 0x461C4000, 0x4B189680};
      return constant(patterns[r_.below(6)], ConstantForm::Real);
    }
    const std::uint64_t value = r_.value(bits(width));
    if (!isSigned(desc.type)) return constant(static_cast<std::int64_t>(value));
    return constant(static_cast<std::int64_t>(value << (64 - bits(width))) >> (64 - bits(width)),
                    ConstantForm::SignedDecimal);
  }

  bool emitFrom(const Desc& desc) {
    Instruction instruction;
    instruction.desc = &desc;
    for (int i = 0; i < desc.operandCount; ++i) {
      std::optional<Operand> o = operand(desc.operand(i));
      if (!o) return false;
      instruction.operands.push_back(std::move(*o));
    }
    out_->push_back(std::move(instruction));
    return true;
  }

  void contact() {
    static constexpr std::string_view joins[] = {"A", "AN", "O", "ON"};
    switch (r_.below(8)) {
      case 0:
        emit("LD", {bit()});
        emit(r_.chance(50) ? "ALD" : "OLD");
        break;
      case 1: emit(r_.chance(50) ? "EU" : "ED"); break;
      case 2: emit("NOT"); break;
      case 3: compare(); break;
      default: emit(joins[r_.below(4)], {bit()});
    }
  }
  void compare() {
    static constexpr std::string_view compares[] = {"AW>=", "OW<", "AB=", "AD<=", "OW<>", "AR>", "OB>="};
    emitFrom(*s7200Instructions().named(compares[r_.below(7)]));
  }

  void load() { emit(r_.chance(20) ? "LDN" : "LD", {bit()}); }

  void rung() {
    switch (r_.below(20)) {
      case 0:
        if (options_.jumps) return jump();
        break;
      case 1:
        if (options_.loops) return loop();
        break;
      case 2:
      case 3:
        if (options_.subroutines) return call();
        break;
      case 4: return segment();
      case 5:
      case 6: return counter();
      case 7: return pointer();
      default: break;
    }
    load();
    for (std::uint32_t i = r_.below(3); i > 0; --i) contact();
    for (std::uint32_t i = 1 + r_.below(2); i > 0; --i) output();
  }

  void output() {
    if (r_.chance(25)) return emit("=", {written()});
    if (r_.chance(20)) return emit(r_.chance(50) ? "S" : "R", {written(), constant(1 + r_.below(3))});
    if (r_.chance(25)) {
      static constexpr std::string_view timers[] = {"TON", "TOF", "TONR"};
      Instruction instruction = make(timers[r_.below(3)]);
      std::optional<Operand> number = operand(instruction.desc->operand(0));
      if (!number) return;
      instruction.operands = {*number, r_.chance(80) ? constant(r_.below(12)) : memory(Area::V, Width::Word, 16)};
      out_->push_back(std::move(instruction));
      return;
    }
    const std::span<const Desc> table = s7200Instructions().all();
    for (int tries = 0; tries < 20; ++tries) {
      const Desc& desc = table[r_.below(static_cast<std::uint32_t>(table.size()))];
      const bool isPlain =
          desc.control == Control::None && desc.execution != Execution::Stack && desc.execution != Execution::Compare;
      if (isPlain && desc.stl != "STOP" && isOnCpu(desc.cpus) && emitFrom(desc)) return;
    }
  }

  void jump() {
    const int label = labels_++;
    load();
    emit("JMP", {constant(label)});
    rung();
    emit("LBL", {constant(label)});
  }
  void loop() {
    const bool hadJumps = options_.jumps;
    options_.loops = false;
    load();
    emit("FOR", {memory(Area::V, Width::Word, 16), constant(1), constant(1 + r_.below(3))});
    for (std::uint32_t i = 1 + r_.below(2); i > 0; --i) rung();
    emit("NEXT");
    options_.loops = true;
    options_.jumps = hadJumps;
  }
  void call() {
    if (level_ >= 2) return;
    load();
    const int callee = level_ == 0 ? static_cast<int>(r_.below(2)) : level_;
    Operand flag = bit();
    while (flag.area == Area::T || flag.area == Area::C || flag.area == Area::L) flag = bit();
    emit("CALL", {constant(callee), flag, memory(Area::V, Width::Word, 16), memory(Area::M, Width::Byte, 4),
                  memory(Area::V, Width::Word, 16)});
  }
  void segment() {
    if (inSegment_) return;
    inSegment_ = true;
    emit("LSCR", {direct(Area::S, Width::Bit, 0, r_.below(3))});
    for (std::uint32_t i = 1 + r_.below(2); i > 0; --i) rung();
    if (r_.chance(60)) {
      load();
      emit("SCRT", {direct(Area::S, Width::Bit, 0, r_.below(3))});
    }
    emit("SCRE");
    inSegment_ = false;
  }
  void counter() {
    static constexpr std::string_view counters[] = {"CTU", "CTD", "CTUD"};
    const std::uint32_t which = r_.below(3);
    for (std::uint32_t i = which == 2 ? 3 : 2; i > 0; --i) load();
    emit(counters[which], {direct(Area::C, Width::Bit, r_.below(3)), constant(r_.below(5))});
  }
  void pointer() {
    if (!options_.pointers) return load();
    Operand address = direct(Area::V, Width::Byte, r_.below(12));
    address.kind = OperandKind::Address;
    Operand cell = r_.chance(50) ? direct(Area::AC, Width::DWord, 1 + r_.below(3)) : direct(Area::V, Width::DWord, 20);
    emit("LD", {r_.chance(50) ? direct(Area::SM, Width::Bit, 0, 0) : bit()});
    emit("MOVD", {address, cell});
    if (r_.chance(60)) emit("INCD", {cell});
    Operand target = cell;
    target.kind = OperandKind::Indirect;
    if (r_.chance(50))
      emit("MOVB", {target, memory(Area::V, Width::Byte, 16)});
    else
      emit("MOVW", {memory(Area::V, Width::Word, 16), target});
  }

  RandomSource& r_;
  GeneratorOptions options_;
  std::vector<Instruction>* out_ = nullptr;
  bool inLocal_ = false;
  bool inSegment_ = false;
  int level_ = 0;
  int labels_ = 0;
};

}  // namespace

Program RandomProgram::program() const {
  Program result;
  result.target = target;
  for (const Block& block : blocks) {
    Pou pou;
    pou.kind = block.kind;
    pou.number = block.number;
    pou.locals = block.locals;
    pou.networks.push_back({});
    pou.networks[0].instructions = block.instructions;
    result.pous.push_back(std::move(pou));
  }
  result.number();
  return result;
}

std::string RandomProgram::text() const {
  std::string text;
  for (const Block& block : blocks) {
    if (block.instructions.empty()) continue;
    text += block.kind == PouKind::Main
                ? "MAIN\n"
                : (block.kind == PouKind::Subroutine ? "SBR " : "INT ") + std::to_string(block.number) + "\n";
    for (const Instruction& instruction : block.instructions) {
      text += "  " + std::string(instruction.desc->stl);
      for (std::size_t i = 0; i < instruction.operands.size(); ++i)
        text += (i == 0 ? " " : ", ") + toString(instruction.operands[i]);
      text += "\n";
    }
  }
  return text;
}

std::size_t RandomProgram::size() const {
  std::size_t count = 0;
  for (const Block& block : blocks) count += block.instructions.size();
  return count;
}

RandomProgram RandomProgram::without(std::size_t index) const {
  RandomProgram copy = *this;
  for (Block& block : copy.blocks) {
    if (index < block.instructions.size()) {
      block.instructions.erase(block.instructions.begin() + static_cast<std::ptrdiff_t>(index));
      return copy;
    }
    index -= block.instructions.size();
  }
  return copy;
}

RandomProgram randomProgram(RandomSource& random, const GeneratorOptions& options) {
  return Generator(random, options).run();
}

}  // namespace rungproof
