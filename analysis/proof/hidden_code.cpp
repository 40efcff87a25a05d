// What hidden code may write.
#include "analysis/proof/hidden_code.hpp"

#include <fmt/format.h>

#include "ir/desc.hpp"

namespace rungproof {

namespace {

bool touches(const ExternalRange& range, const Operand& operand) {
  if (operand.kind != OperandKind::Direct || operand.area != range.first.area) return false;
  const std::uint32_t first = range.first.offset,
                      end = range.last.offset + static_cast<std::uint32_t>(bytes(range.last.width));
  if (operand.offset >= end || operand.offset + static_cast<std::uint32_t>(bytes(operand.width)) <= first) return false;
  const bool areBits =
      range.first.width == Width::Bit && range.first.offset == range.last.offset && operand.width == Width::Bit;
  return !areBits || (operand.bit >= range.first.bit && operand.bit <= range.last.bit);
}

}  // namespace

HiddenCode::HiddenCode(const Program& program, const PropertySet& set) : program_(program) {
  for (const ExternalRange& range : set.externals) {
    if (range.isHidden) ranges_.push_back(range);
  }
  if (ranges_.empty()) return;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (std::size_t i = 0; i < instruction.operands.size() && i < instruction.desc->operandCount; ++i) {
          if (instruction.desc->operands[i].direction == Direction::In) continue;
          for (const ExternalRange& range : ranges_) {
            if (!touches(range, instruction.operands[i])) continue;
            shared_.push_back(fmt::format("{} and {} in {}, network {}", placeOf(range), instruction.desc->stl,
                                          pou.name, network.number));
          }
        }
      }
    }
  }
}

std::string HiddenCode::placeOf(const ExternalRange& range) const {
  const Symbol* symbol = program_.symbolOf(range.first);
  const std::string name = toString(range.first);
  const Position position = program_.sources->position(range.span);
  return fmt::format("{}{}, written by the code at {}:{} that is not covered", name,
                     symbol == nullptr ? "" : fmt::format(" ({})", symbol->name),
                     program_.sources->file(range.span.file).name(), position.line);
}

std::vector<std::string> HiddenCode::reasons(const EncodedScan& encoding,
                                             const std::unordered_set<std::uint32_t>& variables) const {
  std::vector<std::string> result;
  for (const std::string& text : shared_) result.push_back("two hands write one place: " + text);
  if (ranges_.empty()) return result;
  for (const Cell& cell : encoding.cells()) {
    if (cell.kind != CellKind::Input || cell.place.isRegister || !variables.contains(indexOf(cell.start))) continue;
    for (const ExternalRange& range : ranges_) {
      Operand operand = direct(cell.place.area,
                               cell.place.width == 1    ? Width::Bit
                               : cell.place.width == 8  ? Width::Byte
                               : cell.place.width == 16 ? Width::Word
                                                        : Width::DWord,
                               cell.place.byte(), cell.place.width == 1 ? cell.place.bit() : 0);
      if (!touches(range, operand)) continue;
      result.push_back("depends on " + placeOf(range));
      break;
    }
  }
  return result;
}

std::optional<std::string> unfollowedRoutine(const Program& program, const EncodedScan& encoding) {
  if (!encoding.eventSites().empty()) return std::nullopt;
  for (const Flow& flow : encoding.plan().flows) {
    for (const FlowStep& step : flow.steps) {
      if (step.instruction->desc->stl != "ATCH") continue;
      const Span span = step.instruction->span;
      return fmt::format("the interrupt routine attached at {}:{} is not followed",
                         program.sources->file(span.file).name(), program.sources->position(span).line);
    }
  }
  return std::nullopt;
}

}  // namespace rungproof
