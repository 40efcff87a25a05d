// Drawn circuits: the statements of one become one network, which keeps its drawing.
#include <unordered_map>

#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

/// A drawn circuit is a network. One that cannot be lowered as a whole falls apart, so that the rest of it is spared.
/// Gives the first statement behind it.
std::size_t Lowering::writeCircuit(Pou& pou, Scope& scope, const Statements& body, std::size_t first,
                                   const NetworkWriter& write) {
  std::size_t end = first, next = first;
  while (end < body.size() && body[end].circuit == body[first].circuit) ++end;
  const CircuitPicture* const picture = body[first].drawn.get();
  const Span whole = picture != nullptr ? picture->span : body[first].span;
  const std::size_t before = pou.networks.size();
  shown_.clear();
  isDrawn_ = picture != nullptr;
  while (next < end) {
    bool isRefused = false;
    write(whole, [&] {
      for (; next < end && !isRefused; ++next) {
        const std::size_t own = network_->instructions.size();
        span_ = body[next].span;
        try {
          statement(scope, body[next]);
        } catch (const Refused&) {
          network_->instructions.resize(own);
          isRefused = true;
        }
      }
    });
    if (!isRefused) continue;
    const Statement& lost = body[next - 1];
    write(lost.span, [&] { throw Refused{}; });
    pou.networks.back().mayWrite = writtenBy(scope, lost);
  }
  isDrawn_ = false;
  if (pou.networks.size() == before) return end;
  Network& made = pou.networks[before];
  if (picture != nullptr) {
    made.title = picture->title;
    made.comments = picture->comments;
  }
  if (picture == nullptr || pou.networks.size() != before + 1 || !made.complete) return end;
  network_ = &made;
  place(*picture);
  return end;
}

/// What stands in the drawing as that expression lies on the evaluation stack now.
void Lowering::showValue(const Expr& expr) {
  if (!isDrawn_) return;
  const bool isPart = expr.kind == ExprKind::Path && expr.parts.size() > 1;
  shown_.push_back({expr.span.offset, isPart ? foldedName(expr.parts.back().name) : std::string(), false,
                    static_cast<std::uint32_t>(network_->instructions.size() - 1)});
}

/// The drawing of the circuit with the instructions at which its values are to be seen.
void Lowering::place(const CircuitPicture& picture) {
  if (picture.drawing.elements.empty()) return;
  Drawing drawing = picture.drawing;
  std::map<std::uint32_t, std::shared_ptr<BoxFace>> faces;
  for (std::uint32_t i = 0; i < drawing.elements.size(); ++i) {
    if (drawing.elements[i].face != nullptr) faces[i] = std::make_shared<BoxFace>(*drawing.elements[i].face);
  }
  using At = ShownValue::At;
  std::unordered_map<std::uint32_t, std::vector<const Shown*>> byOffset;
  for (const Shown& shown : shown_) byOffset[shown.offset].push_back(&shown);
  for (const ShownValue& value : picture.values) {
    std::uint32_t found = noInstruction;
    for (const Shown* each : byOffset[value.offset]) {
      const Shown& shown = *each;
      const bool isMeant =
          shown.isStored == (value.at == At::Stored) && (value.at != At::Member || shown.member == value.member);
      if (isMeant && (found == noInstruction || value.at != At::FirstRead)) found = shown.instruction;
    }
    if (value.part == ShownValue::Part::Whole) {
      drawing.elements[value.element].instruction = found;
    } else {
      BoxFace& face = *faces.at(value.element);
      (value.part == ShownValue::Part::Left ? face.left : face.right)[value.pin].instruction = found;
    }
  }
  for (auto& [element, face] : faces) drawing.elements[element].face = std::move(face);
  network_->form = picture.form;
  network_->drawing = std::make_shared<const Drawing>(std::move(drawing));
}

}  // namespace rungproof::iec
