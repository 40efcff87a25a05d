// The cone of a question is followed through next-state functions; words for people are put together here once.
#include "analysis/proof/question_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "analysis/encoding/accelerate.hpp"
#include "analysis/encoding/exact_reals.hpp"
#include "analysis/graph/evaluate.hpp"
#include "engine/device_end.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/organization_block.hpp"

namespace rungproof {

QuestionSystem::QuestionSystem(const Program& program, const PropertySet& set, const std::vector<Property>& goals,
                               const EncoderOptions& options, const CheckGroups& groups)
    : record_(program, groups.lint, static_cast<bool>(groups.further)),
      askedProperties_(program, set, goals, options, groups.any() ? &record_ : nullptr) {
  checks_ = ruleQuestions(program, set, groups, askedProperties_, record_);
  for (const RuleQuestion& check : checks_) askedProperties_.ask(check.name, check.bad);
  Graph& graph = askedProperties_.encoding().graph();
  Graph::Bool leftOut = graph.constant(false);
  for (const Approximation& approximation : askedProperties_.approximations()) {
    if (approximation.leftOut != noNode) leftOut = graph.lor(leftOut, {approximation.leftOut});
  }
  if (const auto known = graph.truth(leftOut); !known || *known) {
    leftOutQuestion_ = goals.size() + checks_.size();
    askedProperties_.ask("a scan that is not followed to its end", leftOut.node);
  }
  graph.decideBy(nullptr);
  system_ = withExactReals(askedProperties_.system(), RealScope::Comparisons);
  for (std::size_t i = 0; i < system_.questions.size(); ++i) system_.questions[i].number = i;
}

TransitionSystem QuestionSystem::only(std::size_t question) const {
  TransitionSystem one = system_;
  one.questions = {system_.questions[question]};
  return one;
}

std::unordered_set<std::uint32_t> QuestionSystem::variablesOf(std::size_t question) const {
  const Graph& graph = *system_.graph;
  std::unordered_map<std::uint32_t, Node> next;
  for (const StateVariable& state : system_.states) next[indexOf(state.node)] = state.next;
  std::vector<Node> open{system_.questions[question].bad};
  for (const Node constraint : system_.constraints) {
    if (std::find(system_.totalConstraints.begin(), system_.totalConstraints.end(), constraint) ==
        system_.totalConstraints.end())
      open.push_back(constraint);
  }
  std::unordered_set<std::uint32_t> seen, variables;
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    if (node == noNode || !seen.insert(indexOf(node)).second) continue;
    const NodeData& data = graph[node];
    if (isRealOperation(data.op)) variables.insert(indexOf(node));
    if (data.op == Op::Variable) {
      variables.insert(indexOf(node));
      if (const auto found = next.find(indexOf(node)); found != next.end()) open.push_back(found->second);
    }
    for (const Node child : data.child) open.push_back(child);
  }
  return variables;
}

std::size_t QuestionSystem::exactReals(std::size_t question) const {
  const auto variables = variablesOf(question);
  return static_cast<std::size_t>(std::ranges::count_if(
      variables, [&](std::uint32_t n) { return isExactReal((*system_.graph)[static_cast<Node>(n)]); }));
}

std::vector<const Approximation*> QuestionSystem::approximationsOf(std::size_t question, bool isWritten) {
  std::vector<const Approximation*> found;
  const Graph& graph = *system_.graph;
  const auto variables = variablesOf(question);
  for (const Approximation& approximation : askedProperties_.approximations()) {
    const bool isCarried = std::ranges::any_of(approximation.carriers, [&](Node n) {
      return n != noNode && variables.contains(indexOf(n)) && !(isWritten && isExactReal(graph[n]));
    });
    if (isCarried) found.push_back(&approximation);
  }
  return found;
}

bool QuestionSystem::dependsOnTime(const std::unordered_set<std::uint32_t>& variables) const {
  return std::any_of(system_.states.begin(), system_.states.end(), [&](const StateVariable& s) {
    return variables.contains(indexOf(s.node)) && askedProperties_.isTimeState(s.node);
  });
}

TransitionSystem QuestionSystem::accelerated(std::size_t question, const TimeRange& ordinary) {
  TransitionSystem one = only(question);
  const auto variables = variablesOf(question);
  const TimeModel& time = askedProperties_.encoding().time();
  std::unordered_set<std::uint32_t> ofTime;
  for (const StateVariable& s : time.states()) ofTime.insert(indexOf(s.node));
  for (const Node input : time.inputs()) ofTime.insert(indexOf(input));
  const auto isIdle = [&](Node n) { return !variables.contains(indexOf(n)) && !ofTime.contains(indexOf(n)); };
  std::erase_if(one.states, [&](const StateVariable& s) { return isIdle(s.node); });
  std::erase_if(one.inputs, isIdle);
  // Total constraints over idle inputs can always be met by these.
  std::erase_if(one.constraints, [&](Node constraint) {
    const Node roots[] = {constraint};
    const bool isTotal = std::ranges::find(one.totalConstraints, constraint) != one.totalConstraints.end();
    return isTotal && std::ranges::any_of(coneOf(*one.graph, roots),
                                          [&](Node n) { return (*one.graph)[n].op == Op::Variable && isIdle(n); });
  });
  accelerate(one, time.dt(), time.width(), ordinary, [&](Node n) { return askedProperties_.isTimeState(n); });
  return one;
}

/// Of an S7-300/400: the errors that stop it because it has no block for them. A run ends there.
std::optional<std::string> missingBlocksText(const Program& program) {
  const auto isMissing = [&](int block) {
    const BlockEventRow* row = blockEventRow(block);
    return row != nullptr && row->withoutBlock == WithoutBlock::Stop &&
           std::ranges::none_of(program.pous,
                                [&](const Pou& pou) { return pou.number == blockNumber(BlockType::Ob, block); });
  };
  std::vector<std::string> runs;
  for (int block = 80; block <= 87; ++block) {
    if (!isMissing(block)) continue;
    const int first = block;
    while (isMissing(block + 1)) ++block;
    runs.push_back(first == block ? fmt::format("OB{}", first) : fmt::format("OB{} to OB{}", first, block));
  }
  if (runs.empty()) return std::nullopt;
  return fmt::format("nothing is asked of a CPU that has stopped because it has no block for an event: {} (002:1278)",
                     fmt::join(runs, ", "));
}

std::vector<std::string> environmentTexts(const Program& program, const PropertySet& set, const TimeRange& time,
                                          const Choices& choices) {
  std::vector<std::string> texts;
  const Dialect& dialect = dialectOf(program.target);
  const bool isOfVariables = dialect.memory.isOfVariables;
  if (!dialect.text.hasProducts)
    texts.push_back(fmt::format("program of {}", dialect.title));
  else
    texts.push_back(
        editionModel(program.target.edition).isFirmware
            ? fmt::format("CPU {}, {}", cpuName(program.target.cpu), editionName(program.target.edition))
            : fmt::format("CPU {}, {} edition", cpuName(program.target.cpu), editionName(program.target.edition)));
  texts.push_back(time.low == time.high ? fmt::format("every scan lasts {} ms", time.low)
                                        : fmt::format("every scan lasts {} to {} ms", time.low, time.high));
  texts.push_back(set.initialRetentive ? "retentive memory starts with any value, the rest with zero"
                  : isOfVariables      ? "every variable starts with its initial value"
                                       : "memory starts with zero and the data block");
  const bool hasColdStart =
      std::ranges::any_of(program.pous, [](const Pou& pou) { return pou.number == blockNumber(BlockType::Ob, 102); });
  if (program.coldStart || hasColdStart)
    texts.push_back(fmt::format("runs begin with a {} restart", program.coldStart ? "cold" : "warm"));
  const bool hasHotStart =
      std::ranges::any_of(program.pous, [](const Pou& pou) { return pou.number == blockNumber(BlockType::Ob, 101); });
  if (hasHotStart && choices.is(Choice::HotRestart, "excluded")) texts.emplace_back("no hot restart comes");
  if (dialect.run.startsBlocks) {
    if (std::optional<std::string> text = missingBlocksText(program)) texts.push_back(*std::move(text));
    std::ranges::move(s7300::startTexts(program), std::back_inserter(texts));
  }
  const auto named = [&](const Operand& operand) {
    return isOfVariables && !std::string_view(operand.text).empty() ? std::string(operand.text) : toString(operand);
  };
  for (const ExternalRange& range : set.externals) {
    const std::string first = named(range.first), last = named(range.last);
    texts.push_back(first == last ? fmt::format("{} has any value in every scan", first)
                                  : fmt::format("{} to {} may be written from outside in any scan", first, last));
  }
  if (asksDevices(program))
    texts.push_back("what ports, pulse outputs and other devices write for a request, they write between two scans");
  texts.emplace_back(set.externals.empty()
                         ? "nothing outside the program writes its memory: no panel, no network ('external' names it)"
                         : "nothing else outside the program writes its memory");
  for (const Property& property : set.properties) {
    if (!property.isGoal()) texts.push_back(property.text);
  }
  return texts;
}

std::string placeText(const Program& program, const Instruction& instruction) {
  const Span span = instruction.span;
  return fmt::format("{} at {}:{}", instruction.desc->stl, program.sources->file(span.file).name(),
                     program.sources->position(span).line);
}

std::string approximationText(const Program& program, const Approximation& approximation) {
  if (approximation.place == nullptr) return approximation.reason;
  return fmt::format("{}: {}", placeText(program, *approximation.place), approximation.reason);
}

bool isWrittenOut(const Graph& graph, const Approximation& approximation) {
  return !approximation.carriers.empty() &&
         std::ranges::all_of(approximation.carriers, [&](Node n) { return n != noNode && isExactReal(graph[n]); });
}

std::vector<std::string> approximationTexts(const Program& program, AskedProperties& askedProperties) {
  std::vector<std::string> texts;
  for (const Approximation& approximation : askedProperties.approximations()) {
    if (!isWrittenOut(askedProperties.encoding().graph(), approximation))
      texts.push_back(approximationText(program, approximation));
  }
  return texts;
}

}  // namespace rungproof
