// Names of operands and marks of findings.
#include "frontend/picture/element_text.hpp"

#include <algorithm>

#include "frontend/text/excerpt.hpp"

namespace rungproof {

namespace {

/// The name of an L address in the local variable table of its block.
std::string localName(const Pou* pou, const Operand& operand) {
  if (pou == nullptr || operand.kind != OperandKind::Direct || operand.area != Area::L) return {};
  for (const LocalVariable& local : pou->locals) {
    const Operand& a = local.address;
    const bool isSame =
        a.offset == operand.offset && a.width == operand.width && (a.width != Width::Bit || a.bit == operand.bit);
    if (isSame) return "#" + local.name;
  }
  return {};
}

std::string symbolName(const Program* program, const Pou* pou, const Operand& operand) {
  if (operand.kind != OperandKind::Direct) return {};
  if (std::string local = localName(pou, operand); !local.empty()) return local;
  if (!operand.text.empty()) return operand.text;
  const Symbol* symbol = program == nullptr ? nullptr : program->symbolOf(operand);
  return symbol == nullptr ? std::string() : symbol->name;
}

bool contains(Span outer, Span inner) {
  return outer.file == inner.file && outer.length > 0 && inner.offset >= outer.offset &&
         inner.offset < outer.offset + outer.length;
}

}  // namespace

std::string shortened(const std::string& text, int width) {
  if (displayWidth(text) <= width) return text;
  std::string cut;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t next = i + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0) == 0x80) ++next;
    if (displayWidth(cut) + displayWidth(text.substr(i, next - i)) > width - 3) break;
    cut += text.substr(i, next - i);
    i = next;
  }
  return cut + "...";
}

OperandText ElementTexts::operand(int element, std::size_t index) const {
  const Element& e = drawing_.elements[static_cast<std::size_t>(element)];
  if (index >= e.operands.size()) return {};
  const Operand& operand = e.operands[index];
  OperandText text;
  text.isConstant = operand.kind == OperandKind::Constant || operand.kind == OperandKind::Text ||
                    operand.kind == OperandKind::Address;
  text.symbol = shortened(symbolName(program_, pou_, operand));
  text.address = operand.kind == OperandKind::Missing ? "??.?" : shortened(toString(operand));
  if (!text.isConstant) text.address += value(element, index);
  return text;
}

std::string ElementTexts::value(int element, std::size_t index) const {
  if (flow_ == nullptr) return {};
  const std::vector<std::string>& values = (*flow_)[static_cast<std::size_t>(element)].values;
  return index < values.size() && !values[index].empty() ? "=" + values[index] : std::string();
}

void ElementTexts::setFindings(const std::vector<const Finding*>& findings) {
  marks_.assign(drawing_.elements.size(), {});
  for (const Finding* finding : findings) {
    for (std::size_t i = 0; i < drawing_.elements.size(); ++i) {
      if (!contains(drawing_.elements[i].span, finding->span)) continue;
      ElementMark& mark = marks_[i];
      mark.severity = std::max(mark.severity, static_cast<int>(finding->severity));
      if (mark.text.find(finding->rule) == std::string::npos)
        mark.text += (mark.text.empty() ? "^" : " ") + finding->rule;
      break;
    }
  }
}

}  // namespace rungproof
