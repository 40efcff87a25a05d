// Machine code for groups of traces, where the processor has AVX2.
#include "engine/lanes/lane_code.hpp"

#if defined(__x86_64__)
#include "engine/lanes/lane_emitter.hpp"
#endif

namespace rungproof::lanes {

#if defined(__x86_64__)

namespace {

asmjit::JitRuntime& laneRuntime() {
  static asmjit::JitRuntime runtime;
  return runtime;
}

class X86LaneCode final : public LaneCode {
 public:
  X86LaneCode(const Code& code, const std::vector<bool>& isNeeded, const Concrete::Store& model)
      : LaneCode(code, isNeeded, model) {
    asmjit::CodeHolder holder;
    if (holder.init(laneRuntime().environment()) != asmjit::kErrorOk) return;
    if (!LaneEmitter(code, isNeeded, layout, byTrace_, holder).emit()) return;
    if (laneRuntime().add(&function_, &holder) != asmjit::kErrorOk) function_ = nullptr;
  }
  ~X86LaneCode() override { laneRuntime().release(function_); }
  X86LaneCode(const X86LaneCode&) = delete;
  X86LaneCode& operator=(const X86LaneCode&) = delete;
  bool isThere() const { return function_ != nullptr; }
  void run(std::uint8_t* rows) const override { function_(rows); }

 private:
  std::deque<StepByTrace> byTrace_;
  void (*function_)(std::uint8_t* rows) = nullptr;
};

}  // namespace

bool hasLanes() { return asmjit::CpuInfo::host().features().x86().hasAVX2(); }

std::unique_ptr<LaneCode> translatedForLanes(const Code& code, const std::vector<bool>& isNeeded,
                                             const Concrete::Store& model) {
  auto made = std::make_unique<X86LaneCode>(code, isNeeded, model);
  return made->isThere() ? std::move(made) : nullptr;
}

#else

bool hasLanes() { return false; }
std::unique_ptr<LaneCode> translatedForLanes(const Code&, const std::vector<bool>&, const Concrete::Store&) {
  return nullptr;
}

#endif

}  // namespace rungproof::lanes
