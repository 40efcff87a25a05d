// Goes through the blocks once; what an instruction means for its family says its reader.
#include "engine/coverage/coverage_map.hpp"

#include <algorithm>

#include "engine/coverage/logic_reader.hpp"
#include "ir/dialect.hpp"

namespace rungproof {

namespace {

std::unique_ptr<LogicReader> logicReader(CoverageMap& map) {
  switch (map.plan().form()) {
    case StatementForm::Accumulators: return rloReader(map);
    case StatementForm::Expressions: return expressionReader(map);
    case StatementForm::Rungs: break;
  }
  return stackReader(map);
}

}  // namespace

LogicNode LogicReader::leafOf(LeafKind kind, const Instruction& instruction, CoveragePlace place, bool isNegated) {
  const auto number = static_cast<std::uint32_t>(map_.leaves_.size());
  map_.leaves_.push_back({kind, &instruction, place});
  map_.sites_[instruction.id].leaf = static_cast<int>(number);
  map_.sites_[instruction.id].isWatched = true;
  const LogicNode node = trees().leaf(number);
  return isNegated ? trees().lnot(node) : node;
}

void LogicReader::decide(const Instruction& instruction, std::uint8_t level, LogicNode condition, CoveragePlace place) {
  Decision decision{&instruction, level, condition, {}, true, place};
  bool hasContact = false;
  for (const std::uint32_t leaf : trees().leavesOf(condition)) {
    const LeafKind kind = map_.leaves_[leaf].kind;
    if (kind == LeafKind::Hidden)
      decision.isWhole = false;
    else
      decision.leaves.push_back(leaf);
    hasContact = hasContact || kind == LeafKind::Contact;
  }
  if (!hasContact || !decision.isWhole) return;
  CoverageMap::Site& site = map_.sites_[instruction.id];
  if (site.decisions == 0) site.decision = static_cast<std::uint32_t>(map_.decisions_.size());
  ++site.decisions;
  site.isWatched = true;
  map_.decisions_.push_back(std::move(decision));
}

void LogicReader::output(const Instruction& instruction, bool needsPower, CoveragePlace place) {
  std::vector<CoveragePlace>& networks = map_.networks_;
  const bool isKnown =
      !networks.empty() && networks.back().pou == place.pou && networks.back().network == place.network;
  if (!isKnown) networks.push_back(place);
  CoverageMap::Site& site = map_.sites_[instruction.id];
  site.network = static_cast<int>(networks.size() - 1);
  site.isUnconditional = !needsPower;
  site.isWatched = true;
}

void LogicReader::transition(StepTransition made) {
  CoverageMap::Site& site = map_.sites_[made.instruction->id];
  site.transition = static_cast<int>(map_.transitions_.size());
  site.isWatched = true;
  map_.transitions_.push_back(std::move(made));
}

CoverageMap::CoverageMap(const Program& program, const Choices& choices)
    : program_(program), choices_(choices), plan_(program), sites_(program.instructionCount()) {
  const std::unique_ptr<LogicReader> reader = logicReader(*this);
  for (std::uint32_t p = 0; p < program.pous.size(); ++p) {
    const Pou& pou = program.pous[p];
    if (plan_.dialect().text.isForeign(program, pou) || pou.protectedBlock) continue;
    reader->beginBlock(pou);
    for (std::uint32_t n = 0; n < pou.networks.size(); ++n) {
      for (const Instruction& instruction : pou.networks[n].instructions) reader->read(instruction, {p, n});
    }
  }
}

std::string CoverageMap::placeText(CoveragePlace place) const {
  const Pou& pou = program_.pous[place.pou];
  return pou.name + ":" + std::to_string(pou.networks[place.network].number);
}

std::string CoverageMap::instructionText(const Instruction& instruction) const {
  const auto nameOf = [&](const Operand& operand) {
    const Symbol* symbol = plan_.dialect().memory.isOfVariables ? program_.symbolOf(operand) : nullptr;
    return symbol != nullptr ? symbol->name : toString(operand);
  };
  if (plan_.form() != StatementForm::Expressions) {
    std::string text(instruction.desc->stl);
    for (std::size_t i = 0; i < instruction.operands.size(); ++i)
      text += (i == 0 ? " " : ", ") + nameOf(instruction.operands[i]);
    return text;
  }
  if (!instruction.operands.empty() && instruction.operands[0].kind == OperandKind::Direct)
    return nameOf(instruction.operands[0]);
  if (instruction.desc->relation != Relation::None) return "comparison " + std::string(instruction.desc->stl);
  std::string text(program_.sources->text(instruction.span));
  return text.substr(0, text.find_first_of("\r\n"));
}

}  // namespace rungproof
