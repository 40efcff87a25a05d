// What is shown of a network, and the page as text.
#include "frontend/picture/network_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "analysis/drawing/raise.hpp"
#include "frontend/picture/placement.hpp"
#include "frontend/picture/power_flow.hpp"
#include "frontend/step7/source_writer.hpp"
#include "frontend/stl/stl_writer.hpp"
#include "frontend/text/excerpt.hpp"
#include "ir/iec/statement_text.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

namespace {

std::string commentText(std::string_view text) {
  if (text.starts_with("//"))
    text.remove_prefix(2);
  else if (text.starts_with("(*"))
    text = text.substr(2, text.size() - (text.ends_with("*)") ? 4 : 2));
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  return std::string(text);
}

/// Names of the operands that have one: "Start, Stop".
std::string namesIn(const Program& program, const Instruction& instruction) {
  std::string names;
  for (const Operand& operand : instruction.operands) {
    const Symbol* symbol = program.symbolOf(operand);
    const bool hasName = !operand.text.empty() && operand.kind == OperandKind::Direct && operand.text[0] != '#';
    const std::string name = hasName ? std::string(operand.text) : symbol == nullptr ? "" : symbol->name;
    if (!name.empty()) names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

/// Those of the findings, which stand in the order of their places, that begin in that place.
std::span<const Finding* const> findingsIn(std::span<const Finding* const> findings, Span place) {
  const auto before = [&](std::uint64_t offset) {
    return std::ranges::partition_point(findings, [&](const Finding* finding) {
      return std::pair<std::uint64_t, std::uint64_t>(finding->span.file, finding->span.offset) <
             std::pair<std::uint64_t, std::uint64_t>(place.file, offset);
    });
  };
  return {before(place.offset), before(std::uint64_t{place.offset} + place.length)};
}

/// Statement, stack top and values of the scan, names, findings: one line, columns aligned by the caller.
struct StatementRow {
  std::string statement, top, values, names, marks;
};

std::vector<StatementRow> statementRows(const Program& program, const Network& network, const ViewOptions& options) {
  const std::span<const Finding* const> findings = findingsIn(options.findings, network.span);
  std::vector<StatementRow> rows;
  for (const Instruction& instruction : network.instructions) {
    StatementRow row;
    row.statement = formOf(program.target) == StatementForm::Accumulators
                        ? step7::writeStatement(program, instruction, options.mnemonics)
                        : writeInstruction(instruction);
    row.names = namesIn(program, instruction);
    if (options.recorder != nullptr) {
      const InstructionRecord& record = options.recorder->of(instruction);
      if (formOf(program.target) != StatementForm::Accumulators)
        row.top = record.executions == 0 ? "-" : record.after[0] ? "1" : "0";
      if (record.executions > 0) {
        const std::vector<std::string> values = valueTexts(instruction, record);
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (!values[i].empty())
            row.values +=
                fmt::format("{}{}={}", row.values.empty() ? "" : " ", toString(instruction.operands[i]), values[i]);
        }
      }
    }
    for (const Finding* finding : findingsIn(findings, instruction.span)) {
      if (row.marks.find(finding->rule) == std::string::npos)
        row.marks += (row.marks.empty() ? "^" : " ") + finding->rule;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::string> statementLines(const Program& program, const Network& network, const ViewOptions& options) {
  const std::vector<StatementRow> rows = statementRows(program, network, options);
  int statement = 0, values = 0;
  bool hasNames = false;
  for (const StatementRow& row : rows) {
    statement = std::max(statement, displayWidth(row.statement));
    values = std::max(values, displayWidth(row.values));
    hasNames = hasNames || !row.names.empty();
  }
  const auto padded = [](const std::string& text, int width) {
    return text + std::string(static_cast<std::size_t>(std::max(0, width - displayWidth(text))), ' ');
  };
  std::vector<std::string> lines;
  for (const StatementRow& row : rows) {
    std::string line = padded(row.statement, statement);
    if (options.recorder != nullptr)
      line += (row.top.empty() ? "" : "  " + row.top) + "  " + padded(row.values, values);
    if (!row.names.empty()) line += "  // " + row.names;
    if (!row.marks.empty()) line += "  " + row.marks;
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(std::move(line));
  }
  return lines;
}

/// The text of a statement of IEC 61131-3, as far to the left as it can stand; of a drawing what it says as such text.
std::vector<std::string> sourceLines(const Program& program, const Network& network) {
  if (network.drawing != nullptr) return iec::circuitLines(*program.syntax, network.span);
  std::vector<std::string> lines;
  std::string_view text = program.sources->text(network.span);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    lines.push_back(std::move(line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  std::size_t indent = std::string::npos;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::size_t first = lines[i].find_first_not_of(" \t");
    if (first != std::string::npos) indent = std::min(indent, first);
  }
  for (std::size_t i = 1; i < lines.size() && indent != std::string::npos; ++i)
    lines[i].erase(0, std::min(indent, lines[i].size()));
  return lines;
}

/// More than this nobody can read, and the layout takes time and memory with the product of columns and rows.
constexpr std::size_t mostElements = 2'000;
constexpr std::size_t mostPlaces = 100'000;

/// Why a network is too large for a picture; empty: it is not. Instructions include those that join and branch.
std::string sizeReason(const Network& network, const Drawing* drawing) {
  const std::size_t size = drawing != nullptr ? drawing->elements.size() : network.instructions.size();
  const std::size_t most = drawing != nullptr ? mostElements : 2 * mostElements;
  if (size <= most) return {};
  return fmt::format("too large to draw: {} {}, a picture takes up to {}", size,
                     drawing != nullptr ? "elements" : "instructions", most);
}

/// The same of what is about to be laid out: symbols side by side times branches and outputs below each other.
std::string sizeReason(const PlanNodes& plan) {
  std::vector<std::size_t> column(plan.nodes.size(), 0);
  std::size_t columns = 1, rows = 0;
  for (std::size_t i = 0; i < plan.nodes.size(); ++i) {
    const PlanNode& node = plan.nodes[i];
    for (const NodeInput& input : node.inputs)
      column[i] = std::max(column[i], column[static_cast<std::size_t>(input.from)] + (node.kind != NodeKind::Join));
    columns = std::max(columns, column[i]);
    rows += node.inputs.size() > 1 ? node.inputs.size() - 1 : 0;
    rows += node.kind == NodeKind::Coil || node.kind == NodeKind::Leaf;
  }
  if (columns * rows <= mostPlaces) return {};
  return fmt::format("too large to draw: {} symbols side by side and {} branches below each other", columns, rows);
}

/// The drawing of a network in that form, or why there is none.
Raised drawingOf(const Network& network, const ViewOptions& options, const Target& target) {
  const Form form = options.form;
  // As it was drawn; blocks stand in a ladder as they stand in an FBD.
  if (network.drawing != nullptr && network.drawing->isOfVariables) {
    if (std::string reason = sizeReason(network, network.drawing.get()); !reason.empty())
      return {std::nullopt, std::move(reason), nullptr};
    const bool isTurned = form == Form::Fbd && network.form == Form::Ladder;
    return {isTurned ? asFbd(*network.drawing) : *network.drawing, {}, nullptr};
  }
  // The recorder follows the logic stack, which that family does not have.
  if (options.recorder != nullptr && formOf(target) == StatementForm::Accumulators)
    return {std::nullopt, "the power flow of an S7-300 or S7-400 is not drawn", nullptr};
  if (std::string reason = sizeReason(network, network.drawing.get()); !reason.empty())
    return {std::nullopt, std::move(reason), nullptr};
  if (network.drawing != nullptr && network.form == form) return {*network.drawing, {}, nullptr};
  Raised raised = raise(network, form, target);
  // A ladder whose values pass through memory in STL is drawn from the ladder itself.
  const bool isLadder = network.drawing != nullptr && network.form == Form::Ladder;
  if (!raised.drawing && form == Form::Fbd && isLadder) return {asFbd(*network.drawing), {}, nullptr};
  return raised;
}

void markSeen(Picture& picture, const Drawing& drawing, const Network& network, const ViewOptions& options) {
  for (PictureSymbol& symbol : picture.symbols) {
    if (symbol.element < 0 || (symbol.kind != SymbolKind::Contact && symbol.kind != SymbolKind::Bracket)) continue;
    const std::uint32_t instruction = drawing.elements[static_cast<std::size_t>(symbol.element)].instruction;
    if (instruction < network.instructions.size()) symbol.seen = options.seen(network.instructions[instruction]);
  }
}

}  // namespace

NetworkView networkView(const Program& program, const Pou& pou, const Network& network, const ViewOptions& options) {
  NetworkView view;
  view.heading = fmt::format("Network {}", network.number);
  if (program.declarations != nullptr && program.declarations->protectedBlocks.contains(pou.number)) {
    for (const Finding* finding : findingsIn(options.findings, network.span))
      view.notes.push_back({finding->severity, fmt::format("{}: {}", finding->rule, finding->message)});
    view.statements = {"know-how protected: not shown"};
    return view;
  }
  if (!network.title.empty()) view.heading += "  " + network.title;
  for (const Comment& comment : network.comments) {
    std::string text = commentText(program.sources->text(comment.span));
    if (text != network.title) view.comments.push_back(std::move(text));
  }
  const std::span<const Finding* const> findings = findingsIn(options.findings, network.span);
  for (const Finding* finding : findings)
    view.notes.push_back({finding->severity, fmt::format("{}: {}", finding->rule, finding->message)});
  view.notExecuted =
      options.recorder != nullptr && !network.instructions.empty() && !wasExecuted(network, *options.recorder);
  const bool isText = formOf(program.target) == StatementForm::Expressions || network.isStructured;
  if (isText && (network.drawing == nullptr || options.form == Form::Stl)) {
    view.statements = sourceLines(program, network);
    return view;
  }
  // Statements whose operand no file explains are there all the same.
  const bool hasStatements = network.complete || (network.mayWrite && network.drawing == nullptr);
  if (!hasStatements) view.reason = "a line of the network could not be read";
  if (options.form != Form::Stl && hasStatements && !network.instructions.empty()) {
    const Raised raised = drawingOf(network, options, program.target);
    view.reason = raised.reason;
    if (raised.drawing) view.reason = sizeReason(network, &*raised.drawing);
    if (raised.drawing && view.reason.empty()) {
      ElementTexts texts(&program, &pou, *raised.drawing);
      texts.setFindings({findings.begin(), findings.end()});
      std::vector<ElementFlow> flows;
      if (options.recorder != nullptr) {
        flows = elementFlows(program, *raised.drawing, network, *options.recorder);
        texts.setFlow(&flows);
      }
      const PlanNodes plan =
          options.form == Form::Fbd ? fbdNodes(*raised.drawing, texts) : ladderNodes(*raised.drawing, texts);
      view.reason = plan.reason.empty() ? sizeReason(plan) : plan.reason;
      if (view.reason.empty()) {
        const PlacedPicture placed = place(plan, options.width);
        view.reason = placed.reason;
        if (placed.reason.empty()) {
          view.picture = wrapped(placed.picture, options.width);
          if (options.seen) markSeen(view.picture, *raised.drawing, network, options);
          return view;
        }
      }
    }
  }
  view.statements = isText ? sourceLines(program, network) : statementLines(program, network, options);
  return view;
}

std::string blockHeading(const Pou& pou) {
  if (pou.type != BlockType::None)
    return pou.title.empty() ? step7::blockTitle(pou) : fmt::format("{}  {}", step7::blockTitle(pou), pou.title);
  constexpr std::string_view prefixes[] = {"OB", "SBR", "INT"};
  std::string heading =
      pou.isInstance ? pou.name
                     : fmt::format("{} ({}{})", pou.name, prefixes[static_cast<std::size_t>(pou.kind)], pou.number);
  if (!pou.title.empty()) heading += "  " + pou.title;
  return heading;
}

std::vector<std::string> contentLines(const NetworkView& view, const TextStyle& style) {
  const Paint paint{style.color};
  std::vector<std::string> lines;
  if (!view.reason.empty()) lines.push_back("shown as STL: " + view.reason);
  if (view.notExecuted) lines.emplace_back("not executed in this scan");
  if (view.picture.height > 0) {
    for (std::string& line : textLines(view.picture, style)) lines.push_back(std::move(line));
  }
  for (const std::string& line : view.statements) lines.push_back("  " + line);
  for (const ViewNote& note : view.notes) {
    const std::string word = note.severity == Severity::Error     ? paint.red("error")
                             : note.severity == Severity::Warning ? paint.yellow("warning")
                                                                  : paint.blue("note");
    lines.push_back(fmt::format("  {} {}", word, note.text));
  }
  return lines;
}

std::string viewText(const std::vector<BlockView>& blocks, const TextStyle& style) {
  const Paint paint{style.color};
  std::string text;
  for (const BlockView& block : blocks) {
    if (!text.empty()) text += "\n";
    text += paint.bold(block.heading) + "\n";
    if (!block.declarations.empty()) text += "\n";
    for (const std::string& line : block.declarations) text += "  " + line + "\n";
    for (const NetworkView& view : block.networks) {
      text += "\n" + paint.bold(view.heading) + "\n";
      for (const std::string& comment : view.comments) {
        const bool isDirective = comment.starts_with('@') || comment.starts_with('!');
        text += (isDirective ? "//" : "// ") + comment + "\n";
      }
      for (const std::string& line : contentLines(view, style)) text += line + "\n";
    }
  }
  return text;
}

}  // namespace rungproof
