// A ladder as FBD, element by element: what stands behind something becomes an AND with it. Tested by
// tests/drawing/as_fbd_test.cpp.
#include <algorithm>

#include "analysis/drawing/raise.hpp"
#include "ir/desc.hpp"

namespace rungproof {

namespace {

class Conversion {
 public:
  explicit Conversion(const Drawing& ladder) : from_(ladder.elements), uses_(ladder.elements.size(), 0) {
    for (const Element& element : from_) {
      for (const Wire& wire : element.inputs) ++uses_[wire.from];
    }
  }

  Drawing run() {
    to_.resize(from_.size());
    for (std::uint32_t i = 0; i < from_.size(); ++i) to_[i] = converted(i);
    return withoutReplaced();
  }

 private:
  /// Gates that were extended lead nowhere any more.
  Drawing withoutReplaced() {
    std::vector<std::uint32_t> place(drawing_.elements.size(), 0);
    for (const std::uint32_t gate : replaced_) place[gate] = noInstruction;
    Drawing result;
    for (std::uint32_t i = 0; i < drawing_.elements.size(); ++i) {
      if (place[i] == noInstruction) continue;
      place[i] = static_cast<std::uint32_t>(result.elements.size());
      for (Wire& each : drawing_.elements[i].inputs) each.from = place[each.from];
      result.elements.push_back(std::move(drawing_.elements[i]));
    }
    return result;
  }

  std::uint32_t append(Element element) {
    drawing_.elements.push_back(std::move(element));
    return static_cast<std::uint32_t>(drawing_.elements.size() - 1);
  }
  Wire wire(const Wire& old) const { return {to_[old.from], old.negated}; }
  bool isRail(std::uint32_t i) const { return from_[i].shape == Shape::Rail; }

  std::uint32_t converted(std::uint32_t i) {
    Element element = from_[i];
    for (Wire& each : element.inputs) each = wire(each);
    if (element.shape == Shape::Or) return gate(Shape::Or, element.inputs, element);
    const bool isCondition = element.shape == Shape::Contact && element.desc->stack.pushes == 1;
    const bool isSeries =
        isCondition && !element.inputs.empty() && (!isRail(from_[i].inputs[0].from) || element.inputs[0].negated);
    if (!isSeries) return append(std::move(element));
    const Wire before = element.inputs[0];
    const std::uint32_t old = from_[i].inputs[0].from;
    const std::uint32_t rail = railBefore();
    element.inputs = {{rail, false}};
    const Element sample = element;
    const std::uint32_t contact = append(std::move(element));
    // A gate that only this contact continues takes it as a further input.
    Element& last = drawing_.elements[before.from];
    const bool extends = last.shape == Shape::And && from_[old].shape == Shape::Contact && uses_[old] == 1 &&
                         !before.negated && last.inputs.size() < maxGateInputs;
    std::vector<Wire> inputs = {before};
    if (extends) inputs = last.inputs;
    inputs.push_back({contact, false});
    const std::uint32_t made = gate(Shape::And, inputs, sample);
    if (extends) replaced_.push_back(before.from);
    return made;
  }
  /// In gates of at most 32 inputs, one feeding the next.
  std::uint32_t gate(Shape shape, const std::vector<Wire>& inputs, const Element& sample) {
    Element element;
    element.shape = shape;
    element.span = sample.span;
    element.instruction = sample.instruction;
    std::size_t next = 0;
    while (true) {
      const std::size_t room = maxGateInputs - element.inputs.size();
      const std::size_t count = std::min(room, inputs.size() - next);
      element.inputs.insert(element.inputs.end(), inputs.begin() + static_cast<std::ptrdiff_t>(next),
                            inputs.begin() + static_cast<std::ptrdiff_t>(next + count));
      next += count;
      const std::uint32_t made = append(element);
      if (next == inputs.size()) return made;
      element.inputs = {{made, false}};
    }
  }
  std::uint32_t railBefore() {
    for (std::uint32_t i = 0; i < drawing_.elements.size(); ++i) {
      if (drawing_.elements[i].shape == Shape::Rail) return i;
    }
    return append(Element{});
  }

  const std::vector<Element>& from_;
  std::vector<std::uint32_t> uses_;
  std::vector<std::uint32_t> to_;
  std::vector<std::uint32_t> replaced_;
  Drawing drawing_;
};

}  // namespace

Drawing asFbd(const Drawing& ladder) {
  Drawing made = Conversion(ladder).run();
  made.isOfVariables = ladder.isOfVariables;
  return made;
}

}  // namespace rungproof
