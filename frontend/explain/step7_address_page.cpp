// Facts from the row of the CPU; timers and counters by what their statements do.
#include "frontend/explain/step7_address_page.hpp"

#include <fmt/format.h>

#include <vector>

#include "engine/start_up.hpp"
#include "frontend/step7/name_lookup.hpp"
#include "frontend/stl/missing_address.hpp"
#include "ir/block_map.hpp"

namespace rungproof {

namespace {

std::string_view step7Meaning(Area area) {
  switch (area) {
    case Area::I: return "process image of the inputs";
    case Area::Q: return "process image of the outputs";
    case Area::PI: return "input of a module, read at once";
    case Area::PQ: return "output of a module, written at once";
    case Area::T: return "S5 timer";
    case Area::C: return "counter";
    case Area::DB: return "place in a data block";
    default: return "bit memory";
  }
}

std::vector<std::string> step7Facts(const Target& target, const Operand& operand) {
  std::vector<std::string> facts;
  if (const std::optional<std::string> missing = missingFrom(target, operand)) return {*missing};
  const std::string name = toString(operand);
  if (operand.area == Area::T) {
    facts.push_back("started by SP, SE, SD, SS or SF; its time, 10 ms to 9990 s, stands in ACCU1 then");
    facts.push_back(
        fmt::format("A {0} scans its bit, L {0} loads what is left without the time base, LC {0} with it in "
                    "BCD; {0}.value in properties and traces is what is left in ms",
                    name));
  }
  if (operand.area == Area::C) {
    facts.push_back("counts by CU and CD from 0 to 999, set by S, cleared by R");
    facts.push_back(
        fmt::format("A {0} is 1 while it is not 0, L {0} loads it as a number, LC {0} in BCD; {0}.value in "
                    "properties and traces",
                    name));
  }
  if (!addressedByNumber(operand.area) && bytes(operand.width) > 1 && operand.width != Width::Bit) {
    const auto byteName = [&](int byte) {
      return addressName(operand.area, Width::Byte, operand.offset + static_cast<std::uint32_t>(byte));
    };
    facts.push_back(fmt::format("{} bytes: {} is the most significant, {} the least", bytes(operand.width), byteName(0),
                                byteName(bytes(operand.width) - 1)));
  }
  if (operand.area == Area::DB)
    facts.push_back(fmt::format("leaves DB{} open in the DB register", blockOfByte(operand.offset)));
  if (const std::optional<AddressLimit> limit = addressLimit(target, operand.area, operand.width))
    facts.push_back(fmt::format("CPU {}: up to {}", cpuName(target.cpu),
                                addressName(operand.area, operand.width, limit->lastByte, 7)));
  for (const RetentiveRange& range : defaultRetentiveRanges(target)) {
    if (range.area == operand.area && range.first <= operand.offset && operand.offset <= range.last)
      facts.push_back("keeps its value without power, unless the configuration says otherwise");
  }
  return facts;
}

}  // namespace

std::optional<AddressPage> step7AddressPage(const Target& target, const std::string& word, const Paint& paint) {
  const std::optional<Operand> operand = step7::addressNamed(word);
  if (!operand) return std::nullopt;
  const std::string name = toString(*operand);
  const std::vector<std::string> facts = step7Facts(target, *operand);
  AddressPage page{fmt::format("{}: {}\n\n", paint.bold(name), paint.bold(std::string(step7Meaning(operand->area)))),
                   {}};
  for (const std::string& fact : facts) page.text += fmt::format("  {}\n", fact);
  page.json = {{"address", name}, {"area", step7Meaning(operand->area)}, {"facts", facts}};
  return page;
}

}  // namespace rungproof
