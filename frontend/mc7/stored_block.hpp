// A block as it is stored: in the offline container of a STEP 7 project, or read out of a CPU. Both hold the same
// parts, which one decoder serves. Tested by tests/mc7/upload_test.cpp, tests/s7project.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontend/step7/block_catalogue.hpp"

namespace rungproof::mc7 {

/// Milliseconds since 1984-01-01; 0: not known.
using TimeStamp = std::uint64_t;
/// Of its six bytes: milliseconds of the day, days since 1984-01-01.
TimeStamp timeStampOf(std::string_view sixBytes);

enum class Language : std::uint8_t { None = 0, Stl = 1, Lad = 2, Fbd = 3, Scl = 4, Data = 5, Graph = 6 };
std::string_view languageName(std::uint8_t code);

/// A block named by another one, with the time stamps that it had then.
struct UsedBlock {
  step7::BlockKey key;
  TimeStamp interface = 0;
};

struct StoredBlock {
  step7::BlockKey key;
  std::string place;  ///< where it lies, for messages: "Plant.s7p: ombstx/offline/00000001"
  std::uint8_t language = 0;
  bool isProtected = false;
  bool isUnlinked = false, isNonRetain = false;
  std::string author, family, name;  ///< UTF-8
  std::uint8_t version = 0;
  std::uint16_t localBytes = 0;
  std::optional<std::uint16_t> checksum;  ///< nothing: not computed
  TimeStamp codeTime = 0, interfaceTime = 0;

  std::string code;                            ///< machine code; of a data block its actual values
  std::string declaration;                     ///< compiled
  std::string table;                           ///< lengths of networks, positions of jumps
  std::optional<std::string> declarationText;  ///< UTF-8; nothing: names are lost

  std::string title, comment;  ///< of the block, UTF-8
  /// A comment beside statements, or on a line of its own behind them.
  struct LineText {
    std::uint32_t line = 0;      ///< of the network in the editor, where a call has one more for each parameter
    bool isOfStatement = false;  ///< else: on a line of its own behind that one
    bool keepsApart = false;     ///< the statement opens a data block and is not one with the access behind it
    std::string text;            ///< UTF-8
  };
  struct NetworkText {
    std::string title, comment;
    std::vector<LineText> lines{};
  };
  std::vector<NetworkText> networkTexts;  ///< UTF-8
  std::vector<std::string> labels;        ///< of the jumps in the order of the table
  std::vector<UsedBlock> used;            ///< by its declaration and its code

  std::string damage;             ///< why its code or data cannot be read; empty: they can
  bool isLostWithOthers = false;  ///< the damage is that of a file, which is told once for all blocks in it

  bool isCode() const {
    return key.kind == step7::BlockKind::Ob || key.kind == step7::BlockKind::Fc || key.kind == step7::BlockKind::Fb;
  }
};

/// What the table says of networks and jumps.
struct NetworkTable {
  std::vector<std::uint32_t> lengths;        ///< bytes
  std::vector<std::uint32_t> jumpPositions;  ///< byte offsets of the jump instructions
  std::string fault;                         ///< why it cannot be read; empty: it can
};
NetworkTable readNetworkTable(std::string_view table);

/// Title and comment of one section of the comment row: 06, offsets, both texts ended by NUL. `mark`: its first byte.
StoredBlock::NetworkText readTitleRecord(std::string_view record, char mark);
/// The comments of lines behind the title of a network's section, texts as they are stored.
std::vector<StoredBlock::LineText> readLineRecords(std::string_view section);

/// CRC-16 with polynomial 0x9003 over type, length and code.
std::uint16_t checksumOf(step7::BlockKind kind, std::string_view code);
/// Of the types of blocks in headers and tables: 8 OB, 10 DB, 12 FC, 14 FB; nothing for others.
std::optional<step7::BlockKind> kindOfType(unsigned type);
unsigned typeOfKind(step7::BlockKind kind);

}  // namespace rungproof::mc7
