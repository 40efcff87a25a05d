// Offers of words.
#include "frontend/editor/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "frontend/editor/structured_navigation.hpp"
#include "frontend/editor/structured_text.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/property/property_types.hpp"
#include "frontend/settings/code_list.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "ir/dialect.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof {

namespace {

/// Kinds of items in the protocol.
enum class ItemKind : int { Function = 3, Variable = 6, Keyword = 14, Field = 5, Reference = 18, Constant = 21 };

/// Words that the property language has beside its keywords: they may be names elsewhere.
constexpr std::array<std::string_view, 10> furtherWords = {"not",   "rises",      "falls",     "prev",        "once",
                                                           "since", "first_scan", "retentive", "instruction", "most"};

class Offers {
 public:
  Offers(Json range, bool isQuoted) : range_(std::move(range)), isQuoted_(isQuoted) {}

  /// A symbol of an S7-300/400 source, which stands in quotation marks.
  void addQuoted(std::string_view name, ItemKind kind, std::string_view detail, std::string_view documentation) {
    add(fmt::format("{}{}\"", isQuoted_ ? "" : "\"", name), kind, detail, documentation);
  }

  void add(std::string_view label, ItemKind kind, std::string_view detail, std::string_view documentation = {}) {
    if (!labels_.insert(std::string(label)).second) return;
    Json item{
        {"label", label}, {"kind", static_cast<int>(kind)}, {"textEdit", Json{{"range", range_}, {"newText", label}}}};
    if (!detail.empty()) item["detail"] = detail;
    if (!documentation.empty()) item["documentation"] = documentation;
    items_.push_back(std::move(item));
  }
  Json take() { return {{"isIncomplete", false}, {"items", std::move(items_)}}; }

 private:
  Json range_;
  bool isQuoted_;  ///< the opening quotation mark stands there already
  Json items_ = Json::array();
  std::set<std::string> labels_;
};

bool writesGerman(const Program& program) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        const Desc& desc = *instruction.desc;
        if (desc.german.empty() || desc.german == desc.stl) continue;
        return equalsIgnoringCase(program.sources->text(instruction.mnemonic()), desc.german);
      }
    }
  }
  return false;
}

bool isGermanSource(const CheckedDocument& document) {
  const std::string_view setting = document.settings().text(Opt::Mnemonics);
  return setting == "german" || (setting != "international" && writesGerman(document.program()));
}

/// E, A and Z for I, Q and C: a source has one set of spellings.
std::string inGerman(std::string name) {
  const std::size_t at = name.starts_with("PI") || name.starts_with("PQ") ? 1 : 0;
  constexpr std::string_view international = "IQC", german = "EAZ";
  const std::size_t area = international.find(name[at]);
  if (area != std::string_view::npos) name[at] = german[area];
  return name;
}

void offerMnemonics(const CheckedDocument& document, Offers& offers) {
  const Program& program = document.program();
  const bool isGerman = isGermanSource(document);
  for (const Desc& desc : dialectOf(program.target).instructions().all()) {
    if (desc.drawingOnly || (desc.cpus & cpuBit(program.target.cpu)) == 0) continue;
    if (desc.olderDialectOnly && !program.olderDialect) continue;
    offers.add(isGerman && !desc.german.empty() ? desc.german : desc.stl, ItemKind::Keyword, desc.meaning, desc.group);
  }
}

bool fits(const OperandDesc* wanted, const Operand& address) {
  if (wanted == nullptr || wanted->type == Type::Parameter) return true;
  if (address.kind != OperandKind::Direct || (wanted->forms & form::area(address.area)) == 0) return false;
  return addressedByNumber(address.area) || address.width == widthOf(wanted->type);
}

void offerAddresses(const CheckedDocument& document, const OperandDesc* wanted, Offers& offers) {
  const bool isQuoted = dialectOf(document.program().target).text.quotesSymbols;
  const bool isGerman =
      isQuoted && wanted != nullptr && isGermanSource(document);  // properties have their own spelling
  for (const Symbol& symbol : document.program().symbols) {
    if (!fits(wanted, symbol.address)) continue;
    if (isQuoted)
      offers.addQuoted(symbol.name, ItemKind::Variable, toString(symbol.address), symbol.comment);
    else
      offers.add(symbol.name, ItemKind::Variable, toString(symbol.address), symbol.comment);
  }
  for (const XrefEntry& entry : document.xref().entries) {
    if (entry.area == Area::L) continue;
    const Operand address = direct(entry.area, entry.width, entry.offset, entry.bit);
    if (!fits(wanted, address)) continue;
    const Symbol* const symbol = document.facts().symbolOf(address);
    const bool isNumber = addressedByNumber(entry.area);
    const std::string name =
        addressName(entry.area, isNumber ? Width::Bit : entry.width, entry.offset, isNumber ? 0 : entry.bit);
    offers.add(isGerman ? inGerman(name) : name, ItemKind::Field, symbol == nullptr ? std::string() : symbol->name);
  }
}

/// IEC 61131-3: what an instance shows to those who have it.
void offerMembers(const CheckedDocument& document, const DeclaredName& instance, Offers& offers) {
  const iec::ProjectSyntax* const project = document.program().syntax.get();
  if (project == nullptr) return;
  for (const iec::BlockSyntax& block : project->blocks) {
    if (!equalsIgnoringCase(block.name, instance.type)) continue;
    for (const iec::VariableSyntax& variable : block.variables) {
      const bool isSeen = variable.section == iec::Section::Input || variable.section == iec::Section::Output ||
                          variable.section == iec::Section::InOut;
      if (isSeen) offers.add(fmt::format("{}.{}", instance.name, variable.name), ItemKind::Field, block.name);
    }
  }
}

/// IEC 61131-3: the variables of the block that the place is in, what all blocks see, and the words of ST.
void offerVariables(const CheckedDocument& document, std::uint32_t offset, Offers& offers) {
  const auto offer = [&](const DeclaredName& variable) {
    offers.add(variable.name, ItemKind::Variable, variable.type);
    offerMembers(document, variable, offers);
  };
  for (const DeclaredBlock& block : declaredBlocksOf(document)) {
    if (block.span.offset > offset || offset > block.span.offset + block.span.length) continue;
    for (const DeclaredName& variable : block.variables) offer(variable);
  }
  for (const DeclaredName& variable : declaredGlobalsOf(document)) offer(variable);
  if (const iec::ProjectSyntax* const project = document.program().syntax.get()) {
    for (const iec::BlockSyntax& block : project->blocks) {
      if (block.kind != iec::BlockKind::Program && !block.name.starts_with("__"))
        offers.add(block.name, ItemKind::Function, block.isLibrary ? "standard block" : "block of the program");
    }
  }
  for (const TextWord& word : structuredTextWords()) offers.add(word.word, ItemKind::Keyword, "structured text");
}

void offerRoutines(const CheckedDocument& document, Type type, std::uint32_t offset, Offers& offers) {
  const Program& program = document.program();
  for (const Pou& pou : program.pous) {
    const bool isWanted = (type == Type::Subroutine && pou.kind == PouKind::Subroutine) ||
                          (type == Type::Interrupt && pou.kind == PouKind::Interrupt);
    if (isWanted) offers.add(pou.name, ItemKind::Function, pou.title);
    if (type != Type::Label || pou.span.offset > offset || pou.span.offset + pou.span.length < offset) continue;
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (instruction.desc->control == Control::LabelMark)
          offers.add(toString(instruction.operands[0]), ItemKind::Reference, fmt::format("network {}", network.number));
      }
    }
  }
}

/// Whether the place is within a comment or a text of structured text, where no word is offered.
bool isInert(const CheckedDocument& document, std::uint32_t offset) {
  std::vector<Span> comments;
  const std::vector<iec::IecToken> tokens = tokensOf(document, document.file(), &comments);
  const auto holds = [&](std::uint32_t begin, std::uint32_t end, bool isOpen) {
    return begin < offset && (offset < end || (isOpen && offset == end));
  };
  return std::ranges::any_of(comments,
                             [&](Span span) {
                               const bool isLine = document.source().text(span).starts_with("//");
                               return holds(span.offset, span.offset + span.length, isLine);
                             }) ||
         std::ranges::any_of(tokens, [&](const iec::IecToken& token) {
           return token.kind == iec::TokenKind::Text && holds(token.begin, token.end, false);
         });
}

/// Behind the mnemonic, at the operand that the commas count.
void offerOperands(const CheckedDocument& document, std::string_view line, std::uint32_t offset, Offers& offers) {
  const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  std::string mnemonic(line.substr(0, end));
  std::ranges::transform(mnemonic, mnemonic.begin(), upper);
  const InstructionTable& table = dialectOf(document.program().target).instructions();
  const Desc* desc = table.named(mnemonic);
  if (desc == nullptr) desc = table.namedGerman(mnemonic);
  const auto index = static_cast<int>(std::ranges::count(line.substr(end), ','));
  const OperandDesc* const wanted = desc != nullptr && index < desc->operandCount ? &desc->operand(index) : nullptr;
  const bool isRoutine = wanted != nullptr && (wanted->type == Type::Label || wanted->type == Type::Subroutine ||
                                               wanted->type == Type::Interrupt);
  if (isRoutine) return offerRoutines(document, wanted->type, offset, offers);
  offerAddresses(document, wanted, offers);
}

void offerProperty(const CheckedDocument& document, Offers& offers) {
  for (const std::string_view word : propertyKeywords()) offers.add(word, ItemKind::Keyword, "property language");
  for (const std::string_view word : furtherWords) offers.add(word, ItemKind::Keyword, "property language");
  offerAddresses(document, nullptr, offers);
}

/// Behind "rungproof:".
void offerSuppression(std::string_view text, Offers& offers) {
  const std::string_view bare = trimmed(text);
  const bool hasVerb = bare.starts_with("allow") || bare.starts_with("begin");
  if (!hasVerb || text.find_first_of(" (", text.find(bare)) == std::string_view::npos) {
    for (const char* verb : {"allow", "begin", "end"}) offers.add(verb, ItemKind::Keyword, "suppression");
    return;
  }
  for (const Code& code : allCodes()) {
    if (code.isRule) offers.add(code.id, ItemKind::Constant, code.title);
  }
}

/// The statement that is typed, behind the label that may stand before it (S7-300/400: "M001: A I 0.0").
std::string_view withoutLabel(const CheckedDocument& document, std::string_view typed) {
  const auto bare = [](std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
  };
  const std::string_view line = bare(typed);
  const std::size_t colon = line.find(':');
  const bool hasLabel = dialectOf(document.program().target).text.labelsAreNames && colon != std::string_view::npos &&
                        colon > 0 && line.find_first_of(" \t\"") > colon;
  return hasLabel ? bare(line.substr(colon + 1)) : line;
}

}  // namespace

Json completionsAt(const CheckedDocument& document, ClientPlace place) {
  const std::uint32_t offset = document.offset(place);
  const SourceFile& source = document.source();
  const std::uint32_t begin = source.lineStart(source.position(offset).line);
  const std::string_view typed = source.text().substr(begin, offset - begin);
  const std::size_t word = typed.find_last_of(" \t,();/\"");
  const std::size_t from = word == std::string_view::npos ? 0 : word + 1;
  Offers offers(document.range({document.file(), begin + static_cast<std::uint32_t>(from),
                                static_cast<std::uint32_t>(typed.size() - from)}),
                from > 0 && typed[from - 1] == '"');
  const std::size_t comment = typed.find("//");
  const std::size_t tool = typed.find("rungproof:");
  if (endsInAny(source.name(), {".prop"}) ||
      (comment != std::string_view::npos && typed.substr(comment).starts_with("//@"))) {
    offerProperty(document, offers);
  } else if (comment != std::string_view::npos && tool != std::string_view::npos) {
    offerSuppression(typed.substr(tool + std::string_view("rungproof:").size()), offers);
  } else if (comment == std::string_view::npos && formOf(document.program().target) == StatementForm::Expressions) {
    if (!isInert(document, offset)) offerVariables(document, offset, offers);
  } else if (comment == std::string_view::npos) {
    const std::string_view line = withoutLabel(document, typed);
    if (line.find_first_of(" \t") == std::string_view::npos)
      offerMnemonics(document, offers);
    else
      offerOperands(document, line, offset, offers);
  }
  return offers.take();
}

}  // namespace rungproof
