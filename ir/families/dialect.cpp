// The list of dialects, and what is looked up over all of them.
#include "ir/dialect.hpp"

#include <algorithm>

#include "ir/check.hpp"
#include "ir/iec/dialect.hpp"
#include "ir/s7200/dialect.hpp"
#include "ir/s7300/dialect.hpp"

namespace rungproof {

namespace {

constinit const Dialect* const all[] = {&s7200Dialect, &s7300Dialect, &s7400Dialect, &iecDialect};

/// The first row of some dialect's list that `isWanted`, or nullptr.
template <class Row, class Wanted>
const Row* found(std::span<const Row> Dialect::*list, Wanted isWanted) {
  for (const Dialect* dialect : all) {
    for (const Row& row : dialect->*list) {
      if (isWanted(row)) return &row;
    }
  }
  return nullptr;
}

}  // namespace

std::span<const Dialect* const> dialects() { return all; }

const Dialect& dialectOf(Cpu cpu) {
  static const auto byCpu = [] {
    std::array<const Dialect*, sizeof(CpuSet) * 8> dialects{};
    for (const Dialect* dialect : all) {
      for (const CpuModel& row : dialect->cpus) dialects[static_cast<std::size_t>(row.cpu)] = dialect;
    }
    return dialects;
  }();
  const auto number = static_cast<std::size_t>(cpu);
  CHECK(number < byCpu.size() && byCpu[number] != nullptr, "every CPU has a dialect");
  return *byCpu[number];
}

const EditionModel& editionModel(Edition edition) {
  const EditionModel* row = found(&Dialect::editions, [&](const EditionModel& r) { return r.edition == edition; });
  CHECK(row != nullptr, "every edition has a row");
  return *row;
}

Target::Target() : Target(all[0]->usual) {}

std::optional<Cpu> cpuNamed(std::string_view name) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (name.size() > 3 && std::ranges::equal(name.substr(0, 3), std::string_view("cpu"), {}, small)) {
    name.remove_prefix(3);
    name.remove_prefix(std::min(name.find_first_not_of(" -_"), name.size()));
  }
  const CpuModel* row =
      found(&Dialect::cpus, [&](const CpuModel& r) { return std::ranges::equal(r.name, name, {}, small, small); });
  if (row != nullptr) return row->cpu;
  // What stands behind the model on the device says how it is fed and what its outputs are, or where it is sold.
  const std::size_t blank = name.find_last_of(' ');
  if (blank == std::string_view::npos) return std::nullopt;
  const auto behind =
      std::to_array<std::string_view>({"cn", "dp", "dc/dc/dc", "dc/dc/rly", "dc/dc/relay", "ac/dc/rly", "ac/dc/relay"});
  const bool isModelBefore = std::ranges::any_of(
      behind, [&](std::string_view word) { return std::ranges::equal(word, name.substr(blank + 1), {}, {}, small); });
  return isModelBefore ? cpuNamed(name.substr(0, blank)) : std::nullopt;
}

std::string_view cpuName(Cpu cpu) {
  const CpuModel* row = found(&Dialect::cpus, [&](const CpuModel& r) { return r.cpu == cpu; });
  CHECK(row != nullptr, "every CPU has a row");
  return row->name;
}

std::string_view editionName(Edition edition) { return editionModel(edition).name; }
std::string_view editionText(Edition edition) { return editionModel(edition).text; }

std::optional<Edition> editionNamed(std::string_view name) {
  const EditionModel* row = found(&Dialect::editions, [&](const EditionModel& r) { return r.name == name; });
  return row != nullptr ? std::optional(row->edition) : std::nullopt;
}

}  // namespace rungproof
