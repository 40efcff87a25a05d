// What the readers can say: one row per message, with id, title, severity and help. `explain SYN010` prints from
// here. Ids are stable and never reused. Look-alike characters speak as rule STY004 of the catalogue.
// Tested by tests/reader/syntax_message_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ir/finding.hpp"

namespace rungproof {

enum class Syntax : std::uint8_t {
  FileUnreadable,
  FileUnknown,
  BadCharacters,
  ControlCharacters,
  Converted,
  NoInstruction,
  NoText,
  TooMany,
  UnknownInstruction,
  OtherFamily,
  OperandCount,
  BadOperand,
  BadConstant,
  StrayText,
  LadderName,
  QuoteOpen,
  LenientSpelling,
  GermanSpelling,
  BlockOpen,
  BlockNotOpen,
  BlockTwice,
  BlockHeading,
  NetworkHeading,
  OutsideBlock,
  ProtectedBlock,
  Declaration,
  LocalTableFull,
  SymbolRow,
  DataRow,
  DataValue,
  DataAddress,
  XmlDamaged,
  XmlEntities,
  XmlTooDeep,
  XmlStructure,
  BodyNotCovered,
  BlockHeading7,
  Declaration7,
  Assignment7,
  TypeUndefined,
  ValueOfType,
  Statement7,
  Operand7,
  NameUndefined,
  CallList,
  LabelOfBlock,
  BlockMissing,
  FamilyUndecided,
  NotModelled,
  LibraryBlock,
  SymbolColumns,
  IecText,
  IecType,
  IecName,
  IecNotModelled,
  IecNoProgram,
  NotOfS7200,
  IecSpelling,
  IecTaken,
  ProjectLost,
  ProjectDamaged,
  TimeStampConflict,
  SourceUnlike,
  count
};

struct SyntaxMessage {
  Syntax code;
  std::string_view id;
  std::string_view title;
  Severity severity;
  std::string_view help;
};

inline constexpr std::array<SyntaxMessage, static_cast<std::size_t>(Syntax::count)> syntaxMessages = {{
    {Syntax::FileUnreadable, "SYN001", "File cannot be read", Severity::Error, "check the path and the permissions"},
    {Syntax::FileUnknown, "SYN002", "Not a known kind of file", Severity::Error,
     "expected a statement list (Micro/WIN export or the older one-text form), a data block, a symbol table or another "
     "supported source"},
    {Syntax::BadCharacters, "SYN003", "Bytes that the encoding does not know", Severity::Warning,
     "name the encoding with --encoding utf-8, cp1252, cp1251 or gb18030"},
    {Syntax::ControlCharacters, "SYN004", "Control characters in the text", Severity::Error,
     "the file is damaged or is not a text; the characters were read as blanks"},
    {Syntax::Converted, "SYN005", "Text was converted", Severity::Note,
     "save the file as UTF-8 or in the code page of the editor"},
    {Syntax::NoInstruction, "SYN006", "No instruction found", Severity::Error, "the files given hold no program text"},
    {Syntax::NoText, "SYN007", "File is empty", Severity::Error, "export the program again"},
    {Syntax::TooMany, "SYN008", "Too many problems", Severity::Error, "mend the first ones and read the file again"},
    {Syntax::UnknownInstruction, "SYN010", "Unknown instruction", Severity::Error,
     "correct the mnemonic; the line was left out of its network"},
    {Syntax::OtherFamily, "SYN011", "Instruction of another controller family", Severity::Error,
     "the S7-200 does not have it; the line was left out of its network"},
    {Syntax::OperandCount, "SYN012", "Wrong number of operands", Severity::Error,
     "see the operand list of the instruction with `rungproof explain`"},
    {Syntax::BadOperand, "SYN013", "Operand cannot be read", Severity::Error,
     "write an address such as I0.0, VB10, VW10, T37, *VD10 or &VB10, a constant, or a symbol"},
    {Syntax::BadConstant, "SYN014", "Constant cannot be read", Severity::Error,
     "write 100, +100, 16#FF, 2#1010, 1.5, 'AB' or \"text\"; at most 32 bits"},
    {Syntax::StrayText, "SYN015", "Text without comment sign", Severity::Note, "begin comments with //"},
    {Syntax::LadderName, "SYN016", "Name of a ladder box instead of the mnemonic", Severity::Warning,
     "write the mnemonic of the statement list"},
    {Syntax::QuoteOpen, "SYN017", "Quotation mark without its partner", Severity::Error,
     "close the text with the same quotation mark"},
    {Syntax::LenientSpelling, "SYN018", "Spelling that the editor would not accept", Severity::Note,
     "it was read as the fix shows"},
    {Syntax::GermanSpelling, "SYN019", "German spelling in an international text", Severity::Error,
     "read the file with --mnemonics german, or write I, Q, C, AI, AQ"},
    {Syntax::BlockOpen, "SYN020", "Block without its end", Severity::Error,
     "the file may be cut off; end the block with its END_ line"},
    {Syntax::BlockNotOpen, "SYN021", "End of a block that is not open", Severity::Error,
     "remove the line or add the heading of the block"},
    {Syntax::BlockTwice, "SYN022", "Block number or name used twice", Severity::Error,
     "every block needs a number of its own and there is one main program"},
    {Syntax::BlockHeading, "SYN023", "Block heading cannot be read", Severity::Error,
     "write for example SUBROUTINE_BLOCK SBR_0:SBR0"},
    {Syntax::NetworkHeading, "SYN024", "Network line cannot be read", Severity::Error,
     "write Network and a number, then // and a title"},
    {Syntax::OutsideBlock, "SYN025", "Line outside of any block", Severity::Error,
     "move it between BEGIN and the end of a block"},
    {Syntax::ProtectedBlock, "SYN026", "Password-protected block", Severity::Note,
     "its instructions are not in the file; what it does is not covered"},
    {Syntax::Declaration, "SYN027", "Declaration cannot be read", Severity::Error,
     "write NAME:TYPE; with BOOL, BYTE, WORD, INT, DWORD, DINT, REAL or STRING"},
    {Syntax::LocalTableFull, "SYN028", "Local variables do not fit", Severity::Error,
     "a block has 64 bytes of local memory"},
    {Syntax::SymbolRow, "SYN029", "Row of the symbol table cannot be read", Severity::Error,
     "write name, address and comment, separated by tabs or commas"},
    {Syntax::DataRow, "SYN030", "Line of the data block cannot be read", Severity::Error,
     "write an address of V memory and its values, for example VW100 10, 20"},
    {Syntax::DataValue, "SYN031", "Value does not fit its place", Severity::Error, "use VW or VD for larger values"},
    {Syntax::DataAddress, "SYN032", "Data without an address", Severity::Error,
     "the first line of a data block needs an address"},
    {Syntax::XmlDamaged, "SYN033", "XML is damaged", Severity::Error,
     "export the program again; what could be saved was read"},
    {Syntax::XmlEntities, "SYN034", "XML with entities of its own", Severity::Error,
     "no editor writes such a file; remove the document type"},
    {Syntax::XmlTooDeep, "SYN035", "XML nested too deep", Severity::Error,
     "no editor writes such a file; export the program again"},
    {Syntax::XmlStructure, "SYN036", "Part of an XML export is missing or cannot be read", Severity::Error,
     "export the program again, with all blocks, variables and their types"},
    {Syntax::BodyNotCovered, "SYN037", "Language of a body is not covered", Severity::Warning,
     "write the body as LD, FBD or IL; properties that depend on it get the verdict NOT COVERED"},
    {Syntax::BlockHeading7, "SYN039", "Head of an S7-300/400 block cannot be read", Severity::Error,
     "write for example FUNCTION FC 1 : VOID, then attributes, declarations and BEGIN"},
    {Syntax::Declaration7, "SYN040", "Declaration of an S7-300/400 block cannot be read", Severity::Error,
     "write for example Speed : INT := 10 ; between VAR_INPUT and END_VAR"},
    {Syntax::Assignment7, "SYN041", "Value of a data block cannot be read", Severity::Error,
     "write for example Recipe[2].Eggs := 5 ; between BEGIN and END_DATA_BLOCK"},
    {Syntax::TypeUndefined, "SYN042", "Type that nothing defines", Severity::Error,
     "add the source with the TYPE or FUNCTION_BLOCK, and the symbol table if it has a name"},
    {Syntax::ValueOfType, "SYN043", "Value does not fit the type of its place", Severity::Error,
     "write a constant of the type, such as 5, L#5, W#16#FF, 1.5, S5T#2S, T#2S, 'a'"},
    {Syntax::Statement7, "SYN044", "Statement cannot be read", Severity::Error,
     "its network is not covered; write for example A I 0.0 ; or L #Speed ;"},
    {Syntax::Operand7, "SYN045", "Operand that the instruction does not take", Severity::Error,
     "its network is not covered; `rungproof explain JNB --dialect s7-300` shows what an instruction such as JNB "
     "takes"},
    {Syntax::NameUndefined, "SYN046", "Name that nothing defines", Severity::Error,
     "name the symbol table or the source that defines it beside the others; its network is not covered"},
    {Syntax::CallList, "SYN047", "Parameter list does not fit the block", Severity::Error,
     "give parameters by their declared names and types: an FC needs all of them, an FB its instance"},
    {Syntax::LabelOfBlock, "SYN048", "Label is missing or stands twice", Severity::Error,
     "every label stands once in its block, letters in the same case"},
    {Syntax::BlockMissing, "SYN049", "Block that nothing defines", Severity::Error,
     "add the source of the block; networks that use it are not covered"},
    {Syntax::FamilyUndecided, "SYN050", "Controller family or mnemonics cannot be told", Severity::Error,
     "name them with --dialect s7-200 or s7-300 and --mnemonics international or german"},
    {Syntax::NotModelled, "SYN051", "Larger than the model of the CPU", Severity::Error,
     "data blocks DB 1 to DB 8191 of at most 65535 bytes are modelled"},
    {Syntax::LibraryBlock, "SYN052", "Block of a library without a meaning in the model", Severity::Warning,
     "the network of the call is left out: what depends on it is not covered"},
    {Syntax::SymbolColumns, "SYN053", "Row of a symbol table with fixed columns is out of line", Severity::Error,
     "an .asc row has 126, and then 24 columns for the name, 12 for the address, 10 for the type, 80 for the comment; "
     "export the table again"},
    {Syntax::IecText, "SYN056", "Text of IEC 61131-3 cannot be read", Severity::Error,
     "see the place; reading went on behind the statement or declaration"},
    {Syntax::IecType, "SYN057", "Types or values of IEC 61131-3 do not fit", Severity::Error,
     "write a conversion such as INT_TO_REAL, or correct the declaration"},
    {Syntax::IecName, "SYN058", "Name of IEC 61131-3 is not known", Severity::Error,
     "declare it, correct its spelling, or add the file that has it"},
    {Syntax::IecNotModelled, "SYN059", "Not modelled in IEC 61131-3 programs", Severity::Error,
     "properties that depend on it get the verdict NOT COVERED"},
    {Syntax::IecNoProgram, "SYN060", "No program to run", Severity::Warning,
     "add the PROGRAM, or give one function block alone"},
    {Syntax::NotOfS7200, "SYN061", "PLCopen XML that is no program of an S7-200", Severity::Error,
     "leave --dialect out: PLCopen XML is a program of IEC 61131-3. An S7-200 is named by the heading of the file "
     "(productName) or by addresses such as %VW0"},
    {Syntax::IecSpelling, "SYN062", "Spelling that compilers of IEC 61131-3 refuse", Severity::Warning,
     "it is read as it is meant; correct it before the program is compiled"},
    {Syntax::IecTaken, "SYN063", "Missing part of an IEC 61131-3 program", Severity::Note,
     "add the declaration or the file of the library: nothing has to be taken then"},
    {Syntax::ProjectLost, "SYN070", "Blocks of a STEP 7 project are lost", Severity::Error,
     "the table of blocks is damaged: copy the project again, or open and reorganize it with STEP 7"},
    {Syntax::ProjectDamaged, "SYN071", "Part of a STEP 7 project or upload cannot be read", Severity::Warning,
     "the rest was read; a block without readable code counts as an interface, and what depends on it is not covered"},
    {Syntax::TimeStampConflict, "SYN072", "Caller knows another interface of the block", Severity::Warning,
     "STEP 7 calls it a time stamp conflict: open the caller, update the call, save and download it"},
    {Syntax::SourceUnlike, "SYN073", "Text source of a project is not what its block does", Severity::Note,
     "the block counts: compile the source again, or generate it anew from the block"},
}};

constexpr const SyntaxMessage& syntaxMessage(Syntax code) { return syntaxMessages[static_cast<std::size_t>(code)]; }

namespace detail {
constexpr bool syntaxTableIsInOrder() {
  for (std::size_t i = 0; i < syntaxMessages.size(); ++i) {
    if (static_cast<std::size_t>(syntaxMessages[i].code) != i) return false;
    if (i > 0 && syntaxMessages[i].id <= syntaxMessages[i - 1].id) return false;
  }
  return true;
}
static_assert(syntaxTableIsInOrder(), "syntaxMessages must follow the enumeration, ids rising");
}  // namespace detail

}  // namespace rungproof
