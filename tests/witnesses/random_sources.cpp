// Texts from the generators of the other tests.
#include "tests/witnesses/random_sources.hpp"

#include <algorithm>
#include <set>

#include "analysis/unread/unread_code.hpp"
#include "frontend/input/project.hpp"
#include "tests/differential/program_generator.hpp"
#include "tests/iec/random_iec_program.hpp"
#include "tests/naive7/program_generator.hpp"

namespace rungproof::test {
namespace {

constexpr int propertiesEach = 4;
constexpr std::uint32_t surroundingsPercent = 15;
constexpr int mostRefused = 200;  ///< lines that are taken out of one program

/// What properties may name.
struct Named {
  std::vector<std::string> bits, words, surroundings;
};

/// "never Q0.0", "VW2 <> 3": over what the lines touch, now and then in harsher surroundings.
std::string propertiesOver(const Named& named, RandomSource& random) {
  std::string lines;
  for (const std::string& line : named.surroundings) {
    if (random.chance(surroundingsPercent)) lines += "//@ " + line + "\n";
  }
  for (int i = 0; i < propertiesEach; ++i) {
    lines += "//@ prove p" + std::to_string(i) + ": ";
    const std::string& bit = random.oneOf(named.bits);
    switch (random.below(8)) {
      case 0: lines += "never " + bit; break;
      case 5: lines += "rises(" + bit + ") implies " + random.oneOf(named.bits); break;
      case 6: lines += bit + " held 200ms implies " + random.oneOf(named.bits); break;
      case 7: lines += bit + " leads to " + random.oneOf(named.bits) + " within 3 scans"; break;
      case 1: lines += "always " + bit; break;
      case 2: lines += bit + " implies prev(" + random.oneOf(named.bits) + ")"; break;
      case 3: lines += random.oneOf(named.words) + " <> " + std::to_string(random.below(4)); break;
      default: lines += "never " + bit + " and " + random.oneOf(named.bits); break;
    }
    lines += "\n";
  }
  return lines;
}

std::string linesWithout(const std::string& text, const std::set<std::uint32_t>& without) {
  std::string kept;
  std::uint32_t line = 1;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    if (!without.contains(line)) kept += text.substr(at, end - at);
    at = end;
  }
  return kept;
}

/// Takes out what is refused or not executed, until nothing is.
void leaveWhatRuns(RandomText& source, const ReadOptions& options) {
  for (int i = 0; i < mostRefused; ++i) {
    const Program program = readText(source.name, source.text, options);
    const UnreadCode unread(program);
    std::set<std::uint32_t> refused;
    const auto lineAt = [&](Span span) {
      const auto begin = source.text.begin();
      return static_cast<std::uint32_t>(
          1 + std::count(begin, begin + std::min<std::ptrdiff_t>(span.offset, std::ssize(source.text)), '\n'));
    };
    for (const auto& findings : {program.findings, unread.findings()}) {
      for (const Finding& finding : findings) {
        if (finding.severity == Severity::Error) refused.insert(lineAt(finding.span));
      }
    }
    for (const UnreadPart& part : unread.parts()) refused.insert(lineAt(part.span));
    if (refused.empty()) return;
    source.text = linesWithout(source.text, refused);
  }
}

std::string s7200Block(const RandomProgram::Block& block) {
  const bool isMain = block.kind == PouKind::Main, isSub = block.kind == PouKind::Subroutine;
  const std::string number = std::to_string(block.number);
  const std::string kind = isMain ? "ORGANIZATION" : isSub ? "SUBROUTINE" : "INTERRUPT";
  std::string text = kind + "_BLOCK ";
  text += isMain ? "MAIN:OB1" : isSub ? "SBR_" + number + ":SBR" + number : "INT_" + number + ":INT" + number;
  text += "\n";
  if (!block.locals.empty())
    text += "VAR_INPUT\na:BOOL;\nb:WORD;\nEND_VAR\nVAR_IN_OUT\nc:BYTE;\nEND_VAR\nVAR_OUTPUT\nd:WORD;\nEND_VAR\n";
  text += "BEGIN\nNetwork 1\n";
  for (const Instruction& instruction : block.instructions) {
    text += instruction.desc->stl;
    const bool isCall = instruction.desc->stl == "CALL", isAttach = instruction.desc->stl == "ATCH";
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      const bool isBlock = i == 0 && (isCall || isAttach) && operand.kind == OperandKind::Constant;
      text += i == 0 ? " " : ", ";
      text += isBlock ? (isCall ? "SBR_" : "INT_") + std::to_string(operand.value) : toString(operand);
    }
    text += "\n";
  }
  return text + "END_" + kind + "_BLOCK\n";
}

}  // namespace

RandomText randomS7200Text(std::uint64_t seed, Target target) {
  RandomSource random(seed);
  GeneratorOptions options;
  options.rungs = 3 + static_cast<int>(random.below(6));
  options.jumps = random.chance(40);
  options.loops = random.chance(20);
  options.subroutines = random.chance(40);
  options.interrupts = random.chance(30);
  options.pointers = random.chance(30);
  options.target = target;
  const RandomProgram program = randomProgram(random, options);
  const Named named = {{"Q0.0", "Q0.1", "Q0.2", "Q0.3", "M0.0", "M0.1", "M1.2", "V0.1", "V2.7", "T37", "C0", "I0.1"},
                       {"VB0", "VW2", "VB3", "MB0", "QB0", "T37.value", "C0.value"},
                       {"initial retentive", "external VB2..VB3"}};
  RandomText source = {"random.awl", propertiesOver(named, random), {"--cpu", std::string(cpuName(target.cpu))}};
  for (const RandomProgram::Block& block : program.blocks) source.text += s7200Block(block);
  ReadOptions read;
  read.target = target;
  leaveWhatRuns(source, read);
  return source;
}

RandomText randomStep7Text(std::uint64_t seed) {
  RandomSource random(seed);
  naive7::GeneratorChoices choices;
  choices.is400 = random.chance(50);
  choices.interrupts = random.chance(30);
  choices.snippets = 2 + static_cast<int>(random.below(6));
  const Named named = {{"Q0.0", "Q0.1", "M0.0", "M1.1", "M2.3", "M10.0", "I0.1", "T1", "C1"},
                       {"MW4", "MB1", "MW10", "QB0", "MD200"},
                       {"initial retentive", "external MB1"}};
  RandomText source = {"random.awl",
                       propertiesOver(named, random) + naive7::ProgramGenerator(seed, choices).program(),
                       {"--dialect", choices.is400 ? "s7-400" : "s7-300"}};
  ReadOptions read;
  read.dialect = source.options.back();
  leaveWhatRuns(source, read);
  return source;
}

// The generator of ST leaves out timers, counters, edges, what is kept, and places of the process image.
RandomText randomIecText(std::uint64_t seed) {
  RandomSource random(seed);
  const std::string generated = iec_random::IecProgram(seed).text();
  const std::size_t declarations = generated.find('\n') + 1, end = generated.find("END_PROGRAM");
  const Named named = {{"b0", "b1", "b2", "y0", "q0", "t0.Q", "c0.Q"},
                       {"i0", "i1", "d0", "u0", "w0", "kept", "c0.CV"},
                       {"initial retentive"}};
  return {"random.st",
          propertiesOver(named, random) + generated.substr(0, declarations) +
              "VAR t0 : TON; t1 : TP; c0 : CTU; e0 : R_TRIG; s0 AT %IX0.0 : BOOL; q0 AT %QX0.0 : BOOL; END_VAR\n"
              "VAR RETAIN kept : INT; END_VAR\n" +
              generated.substr(declarations, end - declarations) +
              "t0(IN := b0, PT := T#250ms);\nt1(IN := s0, PT := T#70ms);\nc0(CU := t1.Q, R := b1, PV := 3);\n"
              "e0(CLK := b2);\nIF e0.Q THEN kept := kept + i0; END_IF;\nq0 := t0.Q OR s0 AND c0.Q;\nEND_PROGRAM\n",
          {}};
}

RandomText otherVersion(const RandomText& source, std::uint64_t seed) {
  std::set<std::uint32_t> outputs, markers;
  std::uint32_t line = 1;
  for (std::size_t at = 0; at < source.text.size(); ++line) {
    const std::size_t end = std::min(source.text.find('\n', at), source.text.size());
    std::string_view text = std::string_view(source.text).substr(at, end - at);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    const bool isAssignment = text.starts_with("= ") || text.starts_with("S ") || text.starts_with("R ") ||
                              text.starts_with("T ") || text.starts_with("MOV");
    if (isAssignment) (text.find(" Q") != std::string_view::npos ? outputs : markers).insert(line);
    at = end + 1;
  }
  RandomText other = source;
  const std::set<std::uint32_t>& candidates = outputs.empty() ? markers : outputs;
  if (candidates.empty()) return other;
  const auto chosen = std::next(candidates.begin(), static_cast<std::ptrdiff_t>(seed % candidates.size()));
  other.text = linesWithout(source.text, {*chosen});
  return other;
}

}  // namespace rungproof::test
