// A program: blocks (POUs), networks, instructions, declarations. Every reader produces it; rules, engine,
// encoder and printers consume it. Operands keep the place where they were written.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ir/block_event.hpp"
#include "ir/desc.hpp"
#include "ir/finding.hpp"
#include "ir/operands.hpp"
#include "ir/source.hpp"

namespace rungproof {

struct Drawing;  // ladder or FBD, drawing.hpp
namespace s7300 {
struct Declarations;  // names of data, ir/s7300/declarations.hpp
}
namespace iec {
struct ProjectSyntax;  // the syntax tree, ir/iec/syntax.hpp
}

/// How a value of an IEC 61131-3 program is meant.
enum class ValueType : std::uint8_t { Signed, Unsigned, Real };

/// The values of a subrange, an enumeration or a time of day: its runs, in rising order.
struct ValueLimits {
  int width = 0;  ///< bits: 8, 16, 32, 64
  bool isSigned = false;
  std::vector<std::pair<std::int64_t, std::int64_t>> runs;  ///< first and last value
  bool isKept = false;  ///< what the program writes is one of these: constants, and what stands in `sources`
  std::vector<std::uint32_t> sources{};  ///< first bytes of variables with limits of their own

  bool hold(std::int64_t value) const {
    return std::ranges::any_of(runs, [&](const auto& run) { return run.first <= value && value <= run.second; });
  }
};

enum class PouKind : std::uint8_t { Main, Subroutine, Interrupt };
enum class VarSection : std::uint8_t { Input, InOut, Output, Temp, Static };
/// What a block of an S7-300/400 is; all blocks of an S7-200 are None.
enum class BlockType : std::uint8_t { None, Ob, Fc, Fb, Sfc, Sfb };
enum class Form : std::uint8_t { Stl, Ladder, Fbd };

/// A row of a local variable table with its place in L memory (001:6817-6821).
struct LocalVariable {
  std::string name;
  VarSection section = VarSection::Temp;
  DataType type = DataType::Bool;
  /// The L operand that the layout rule assigns. S7-300/400: static data and parameters of an FB by Way::Instance,
  /// parameters by reference by Way::Parameter.
  Operand address;
  std::uint32_t size = 0;  ///< S7-300/400: bytes; 0 for a bit
  /// S7-300/400: byte of the pointer by which a parameter is handed over: of an FC among those of the call, of an FB in
  /// its instance (ir/s7300/handed_pointer.hpp).
  std::uint32_t pointerByte = 0;
  int instanceOf = 0;  ///< DataType::Instance: Pou::number of the FB
  Span span;
};

struct Instruction {
  const Desc* desc = nullptr;  ///< never null in a program; unknown mnemonics become findings, not instructions
  Operands operands;
  Span span;                         ///< mnemonic through last operand
  std::uint32_t mnemonicLength = 0;  ///< bytes
  std::uint32_t id = 0;              ///< number over the whole program, in program order; set by Program::number()

  /// The mnemonic as written.
  Span mnemonic() const { return {span.file, span.offset, mnemonicLength}; }
};

inline Role roleOf(const Instruction& instruction) { return instruction.desc->role; }

struct Comment {
  Span span;  ///< the comment with its marker
};

struct Network {
  int number = 0;  ///< as written, or counted from 1
  Span span;       ///< heading through last line
  ShortText title;
  std::vector<Comment> comments;
  std::vector<Instruction> instructions;
  std::shared_ptr<const Drawing> drawing;  ///< of a network that was read as a drawing, lowered to `instructions`
  /// Of a network that is not complete: all that it may write, where that is known; otherwise it may write anything.
  std::optional<Operands> mayWrite;
  Form form = Form::Stl;
  /// S7-300/400: written in SCL. The instructions are what the text means, and it alone is shown.
  bool isStructured = false;
  bool complete = true;  ///< false: a line of it could not be read; its findings stand in Program::findings
};

struct Pou {
  PouKind kind = PouKind::Main;
  std::string name;  ///< "MAIN", "SBR_0", or the symbolic name
  int number = 0;    ///< of SBRn, INTn, OBn; of blocks of an S7-300/400: blockNumber() (ir/s7300/block.hpp)
  std::string title;
  std::vector<LocalVariable> locals;
  std::vector<Network> networks;
  std::vector<Comment> comments;  ///< outside networks
  Span span;
  bool protectedBlock = false;  ///< password-protected: no instruction is visible
  BlockType type = BlockType::None;
  bool isBuiltIn = false;           ///< S7-300/400: its struct in ir/s7300/library says what it does, not its text
  bool isInstance = false;          ///< IEC 61131-3: the body of one instance of a block
  std::uint32_t localBytes = 0;     ///< S7-300/400: L memory, with that of the LAD/FBD compiler; even
  std::uint32_t pointerBytes = 0;   ///< S7-300/400: the last of them, for pointers that calls hand over
  bool takesPointers = false;       ///< S7-300/400: whether a parameter is handed over by a pointer
  std::uint32_t instanceBytes = 0;  ///< of an FB
};

/// A row of a symbol table.
struct Symbol {
  std::string name;
  Operand address;
  std::string comment;
  Span span;
};

/// An initial value of V memory from a data block: `width` bytes big-endian at VB`offset`, or a text.
struct DataInit {
  std::uint32_t offset = 0;
  std::vector<std::uint8_t> bytes;
  Span span;
};

/// A line `//@ ...` or a statement of a property file, kept as text for analysis/property.
struct Directive {
  std::string text;
  Span span;
  int pou = -1;  ///< index of the block that contains it, -1 outside
  int network = 0;
};

/// A data block of an S7-300/400.
struct DataBlock {
  std::uint32_t number = 0;
  std::string name;                 ///< symbol, or empty
  std::vector<std::uint8_t> bytes;  ///< actual values as they are loaded
  int instanceOf = 0;               ///< Pou::number of the FB; 0: a global block
  bool readOnly = false, unlinked = false, nonRetain = false;
  Span span;
};

/// Bytes of V memory that a library was given (001:2497), as the project's settings name them.
struct LibraryMemory {
  std::string block;  ///< "MBUS_SLAVE"; empty: of any library
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

struct Program {
  std::shared_ptr<SourceSet> sources = std::make_shared<SourceSet>();
  Target target;
  std::vector<Pou> pous;  ///< main first when there is one
  std::vector<Symbol> symbols;
  std::vector<DataInit> data;
  std::vector<DataBlock> dataBlocks;  ///< in the order of their numbers
  std::vector<Directive> directives;
  std::shared_ptr<const s7300::Declarations> declarations;  ///< S7-300/400: names of data; nullptr elsewhere
  std::vector<LibraryMemory> libraryMemory;
  /// S7-300/400: ms from one start of OB30 and those that follow to the next.
  std::array<std::uint16_t, cyclicBlockCount> cyclicPeriods = usualPeriods;
  std::optional<std::uint32_t> clockMemory;       ///< S7-300/400: byte of M (ir/s7300/clock_memory.hpp)
  bool coldStart = false;                         ///< S7-300/400: runs begin with OB102 and nothing retained (002:1383)
  std::uint16_t cycleMonitoringMs = 150;          ///< S7-300/400: a scan that lasts longer is a time error (002:1296)
  std::map<std::uint32_t, ValueType> valueTypes;  ///< IEC 61131-3: of the variables, by their first byte in V
  /// IEC 61131-3: of variables whose type has fewer values than patterns, by their first byte in V.
  std::map<std::uint32_t, ValueLimits> valueLimits;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> retained;  ///< IEC 61131-3: first and last byte of RETAIN data
  std::optional<std::uint32_t> taskMs;                            ///< IEC 61131-3: interval of the task
  std::shared_ptr<const iec::ProjectSyntax> syntax;  ///< IEC 61131-3: what the program was made of; nullptr elsewhere
  std::vector<Finding> findings;                     ///< of the readers
  bool olderDialect = false;                         ///< one-text dialect of the S7-212/214 time (MEND, SBR n)

  /// Numbers all instructions in program order; call after the last block was added.
  void number();
  std::size_t instructionCount() const;
  const Pou* main() const;
  const Pou* subroutine(int number) const;
  const Pou* interrupt(int number) const;
  /// The symbol of an address, or nullptr.
  const Symbol* symbolOf(const Operand& address) const;
  const Symbol* symbolNamed(std::string_view name) const;
};

}  // namespace rungproof
