// Reading tables.
#include "frontend/s7project/dbase.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::s7project {

namespace {

std::uint64_t littleNumber(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

constexpr std::size_t descriptorBytes = 32, memoHeadBytes = 8;
constexpr char headerEnd = 0x0D, deletedMark = '*';

}  // namespace

DbaseTable::DbaseTable(std::string bytes, std::optional<std::string> memoBytes, std::vector<std::string>& faults)
    : bytes_(std::move(bytes)), memos_(std::move(memoBytes)) {
  const std::string_view all = bytes_;
  if (all.size() < descriptorBytes + 1 || (all[0] != '\x03' && all[0] != '\x8B' && all[0] != '\x83')) {
    faults.emplace_back("byte 0: it is no table of dBase III or IV");
    return;
  }
  const std::size_t count = littleNumber(all, 4, 4);
  header_ = littleNumber(all, 8, 2);
  record_ = littleNumber(all, 10, 2);
  std::size_t at = 1;  // behind the deletion flag
  std::size_t descriptor = descriptorBytes;
  for (; descriptor < all.size() && all[descriptor] != headerEnd; descriptor += descriptorBytes) {
    if (descriptor + descriptorBytes > all.size() || descriptor + descriptorBytes > header_) {
      faults.push_back(fmt::format("byte {}: the list of its fields is cut off", descriptor));
      return;
    }
    const std::string_view name = all.substr(descriptor, 11);
    fields_.push_back({std::string(name.substr(0, name.find('\0'))), all[descriptor + 11], at,
                       static_cast<std::uint8_t>(all[descriptor + 16])});
    at += fields_.back().length;
  }
  if (record_ == 0 || at > record_ || header_ > all.size()) {
    faults.push_back(fmt::format("byte 8: header and records have no possible length ({} and {})", header_, record_));
    fields_.clear();
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = header_ + i * record_;
    if (begin + record_ > all.size()) {
      faults.push_back(fmt::format("byte {}: record {} of {} lies behind the end of the file", begin, i + 1, count));
      return;
    }
    if (all[begin] != deletedMark) live_.push_back(i);
  }
}

const DbaseTable::Field* DbaseTable::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(fields_, [&](const Field& field) { return equalsIgnoringCase(field.name, name); });
  return found == fields_.end() ? nullptr : &*found;
}

bool DbaseTable::lacksMemos() const {
  return !memos_ &&
         std::ranges::any_of(fields_, [](const Field& field) { return field.type == 'M' || field.type == 'B'; });
}

std::string_view DbaseTable::raw(std::size_t row, std::string_view name) const {
  const Field* field = find(name);
  if (field == nullptr) return {};
  return std::string_view(bytes_).substr(header_ + live_[row] * record_ + field->at, field->length);
}

std::string_view DbaseTable::text(std::size_t row, std::string_view name) const {
  const std::string_view bytes = raw(row, name);
  return trimmed(bytes.substr(0, bytes.find('\0')));
}

std::optional<std::int64_t> DbaseTable::number(std::size_t row, std::string_view name) const {
  std::string_view digits = text(row, name);
  const bool isNegative = digits.starts_with('-');
  if (isNegative) digits.remove_prefix(1);
  if (const std::size_t point = digits.find('.'); point != std::string_view::npos) digits = digits.substr(0, point);
  if (digits.empty() || digits.size() > 18) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + (c - '0');
  }
  return isNegative ? -value : value;
}

std::int64_t DbaseTable::numberOrByte(std::size_t row, std::string_view name) const {
  const std::string_view bytes = raw(row, name);
  if (bytes.size() == 1 && (bytes[0] < '0' || bytes[0] > '9') && bytes[0] != ' ')
    return static_cast<std::uint8_t>(bytes[0]);
  return number(row, name).value_or(0);
}

DbaseTable::Memo DbaseTable::memo(std::size_t row, std::string_view name) const {
  const std::optional<std::int64_t> block = number(row, name);
  if (!block || *block == 0) return {};
  if (!memos_) return {{}, fmt::format("{} lies in a memo file that is missing", name)};
  const std::string_view all = *memos_;
  std::size_t unit = all.size() > 22 ? littleNumber(all, 20, 2) : 0;
  if (unit == 0) unit = 512;
  const std::size_t at = static_cast<std::size_t>(*block) * unit;
  if (*block < 0 || at + memoHeadBytes > all.size())
    return {{}, fmt::format("memo {} of {} lies behind the end of the memo file", *block, name)};
  if (!all.substr(at).starts_with(std::string_view("\xFF\xFF\x08\x00", 4)))
    return {{}, fmt::format("memo {} of {}, byte {} of the memo file: no memo begins there", *block, name, at)};
  const std::size_t length = littleNumber(all, at + 4, 4);
  if (length < memoHeadBytes || length > all.size() - at)
    return {{},
            fmt::format("memo {} of {}, byte {} of the memo file: its length {} is not possible", *block, name, at,
                        length)};
  return {std::string(all.substr(at + memoHeadBytes, length - memoHeadBytes)), {}};
}

}  // namespace rungproof::s7project
