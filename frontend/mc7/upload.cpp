// Headers and footers of uploads.
#include "frontend/mc7/upload.hpp"

#include <fmt/format.h>

namespace rungproof::mc7 {

namespace {

constexpr std::size_t headerBytes = 36, footerBytes = 36;
constexpr std::uint8_t protectedBit = 0x08, nonRetainBit = 0x20;

std::uint32_t bigEndian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

std::string nameField(std::string_view bytes) {
  std::string text(bytes.substr(0, bytes.find('\0')));
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

void addNumber(std::string& bytes, std::uint32_t value, int count) {
  for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i));
}

void addStamp(std::string& bytes, TimeStamp stamp) {
  addNumber(bytes, static_cast<std::uint32_t>(stamp % 86'400'000), 4);
  addNumber(bytes, static_cast<std::uint32_t>(stamp / 86'400'000), 2);
}

}  // namespace

bool isUpload(std::string_view bytes) {
  return bytes.size() >= 6 && bytes.starts_with("pp") && kindOfType(static_cast<std::uint8_t>(bytes[5])).has_value() &&
         static_cast<std::uint8_t>(bytes[5]) >= 8 && static_cast<std::uint8_t>(bytes[2]) < 0x20;
}

StoredBlock readUpload(std::string_view bytes, std::string place) {
  StoredBlock block;
  block.place = std::move(place);
  block.key = {*kindOfType(static_cast<std::uint8_t>(bytes[5])), 0};
  if (bytes.size() < headerBytes) {
    block.damage = "the file ends within the header of the block";
    return block;
  }
  block.key.number = bigEndian(bytes, 6, 2);
  block.language = static_cast<std::uint8_t>(bytes[4]);
  block.isProtected = (static_cast<std::uint8_t>(bytes[3]) & protectedBit) != 0 || bigEndian(bytes, 12, 4) != 0;
  block.isNonRetain = (static_cast<std::uint8_t>(bytes[3]) & nonRetainBit) != 0;
  block.codeTime = timeStampOf(bytes.substr(16, 6));
  block.interfaceTime = timeStampOf(bytes.substr(22, 6));
  const std::size_t declaration = bigEndian(bytes, 28, 2), table = bigEndian(bytes, 30, 2),
                    code = bigEndian(bytes, 34, 2);
  block.localBytes = static_cast<std::uint16_t>(bigEndian(bytes, 32, 2));
  const std::size_t whole = headerBytes + code + declaration + table + footerBytes;
  if (bytes.size() < whole) {
    block.damage = fmt::format("the block has {} bytes by its header, the file only {}", whole, bytes.size());
    return block;
  }
  if (bigEndian(bytes, 8, 4) != whole) {
    block.damage = fmt::format("at byte 8: the parts of the block have {} bytes, the header says {}", whole,
                               bigEndian(bytes, 8, 4));
    return block;
  }
  block.code = bytes.substr(headerBytes, code);
  block.declaration = bytes.substr(headerBytes + code, declaration);
  block.table = bytes.substr(headerBytes + code + declaration, table);
  const std::string_view footer = bytes.substr(whole - footerBytes, footerBytes);
  block.author = nameField(footer.substr(0, 8));
  block.family = nameField(footer.substr(8, 8));
  block.name = nameField(footer.substr(16, 8));
  block.version = static_cast<std::uint8_t>(footer[24]);
  block.checksum = static_cast<std::uint16_t>(bigEndian(footer, 26, 2));
  if (*block.checksum == 0) block.checksum.reset();
  return block;
}

std::string writeUpload(const StoredBlock& block) {
  const auto length = [](const std::string& part) { return static_cast<std::uint32_t>(part.size()); };
  std::string bytes = "pp";
  bytes += '\1';
  bytes += static_cast<char>(1 | (block.isProtected ? protectedBit : 0) | (block.isNonRetain ? nonRetainBit : 0));
  bytes += static_cast<char>(block.language);
  bytes += static_cast<char>(typeOfKind(block.key.kind));
  addNumber(bytes, block.key.number, 2);
  addNumber(bytes,
            static_cast<std::uint32_t>(headerBytes + footerBytes) + length(block.code) + length(block.declaration) +
                length(block.table),
            4);
  addNumber(bytes, 0, 4);
  addStamp(bytes, block.codeTime);
  addStamp(bytes, block.interfaceTime);
  addNumber(bytes, length(block.declaration), 2);
  addNumber(bytes, length(block.table), 2);
  addNumber(bytes, block.localBytes, 2);
  addNumber(bytes, length(block.code), 2);
  bytes += block.code + block.declaration + block.table;
  for (const std::string* name : {&block.author, &block.family, &block.name}) {
    std::string field = name->substr(0, 8);
    field.resize(8);
    bytes += field;
  }
  bytes += static_cast<char>(block.version);
  bytes += '\0';
  addNumber(bytes, block.checksum.value_or(checksumOf(block.key.kind, block.code)), 2);
  bytes.append(8, '\0');
  return bytes;
}

}  // namespace rungproof::mc7
