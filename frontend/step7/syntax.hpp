// The syntax tree of STEP 7 sources: what stands in the files, with the place of everything, before any name is looked
// up. Blocks, declarations, networks, statements, operands.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ir/program.hpp"
#include "ir/s7300/declaration.hpp"
#include "ir/source.hpp"

namespace rungproof::step7 {

using s7300::Constant;
using s7300::PathStep;
using s7300::Section;

/// A word of the source with its place.
struct Name {
  std::string text;
  Span span;
};

enum class BlockKind : std::uint8_t { Ob, Fc, Fb, Db, Di, Sfc, Sfb, Udt, Sdb, Vat };
/// "OB", "FC", ...
std::string_view blockKindName(BlockKind kind);

/// A block by number (FC 5) or by symbol ("Valve").
struct BlockName {
  std::optional<BlockKind> kind;  ///< nothing: a symbol
  std::uint32_t number = 0;
  std::string symbol;
  Span span;
};
/// "FC 5" or the symbol in its quotation marks.
std::string toString(const BlockName& name);

enum class Place : std::uint8_t { I, Q, M, PI, PQ, L, DB, DI, T, C };
enum class Size : std::uint8_t { Bit, Byte, Word, DWord };

enum class OperandForm : std::uint8_t {
  None,
  Address,   ///< I 0.0, MW 10, T 5, DB10.DBX 0.0, "Motor".DBW 2
  Local,     ///< #name.part[2]
  Symbol,    ///< "name", "Db".part[2]
  Constant,  ///< 5, W#16#FF, P#M 10.0
  Block,     ///< FC 5, DB 10
  Word,      ///< a bare name: label, status bit (OV, ==0), register (STW, AR1, DBNO)
  Indirect,  ///< I [MD 4], MW [AR1,P#2.0], [AR1,P#0.0], DB [#number]
  Parameter  ///< P##name: the address of a parameter
};

/// One operand as written.
struct Operand {
  OperandForm form = OperandForm::None;
  Span span;
  Place place = Place::M;            ///< Address; Indirect that names its area
  Size size = Size::Bit;             ///< Address, Indirect
  std::uint32_t number = 0;          ///< Address: byte, or number of the timer or counter
  std::uint8_t bit = 0;              ///< Address: 0 to 7, larger ones are kept
  bool isBehindDeclared = false;     ///< Address of L: counted from behind the declared data
  bool isPeripheral = false;         ///< Symbol with :P: the module itself, not its image
  std::optional<BlockName> block;    ///< Address, Symbol: DB10. before it; Block: itself; Indirect: the kind of block
  std::string name;                  ///< Symbol, Address beside one: the name; Word: itself
  std::vector<PathStep> path;        ///< Local, Parameter: all; Symbol: what follows the name
  Constant constant;                 ///< Constant
  std::uint8_t addressRegister = 0;  ///< Indirect: 1, 2; 0: `pointer` holds the address
  std::uint32_t offset = 0;          ///< Indirect by register: the constant P#byte.bit in bits
  bool crossesAreas = false;         ///< Indirect by register: the area stands in the register
  std::shared_ptr<const Operand> pointer;  ///< Indirect: where the address lies
};

/// NAME := actual of a call.
struct Argument {
  Name formal;
  Operand actual;  ///< None: nothing stands behind the sign
  Span span;
};

struct Statement {
  Name label;     ///< empty: none
  Name mnemonic;  ///< empty: nothing but a label
  Operand operand;
  Operand instance;  ///< of a call: DB 3, "InstDb", #instance
  std::vector<Argument> arguments;
  bool hasArguments = false;      ///< a parameter list stands there, may be empty
  std::vector<Operand> pointers;  ///< UC, CC: what stands in braces
  std::string fault;              ///< why it cannot be read; empty: it can
  Span faultSpan;
  Span span;  ///< label through end
};

struct Remark {
  Span span;  ///< with its marks
};

struct SclBody;  // scl_body.hpp

struct NetworkSyntax {
  int number = 0;  ///< counted from 1
  std::string title;
  std::vector<Remark> remarks;
  std::vector<Statement> statements;
  Span span;
  Form form = Form::Stl;
  bool isUnread = false;      ///< some of it is not among the statements, and has a finding
  bool keepsStores = false;   ///< the same, but the statements store at all places where it may
  bool isStructured = false;  ///< written in SCL; the statements are what its text means
  /// SCL that becomes statements once all names are known: of a block in SCL all of it, which becomes networks.
  std::shared_ptr<const SclBody> scl;
};

struct TypeSyntax;

struct DeclarationSyntax {
  Name name;
  std::shared_ptr<const TypeSyntax> type;
  std::vector<Constant> initial;  ///< repetitions written out
  Section section = Section::Static;
  std::string view;  ///< AT: the name whose place it shares
  Span span;
};

struct TypeSyntax {
  s7300::Type elementary;             ///< kind and length; Array, Struct, Unknown: more follows
  std::vector<s7300::Bounds> bounds;  ///< Array
  std::shared_ptr<const TypeSyntax> element;
  std::vector<DeclarationSyntax> fields;  ///< Struct
  std::optional<BlockName> named;         ///< UDT, FB, SFB, or a symbol or name of one of them
  Span span;
};

/// name.part[1] := value ; of the body of a data block.
struct Assignment {
  std::vector<PathStep> path;
  std::vector<Constant> values;
  Span span;
};

/// A line //@ with what follows the sign.
struct DirectiveSyntax {
  std::string text;
  Span span;
  int network = 0;
};

struct BlockSyntax {
  BlockKind kind = BlockKind::Ob;
  BlockName name;
  bool framed = true;  ///< false: a statement list without any head
  Span heading;
  Span span;
  std::string title, author, family, nameAttribute, version;
  bool knowHowProtected = false, readOnly = false, unlinked = false, nonRetain = false;
  std::shared_ptr<const TypeSyntax> type;  ///< FUNCTION: of its value; DATA_BLOCK, TYPE: of the whole
  std::vector<DeclarationSyntax> declarations;
  std::vector<DeclarationSyntax> constants;  ///< VAR CONSTANT: names of values, which take no place
  std::vector<NetworkSyntax> networks;
  std::vector<Assignment> assignments;
  std::vector<Remark> remarks;
  std::vector<DirectiveSyntax> directives;
  bool isScl = false;            ///< its body is in SCL, all of it in one network
  bool hasBody = false;          ///< BEGIN was there
  bool isOpen = false;           ///< its end is missing
  bool declarationsRead = true;  ///< false: one of them, or the heading, has a finding
};

struct SourceSyntax {
  std::uint32_t file = 0;
  std::vector<BlockSyntax> blocks;
  std::vector<DirectiveSyntax> directives;  ///< outside of blocks
};

/// A row of a symbol table: a name for an address or a block.
struct SymbolRow {
  Name name;
  Operand address;   ///< Address, Block, or Constant
  std::string type;  ///< as written, without double blanks: "BOOL", "FB 1"
  std::string comment;
};

}  // namespace rungproof::step7
