// Drawings built by hand for the tests of layout and rendering.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ir/check.hpp"
#include "ir/drawing.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof::show_test {

inline Operand bitOf(std::string_view text) {
  const std::size_t dot = text.find('.');
  const std::string letters(text.substr(0, text.find_first_of("0123456789")));
  Area area = Area::V;
  for (int a = 0; a < areaCount; ++a) {
    if (areaName(static_cast<Area>(a)) == letters) area = static_cast<Area>(a);
  }
  const auto number = static_cast<std::uint32_t>(std::stoul(std::string(text.substr(letters.size()))));
  if (dot == std::string_view::npos) return direct(area, Width::Bit, number);
  return direct(area, Width::Bit, number, static_cast<unsigned>(std::stoul(std::string(text.substr(dot + 1)))));
}
inline Operand word(Area area, std::uint32_t offset) { return direct(area, Width::Word, offset); }

/// Builds a drawing element by element; every function gives the index of the new element.
class Builder {
 public:
  using Index = std::uint32_t;

  Index rail() { return add(Shape::Rail, nullptr, {}, {}); }
  Index contact(std::string_view mnemonic, Operands operands, Index from) {
    return add(Shape::Contact, instruction(mnemonic), std::move(operands), {{from}});
  }
  Index no(std::string_view address, Index from) { return contact("LD", {bitOf(address)}, from); }
  Index nc(std::string_view address, Index from) { return contact("LDN", {bitOf(address)}, from); }
  Index either(std::vector<Index> from) { return add(Shape::Or, nullptr, {}, wires(from)); }
  Index both(std::vector<Index> from) { return add(Shape::And, nullptr, {}, wires(from)); }
  Index box(std::string_view mnemonic, Operands operands, std::vector<Index> from) {
    return add(Shape::Box, instruction(mnemonic), std::move(operands), wires(from));
  }
  Index coil(std::string_view mnemonic, Operands operands, Index from) {
    return add(Shape::Coil, instruction(mnemonic), std::move(operands), {{from}});
  }
  Index out(std::string_view address, Index from) { return coil("=", {bitOf(address)}, from); }
  Index heading(std::string_view mnemonic, Operands operands) {
    return add(Shape::Coil, instruction(mnemonic), std::move(operands), {});
  }
  void negate(Index element, std::size_t input) { drawing.elements[element].inputs[input].negated = true; }

  Drawing drawing;

 private:
  static const Desc* instruction(std::string_view mnemonic) {
    const Desc* desc = s7200Instructions().named(mnemonic);
    CHECK(desc != nullptr, "unknown mnemonic in a test");
    return desc;
  }
  static std::vector<Wire> wires(const std::vector<Index>& from) {
    std::vector<Wire> list;
    for (const Index i : from) list.push_back({i});
    return list;
  }
  Index add(Shape shape, const Desc* desc, Operands operands, std::vector<Wire> inputs) {
    // Every element gets a place of its own, so that findings can point at it.
    drawing.elements.push_back({shape,
                                desc,
                                std::move(operands),
                                std::move(inputs),
                                {0, static_cast<std::uint32_t>(10 * drawing.elements.size()), 5}});
    return static_cast<Index>(drawing.elements.size() - 1);
  }
};

}  // namespace rungproof::show_test
