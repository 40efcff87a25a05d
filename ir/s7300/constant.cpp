// Constants in the accumulator.
#include "ir/s7300/constant.hpp"

namespace rungproof::s7300 {

std::uint32_t accumulatorBits(const Constant& constant) {
  switch (constant.kind) {
    case ConstantKind::Integer:
      // An INT fills the right half only; what does not fit one is a DINT.
      return constant.value >= -32768 && constant.value <= 32767 ? static_cast<std::uint32_t>(constant.value) & 0xFFFFU
                                                                 : static_cast<std::uint32_t>(constant.value);
    case ConstantKind::Text: {
      std::uint32_t bits = 0;
      for (const char c : constant.text) bits = bits << 8 | static_cast<unsigned char>(c);
      return bits;
    }
    default: return static_cast<std::uint32_t>(constant.value);
  }
}

}  // namespace rungproof::s7300
