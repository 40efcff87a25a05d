// Collects the external values of calls by block and output.
#include "frontend/simulation/library_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "ir/s7200/call_contract.hpp"

namespace rungproof {

namespace {

using OutputKey = std::pair<std::string, std::uint32_t>;  // block and place

std::string columnName(const CallContract& contract, std::uint32_t place) {
  const LibraryBlock* block = libraryBlockWith(contract.name, contract.given);
  if (block == nullptr) return fmt::format("{}.{}", contract.name, place);
  return fmt::format("{}.{}", contract.name, block->parameters[place - 1].name);
}

}  // namespace

SignalType signalTypeOf(DataType type) {
  switch (type) {
    case DataType::Bool: return SignalType::Bool;
    case DataType::Real: return SignalType::Real;
    case DataType::Byte: return SignalType::Unsigned;
    default: return SignalType::Signed;
  }
}

LibraryColumns::LibraryColumns(const Program& program, const Witness& witness) {
  const CallContracts contracts(program);
  struct Column {
    std::string name;
    DataType type;
    std::map<std::size_t, std::uint64_t> values{};
  };
  std::map<OutputKey, Column> columns;
  std::set<OutputKey> divided;  // the calls of one scan differ
  for (std::size_t scan = 0; scan < witness.scans.size() && !contracts.empty(); ++scan) {
    for (const ExternalValue& external : witness.scans[scan].externals) {
      if (external.site.kind != External::LibraryOutput || libraryEffect(external.site.index)) continue;
      const auto called = contracts.all().find(external.site.instruction);
      if (called == contracts.all().end()) continue;
      for (const CallContract::Output& output : called->second.outputs) {
        if (output.place != external.site.index) continue;
        const OutputKey key{called->second.name, output.place};
        Column& column =
            columns.try_emplace(key, Column{columnName(called->second, output.place), output.type}).first->second;
        const auto [known, isNew] = column.values.emplace(scan, external.value);
        if (!isNew && known->second != external.value) divided.insert(key);
      }
    }
  }
  for (const auto& [key, column] : columns) {
    const bool isQuiet = std::ranges::all_of(column.values, [](const auto& value) { return value.second == 0; });
    if (isQuiet || divided.contains(key)) continue;
    TraceSignal& signal = signals_.emplace_back();
    signal.name = column.name;
    signal.type = signalTypeOf(column.type);
    std::map<std::size_t, TraceNumber>& values = values_.emplace_back();
    for (const auto& [scan, value] : column.values)
      values[scan] = numberOf(value, signal.type, bits(widthOf(column.type)));
  }
}

std::vector<std::optional<TraceNumber>> LibraryColumns::valuesIn(std::size_t scan) const {
  std::vector<std::optional<TraceNumber>> row;
  for (const std::map<std::size_t, TraceNumber>& values : values_) {
    const auto found = values.find(scan);
    row.push_back(found == values.end() ? std::nullopt : std::optional(found->second));
  }
  return row;
}

}  // namespace rungproof
