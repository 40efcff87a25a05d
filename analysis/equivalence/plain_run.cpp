// Values inside a scan are left out by their kind.
#include "analysis/equivalence/plain_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/equivalence/product.hpp"
#include "analysis/proof/question_system.hpp"
#include "analysis/witness/witness.hpp"

namespace rungproof {

EquivalenceRun without(EquivalenceRun run, bool (*isLeftOut)(External)) {
  for (std::vector<ReplayScan>* scans : {&run.before, &run.after}) {
    for (ReplayScan& scan : *scans)
      std::erase_if(scan.externals, [&](const ExternalValue& value) { return isLeftOut(value.site.kind); });
  }
  return run;
}
namespace {

EquivalenceRun withoutMoments(EquivalenceRun run) {
  for (std::vector<ReplayScan>* scans : {&run.before, &run.after}) {
    for (ReplayScan& scan : *scans) {
      scan.script.ticks10.reset();
      scan.script.ticks100.reset();
      scan.script.ticks1.clear();
    }
  }
  return run;
}
std::optional<std::uint64_t> givenBit(const ReplayScan& scan, std::uint32_t index) {
  for (const PresetValue& input : scan.inputs) {
    if (input.operand.area != Area::I) continue;
    const Place place = memoryPlace(Area::I, input.operand.offset, input.operand.width, input.operand.bit);
    for (std::uint32_t i = 0; i < place.width; ++i) {
      if (bitOf(place, i).index == index) return input.value >> (place.width - 1 - i) & 1U;
    }
  }
  return std::nullopt;
}
/// Immediate reads find what the input of the scan is, as in a run by a stimulus.
void holdImmediateReads(const Program& program, std::vector<ReplayScan>& scans) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (!instruction.desc->immediate || instruction.operands.empty()) continue;
        const Operand& o = instruction.operands[0];
        if (o.kind != OperandKind::Direct || o.area != Area::I) continue;
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(bits(o.width)); ++i) {
          const std::uint32_t index = bitOf(memoryPlace(Area::I, o.offset, o.width, o.bit), i).index;
          std::uint64_t last = 0;
          for (ReplayScan& scan : scans) {
            last = givenBit(scan, index).value_or(last);
            scan.externals.push_back({{External::ImmediateInput, index, instruction.id}, last});
          }
        }
      }
    }
  }
}

}  // namespace

EquivalenceRun stimulusOnly(const Program& before, const Program& after, const EquivalenceRun& run) {
  EquivalenceRun plain = withoutMoments(without(run, [](External) { return true; }));
  plain.initialBefore.reset();
  plain.initialAfter.reset();
  holdImmediateReads(before, plain.before);
  holdImmediateReads(after, plain.after);
  return plain;
}
std::string undefinedText(const Program& program, const ExternalSite& site) {
  std::string what = site.kind == External::StackBottom   ? "a level of the logic stack that nothing has filled"
                     : site.kind == External::LocalMemory ? fmt::format("local memory LB{}", site.index)
                                                          : "a register at the start of an organization block";
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (instruction.id == site.instruction) return fmt::format("{} ({})", what, placeText(program, instruction));
      }
    }
  }
  return what;
}

std::set<std::string> undefinedReads(const Program& before, const Program& after, const EquivalenceRun& run) {
  std::set<std::string> reads;
  for (const auto& [program, scans] : {std::pair{&before, &run.before}, {&after, &run.after}}) {
    for (const ReplayScan& scan : *scans) {
      for (const ExternalValue& value : scan.externals) {
        if (isUndefinedRead(value.site.kind) && value.value != quietExternal(value.site))
          reads.insert(undefinedText(*program, value.site));
      }
    }
  }
  return reads;
}

}  // namespace rungproof
