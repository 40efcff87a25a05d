// The layout rule.
#include "frontend/stl/local_layout.hpp"

#include <algorithm>
#include <array>

#include "frontend/stl/stl_lexer.hpp"
#include "ir/desc.hpp"

namespace rungproof {

namespace {
constexpr std::array<std::string_view, 9> typeNames = {"BOOL", "BYTE", "WORD",   "INT", "DWORD",
                                                       "DINT", "REAL", "STRING", "TIME"};
}

std::uint32_t layOutLocals(std::vector<LocalVariable>& locals) {
  std::stable_sort(locals.begin(), locals.end(),
                   [](const LocalVariable& a, const LocalVariable& b) { return a.section < b.section; });
  std::uint32_t byte = 0;
  unsigned bit = 0;
  for (LocalVariable& local : locals) {
    const Width width = widthOf(local.type);
    if (width == Width::Bit) {
      local.address = direct(Area::L, Width::Bit, byte, bit);
      if (++bit == 8) {
        bit = 0;
        ++byte;
      }
      continue;
    }
    if (bit > 0) ++byte;
    bit = 0;
    local.address = direct(Area::L, width, byte);
    byte += static_cast<std::uint32_t>(bytes(width));
  }
  return byte + (bit > 0 ? 1 : 0);
}

std::optional<DataType> dataTypeNamed(std::string_view name) {
  for (std::size_t i = 0; i < typeNames.size(); ++i) {
    if (equalsIgnoringCase(typeNames[i], name)) return static_cast<DataType>(i);
  }
  return std::nullopt;
}

std::string_view dataTypeName(DataType type) { return typeNames[static_cast<std::size_t>(type)]; }

}  // namespace rungproof
