// From arguments to two programs.
#include "frontend/sides/sides.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/access_index.hpp"
#include "analysis/unread/idle_blocks.hpp"
#include "engine/trace.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/sides/block_comparison.hpp"
#include "frontend/sides/map_file.hpp"
#include "frontend/sides/variable_pairs.hpp"
#include "frontend/simulation/trace_file.hpp"
#include "frontend/stl/missing_address.hpp"
#include "ir/s7200/event.hpp"

namespace rungproof {

namespace {

constexpr std::string_view oldPrefix = "old:", newPrefix = "new:";

bool overlaps(const TraceSignal& signal, const Address& first, std::uint32_t count) {
  const Address own = addressOf(signal.operand);
  return own.area == first.area && own.index < first.index + count &&
         first.index < own.index + extentOf(signal.operand);
}
bool isUsed(const std::vector<TraceSignal>& signals, const Address& first, std::uint32_t count) {
  return std::ranges::any_of(signals, [&](const TraceSignal& signal) { return overlaps(signal, first, count); });
}

/// Whether an ATCH names that event, or one that only the running program knows.
bool mayAttach(const Program& program, int event) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (roleOf(instruction) != Role::Atch || instruction.operands.size() != 2) continue;
        const Operand& attached = instruction.operands[1];
        if (attached.kind != OperandKind::Constant || attached.value == event) return true;
      }
    }
  }
  return false;
}

/// The input, timer or counter that an event comes from; nothing for ports, pulse trains and timed interrupts.
std::optional<Address> sourceOf(int event) {
  constexpr std::string_view counter = "HSC";
  if (isEdgeEvent(event)) return Address{Area::I, edgeInputFor(event).bit};
  const std::string_view text = eventInfo(event).text;
  if (text.starts_with(counter)) return Address{Area::HC, static_cast<std::uint32_t>(text[counter.size()] - '0')};
  for (const std::uint32_t timer : {32U, 96U}) {
    if (eventOfTimer(timer) == event) return Address{Area::T, timer};
  }
  return std::nullopt;
}

/// Whether an interrupt of the program comes from one of these addresses, which no instruction need name.
bool isSource(const Program& program, const Address& first, std::uint32_t count) {
  return std::ranges::any_of(eventTable, [&](const EventInfo& info) {
    const std::optional<Address> source = sourceOf(info.event);
    return source && source->area == first.area && source->index >= first.index &&
           source->index < first.index + count && mayAttach(program, info.event);
  });
}

std::string nameOfSource(const Address& source) {
  Operand operand = operandAt(source);
  if (source.area == Area::HC) operand.width = Width::DWord;
  return toString(operand);
}

void readPairs(const Context& context, const std::string& name, Sides& sides, std::vector<Failure>& failures) {
  const std::optional<std::string> text = readFile(context, name, failures);
  if (!text) return;
  const std::vector<TraceSignal> before = touchedSignals(sides.before.program),
                                 after = touchedSignals(sides.after.program);
  std::vector<MapLine> events;
  for (const MapLine& line : readMap(name, *text, sides.before.program, sides.after.program, failures)) {
    const std::string place = fmt::format("{}:{}", name, line.line);
    if (line.events) {
      const auto& [old, now] = *line.events;
      if (!mayAttach(sides.before.program, old) && !mayAttach(sides.after.program, now))
        failures.push_back({"neither program attaches what this line pairs", place, "remove the line, or mend it"});
      else if (!sides.pairs.addEvent(old, now))
        failures.push_back({"an event of this line has a partner already", place, "pair each event once"});
      else
        events.push_back(line);
      continue;
    }
    const bool isNamed = isUsed(before, line.before, line.count) || isUsed(after, line.after, line.count) ||
                         isSource(sides.before.program, line.before, line.count) ||
                         isSource(sides.after.program, line.after, line.count);
    if (!isNamed)
      failures.push_back(
          {"neither program uses what this line pairs", place, "remove the line, or mend the addresses"});
    else if (!sides.pairs.add(line.before, line.after, line.count))
      failures.push_back({"an address of this line has a partner already", place, "pair each address once"});
  }
  for (const MapLine& line : events) {
    const std::optional<Address> old = sourceOf(line.events->first), now = sourceOf(line.events->second);
    if (!old || sides.pairs.before(*now) == old) continue;
    const std::string one = nameOfSource(*old), other = nameOfSource(*now);
    failures.push_back({fmt::format("event {} comes from {}, event {} from {}, which do not stand for each other",
                                    line.events->first, one, line.events->second, other),
                        fmt::format("{}:{}", name, line.line), fmt::format("pair them too: {} = {}", one, other)});
  }
}

/// Lines of a property file for one side, by the prefixes in them: a line that names the other side becomes empty, and
/// the own prefix becomes blank, so that places stay what they are.
std::string linesFor(std::string text, std::string_view own, std::string_view other) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::size_t stop = std::min(text.find('#', begin), end);
    bool namesOther = false;
    for (std::size_t i = begin; i < stop; ++i) {
      const bool isStart =
          i == begin || (std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0 && text[i - 1] != '_');
      if (isStart && text.compare(i, other.size(), other) == 0) namesOther = true;
      if (isStart && text.compare(i, own.size(), own) == 0)
        std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(i), own.size(), ' ');
    }
    if (namesOther)
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end),
                ' ');
    begin = end + 1;
  }
  return text;
}

/// The lines that name both sides; the others become empty.
std::string linesForBoth(std::string text) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    const bool namesBoth =
        line.find(oldSidePrefix) != std::string_view::npos && line.find(newSidePrefix) != std::string_view::npos;
    if (!namesBoth)
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end),
                ' ');
    begin = end + 1;
  }
  return text;
}

void readPairAssumptions(Sides& sides, const std::string& name, const std::string& text) {
  const std::uint32_t file = sides.before.program.sources->add(name, text);
  const OperandLookup ofOld = lookupIn(sides.before.program), ofNew = lookupIn(sides.after.program);
  const auto lookup = [&](std::string_view word) -> std::optional<Operand> {
    if (word.starts_with(oldSidePrefix)) return ofOld(word.substr(oldSidePrefix.size()));
    if (!word.starts_with(newSidePrefix)) return ofOld(word);
    std::optional<Operand> operand = ofNew(word.substr(newSidePrefix.size()));
    if (operand) operand->text = std::string(word);
    return operand;
  };
  PropertySet set;
  readPropertyText(file, linesForBoth(text), 0, lookup, set, sides.before.program.findings);
  for (Property& property : set.properties) {
    if (!property.isGoal()) sides.assumptions.push_back(std::move(property));
  }
}

ProgramInput readSide(const Settings& settings, const std::vector<std::string>& files) {
  ProgramInput input;
  input.program = readProgram(files, readOptionsOf(settings));
  applyProjectSettings(settings, input.program);
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  addSurroundings(settings, input);
  return input;
}

/// `lines`: what of the text is said of this program; the rest is blank.
void addProperties(ProgramInput& input, const std::string& name, const std::string& text, const std::string& lines) {
  const std::uint32_t file = input.program.sources->add(name, text);
  readPropertyText(file, lines, 0, withReals(input.program, lookupIn(input.program)), input.properties,
                   input.program.findings, &input.program.target);
}

/// An address of OLD by its name there, or by a symbol that only NEW has.
std::optional<Operand> observedNamed(const Sides& sides, const std::string& text) {
  if (std::optional<Operand> own = lookupIn(sides.before.program)(text)) return own;
  const std::optional<Operand> there = lookupIn(sides.after.program)(text);
  return there ? sides.pairs.before(*there) : std::nullopt;
}

/// Gives data blocks of both programs the values that they have in OLD, as far as they have the same length.
void takeValues(const Program& before, Program& after) {
  for (DataBlock& block : after.dataBlocks) {
    const auto old = std::ranges::find(before.dataBlocks, block.number, &DataBlock::number);
    if (old != before.dataBlocks.end() && old->bytes.size() == block.bytes.size()) block.bytes = old->bytes;
  }
}

/// What constrains runs; what is to be proved of one program is no part of a comparison.
void keepAssumptions(PropertySet& set) {
  std::erase_if(set.properties, [](const Property& property) { return property.isGoal(); });
}

/// Data blocks that neither program can open and nothing asks for. A map may pair them with others.
void leaveOutIdleBlocks(Sides& sides) {
  if (!sides.pairs.empty()) return;
  NamedBlocks named;
  for (const ProgramInput* input : {&sides.before, &sides.after}) {
    named.addText(input->program);
    named.addQuestions(input->properties);
  }
  for (const Operand& operand : sides.observed) named.add(operand);
  for (const Property& assumption : sides.assumptions) {
    for (const Operand* operand : addressesOf(assumption)) named.add(*operand);
  }
  leaveOutBlocks(sides.before.program, named);
  leaveOutBlocks(sides.after.program, named);
}

}  // namespace

void SideArguments::declare(ArgumentTable& table) {
  table.argument("OLD", before, "a program: a file or a folder");
  table.argument("NEW", after, "the program that it is compared with");
  table.option("--with", with, "SIDE:FILE", "one more file of a side, as old:symbols.sdf; may be repeated");
  table.flag("--as-downloaded", asDownloaded, asDownloadedHelp);
  table.word("--values", values, {"own", "old"}, "own|old",
             "old: data blocks of both programs begin with the values that they have in OLD");
  table.option("--map", map, "FILE", "addresses that stand for each other: OLD-address = NEW-address, one pair a line");
  table.list("--observe", observed, "ADDRESS", "compare these addresses of OLD instead of all outputs");
  table.option("--props", properties, "FILE",
               "property file whose assumptions hold; old. and new. before an address name a side");
}

Sides readSides(const Context& context, const SideArguments& arguments, std::vector<Failure>& failures) {
  Sides sides;
  sides.filesBefore = expandFolders({arguments.before}, context.side(ProgramSide::Old));
  sides.filesAfter = expandFolders({arguments.after}, context.side(ProgramSide::New));
  for (const std::string& text : arguments.with) {
    if (text.starts_with(oldPrefix))
      sides.filesBefore.push_back(text.substr(oldPrefix.size()));
    else if (text.starts_with(newPrefix))
      sides.filesAfter.push_back(text.substr(newPrefix.size()));
    else
      failures.push_back(
          {fmt::format("--with {} names no side", text), {}, "write --with old:FILE or --with new:FILE"});
  }
  sides.before = readSide(context.side(ProgramSide::Old), sides.filesBefore);
  sides.after = readSide(context.side(ProgramSide::New), sides.filesAfter);
  sides.storedBefore = storedBlocksOf(sides.filesBefore, context.side(ProgramSide::Old));
  sides.storedAfter = storedBlocksOf(sides.filesAfter, context.side(ProgramSide::New));
  if (arguments.values == "old") takeValues(sides.before.program, sides.after.program);
  const bool hasVariables = dialectOf(sides.before.program.target).memory.isOfVariables;
  const bool isOneIec = hasVariables != dialectOf(sides.after.program.target).memory.isOfVariables;
  if (isOneIec) sides.pairs.separate();
  guessFamily(context, {{&context.side(ProgramSide::Old), &sides.before.program},
                        {&context.side(ProgramSide::New), &sides.after.program}});
  for (const std::string& name : arguments.properties) {
    const std::optional<std::string> text = readFile(context, name, failures);
    if (!text) continue;
    addProperties(sides.before, name, *text, linesFor(*text, oldSidePrefix, newSidePrefix));
    addProperties(sides.after, name, *text, linesFor(*text, newSidePrefix, oldSidePrefix));
    readPairAssumptions(sides, name, *text);
  }
  keepAssumptions(sides.before.properties);
  keepAssumptions(sides.after.properties);
  if (!arguments.map.empty()) readPairs(context, arguments.map, sides, failures);
  for (const std::string& text : arguments.observed) {
    const auto operand = observedNamed(sides, text);
    const auto missing = operand ? missingFrom(sides.before.program.target, *operand) : std::nullopt;
    if (missing)
      failures.push_back({fmt::format("--observe: {}", *missing),
                          {},
                          operand->bit > 7 ? "mend the address" : "mend the address, or choose the CPU with --cpu"});
    else if (!operand)
      failures.push_back({fmt::format("--observe: '{}' is neither an address nor a symbol of either program", text),
                          {},
                          "name an address of OLD, or give the symbol table with --symbols"});
    else if (operand->area == Area::L || operand->area == Area::AC || operand->area == Area::HC ||
             isInputArea(operand->area))
      failures.push_back({fmt::format("--observe: {} is no output and no memory", text),
                          {},
                          "name addresses of Q, AQ, V, M, S, SM, T or C"});
    else
      sides.observed.push_back(*operand);
  }
  if (isOneIec)
    pairWithOtherFamily(sides, failures);
  else if (hasVariables)
    pairVariables(sides, failures);
  if (arguments.asDownloaded) {
    sides.leftOutBefore = leaveOut(sides.before.program);
    sides.leftOutAfter = leaveOut(sides.after.program);
    std::erase_if(sides.leftOutAfter, [&](const std::string& line) {  // of a file that both have
      return std::ranges::find(sides.leftOutBefore, line) != sides.leftOutBefore.end();
    });
  }
  sides.blocks = compareBlocks(sides);
  leaveOutIdleBlocks(sides);
  sides.unreadBefore = std::make_unique<UnreadCode>(sides.before.program, context.settings.choices());
  sides.unreadAfter = std::make_unique<UnreadCode>(sides.after.program, context.settings.choices());
  const auto whatRuns = [](const Program& program, const UnreadCode& unread) {
    return std::make_unique<Program>(unread.isWhole() ? program : unread.executable());
  };
  sides.runBefore = whatRuns(sides.before.program, *sides.unreadBefore);
  sides.runAfter = whatRuns(sides.after.program, *sides.unreadAfter);
  return sides;
}

}  // namespace rungproof
