// What vector instructions do not do, trace by trace: division, functions of REAL numbers, and accesses whose addresses
// differ from trace to trace.
#include "engine/lanes/lane_code.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

namespace {

class NobodyOutside final : public Outside {
 public:
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};

std::uint64_t computedByTrace(const Step& s, std::uint64_t a, std::uint64_t b) {
  static NobodyOutside outside;
  static const Concrete d(outside);
  switch (s.op) {
    case CodeOp::Mul: return d.mul(a, b, s.width);
    case CodeOp::DivideUnsigned: return d.udiv(a, b, s.width);
    case CodeOp::RemainderUnsigned: return d.urem(a, b, s.width);
    case CodeOp::DivideSigned: return d.sdiv(a, b, s.width);
    case CodeOp::RemainderSigned: return d.srem(a, b, s.width);
    case CodeOp::RealFunction: return d.rfunction(s.value, a);
    case CodeOp::RealToInt: return d.rtoInt(a, s.value != 0);
    default: CHECK(false, "no step that is done trace by trace");
  }
  return 0;
}

/// The highest byte first. A trace that has left the code, or does not run, may have any address.
void accessByTrace(const StepByTrace& by, const LaneLayout& layout, std::uint8_t* rows, Rep rep) {
  const ReachedRows& reached = by.rows;
  const std::uint32_t bytes = by.step.width / 8U;
  const bool isLoad = by.step.op == CodeOp::LoadAt;
  for (std::size_t lane = 0; lane < layout.lanes; ++lane) {
    if (numberIn(rows, {layout.active(), Rep::Truth}, lane, layout.form) == 0) continue;
    const std::uint64_t address = numberIn(rows, {layout.scratch(0), Rep::Double}, lane, layout.form) + by.step.value;
    if (address < reached.first || address + bytes > std::uint64_t{reached.first} + reached.count) continue;
    std::uint8_t* const from = rows + reached.at + layout.pieceBytes * (address - reached.first) + lane;
    if (isLoad) {
      std::uint64_t value = 0;
      for (std::uint32_t k = 0; k < bytes; ++k) value = value << 8 | from[layout.pieceBytes * k];
      setNumberIn(rows, {layout.scratch(2), rep}, lane, layout.form, value);
    } else {
      const std::uint64_t value = numberIn(rows, {layout.scratch(1), rep}, lane, layout.form);
      for (std::uint32_t k = 0; k < bytes; ++k)
        from[layout.pieceBytes * k] = static_cast<std::uint8_t>(value >> 8 * (bytes - 1 - k));
    }
  }
}

}  // namespace

void doByTrace(const StepByTrace* step, const LaneLayout* layout, std::uint8_t* rows, std::uint64_t rep) {
  const Rep form = static_cast<Rep>(rep);
  if (step->step.op == CodeOp::LoadAt || step->step.op == CodeOp::StoreAt)
    return accessByTrace(*step, *layout, rows, form);
  for (std::size_t lane = 0; lane < layout->lanes; ++lane) {
    const std::uint64_t a = numberIn(rows, {layout->scratch(0), form}, lane, layout->form);
    const std::uint64_t b = numberIn(rows, {layout->scratch(1), form}, lane, layout->form);
    setNumberIn(rows, {layout->scratch(2), form}, lane, layout->form, computedByTrace(step->step, a, b));
  }
}

}  // namespace rungproof::lanes
