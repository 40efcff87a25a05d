// SUB003: a call whose parameters do not fit the table of the called block, or the manual's for a library block:
// number, direction, area, width, kind of constant. No conversion is made. Tested by its examples and
// tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/operand_check.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/call_parameters.hpp"
#include "ir/s7200/library_block.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/pointer_parameter.hpp"

namespace rungproof {

namespace {

struct Formal {
  std::string_view name;
  VarSection section;
  DataType type;
  bool mayBeReal = false;
};

std::string_view typeName(DataType type) {
  static constexpr std::string_view names[] = {"BOOL", "BYTE", "WORD",   "INT", "DWORD",
                                               "DINT", "REAL", "STRING", "TIME"};
  return names[static_cast<std::size_t>(type)];
}

bool widthFits(const Operand& actual, DataType type) {
  if (actual.kind != OperandKind::Direct) return true;
  switch (actual.area) {
    case Area::T:
    case Area::C: return type == DataType::Bool || widthOf(type) == Width::Word;
    case Area::AC: return type != DataType::Bool;
    case Area::HC: return widthOf(type) == Width::DWord;
    default: return actual.width == widthOf(type);
  }
}

std::string_view sectionName(VarSection section) {
  return section == VarSection::Input ? "an input" : section == VarSection::InOut ? "an IN_OUT" : "an output";
}

/// What may stand for the parameter, as an operand of an instruction.
OperandDesc allowedFor(const Formal& formal) {
  const Type type = formal.type == DataType::Bool         ? Type::Bool
                    : widthOf(formal.type) == Width::Byte ? Type::Byte
                    : widthOf(formal.type) == Width::Word ? Type::Word
                                                          : Type::DWord;
  return operandDesc(formal.name, Direction::InOut, type, parameterForms(formal.section, formal.type));
}

class CallCheck {
 public:
  CallCheck(FindingSink& sink, const Instruction& call) : sink_(sink), call_(call) {}

  void run(std::string_view callee, const std::vector<Formal>& formals, Span declaration) {
    const std::size_t given = call_.operands.size() - 1;
    if (given != formals.size()) {
      Finding& finding = sink_.report(
          call_.span, fmt::format("{} has {} parameters, this call gives {}", callee, formals.size(), given));
      if (declaration.length > 0) finding.related.push_back({declaration, "the parameters are declared here"});
      finding.help = "give inputs, then IN_OUT, then outputs, in the order of the table (001:6823)";
      return;
    }
    for (std::size_t i = 0; i < formals.size(); ++i) parameter(formals[i], call_.operands[i + 1]);
  }

 private:
  void report(const Formal& formal, const Operand& actual, std::string_view why, std::string_view help) {
    Finding& finding = sink_.report(actual.span, fmt::format("{} does not fit parameter {} ({}): {}", toString(actual),
                                                             formal.name, typeName(formal.type), why));
    finding.address = toString(actual);
    finding.help = std::string(help);
  }

  void parameter(const Formal& formal, const Operand& actual) {
    const bool isOutput = formal.section != VarSection::Input;
    if (actual.kind == OperandKind::Symbol || actual.kind == OperandKind::Missing) return;
    if (isOutput && actual.kind != OperandKind::Direct && actual.kind != OperandKind::Indirect) {
      return report(formal, actual, "an output needs a place to write to",
                    "give an address; constants and & are for inputs only (001:6784)");
    }
    if (isOutput && actual.kind == OperandKind::Direct && actual.area == Area::SM &&
        actual.offset < firstParameterSm(formal.section)) {
      return report(formal, actual, "SM0 to SM29 are read-only",
                    "use an address from SMB30 on, or V or M memory (001:6757)");
    }
    if (formal.type == DataType::String) {
      if (actual.kind == OperandKind::Direct)
        report(formal, actual, "a string is passed by a pointer or as a text",
               "write *VD or a text in double quotes (001:6804)");
      return;
    }
    if (actual.kind == OperandKind::Text)
      return report(formal, actual, "a text is no number", "give an address or a number");
    if (!widthFits(actual, formal.type)) {
      return report(formal, actual, fmt::format("it is {}", widthName(actual.width)),
                    "no conversion is made (001:6813); give an operand of the same width");
    }
    if (formal.type == DataType::Bool && actual.kind != OperandKind::Direct) {
      return report(formal, actual, "a BOOL needs the address of a bit", "use SM0.0 for 1, or a bit of memory");
    }
    if (actual.kind == OperandKind::Address && widthOf(formal.type) != Width::DWord) {
      return report(formal, actual, "an address is a double word", "declare the parameter as DWORD (001:6811)");
    }
    const OperandDesc allowed = allowedFor(formal);
    if (!formIsAllowed(allowed, actual)) {
      return report(formal, actual, "table 6-78 does not list it",
                    fmt::format("{} may be {} (001:6753)", sectionName(formal.section), allowedForms(allowed)));
    }
    constantParameter(formal, actual);
  }

  void constantParameter(const Formal& formal, const Operand& actual) {
    if (actual.kind != OperandKind::Constant) return;
    const bool isReal = actual.form == ConstantForm::Real;
    const bool wantsReal = formal.type == DataType::Real;
    const bool isPattern = actual.form == ConstantForm::Hex || actual.form == ConstantForm::Binary ||
                           actual.form == ConstantForm::Typed || actual.value == 0;
    if (isReal != wantsReal && !(wantsReal && isPattern) && !(isReal && formal.mayBeReal)) {
      return report(formal, actual, wantsReal ? "it is a whole number" : "it is a real number",
                    "no conversion is made (001:6813)");
    }
    const std::int64_t high = widthOf(formal.type) == Width::Byte   ? 255
                              : widthOf(formal.type) == Width::Word ? 65535
                                                                    : 4294967295LL;
    if (!isReal && (actual.value > high || actual.value < -(high + 1) / 2)) {
      report(formal, actual, fmt::format("it does not fit {} bits", bits(widthOf(formal.type))),
             "use a smaller constant or a wider type");
    }
  }

  FindingSink& sink_;
  const Instruction& call_;
};

VarSection sectionOf(Direction direction) {
  return direction == Direction::In      ? VarSection::Input
         : direction == Direction::InOut ? VarSection::InOut
                                         : VarSection::Output;
}

/// Parameters of a block in the order of its table.
std::vector<Formal> formalsOf(const Pou& pou) {
  std::vector<Formal> formals;
  for (const LocalVariable& local : pou.locals) {
    if (local.section == VarSection::Temp) continue;
    formals.push_back({local.name, local.section, local.type});
  }
  return formals;
}

void checkTables(const Facts& facts, FindingSink& sink) {
  for (const Pou& pou : facts.program().pous) {
    VarSection last = VarSection::Input;
    std::size_t count = 0;
    for (const LocalVariable& local : pou.locals) {
      if (local.section == VarSection::Temp) continue;
      if (++count == maxParameters + 1) {
        sink.report(local.span, fmt::format("{} is parameter {} of {}; a subroutine has at most {}", local.name, count,
                                            pou.name, maxParameters))
            .help = "pass a pointer to a block of V memory (001:6775; error 009E, 001:14008)";
      }
      if (local.section < last) {
        sink.report(local.span,
                    fmt::format("{} of {} stands behind parameters of a later section", local.name, pou.name))
            .help = "declare inputs, then IN_OUT, then outputs (001:6823)";
      }
      last = std::max(last, local.section);
    }
  }
}

/// Whether nobody knows its parameters: a listing may leave out the table of a protected block with its text.
bool isWithoutTable(const Pou& callee) { return callee.protectedBlock && callee.locals.empty(); }

/// Without the manual's word on the parameters there is nothing to hold against; of unknown names SYM001 speaks.
void checkLibraryCall(const Facts& facts, FindingSink& sink, const Instruction& call, std::string_view name) {
  const LibraryBlock* library = libraryBlockWith(name, call.operands.size() - 1);
  if (library == nullptr && hasFixedParameters(facts.target(), name)) library = libraryBlockNamed(name);
  if (library == nullptr) return;
  std::vector<Formal> formals;
  for (const LibraryParameter& p : library->parameters)
    formals.push_back({p.name, sectionOf(p.direction), p.type, p.mayBeReal});
  CallCheck(sink, call).run(name, formals, {});
}

bool hasParts(const LocalVariable& local) { return local.type == DataType::Array || local.type == DataType::Struct; }

/// The parameter of an FC that the operand is, if it is an ARRAY or a STRUCT; nullptr otherwise.
const LocalVariable* ownParameter(const Pou& caller, const Operand& operand) {
  if (operand.reach == nullptr || operand.reach->way != Way::Parameter) return nullptr;
  const auto found = std::ranges::find_if(caller.locals, [&](const LocalVariable& local) {
    return hasParts(local) && isParameter(local) && local.address.reach != nullptr &&
           local.address.reach->way == Way::Parameter && local.address.reach->parameter == operand.reach->parameter;
  });
  return found == caller.locals.end() ? nullptr : &*found;
}

/// S7-300/400: an FB, but no FC, may hand its parameters of ARRAY and STRUCT on (002:2166-2168). What such a call would
/// do is clear, so the program is not refused for it.
void checkHandedOn(const Facts& facts, FindingSink& sink) {
  for (const CallSite& site : facts.calls().sites()) {
    const Pou& caller = facts.program().pous[site.caller];
    if (caller.type != BlockType::Fc || site.callee == noBlock) continue;
    const Pou& callee = facts.program().pous[site.callee];
    std::size_t at = hasInstance(callee) ? 2 : 1;
    for (const LocalVariable& formal : callee.locals) {
      if (!isParameter(formal) || at >= site.instruction->operands.size()) continue;
      const Operand& actual = site.instruction->operands[at++];
      const LocalVariable* own = hasParts(formal) ? ownParameter(caller, actual) : nullptr;
      if (own == nullptr) continue;
      Finding& finding =
          sink.report(actual.span.length > 0 ? actual.span : site.instruction->span,
                      fmt::format("{} hands its parameter {} on to {}; an FC cannot do that with an {}", caller.name,
                                  own->name, callee.name, own->type == DataType::Array ? "ARRAY" : "STRUCT"));
      finding.refused = false;
      finding.address = "#" + own->name;
      finding.related.push_back({own->span, fmt::format("{} is declared here", own->name)});
      finding.help = "copy it into temporary data with SFC 20 and hand that on, or make the block an FB (002:2166)";
    }
  }
}

void checkSub003(const Facts& facts, FindingSink& sink) {
  if (facts.form() == StatementForm::Accumulators) return checkHandedOn(facts, sink);
  checkTables(facts, sink);
  for (const CallSite& site : facts.calls().sites()) {
    const Instruction& call = *site.instruction;
    if (call.operands.empty()) continue;
    const Operand& target = call.operands[0];
    const Pou* callee = site.callee == noBlock ? nullptr : &facts.program().pous[site.callee];
    if (callee != nullptr && !isWithoutTable(*callee)) {
      CallCheck(sink, call)
          .run(callee->name, formalsOf(*callee), callee->locals.empty() ? Span{} : callee->locals.front().span);
    } else if (callee != nullptr || target.kind == OperandKind::Symbol) {
      checkLibraryCall(facts, sink, call, callee != nullptr ? std::string_view(callee->name) : target.text);
    } else if (target.kind == OperandKind::Constant && call.operands.size() == 1 && facts.program().main() != nullptr) {
      sink.report(call.span, fmt::format("{} calls a subroutine that the program does not have", Facts::text(call)))
          .help = "add the subroutine, or correct the number (error 0087, 001:13989)";
    }
  }
}

}  // namespace

extern constexpr Rule sub003_call_does_not_match = {
    .id = "SUB003",
    .title = "CALL does not match the table",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "number, direction, width or kind of the actual parameters that do not fit the local variable table of the "
        "called block; more than 16 parameters; a call without parameters of a subroutine that does not exist; "
        "S7-300/400: an FC that hands its own parameter of ARRAY or STRUCT on",
    .why =
        "no conversion is made and the order is fixed, so the values land in the wrong bytes; error 009E or 0087 at "
        "download",
    .manual = "001:6813, 001:6823, 001:6775, 001:14008, 002:2166-2168",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0, VB10\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nLevel:WORD;\nEND_VAR\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW LW0, "
        "VW100\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0, VW10\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nLevel:WORD;\nEND_VAR\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW LW0, "
        "VW100\nEND_SUBROUTINE_BLOCK\n",
    .peers = "CP17; SA0107; ironplc P4018; iec-checker CP17",
    .dialects = dialect::Every,
    .refuses = true,
    .check = checkSub003,
};

}  // namespace rungproof
