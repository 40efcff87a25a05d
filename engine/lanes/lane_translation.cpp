// Machine code for groups of traces, where the processor has AVX2 or AVX-512.
#include <algorithm>

#include "engine/lanes/lane_code.hpp"

#if defined(__x86_64__)
#include "engine/compiled/code_pages.hpp"
#include "engine/lanes/lane_emitter.hpp"
#include "engine/lanes/wide_emitter.hpp"
#endif

namespace rungproof::lanes {

#if defined(__x86_64__)

namespace {

class X86LaneCode final : public LaneCode {
 public:
  X86LaneCode(const Code& code, const std::vector<bool>& isNeeded, const Concrete::Store& model, bool isWide)
      : LaneCode(code, isNeeded, model, isWide) {
    asmjit::CodeHolder holder;
    if (holder.init(compiled::codePages().environment()) != asmjit::kErrorOk) return;
    const Translation translation{code, isNeeded, layout, byTrace_, holder};
    if (layout.form == Form::Wide)
      translate(WideEmitter(translation), holder);
    else
      translate(LaneEmitter(translation), holder);
  }
  ~X86LaneCode() override { compiled::codePages().release(code_); }
  X86LaneCode(const X86LaneCode&) = delete;
  X86LaneCode& operator=(const X86LaneCode&) = delete;
  bool isThere() const { return code_ != nullptr; }
  void run(std::span<std::uint8_t* const> groups) const override {
    for (const Part part : parts_) {
      for (std::uint8_t* const rows : groups) part(rows);
    }
  }

 private:
  using Part = void (*)(std::uint8_t* rows);

  template <class Emitter>
  void translate(Emitter&& emitter, asmjit::CodeHolder& holder) {
    if (!emitter.emit() || compiled::codePages().add(&code_, &holder) != asmjit::kErrorOk) return;
    for (const asmjit::Label& entry : emitter.entries())
      parts_.push_back(reinterpret_cast<Part>(code_ + holder.labelOffsetFromBase(entry)));
  }

  std::deque<StepByTrace> byTrace_;
  std::uint8_t* code_ = nullptr;
  std::vector<Part> parts_;
};

}  // namespace

Vectors vectorsHere() {
  const auto& features = asmjit::CpuInfo::host().features().x86();
  if (!features.hasAVX2()) return Vectors::None;
  const bool isWide = features.hasAVX512_F() && features.hasAVX512_BW() && features.hasAVX512_DQ() &&
                      features.hasAVX512_VL() && features.hasBMI() && features.hasBMI2();
  return isWide ? Vectors::Bits512 : Vectors::Bits256;
}

std::unique_ptr<LaneCode> translatedForLanes(const Code& code, const std::vector<bool>& isNeeded,
                                             const Concrete::Store& model, Vectors most) {
  const bool isWide = std::min(most, vectorsHere()) == Vectors::Bits512;
  auto made = std::make_unique<X86LaneCode>(code, isNeeded, model, isWide);
  return made->isThere() ? std::move(made) : nullptr;
}

#else

Vectors vectorsHere() { return Vectors::None; }
std::unique_ptr<LaneCode> translatedForLanes(const Code&, const std::vector<bool>&, const Concrete::Store&, Vectors) {
  return nullptr;
}

#endif

}  // namespace rungproof::lanes
