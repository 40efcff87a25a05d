// What each kind of statement does to RLO, /FC, BR and parentheses.
#include "analysis/flow/logic_string.hpp"

namespace rungproof {

namespace {

void make(LogicState& state, BitValues rlo, BitValues firstCheck) {
  state.rlo = rlo;
  state.rloMaker = byBlock;
  state.firstCheck = firstCheck;
}

void closeLevel(LogicState& state) {
  if (state.depth != 0 && state.depth != LogicState::unknownDepth) --state.depth;
  make(state, mayBeAny, mayBe1);
}

void applyStatement(LogicState& state, std::uint32_t at, StatementRole role) {
  switch (role) {
    case StatementRole::AndScan:
      // What a string begins with may be either; joined with 0 it stays 0.
      return make(state, state.firstCheck == mayBe1 && state.rlo == mayBe0 ? mayBe0 : mayBeAny, mayBe1);
    case StatementRole::OrScan:
      return make(state, state.firstCheck == mayBe1 && state.rlo == mayBe1 ? mayBe1 : mayBeAny, mayBe1);
    case StatementRole::OrOfAnds: state.rlo = mayBeAny; return;
    case StatementRole::XorScan:
    case StatementRole::Compare:
    case StatementRole::CompareRealEqual:
    case StatementRole::Edge: return make(state, mayBeAny, mayBe1);
    case StatementRole::Open:
      if (state.depth < nestingLevels) state.opened[state.depth++] = at;
      state.firstCheck = mayBe0;
      return;
    case StatementRole::Close: return closeLevel(state);
    case StatementRole::Negate:
      state.rlo = static_cast<BitValues>((state.rlo & mayBe0) << 1 | (state.rlo & mayBe1) >> 1);
      return;
    case StatementRole::SetRlo: return make(state, mayBe1, mayBe0);
    case StatementRole::ClearRlo: return make(state, mayBe0, mayBe0);
    case StatementRole::Save: state.brMaker = byBlock; return;
    case StatementRole::JumpKeepingRlo: state.brMaker = byBlock; return make(state, mayBe1, mayBe0);
    case StatementRole::JumpByRlo:
    case StatementRole::EndByRlo: return make(state, mayBe1, mayBe0);
    case StatementRole::TransferStatus: state.brMaker = byBlock; return make(state, mayBeAny, mayBe0);
    case StatementRole::Call:
    case StatementRole::CallByRlo:
      state.rlo = mayBeAny;
      state.rloMaker = state.brMaker = byCallee;
      state.firstCheck = mayBe0;
      return;
    case StatementRole::JumpByBr:
    case StatementRole::OpenRelay: state.firstCheck = mayBe0; return;
    default:
      if (drivesBit(role) || drivesElement(role)) state.firstCheck = mayBe0;
      return;
  }
}

}  // namespace

bool LogicState::join(const LogicState& other) {
  const LogicState old = *this;
  firstCheck |= other.firstCheck;
  rlo |= other.rlo;
  rloMaker |= other.rloMaker;
  brMaker |= other.brMaker;
  if (depth != other.depth) depth = unknownDepth;
  return firstCheck != old.firstCheck || rlo != old.rlo || rloMaker != old.rloMaker || brMaker != old.brMaker ||
         depth != old.depth;
}

LogicStates logicStates(const Flow& flow) {
  const FlowStep* const first = flow.steps.data();
  return statesOf(flow, LogicState{}, [&](LogicState& state, const FlowStep& step) {
    applyStatement(state, static_cast<std::uint32_t>(&step - first), statementRole(*step.instruction));
  });
}

bool usesRlo(StatementRole role) {
  switch (role) {
    case StatementRole::Edge:
    case StatementRole::Negate:
    case StatementRole::Save:
    case StatementRole::JumpByRlo:
    case StatementRole::JumpKeepingRlo:
    case StatementRole::EndByRlo:
    case StatementRole::CallByRlo:
    case StatementRole::OpenRelay: return true;
    default: return drivesBit(role) || drivesElement(role);
  }
}

bool asksFirstCheck(StatementRole role) {
  return role == StatementRole::AndScan || role == StatementRole::OrScan || role == StatementRole::XorScan ||
         role == StatementRole::Open || role == StatementRole::OrOfAnds;
}

}  // namespace rungproof
