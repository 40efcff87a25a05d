// What moves the flow of an S7-300/400 program: organization blocks, jumps, calls (002:145-247, 002:2790-2824).
// An FC takes its parameters by reference; an FB works on its instance, into which the call copies what it is given and
// from which it copies what it hands out (002:154-169, 002:255). The return gives back DB and DI register (002:222);
// accumulators, AR1 and the RLO stay as the block left them; of AR2, CALL of an FB takes care (general knowledge).
// Members of Scan (ir/machine/scan.hpp).
#pragma once

#include <algorithm>
#include <utility>

#include "ir/machine/scan.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/handed_pointer.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/timer.hpp"

namespace rungproof {

inline constexpr int warmRestart = 100;  ///< OB100 (002:1373)

/// An organization block, where `condition` holds: nothing of the registers outlives it, and what they hold at its
/// start is any value.
template <class D, class Hooks>
void Scan<D, Hooks>::organizationBlock(int number, Bool condition) {
  const Flow* flow = m_.plan.block(blockNumber(BlockType::Ob, number));
  if (flow == nullptr) return;
  m_.when(condition, [&] {
    const Step7Registers<D> saved = m_.step7;
    Step7Registers<D>& s = m_.step7;
    s = Step7Registers<D>(m_.d);
    std::uint32_t index = 0;
    const auto any = [&](int width) { return m_.external(External::RegisterAtStart, index++, width); };
    for (Bool* bit : {&s.br, &s.cc1, &s.cc0, &s.ov, &s.os, &s.orBit, &s.sta, &s.rlo}) *bit = m_.d.bit(any(1), 0);
    for (std::size_t i = 0; i < s.accu.size(); ++i) s.accu[i] = any(32);
    for (Bits& ar : s.ar) ar = any(32);
    s.db = any(16);
    s.di = any(16);
    Activation<D> activation;
    activation.pou = flow->pou;
    activation.localBase = saved.running == nullptr ? 0 : saved.running->localBase + saved.running->pou->localBytes;
    activation.callerDb = activation.callerDi = m_.d.literal(0, 16);
    activation.callerAr2 = m_.d.literal(0, 32);
    s.running = &activation;
    s.isErrorBlock = number == numberOfBlock(errorBlock) || number == numberOfBlock(accessErrorBlock);
    const bool handlesError = s.isErrorBlock;
    if (handlesError) s.delays = saved.delays;  // the priority class is that of the block with the error
    freshBytes(activation.localBase, flow->pou->localBytes);
    startInformation(activation.localBase, number, saved);
    this->withOwnRegisters([&] { walk(*flow); });
    const Step7Registers<D> after = s;
    m_.step7 = saved;
    m_.guard = m_.d.land(m_.guard, m_.d.lnot(m_.halted));
    if (handlesError) {
      m_.put(m_.step7.accu[0], m_.d.select(after.isReplaced, after.replacement, saved.accu[0], 32), 32);
      m_.put(m_.step7.delays, after.delays, 8);
    } else {  // what the block has delayed comes now
      m_.when(m_.d.lnot(m_.d.equal(after.delays, m_.d.literal(0, 8), 8)),
              [&] { m_.setBit(Reg::InterruptsEnabled, 0, m_.d.equal(saved.delays, m_.d.literal(0, 8), 8)); });
    }
  });
}

/// An organization block that interrupts another one, or comes behind OB1: that one goes on as if nothing had been,
/// but for what it finds in memory.
template <class D, class Hooks>
void Scan<D, Hooks>::interruptBlock(int number, Bool condition) {
  const Instruction* current = m_.current;
  const bool isNested = std::exchange(m_.inInterrupt, true);
  organizationBlock(number, condition);
  m_.inInterrupt = isNested;
  m_.current = current;
}

/// OB121 where the instruction has met a synchronous error, OB122 where a module has not answered it; the program goes
/// on behind them (002:1278-1292). What such an instruction leaves in the accumulators is not stated.
template <class D, class Hooks>
void Scan<D, Hooks>::serveError() {
  const Bool failed = m_.step7.failed;
  if (const auto known = m_.d.truth(failed); known && !*known) return;
  m_.step7.failed = m_.d.constant(false);
  if constexpr (requires { m_.d.leave(failed); }) {
    m_.step7.syncError = m_.step7.accessError = m_.d.constant(false);
    return m_.d.leave(failed);
  }
  m_.when(failed, [&] {
    for (std::uint32_t i = 0; i < 2; ++i) {
      constexpr std::uint32_t firstIndex = 0x306;  // beside what instructions leave open
      const Bool changes = m_.externalBit(External::UnknownResult, firstIndex + 2 * i);
      const Bits any = m_.external(External::UnknownResult, firstIndex + 2 * i + 1, 32);
      m_.put(m_.step7.accu[i], m_.d.select(changes, any, m_.step7.accu[i], 32), 32);
    }
  });
  const auto serve = [&](Bool& due, int block) {
    if (const auto known = m_.d.truth(due); known && !*known) return;
    const Bool isDue = std::exchange(due, m_.d.constant(false));
    const Instruction* current = m_.current;
    organizationBlock(numberOfBlock(block), isDue);
    m_.current = current;
  };
  serve(m_.step7.syncError, errorBlock);
  m_.step7.fault = m_.d.literal(0, 8);
  serve(m_.step7.accessError, accessErrorBlock);
}

/// Of its 20 bytes (002:2000-2015) the number is known; of OB1 event class, kind of scan and priority; of OB100 that
/// the start is a manual or an automatic one (002:1377); of OB20 to OB23 SIGN (002:1210); of OB121 the error (general
/// knowledge). All others stay any value: classes of other events stand nowhere in the manual, OB121 has the priority
/// of the block that it interrupts (002:1282), and not every CPU says where the error was.
template <class D, class Hooks>
void Scan<D, Hooks>::startInformation(std::uint32_t base, int number, const Step7Registers<D>& interrupted) {
  const auto save = [&](std::uint32_t byte, Bits value, int width = 8) {
    m_.store.save(Area::L, (base + byte) * 8, width, value, m_.guard);
  };
  save(3, m_.d.literal(static_cast<std::uint64_t>(number), 8));
  if (number == 1) {
    const std::uint64_t first = m_.plan.program->coldStart ? 4 : 1;
    save(0, m_.d.literal(0x11, 8));
    save(1, m_.d.select(m_.getBit(Reg::FirstScan), m_.d.literal(first, 8), m_.d.literal(3, 8), 8));
    save(2, m_.d.literal(1, 8));
  }
  if (number == warmRestart) {
    const Bits given = m_.store.load(Area::L, (base + 1) * 8, 8), automatic = m_.d.literal(0x82, 8);
    save(1, m_.d.select(m_.d.equal(given, automatic, 8), automatic, m_.d.literal(0x81, 8), 8));
  }
  if (isDelayEvent(eventOfBlock(number)))
    save(6, m_.get(Reg::DelaySign, static_cast<std::uint32_t>(number - firstDelayBlock)), 16);
  if (number != numberOfBlock(errorBlock)) return;
  const Bits fault = interrupted.fault;
  const auto is = [&](std::uint64_t code) { return m_.d.equal(fault, m_.d.literal(code, 8), 8); };
  constexpr std::uint32_t index = 0x303;  // reading or writing
  const Bool isPair = m_.d.lor(is(0x22), is(0x30));
  const Bool second = m_.d.land(isPair, m_.externalBit(External::UnknownResult, index));
  m_.when(m_.d.lnot(is(0)), [&] { save(1, m_.d.bor(fault, m_.d.fromBool(second, 8), 8)); });
}

template <class D, class Hooks>
void Scan<D, Hooks>::freshBytes(std::uint32_t base, std::uint32_t count) {
  if constexpr (requires { hooks_.freshBytes(*this, base, count); }) {
    hooks_.freshBytes(*this, base, count);
  } else {
    for (std::uint32_t byte = 0; byte < count; ++byte) hooks_.freshLocal(*this, base, byte);
  }
}

/// The start-up block sees cleared images and runs once before the first scan (002:1367-1375).
template <class D, class Hooks>
void Scan<D, Hooks>::step7Program() {
  m_.isStartUp = true;
  organizationBlock(m_.plan.program->coldStart ? 102 : 100, m_.getBit(Reg::FirstScan));
  m_.isStartUp = false;
  organizationBlock(1, m_.d.constant(true));
}

template <class D, class Hooks>
void Scan<D, Hooks>::step7Control(Walk& w, std::uint32_t at) {
  const FlowStep& step = w.flow.steps[at];
  const Instruction& instruction = *step.instruction;
  Step7Registers<D>& s = m_.step7;
  dispatch_[instruction.desc->opcode](m_, instruction);
  switch (instruction.desc->control) {
    case Control::Branch:
      if (step.partner != noPartner) branch(w, s.jumps, step.partner);
      break;
    case Control::Distributor: distribute(w, at); break;
    case Control::BlockEnd: branch(w, s.jumps, static_cast<std::uint32_t>(w.flow.steps.size())); break;
    case Control::BlockCall: inside(s.jumps, [&] { step7Call(instruction); }); break;
    default: break;
  }
}

/// JL: the unconditional jumps that follow it are the list.
template <class D, class Hooks>
void Scan<D, Hooks>::distribute(Walk& w, std::uint32_t at) {
  const auto isEntry = [&](std::uint32_t i) {
    return i < w.flow.steps.size() && w.flow.steps[i].instruction->desc->execution == Execution::Control;
  };
  const Bits chosen = m_.d.extract(m_.step7.accu[0], 7, 0);
  Bool inList = m_.d.constant(false);
  for (std::uint32_t k = 0; k < 255 && isEntry(at + 1 + k); ++k) {
    const Bool isThis = m_.d.equal(chosen, m_.d.literal(k, 8), 8);
    inList = m_.d.lor(inList, isThis);
    branch(w, isThis, at + 1 + k);
  }
  const std::uint32_t beyond = w.flow.steps[at].partner;
  if (beyond != noPartner) branch(w, m_.d.lnot(inList), beyond);
}

template <class D, class Hooks>
void Scan<D, Hooks>::step7Call(const Instruction& instruction) {
  const Operand& block = instruction.operands[0];
  if (block.kind == OperandKind::Constant) {
    const Flow* callee = m_.plan.block(static_cast<int>(block.value));
    const BlockType type = blockTypeOf(static_cast<int>(block.value));
    const bool isSystem = type == BlockType::Sfc || type == BlockType::Sfb;
    const s7300::LibraryBlock* row =
        isSystem ? s7300::libraryBlock(type, static_cast<std::uint32_t>(numberOfBlock(static_cast<int>(block.value))))
                 : nullptr;
    if (row != nullptr && row->actsOnCpu) actOnCpu(m_, instruction);
    if (row != nullptr && row->stopsCpu) return m_.stop(Hazard::S7Stop, m_.d.constant(true));
    if (callee == nullptr && !isSystem) return m_.error(Hazard::S7BlockMissing, m_.d.constant(true));
    if (callee == nullptr || callee->pou->protectedBlock) return hooks_.callWithoutBody(*this, instruction);
    return enterBlock(*callee, instruction);
  }
  const BlockType type = typeOfComputedCall(block.value);
  const Bits number = Step7Places<D>(m_).blockNumberOf(block);
  Bool exists = m_.d.constant(false);
  const Bool guard = m_.guard;
  for (const Flow& flow : m_.plan.flows) {
    if (flow.pou->type != type) continue;
    const Bool isThis =
        m_.d.equal(number, m_.d.literal(static_cast<std::uint64_t>(numberOfBlock(flow.pou->number)), 16), 16);
    exists = m_.d.lor(exists, isThis);
    inside(isThis, [&] { enterBlock(flow, instruction); });
  }
  m_.guard = m_.d.land(guard, m_.d.lnot(m_.halted));
  m_.error(Hazard::S7BlockMissing, m_.d.lnot(exists));
}

/// Parameters that are handed over as values: those of an FB, except numbers of timers, counters and blocks and whole
/// structures that are read and written in place, and except pointers.
inline bool isCopied(const LocalVariable& parameter) {
  return parameter.address.reach != nullptr && parameter.address.reach->way == Way::Instance &&
         !isPointerType(parameter.type);
}

/// An output of an FC that the block does not write keeps its value or gets any (Choice::UnwrittenOutput).
template <class D, class Hooks>
void Scan<D, Hooks>::forgetOutput(const LocalVariable& formal, const Operand& actual, std::uint32_t number) {
  constexpr std::uint32_t firstIndex = 0x400;  // beside what instructions leave open
  const bool isPlace = actual.kind == OperandKind::Direct || actual.kind == OperandKind::Indirect;
  if (formal.section != VarSection::Output || formal.size > 4 || takesPointer(formal) || !isPlace) return;
  const Width width = formal.size == 0   ? Width::Bit
                      : formal.size == 1 ? Width::Byte
                      : formal.size == 2 ? Width::Word
                                         : Width::DWord;
  m_.when(m_.reads({Choice::UnwrittenOutput, "any"}), [&] {
    Step7Places<D> places(m_);
    const Bits db = m_.step7.db;
    const Spot<D> spot = places.find(actual, width);
    places.save(spot, width, m_.external(External::UnknownResult, firstIndex + number, bits(width)));
    m_.step7.db = db;
  });
}

/// Numbers of what openActuals() leaves open, beside what instructions leave open.
inline constexpr std::uint32_t openBehindCall = 0x100, openAtEntry = 0x300;

template <class D, class Hooks>
void Scan<D, Hooks>::enterBlock(const Flow& callee, const Instruction& instruction) {
  Step7Registers<D>& s = m_.step7;
  Step7Places<D> places(m_);
  const Pou& pou = *callee.pou;
  const Activation<D>* caller = s.running;
  const int level = caller->level + 1;
  if (level > step7Row(m_.target.cpu).nesting) return m_.stop(Hazard::S7Nesting, m_.d.constant(true));

  Activation<D> activation{&pou,  &instruction, caller, caller->localBase + caller->pou->localBytes,
                           level, s.db,         s.di,   s.ar[1]};
  const bool isFb = hasInstance(pou) && instruction.operands.size() > 1;
  const std::size_t first = isFb ? 2 : 1;
  std::vector<const LocalVariable*> parameters;
  for (const LocalVariable& local : pou.locals) {
    if (isParameter(local)) parameters.push_back(&local);
  }
  const auto given = [&](std::size_t i) -> const Operand* {
    if (first + i >= instruction.operands.size()) return nullptr;
    const Operand& operand = instruction.operands[first + i];
    return operand.kind == OperandKind::Missing ? nullptr : &operand;
  };
  const auto widthAt = [](const LocalVariable& local, std::uint32_t byte) {
    if (local.size == 0) return Width::Bit;
    const std::uint32_t left = local.size - byte;
    return left >= 4 ? Width::DWord : left >= 2 ? Width::Word : Width::Byte;
  };
  /// Calls visit(actual, formal, width) for the pieces of every parameter of the sections that is copied.
  const auto eachPiece = [&](VarSection section, auto&& visit) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const LocalVariable& formal = *parameters[i];
      const bool isWanted = formal.section == section || formal.section == VarSection::InOut;
      if (!isWanted || !isCopied(formal) || given(i) == nullptr) continue;
      std::uint32_t byte = 0;
      do {
        const Width width = widthAt(formal, byte);
        Operand actual = *given(i), place = formal.address;
        if (actual.kind != OperandKind::Constant) actual.offset += byte;
        place.offset += byte;
        visit(actual, place, width);
        byte += static_cast<std::uint32_t>(bytes(width));
      } while (byte < formal.size);
    }
  };

  if (!hasInstance(pou) && !pou.isBuiltIn) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const auto number = static_cast<std::size_t>(parameters[i] - pou.locals.data());
      if (given(i) != nullptr && !callee.writtenParameters[number])
        forgetOutput(*parameters[i], *given(i), static_cast<std::uint32_t>(i));
    }
  }
  const std::vector<std::pair<std::uint32_t, HandedPointer<D>>> pointers = pointersOf(instruction, pou, first);
  std::vector<Bits> values;
  Bits instanceBlock = s.di, instancePointer = s.ar[1];
  if (isFb) {
    eachPiece(VarSection::Input, [&](const Operand& actual, const Operand&, Width width) {
      values.push_back(places.load(places.find(actual, width), width));
      serveError();  // each of them is a statement of its own
    });
    const Operand& instance = instruction.operands[1];
    if (instance.kind == OperandKind::Direct) {
      instanceBlock = m_.d.literal(blockOfByte(instance.offset), 16);
      // The compiled call loads P#DBX 0.0 into AR2, although the FB reaches its data through DI.
      instancePointer = m_.d.literal(0x84000000U | byteInBlock(instance.offset) * 8, 32);
    } else {
      instanceBlock = s.di;
      instancePointer = m_.d.add(s.ar[1], m_.d.literal(instance.offset * 8, 32), 32);
    }
  }
  const auto useInstance = [&] {
    m_.put(s.di, instanceBlock, 16);
    m_.put(s.ar[1], instancePointer, 32);
  };
  const auto save = [&](const Operand& place, Width width, Bits value) {
    places.save(places.find(place, width), width, width == Width::Bit ? m_.d.extract(value, 0, 0) : value);
    serveError();
  };
  const auto inDb = [&](Bits exchanged) {
    return m_.d.select(m_.reads({Choice::CallDataBlock, "exchanged"}), exchanged, activation.callerDb, 16);
  };
  if (isFb) {
    useInstance();
    std::size_t next = 0;
    eachPiece(VarSection::Input,
              [&](const Operand&, const Operand& place, Width width) { save(place, width, values[next++]); });
    m_.put(s.db, inDb(activation.callerDi), 16);
  } else if (!pou.isBuiltIn) {
    openActuals(instruction, openAtEntry);
  }
  const auto mcrActive = s.mcrActive;
  const auto mcr = s.mcr;
  m_.put(s.mcrActive, m_.d.constant(false));
  for (Bool& level7 : s.mcr) m_.put(level7, m_.d.constant(true));
  freshBytes(activation.localBase, pou.localBytes);
  if (isIecTimer(pou.number)) {
    const Bits passed = m_.d.zext(passedBefore(m_), restBits, 32);
    m_.store.save(Area::L, activation.localBase * 8, 32, passed, m_.guard);
  }
  const Instruction* current = m_.current;
  s.running = &activation;
  for (const auto& [parameter, pointer] : pointers) places.saveHanded(pointer, parameter);
  if (pou.isBuiltIn)
    systemBlock(instruction);
  else
    walk(callee);
  s.running = caller;
  m_.current = current;

  m_.put(s.os, m_.d.constant(false));
  m_.put(s.orBit, m_.d.constant(false));
  m_.put(s.sta, m_.d.constant(true));
  m_.put(s.firstCheck, m_.d.constant(false));
  m_.put(s.mcrActive, mcrActive);
  for (std::size_t i = 0; i < mcr.size(); ++i) m_.put(s.mcr[i], mcr[i]);
  values.clear();
  if (isFb) {
    useInstance();
    eachPiece(VarSection::Output, [&](const Operand&, const Operand& place, Width width) {
      values.push_back(places.load(places.find(place, width), width));
    });
    m_.put(s.ar[1], activation.callerAr2, 32);
  } else if (hasInstance(*caller->pou) && instruction.desc->stl == "CALL") {
    const Bool isGivenBack = m_.reads({Choice::CallAddressRegister, "given-back"});
    m_.put(s.ar[1], m_.d.select(isGivenBack, activation.callerAr2, s.ar[1], 32), 32);
  }
  m_.put(s.db, activation.callerDb, 16);
  m_.put(s.di, activation.callerDi, 16);
  std::size_t next = 0;
  if (isFb)
    eachPiece(VarSection::Output,
              [&](const Operand& actual, const Operand&, Width width) { save(actual, width, values[next++]); });
  m_.put(s.db, isFb ? inDb(instanceBlock) : activation.callerDb, 16);
  openActuals(instruction, openBehindCall);
}

/// A block whose meaning is no list of statements. Where organization blocks interrupt it, they come as they come in
/// front of its call.
template <class D, class Hooks>
void Scan<D, Hooks>::systemBlock(const Instruction& call) {
  const FlowStep step{&call, noPartner, 0};
  std::function<void()> between;
  const bool isInterrupted = std::ranges::any_of(m_.plan.flows, [](const Flow& flow) {
    return flow.pou->type == BlockType::Ob && eventOfBlock(numberOfBlock(flow.pou->number)) >= 0;
  });
  if (isInterrupted) between = [this, step] { hooks_.before(*this, step); };
  runSystemBlock(m_, between);
}

/// The pointers that the call hands over, by the number of the parameter. The statements that make them work in
/// accumulators and AR1: what these hold when the block begins is any value (general knowledge).
template <class D, class Hooks>
std::vector<std::pair<std::uint32_t, HandedPointer<D>>> Scan<D, Hooks>::pointersOf(const Instruction& call,
                                                                                   const Pou& callee,
                                                                                   std::size_t firstActual) {
  std::vector<std::pair<std::uint32_t, HandedPointer<D>>> pointers;
  if (!callee.takesPointers) return pointers;
  Step7Places<D> places(m_);
  for (std::uint32_t i = 0; i < callee.locals.size() && isParameter(callee.locals[i]); ++i) {
    const LocalVariable& formal = callee.locals[i];
    if (firstActual + i >= call.operands.size()) break;
    const OperandKind kind = call.operands[firstActual + i].kind;
    const bool isGiven = kind != OperandKind::Missing && kind != OperandKind::Constant;
    if (isGiven && takesPointer(formal))
      pointers.emplace_back(i, places.handed(call.operands[firstActual + i], formal.type, i));
  }
  if (pointers.empty()) return pointers;
  constexpr std::uint32_t firstIndex = 0x200;  // beside what instructions leave open
  std::uint32_t index = firstIndex;
  for (Bits* bits : {&m_.step7.accu[0], &m_.step7.accu[1], &m_.step7.ar[0]})
    m_.put(*bits, m_.external(External::UnknownResult, index++, 32), 32);
  return pointers;
}

/// Whether the statements that hand over `DB50.DBD22` leave that block open in the called FC and in the caller is not
/// stated (general knowledge: neither must rely on its DB register): either. `firstIndex` tells the two apart.
template <class D, class Hooks>
void Scan<D, Hooks>::openActuals(const Instruction& call, std::uint32_t firstIndex) {
  for (std::size_t i = 1; i < call.operands.size(); ++i) {
    const Operand& actual = call.operands[i];
    const bool isInstance = i == 1 && blockTypeOf(static_cast<int>(call.operands[0].value)) != BlockType::Fc;
    if (actual.kind != OperandKind::Direct || actual.area != Area::DB || isInstance) continue;
    const Bits opened = m_.external(External::UnknownResult, firstIndex + static_cast<std::uint32_t>(i), 1);
    m_.when(m_.d.bit(opened, 0), [&] { m_.put(m_.step7.db, m_.d.literal(blockOfByte(actual.offset), 16), 16); });
  }
}

}  // namespace rungproof
