// Bodies that run: as routines, or written out for the variables that stand for their IN_OUT.
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

/// Whether two IN_OUT of a call are one place, or one of them is a global variable, which the body may know as well.
bool Lowering::mayMeet(const Scope& inner) const {
  const auto overlaps = [](const Reference& a, std::uint32_t offset, std::uint32_t bytes) {
    return a.offset < offset + bytes && offset < a.offset + a.type->bytes;
  };
  for (auto one = inner.inOuts.begin(); one != inner.inOuts.end(); ++one) {
    const Reference& place = one->second;
    for (auto other = std::next(one); other != inner.inOuts.end(); ++other) {
      if (overlaps(place, other->second.offset, other->second.type->bytes)) return true;
    }
    for (const auto& [name, global] : globals_) {
      if (global.type != nullptr && overlaps(place, global.offset, global.type->bytes)) return true;
    }
  }
  return false;
}

/// IN_OUT by reference, or by copies that are written back behind the body in the order of the declaration.
void Lowering::runWithInOuts(Scope& scope, BlockInstance& instance, Scope& inner, Span span) {
  if (!mayMeet(inner)) return runBody(scope, instance, inner, span);
  const int direct = newLabel(), end = newLabel();
  emit("READING", {static_cast<std::int64_t>(Choice::IecInout), 1});
  jumpIfFalse(direct);
  Scope copied = inner;
  std::vector<std::pair<Reference, Reference>> back;
  for (const VariableSyntax& variable : instance.block->variables) {
    const auto given = copied.inOuts.find(foldedName(variable.name));
    if (variable.section != Section::InOut || given == copied.inOuts.end() || given->second.type->bytes == 0) continue;
    Reference own = given->second;
    own.offset = allocate(own.type->bytes);
    copy(scope, given->second, own);
    back.emplace_back(own, given->second);
    given->second = own;
  }
  runBody(scope, instance, copied, span);
  for (const auto& [own, given] : back) copy(scope, own, given);
  jump(end);
  label(direct);
  runBody(scope, instance, inner, span);
  label(end);
}

void Lowering::runBody(Scope& scope, BlockInstance& instance, Scope& inner, Span span) {
  instance.isCalled = true;
  madeBlocks_.insert(instance.block);
  if (instance.isOpen) refuse(span, fmt::format("{} calls itself", instance.block->name));
  if (!instance.hasInOut) {
    constexpr int mostOpen = 500;
    if (instance.routine < 0 && openRoutines_ >= mostOpen) refuse(span, "calls are nested too deeply");
    if (instance.routine < 0) makeRoutine(instance);
    return emit("CAL", {instance.routine});
  }
  constexpr int deepest = 32;
  if (depth_ >= deepest) refuse(span, "calls are nested too deeply");
  ++depth_;
  inner.caller = &scope;
  inner.returnLabel = newLabel();
  instance.isOpen = true;
  try {
    freshLocals(inner);
    beginList(inner, instance.block->body);
    statements(inner, instance.block->body);
    endList(inner);
  } catch (const Refused&) {
    instance.isOpen = false;
    --depth_;
    throw;
  }
  instance.isOpen = false;
  --depth_;
  label(inner.returnLabel);
}

}  // namespace rungproof::iec
