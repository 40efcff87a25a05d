// Finds which state the code touches, and gives it rows.
#include "engine/lanes/lane_layout.hpp"

#include <algorithm>
#include <cstring>

namespace rungproof::lanes {

namespace {

std::uint64_t keyOf(Area area, std::uint32_t byte) { return static_cast<std::uint64_t>(area) << 32 | byte; }

bool isMemoryAccess(CodeOp op) { return op == CodeOp::LoadMemory || op == CodeOp::StoreMemory; }

/// Whether a step leaves truth values alone among themselves. Constants are seen where they are used.
bool isBitwise(const Step& s, const Code& code) {
  switch (s.op) {
    case CodeOp::Equal:
    case CodeOp::Less:
    case CodeOp::LessSigned:
    case CodeOp::AddOverflows:
    case CodeOp::SubOverflows:
    case CodeOp::RealEqual:
    case CodeOp::RealLess:
    case CodeOp::RealLegal:
    case CodeOp::LoadMemory:
    case CodeOp::LoadSlots:
    case CodeOp::LoadTicks:
    case CodeOp::LoadAt:
    case CodeOp::StoreStateWord:
    case CodeOp::StoreAt: return false;
    case CodeOp::StoreMemory: return isClearing(s, code);  // what nothing reads but bit by bit
    case CodeOp::StoreSlots: return code.steps[s.a].op == CodeOp::Constant;
    case CodeOp::TestBit: return s.value == 0 && widthOf(code.steps[s.a]) == 1;
    case CodeOp::StoreRegister: return widthOf(code.steps[s.a]) == 1;
    case CodeOp::LoadRegister: return s.width == 1;
    case CodeOp::Constant: return true;
    default: return isTruth(s.op) || !hasValue(s.op) || s.op == CodeOp::FromBit;
  }
}

}  // namespace

LaneLayout::LaneLayout(const Code& code, const std::vector<bool>& isNeeded, const Concrete::Store& model, bool isWide) {
  std::vector<int> registerWidth(model.registers().size(), 0);
  for (const RegInfo& info : regTable) {
    if (Concrete::Store::isTerminal(info.reg)) continue;
    for (std::uint32_t k = 0; k < model.count(info.reg); ++k) registerWidth[model.indexOf(info.reg, k)] = info.width;
  }
  bool isOfBits = true;
  registers_.resize(registerWidth.size());
  std::vector<bool> isUsed(registerWidth.size(), false);
  std::vector<int> stateWidth(code.states, 1);
  for (std::size_t i = 0; i < code.steps.size(); ++i) {
    const Step& s = code.steps[i];
    if (!isNeeded[i]) continue;
    isOfBits = isOfBits && isBitwise(s, code);
    if (s.op == CodeOp::LoadRegister || s.op == CodeOp::StoreRegister) isUsed[s.value] = true;
    if (s.op == CodeOp::LoadStateWord) stateWidth[s.value] = std::max(stateWidth[s.value], int{s.width});
  }
  form = isOfBits ? Form::Bits : isWide ? Form::Wide : Form::Bytes;
  lanes = isOfBits ? 256 : isWide ? 64 : 32;
  if (form == Form::Wide) truthBytes = wideTruthBytes, pieceBytes = wideBytes;
  size = (sizeof(Head) + pieceBytes - 1) / pieceBytes * pieceBytes;
  slots_ = rows(8 * code.slots.size(), Rep::Truth);
  for (std::size_t k = 0; k < registers_.size(); ++k) {
    if (!isUsed[k]) continue;
    const Rep rep = repFor(registerWidth[k]);
    registers_[k] = Row{rows(1, rep), rep};
  }
  placeMemory(code, isNeeded);
  errors_ = rows(code.sites.size(), Rep::Truth);
  stateEnd = size;
  for (const int width : stateWidth) states_.push_back({rows(1, repFor(width)), repFor(width)});
  pending_ = rows(code.marks, Rep::Truth);
  active_ = rows(2, Rep::Truth);
  scratch_ = rows(4 * mostPieces, Rep::Byte);
}

/// Bytes that are always touched together have one row, others a row each.
void LaneLayout::placeMemory(const Code& code, const std::vector<bool>& isNeeded) {
  for (const compiled::Reached& r : code.reached) {
    ReachedRows& ofArea = reached_[static_cast<std::size_t>(r.area)];
    const std::uint32_t end = std::max(ofArea.first + ofArea.count, r.first + r.count);
    ofArea.first = ofArea.count == 0 ? r.first : std::min(ofArea.first, r.first);
    ofArea.count = end - ofArea.first;
  }
  for (ReachedRows& ofArea : reached_) ofArea.at = rows(ofArea.count, Rep::Byte);
  struct Access {
    Area area;
    std::uint32_t byte;
    std::uint32_t bytes;
    auto operator<=>(const Access&) const = default;
  };
  // A byte of local memory that is only cleared stays 0 from power-up on and has no row.
  std::vector<Access> all, cleared;
  for (std::size_t i = 0; i < code.steps.size(); ++i) {
    const Step& s = code.steps[i];
    if (!isNeeded[i] || !isMemoryAccess(s.op)) continue;
    (isClearing(s, code) ? cleared : all).push_back({s.area, static_cast<std::uint32_t>(s.value), s.width / 8U});
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::ranges::sort(cleared);
  cleared.erase(std::unique(cleared.begin(), cleared.end()), cleared.end());
  const auto isCutByClearing = [&](const Access& a) {
    return std::ranges::any_of(cleared, [&](const Access& c) {
      const bool begins = a.byte >= c.byte && a.byte < c.byte + c.bytes;
      const bool ends = a.byte + a.bytes > c.byte && a.byte + a.bytes <= c.byte + c.bytes;
      return a.area == c.area && begins != ends;
    });
  };
  const auto isReached = [&](const Access& a) {
    const ReachedRows& ofArea = reached(a.area);
    return a.byte + a.bytes > ofArea.first && a.byte < ofArea.first + ofArea.count;
  };
  const auto place = [&](Area area, std::uint32_t byte, int bytes) {
    const Access access{area, byte, 1};
    const std::size_t at = bytes == 1 && isReached(access)
                               ? reached(area).at + pieceBytes * (byte - reached(area).first)
                               : rows(1, repFor(8 * bytes));
    cellAt_[keyOf(area, byte)] = cells_.size();
    cells_.push_back({area, byte, bytes, at});
  };
  for (std::size_t i = 0; i < all.size();) {
    std::uint32_t end = all[i].byte + all[i].bytes;
    std::size_t next = i + 1;
    bool isOne = true;
    for (; next < all.size() && all[next].area == all[i].area && all[next].byte < end; ++next) {
      isOne = isOne && all[next].byte == all[i].byte && all[next].bytes == all[i].bytes;
      end = std::max(end, all[next].byte + all[next].bytes);
    }
    if (isOne && !isReached(all[i]) && !isCutByClearing(all[i])) {
      place(all[i].area, all[i].byte, static_cast<int>(all[i].bytes));
    } else {
      for (std::uint32_t byte = all[i].byte; byte < end; ++byte) place(all[i].area, byte, 1);
    }
    i = next;
  }
  // Reached bytes that no other access names are state too.
  for (std::size_t a = 0; a < areaCount; ++a) {
    const ReachedRows& ofArea = reached_[a];
    for (std::uint32_t byte = ofArea.first; byte < ofArea.first + ofArea.count; ++byte) {
      if (!cellAt_.contains(keyOf(static_cast<Area>(a), byte))) place(static_cast<Area>(a), byte, 1);
    }
  }
}

std::optional<Row> LaneLayout::cell(Area area, std::uint32_t byte, int bytes) const {
  const auto found = cellAt_.find(keyOf(area, byte));
  if (found == cellAt_.end() || cells_[found->second].bytes != bytes) return std::nullopt;
  return Row{cells_[found->second].at, repFor(8 * bytes)};
}

std::vector<Row> LaneLayout::rowsWithin(Area area, std::uint32_t first, std::uint32_t count) const {
  std::vector<Row> found;
  for (std::uint32_t byte = first; byte < first + count; ++byte) {
    for (const int size : {1, 2, 4}) {
      if (const auto row = cell(area, byte, size)) found.push_back(*row);
    }
  }
  return found;
}

void LaneLayout::keepRows(std::size_t count, std::size_t truths) {
  kept_ = rows(count, Rep::Byte);
  keptTruths_ = rows(truths, Rep::Truth);
}

std::uint64_t numberIn(const std::uint8_t* rows, Row row, std::size_t lane, Form form) {
  const std::uint8_t* const from = rows + row.at;
  if (row.rep == Rep::Truth) return form == Form::Bytes ? from[lane] & 1U : from[lane / 8] >> (lane % 8) & 1U;
  const auto bytes = static_cast<std::size_t>(bitsOf(row.rep)) / 8;
  std::uint64_t value = 0;
  std::memcpy(&value, from + bytes * (form == Form::Wide ? lane : elementOf(row.rep, lane)), bytes);
  return value;
}

void setNumberIn(std::uint8_t* rows, Row row, std::size_t lane, Form form, std::uint64_t value) {
  std::uint8_t* const to = rows + row.at;
  if (row.rep == Rep::Truth && form != Form::Bytes) {
    const auto mask = static_cast<std::uint8_t>(1U << (lane % 8));
    to[lane / 8] = static_cast<std::uint8_t>((value & 1) != 0 ? to[lane / 8] | mask : to[lane / 8] & ~mask);
    return;
  }
  if (row.rep == Rep::Truth) value = (value & 1) != 0 ? 0xFF : 0;
  const std::size_t bytes = row.rep == Rep::Truth ? 1 : static_cast<std::size_t>(bitsOf(row.rep)) / 8;
  std::memcpy(to + bytes * (form == Form::Wide ? lane : elementOf(row.rep, lane)), &value, bytes);
}

}  // namespace rungproof::lanes
