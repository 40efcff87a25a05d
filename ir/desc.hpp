// What a descriptor of an instruction says: spelling, operands, stack effect, class of execution.
// One constexpr Desc stands in each instruction's struct in ir/s7200/isa/*.hpp; names, look-ups, operand checks,
// printing, completion and dispatch derive from it. The table is compared row by row with
// tests/data/*.tsv by tests/ir/isa_table_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "ir/area.hpp"
#include "ir/operand.hpp"
#include "ir/role.hpp"
#include "ir/target.hpp"

namespace rungproof {

/// Data type of an operand as the manual's operand tables name it, plus the kinds of number.
enum class Type : std::uint8_t {
  Bool,
  Byte,
  Word,
  Int,
  DWord,
  DInt,
  Real,
  String,
  Timer,
  Counter,  ///< a T or C number; word access is its current value
  Label,
  Subroutine,
  Interrupt,  ///< numbers of LBL, SBR, INT
  Parameter,  ///< an actual parameter of CALL: its type comes from the called block
  Block,      ///< S7-300/400: FC, FB, SFC, SFB (ir/s7300/block.hpp), DB
  Value       ///< S7-300/400: byte, word or double word as the operand is written
};

enum class Direction : std::uint8_t { In, Out, InOut };

/// Areas and forms an operand may take; the width follows from its type.
using Forms = std::uint32_t;
namespace form {
constexpr Forms area(Area a) { return 1U << static_cast<unsigned>(a); }
inline constexpr Forms I = area(Area::I), Q = area(Area::Q), AI = area(Area::AI), AQ = area(Area::AQ),
                       V = area(Area::V), M = area(Area::M), S = area(Area::S), SM = area(Area::SM), L = area(Area::L),
                       T = area(Area::T), C = area(Area::C), AC = area(Area::AC), HC = area(Area::HC);
inline constexpr Forms PtrV = 1U << 16, PtrL = 1U << 17, PtrAC = 1U << 18;  ///< *VD, *LD, *AC (AC1-AC3, 001:1459)
inline constexpr Forms Const = 1U << 19;
inline constexpr Forms Address = 1U << 20;  ///< &VB and the like (001:5619)
inline constexpr Forms Pointers = PtrV | PtrL | PtrAC;
/// Bit operands of contacts and coils (001:2750, 001:2811).
inline constexpr Forms bitAny = I | Q | V | M | SM | S | T | C | L;
/// Byte, word and double word destinations and sources of chapter 6.
inline constexpr Forms byteOut = I | Q | V | M | SM | S | L | AC | Pointers;
inline constexpr Forms byteIn = byteOut | Const;
inline constexpr Forms wordOut = byteOut | T | C;
inline constexpr Forms wordIn = wordOut | AI | Const;
inline constexpr Forms dwordOut = byteOut;
inline constexpr Forms dwordIn = dwordOut | HC | Const;
inline constexpr Forms realIn = dwordOut | Const;
/// Buffers and strings that start at a byte: no accumulator.
inline constexpr Forms byteBuffer = I | Q | V | M | SM | S | L | Pointers;
inline constexpr Forms stringOut = V | L | Pointers;
inline constexpr Forms stringIn = stringOut | Const;
}  // namespace form

/// Permitted values of a constant on some CPUs; an operand may have several ranges.
struct ValueRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
  CpuSet cpus = everyCpu;
};

/// Number of elements of a buffer that starts at the operand: 1, 1 = a plain operand; 0 high = given at run time.
struct BufferLength {
  int low = 1;
  int high = 1;
};

/// Another operand that counts the elements: N of S, BMB, SHRB. Its range tells whether it is signed; then its amount
/// counts. `divisor`: how many of N share one element (two hexadecimal digits a byte).
struct CountOperand {
  std::int8_t operand = -1;
  std::uint8_t limit = 0;  ///< the most that takes effect
  std::uint8_t divisor = 1;
};

struct OperandDesc {
  std::string_view name;
  Direction direction = Direction::In;
  Type type = Type::Bool;
  Forms forms = 0;
  std::array<ValueRange, 6> ranges{};  ///< unused rows have cpus == 0
  BufferLength buffer{};
  CountOperand count{};      ///< operand < 0: nothing counts them
  bool lowWordRead = false;  ///< a double word of which only the low word is read (MUL, DIV)
  bool optional = false;

  constexpr bool hasRanges() const { return ranges[0].cpus != 0; }
  constexpr OperandDesc within(std::initializer_list<ValueRange> list) const {
    OperandDesc copy = *this;
    std::size_t i = 0;
    for (const ValueRange& range : list) copy.ranges[i++] = range;
    return copy;
  }
  constexpr OperandDesc elements(int low, int high) const {
    OperandDesc copy = *this;
    copy.buffer = {low, high};
    return copy;
  }
  constexpr OperandDesc counted(int by, int limit, int divisor = 1) const {
    OperandDesc copy = *this;
    copy.count = {static_cast<std::int8_t>(by), static_cast<std::uint8_t>(limit), static_cast<std::uint8_t>(divisor)};
    return copy;
  }
};

constexpr OperandDesc operandDesc(std::string_view name, Direction direction, Type type, Forms forms) {
  OperandDesc desc;
  desc.name = name;
  desc.direction = direction;
  desc.type = type;
  desc.forms = forms;
  for (ValueRange& range : desc.ranges) range.cpus = 0;
  return desc;
}
constexpr OperandDesc in(std::string_view name, Type type, Forms forms) {
  return operandDesc(name, Direction::In, type, forms);
}
constexpr OperandDesc out(std::string_view name, Type type, Forms forms) {
  return operandDesc(name, Direction::Out, type, forms);
}
constexpr OperandDesc inout(std::string_view name, Type type, Forms forms) {
  return operandDesc(name, Direction::InOut, type, forms);
}

constexpr OperandDesc optional(OperandDesc desc) {
  desc.optional = true;
  return desc;
}

constexpr OperandDesc lowWordRead(OperandDesc desc) {
  desc.lowWordRead = true;
  return desc;
}

/// When an instruction runs and what it does with the top of the stack.
enum class Execution : std::uint8_t {
  Stack,        ///< always executed, reads or writes the logic stack
  Compare,      ///< always executed even without power flow; errors are fatal (001:3384-3391)
  Coil,         ///< always executed; copies the top to a bit
  Conditional,  ///< executed only with power flow (001:2274); otherwise nothing changes
  Sampled,      ///< always executed; takes stack levels as data (timers, counters, PID)
  Control,      ///< moves the flow of the program; its meaning is in ir/machine/scan.hpp
  Always        ///< S7-300/400: runs whatever the RLO is
};

/// Which control instruction, for ir/flow.hpp, ir/machine/scan.hpp and ir/s7300/control.hpp.
enum class Control : std::uint8_t {
  None,
  Jump,
  LabelMark,
  For,
  Next,
  Call,
  ReturnConditional,
  Return,
  InterruptReturnConditional,
  InterruptReturn,
  End,
  MainEnd,
  Stop,
  Lscr,
  Scrt,
  ScrEndConditional,
  ScrEnd,
  SubroutineHead,
  InterruptHead,
  Branch,       ///< S7-300/400: jumps where the meaning says so; LOOP too
  Distributor,  ///< JL
  BlockEnd,     ///< BE, BEU, BEC
  BlockCall     ///< CALL, UC, CC
};

/// Stack effect for depth analysis: levels it needs filled, levels popped, levels pushed.
struct StackEffect {
  std::uint8_t needs = 0;
  std::uint8_t pops = 0;
  std::uint8_t pushes = 0;
};

/// Special-memory status bits SM1.0-SM1.7 that an instruction may change, one bit each (001:14063-14073).
using StatusBits = std::uint8_t;
namespace status {
inline constexpr StatusBits Zero = 1, Overflow = 2, Negative = 4, DivideByZero = 8, TableFull = 16, TableEmpty = 32,
                            NotBcd = 64, NotAscii = 128;
}

/// What the model has of an instruction. Networks with others than Whole are left out, and nothing is proved that may
/// depend on what they write.
enum class Modelling : std::uint8_t {
  Whole,
  WritesOperands,  ///< what is written, now or later, lies at its operands
  WritesAnything   ///< a pointer in its table names a buffer
};

inline constexpr int maxOperands = 6;  ///< S_ITR has most

using FlowPins = std::array<std::string_view, 4>;

struct Desc {
  std::string_view stl;           ///< international mnemonic, "LDW>="
  std::string_view german = {};   ///< SIMATIC German mnemonic where it differs, "UW>="
  std::string_view family = {};   ///< "LDWx" for comparison families; empty: the mnemonic itself
  std::string_view meaning = {};  ///< a few words for explain, xref and completion
  std::string_view group = {};    ///< manual section, "boolean", "timers and counters"
  Role role = Role::Other;
  bool negated = false;    ///< a contact that is closed by a 0
  bool immediate = false;  ///< reads or writes the physical point at that moment (001:2731, 001:2781)
  Relation relation = Relation::None;
  std::string_view drawn = {};  ///< name of its box or sign of its contact or coil; empty: the mnemonic
  FlowPins flowPins = {"EN"};   ///< names of the power inputs of its box, topmost first
  std::array<OperandDesc, maxOperands> operands{};
  std::uint8_t operandCount = 0;
  Execution execution = Execution::Conditional;
  StackEffect stack{};
  bool eno = false;        ///< sets the ENO bit (001:2276-2278)
  StatusBits affects = 0;  ///< SM1.x bits it may change
  Control control = Control::None;
  CpuSet cpus = everyCpu;
  bool since2004 = false;  ///< absent from the 2003 edition (001:130)
  bool since28 = false;    ///< S7-200 SMART: needs firmware V2.8
  Modelling modelling = Modelling::Whole;
  bool olderDialectOnly = false;  ///< RET, RETI, MEND: written only in the one-text dialect
  bool drawingOnly = false;       ///< SR, RS and the IEC boxes: exist in LAD/FBD only, named so in the IR
  bool notInInterrupt = false;    ///< 001:5426, 001:3353
  std::uint32_t time = 0;  ///< execution time with power flow in 0.01 us (Appendix F), 0 unknown; where it depends
                           ///< on operands: inputs, local points, constant count, without elements; typical value
  std::string_view manual = {};  ///< "001:4814"
  std::uint16_t opcode = 0;      ///< position in the joined table, set by makeTable

  constexpr const OperandDesc& operand(int i) const { return operands[static_cast<std::size_t>(i)]; }
  constexpr std::string_view familyName() const { return family.empty() ? stl : family; }
  constexpr std::string_view drawnName() const { return drawn.empty() ? stl : drawn; }
};

constexpr Desc withOperands(Desc desc, std::initializer_list<OperandDesc> list) {
  for (const OperandDesc& operand : list) desc.operands[desc.operandCount++] = operand;
  return desc;
}

/// A move of values of that type: MOVW for Type::Word.
constexpr bool isMoveOf(const Desc& desc, Type type) {
  return desc.role == Role::Move && desc.operands[0].type == type;
}
/// = , which reaches the image only.
constexpr bool isPlainCoil(const Desc& desc) { return desc.role == Role::Assign && !desc.immediate; }
/// A contact of the image or of memory that is closed by a 0: LDN, not LDNI.
constexpr bool invertsImage(const Desc& desc) { return desc.negated && !desc.immediate; }

/// Width of a value of that type; String and buffers: Byte; numbers of timers and counters: Word.
constexpr Width widthOf(Type type) {
  switch (type) {
    case Type::Bool: return Width::Bit;
    case Type::Byte:
    case Type::String:
    case Type::Interrupt: return Width::Byte;
    case Type::DWord:
    case Type::DInt:
    case Type::Real:
    case Type::Parameter: return Width::DWord;
    default: return Width::Word;
  }
}
constexpr Width widthOf(DataType type) {
  switch (type) {
    case DataType::Bool: return Width::Bit;
    case DataType::Byte: return Width::Byte;
    case DataType::Word:
    case DataType::Int: return Width::Word;
    default: return Width::DWord;
  }
}
constexpr bool isSigned(Type type) { return type == Type::Int || type == Type::DInt; }

}  // namespace rungproof
