// The rounds of the encoder: encode a scan, learn from it, encode again with what was learned.
#include "analysis/encoder.hpp"

#include "analysis/scan_encoding.hpp"
#include "ir/check.hpp"

namespace rungproof {

class Encoding::Impl {
 public:
  Impl(const Program& program, const EncoderOptions& given) : options(given), plan(program), layout(program.target) {
    layout.add(program, plan);
    for (const Operand& operand : options.observed) layout.add(operand.area, operand.width, operand.offset);
    // SM0.0 is always on; SM0.7 is the mode switch, in RUN (001:14050, 001:14057).
    knowledge.constants = {{memoryPlace(Area::SM, 0, Width::Bit, 0), 1}, {memoryPlace(Area::SM, 0, Width::Bit, 7), 1}};
    scan = std::make_unique<ScanEncoding>(program, options, plan, layout, knowledge);
  }

  EncoderOptions options;
  Plan plan;
  MemoryLayout layout;
  Knowledge knowledge;
  std::unique_ptr<ScanEncoding> scan;
};

Encoding::Encoding(const Program& program, const EncoderOptions& options) : impl_(std::make_unique<Impl>(program, options)) {}
Encoding::~Encoding() = default;
Encoding::Encoding(Encoding&&) noexcept = default;
Encoding& Encoding::operator=(Encoding&&) noexcept = default;

Graph& Encoding::graph() const { return impl_->scan->graph; }
const Plan& Encoding::plan() const { return impl_->plan; }
const TimeModel& Encoding::time() const { return impl_->scan->time; }
const EncoderOptions& Encoding::options() const { return impl_->options; }

Node Encoding::atEnd(const Place& place) { return impl_->scan->value(place); }

Node Encoding::atEnd(const Operand& operand, int width) {
  CHECK(operand.kind == OperandKind::Direct, "only direct operands have a value of their own");
  const auto low = [&](Node n) { return graph().make(Op::Extract, width, n); };
  switch (operand.area) {
    case Area::T: return atEnd(registerPlace(width == 1 ? Reg::TimerBit : Reg::TimerCurrent, operand.offset));
    case Area::C: return atEnd(registerPlace(width == 1 ? Reg::CounterBit : Reg::CounterCurrent, operand.offset));
    case Area::AC: return low(atEnd(registerPlace(Reg::Accumulator, operand.offset)));
    case Area::HC: return low(atEnd(registerPlace(Reg::HscCurrent, operand.offset)));
    case Area::AI: return impl_->scan->analogInput(operand.offset);
    default: {
      const Width access = width == 1 ? Width::Bit : width == 8 ? Width::Byte : width == 16 ? Width::Word : Width::DWord;
      return atEnd(memoryPlace(operand.area, operand.offset, access, operand.bit));
    }
  }
}

Node Encoding::atStart(const Place& place) { return impl_->scan->start(place); }
Node Encoding::firstScan() const { return impl_->scan->start(registerPlace(Reg::FirstScan, 0)); }
TransitionSystem Encoding::system() { return impl_->scan->system(); }

const std::vector<HazardRecord>& Encoding::hazards() const { return impl_->scan->hazards; }
const std::vector<BitWrite>& Encoding::bitWrites() const { return impl_->scan->bitWrites(); }
const std::vector<Approximation>& Encoding::approximations() const { return impl_->scan->approximations; }
const std::vector<ExternalInput>& Encoding::externals() const { return impl_->scan->externals; }
const std::vector<TickSite>& Encoding::tickSites() const { return impl_->scan->tickSites; }
const std::vector<EventSite>& Encoding::eventSites() const { return impl_->scan->eventSites; }
const std::vector<Cell>& Encoding::cells() const { return impl_->scan->cells(); }
Node Encoding::lastTicks() const { return impl_->scan->lastTicks; }

}  // namespace rungproof
