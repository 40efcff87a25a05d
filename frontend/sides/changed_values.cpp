// By the names of the declarations where there are some, otherwise byte by byte.
#include "frontend/sides/changed_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "frontend/mc7/actual_values.hpp"
#include "ir/dialect.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

namespace {

const DataBlock* blockOf(const Program& program, std::uint32_t number) {
  const auto found = std::ranges::find(program.dataBlocks, number, &DataBlock::number);
  return found == program.dataBlocks.end() ? nullptr : &*found;
}

const s7300::Structure* structureOf(const Program& program, std::uint32_t number) {
  if (program.declarations == nullptr) return nullptr;
  const auto found = program.declarations->dataBlocks.find(number);
  return found == program.declarations->dataBlocks.end() ? nullptr : found->second.get();
}

void addDataBlock(std::vector<ValueChange>& changes, const Program& before, const Program& after,
                  std::uint32_t number) {
  const DataBlock *old = blockOf(before, number), *now = blockOf(after, number);
  const std::string name = fmt::format("DB{}", number);
  if (old == nullptr || now == nullptr)
    return changes.push_back({name, old == nullptr ? "" : "a block", now == nullptr ? "" : "a block"});
  if (old->bytes == now->bytes) return;
  if (old->bytes.size() != now->bytes.size())
    return changes.push_back(
        {name, fmt::format("{} bytes", old->bytes.size()), fmt::format("{} bytes", now->bytes.size())});
  const s7300::Structure* structure = structureOf(after, number);
  std::size_t named = 0;
  if (structure != nullptr) {
    const auto unlike = [&](const DataBlock& block, const DataBlock& other) {
      return mc7::valuesUnlike(*structure, other.bytes,
                               {reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size()});
    };
    const std::vector<mc7::NamedValue> ofOld = unlike(*old, *now), ofNew = unlike(*now, *old);
    for (std::size_t i = 0; i < ofOld.size() && i < ofNew.size(); ++i, ++named)
      changes.push_back({name + '.' + ofNew[i].name, ofOld[i].value, ofNew[i].value});
  }
  if (named == 0) changes.push_back({name, "other bytes", "those of NEW"});
}

/// The bytes of V memory that a program gives a value.
std::map<std::uint32_t, std::uint8_t> imageOf(const Program& program) {
  std::map<std::uint32_t, std::uint8_t> image;
  for (const DataInit& init : program.data) {
    for (std::size_t i = 0; i < init.bytes.size(); ++i)
      image[init.offset + static_cast<std::uint32_t>(i)] = init.bytes[i];
  }
  return image;
}

std::string valueAt(const std::map<std::uint32_t, std::uint8_t>& image, std::uint32_t first, std::uint32_t count) {
  std::string text = "16#";
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto found = image.find(first + i);
    text += fmt::format("{:02X}", found == image.end() ? 0 : found->second);
  }
  return text;
}

void addVariables(std::vector<ValueChange>& changes, const Program& before, const Program& after) {
  const auto ofOld = imageOf(before), ofNew = imageOf(after);
  std::set<std::uint32_t> told;
  for (const Symbol& now : after.symbols) {
    const Symbol* old = before.symbolNamed(now.name);
    if (old == nullptr || now.address.area != Area::V || old->address.area != Area::V ||
        old->address.width != now.address.width)
      continue;
    const auto count = static_cast<std::uint32_t>(bytes(now.address.width));
    const std::string was = valueAt(ofOld, old->address.offset, count), is = valueAt(ofNew, now.address.offset, count);
    // A variable of a program has a second name, with that of the program in front.
    if (was != is && told.insert(now.address.offset).second) changes.push_back({now.name, was, is});
  }
}

void addMemory(std::vector<ValueChange>& changes, const Program& before, const Program& after) {
  const auto ofOld = imageOf(before), ofNew = imageOf(after);
  std::map<std::uint32_t, std::uint8_t> all = ofOld;
  all.insert(ofNew.begin(), ofNew.end());
  for (const auto& [byte, value] : all) {
    const std::string was = valueAt(ofOld, byte, 1), is = valueAt(ofNew, byte, 1);
    if (was != is) changes.push_back({fmt::format("VB{}", byte), was, is});
  }
}

}  // namespace

std::vector<ValueChange> changedValues(const Program& before, const Program& after) {
  std::vector<ValueChange> changes;
  if (dialectOf(before.target).memory.isOfVariables && dialectOf(after.target).memory.isOfVariables) {
    addVariables(changes, before, after);
  } else {
    addMemory(changes, before, after);
  }
  std::set<std::uint32_t> numbers;
  for (const Program* program : {&before, &after}) {
    for (const DataBlock& block : program->dataBlocks) numbers.insert(block.number);
  }
  for (const std::uint32_t number : numbers) addDataBlock(changes, before, after, number);
  return changes;
}

std::string changeText(const ValueChange& change) {
  if (change.before.empty()) return change.name + " is new";
  if (change.after.empty()) return change.name + " is gone";
  return fmt::format("{} begins with {} in place of {}", change.name, change.after, change.before);
}

}  // namespace rungproof
