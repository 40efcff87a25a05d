// Facts about an address, gathered from the tables of the CPU and the instructions.
#include "frontend/explain/address_page.hpp"

#include <fmt/ranges.h>

#include <vector>

#include "engine/start_up.hpp"
#include "frontend/stl/missing_address.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "ir/s7200/cpu_tables.hpp"
#include "ir/s7200/event.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof {

namespace {

std::string_view meaningOf(Area area) {
  switch (area) {
    case Area::I: return "process image of the inputs";
    case Area::Q: return "process image of the outputs";
    case Area::AI: return "analog input";
    case Area::AQ: return "analog output";
    case Area::V: return "variable memory";
    case Area::M: return "bit memory";
    case Area::S: return "sequence control relay";
    case Area::SM: return "special memory";
    case Area::L: return "local memory of a block";
    case Area::T: return "timer";
    case Area::C: return "counter";
    case Area::AC: return "accumulator";
    case Area::HC: return "value of a high-speed counter";
    case Area::DB: return "data block";
    case Area::PI: return "input of a module, read at once";
    case Area::PQ: return "output of a module, written at once";
  }
  return "";
}

/// The boxes that take the timer or counter.
std::vector<std::string_view> boxesOf(const Target& target, const Operand& o) {
  std::vector<std::string_view> names;
  for (const Desc& desc : s7200Instructions().all()) {
    const Type wanted = o.area == Area::T ? Type::Timer : Type::Counter;
    if (desc.drawingOnly || desc.operandCount == 0 || desc.operands[0].type != wanted) continue;
    if ((desc.cpus & cpuBit(target.cpu)) == 0) continue;
    bool isLegal = !desc.operands[0].hasRanges();
    for (const ValueRange& range : desc.operands[0].ranges)
      isLegal = isLegal || ((range.cpus & cpuBit(target.cpu)) != 0 && range.low <= o.offset && o.offset <= range.high);
    if (isLegal) names.push_back(desc.stl);
  }
  return names;
}

void addTimer(const Target& target, const Operand& o, std::vector<std::string>& lines) {
  const auto number = static_cast<int>(o.offset);
  const int resolution = timerResolution(number);
  lines.push_back(fmt::format("resolution {} ms: PT counts steps of {} ms, at most 32767 of them ({:g} s)", resolution,
                              resolution, 32.767 * resolution));
  lines.push_back(fmt::format("for {}", fmt::join(boxesOf(target, o), ", ")));
  lines.push_back(fmt::format("T{} is its bit as a contact, its current value as a word (T{}.value in properties)",
                              number, number));
  if (eventOfTimer(o.offset) >= 0)
    lines.push_back(fmt::format("event {} when its value reaches the preset", eventOfTimer(o.offset)));
}

void addBytes(const Target& target, const Operand& o, std::vector<std::string>& lines) {
  const std::string_view area = areaName(o.area);
  const int count = bytes(o.width);
  if (count > 1)
    lines.push_back(fmt::format("{} bytes: {}B{} is the most significant, {}B{} the least", count, area, o.offset, area,
                                o.offset + static_cast<std::uint32_t>(count) - 1));
  if (const std::optional<AddressLimit> limit = addressLimit(target, o.area, o.width))
    lines.push_back(fmt::format("CPU {}: up to {}", cpuName(target.cpu),
                                addressName(o.area, o.width, limit->lastByte, o.width == Width::Bit ? 7 : 0)));
}

void addPoint(const Target& target, const Operand& o, std::vector<std::string>& lines) {
  if (o.width != Width::Bit) return;
  for (const EdgeInput& edge : edgeInputs) {
    if (o.area != Area::I || edge.bit != o.offset * 8 + o.bit || !eventExists(target, edge.rising)) continue;
    lines.push_back(
        fmt::format("its rising edge is event {}, its falling edge event {}", edge.rising, edge.rising + 1));
  }
  if (o.area != Area::Q || o.offset != 0) return;
  const std::optional<std::uint32_t> output = generatorOf(o.bit);
  if (output && static_cast<int>(*output) < cpuFeatures(target).pulseOutputs)
    lines.push_back(
        fmt::format("pulse output {}: PLS {} with the control byte SMB{}", *output, *output, pulseControl(*output)));
}

}  // namespace

std::optional<AddressPage> addressPage(const Target& target, const std::string& word, const Paint& paint) {
  Operand operand;
  if (!readAddress(word, Spelling::International, operand)) return std::nullopt;
  std::vector<std::string> lines;
  if (const std::optional<std::string> missing = missingFrom(target, operand)) {
    lines.push_back(*missing);
  } else {
    if (operand.area == Area::T) addTimer(target, operand, lines);
    if (operand.area == Area::C) lines.push_back(fmt::format("for {}", fmt::join(boxesOf(target, operand), ", ")));
    if (!addressedByNumber(operand.area)) addBytes(target, operand, lines);
    addPoint(target, operand, lines);
    for (const RetentiveRange& range : defaultRetentiveRanges(target)) {
      const bool isIn = range.area == operand.area && range.first <= operand.offset && operand.offset <= range.last;
      if (isIn) lines.push_back("keeps its value without power, unless the system block says otherwise");
    }
  }
  const std::string name = toString(operand);
  AddressPage page{fmt::format("{}: {}\n\n", paint.bold(name), paint.bold(std::string(meaningOf(operand.area)))), {}};
  for (const std::string& line : lines) page.text += fmt::format("  {}\n", line);
  page.json = {{"address", name}, {"area", meaningOf(operand.area)}, {"facts", lines}};
  if (operand.area == Area::T) page.json["resolution_ms"] = timerResolution(static_cast<int>(operand.offset));
  return page;
}

}  // namespace rungproof
