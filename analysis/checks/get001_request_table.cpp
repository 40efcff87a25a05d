// GET001: the tables of GET and PUT, byte by byte, as constants and the data block fill them. What is calculated is not
// judged. Tested by its examples and tests/rules/request_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/machine/machine.hpp"
#include "ir/s7200/isa/ethernet.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t tableBytes = isa::requestTableBytes;
constexpr std::uint32_t reservedFrom = 5, reservedTo = 6, remoteAt = 7, lengthAt = 11, localAt = 12;
constexpr std::int64_t mostRead = 222, mostWritten = 212;

/// A value that something puts into a byte of the table.
struct ByteValue {
  std::uint8_t value;
  const Instruction* writer;  ///< nullptr: the data block
};
/// A pointer that a constant or &VB puts into the table.
struct PointerValue {
  Area area;
  std::uint32_t offset;
  bool isPlace;  ///< its area can be pointed to
  const Instruction* writer;
};

struct Table {
  const Instruction* request;
  Area area;
  std::uint32_t offset;
  bool isGet;
  std::array<std::vector<ByteValue>, tableBytes> values{};
  std::array<bool, tableBytes> isFilled{};  ///< something writes the byte, or may
  std::vector<PointerValue> remote{}, local{};

  std::int64_t mostData() const { return isGet ? mostRead : mostWritten; }
};

/// V memory that GET fills.
struct Buffer {
  const Table* table;
  const Instruction* writer;
  std::uint32_t first, last;
};

class TableCheck {
 public:
  TableCheck(const Facts& facts, FindingSink& sink) : facts_(facts), sink_(sink) {
    for (const InstructionPlace& place :
         facts.placesOf([](const Desc& desc) { return desc.role == Role::Get || desc.role == Role::Put; })) {
      const Role role = roleOf(*place.instruction);
      if ((role != Role::Get && role != Role::Put) || place.instruction->operands.empty()) continue;
      const Operand& table = place.instruction->operands[0];
      if (table.kind != OperandKind::Direct) continue;
      const bool isKnown = std::ranges::any_of(
          tables_, [&](const Table& t) { return t.area == table.area && t.offset == table.offset; });
      if (!isKnown) tables_.push_back({place.instruction, table.area, table.offset, role == Role::Get});
    }
  }

  void run() {
    for (Table& table : tables_) fill(table);
    for (const Table& table : tables_) {
      place(table);
      contents(table);
    }
    overlaps();
    for (const Table& table : tables_) buffers(table);
    bufferUses();
  }

 private:
  Finding& report(const Table& table, const Instruction* writer, std::uint32_t at, Width width, std::string message,
                  std::string help) {
    const Instruction& place = writer == nullptr ? *table.request : *writer;
    Finding& finding = sink_.report(place.span, std::move(message));
    finding.address = addressName(table.area, width, table.offset + at);
    if (writer != nullptr) finding.related.push_back({table.request->span, "the request"});
    finding.help = std::move(help);
    return finding;
  }
  std::string nameOf(const Table& table) const { return Facts::text(*table.request); }
  static bool isRequest(const Instruction& instruction) {
    return roleOf(instruction) == Role::Get || roleOf(instruction) == Role::Put;
  }

  // What the program and the data block put into the table -----------------------------------------------------------

  void fill(Table& table) {
    const CellMap& cells = facts_.index().cells();
    for (std::uint32_t k = 0; k < tableBytes; ++k) {
      const std::uint32_t cell = cells.cell(table.area, table.offset + k, 0);
      if (cell == cells.size()) continue;
      table.isFilled[k] = facts_.index().isWrittenAtLarge(cell) || facts_.isExternal(cell);
    }
    for (const DataInit& init : facts_.program().data) {
      for (std::uint32_t k = 0; k < init.bytes.size() && table.area == Area::V; ++k) {
        const std::uint32_t at = init.offset + k - table.offset;
        if (at < tableBytes) table.values[at].push_back({init.bytes[k], nullptr});
      }
    }
    for (const Access& access : facts_.accesses().all()) {
      if (!access.write || access.viaPointer || access.byNumber() || access.area != table.area) continue;
      const Instruction& instruction = facts_.instruction(access.instruction);
      if (isRequest(instruction)) continue;
      for (std::uint32_t k = 0; k < access.possibleLength(); ++k) {
        if (access.offset + k - table.offset < tableBytes) table.isFilled[access.offset + k - table.offset] = true;
      }
      if (roleOf(instruction) == Role::Move && access.most == 1 && access.width != Width::Bit)
        moved(table, access, instruction);
    }
  }
  void moved(Table& table, const Access& access, const Instruction& instruction) {
    const Operand& source = instruction.operands[0];
    const auto length = access.certainLength();
    const std::uint32_t at = access.offset - table.offset;
    const bool isPointer = length == 4 && (at == remoteAt || at == localAt);
    auto& pointers = at == remoteAt ? table.remote : table.local;
    if (source.kind == OperandKind::Address && isPointer) {
      pointers.push_back({source.area, source.offset, areaInfo(source.area).tag.has_value(), &instruction});
    } else if (source.kind == OperandKind::Constant) {
      const auto bits = static_cast<std::uint32_t>(source.value);
      const std::optional<Area> area = pointer::areaOf(bits);
      if (isPointer)
        pointers.push_back({area.value_or(Area::V), pointer::offsetOf(bits), area.has_value(), &instruction});
      for (std::uint32_t k = 0; k < length; ++k) {
        if (at + k < tableBytes)
          table.values[at + k].push_back({static_cast<std::uint8_t>(bits >> 8 * (length - 1 - k)), &instruction});
      }
    }
  }

  // The table ---------------------------------------------------------------------------------------------------------

  void place(const Table& table) {
    if (table.offset + tableBytes <= areaSize(facts_.target(), table.area)) return;
    report(table, nullptr, 0, Width::Byte,
           fmt::format("the table of {} has {} bytes and reaches beyond the end of {} memory", nameOf(table),
                       tableBytes, areaName(table.area)),
           "place it further down, or choose the CPU with --cpu");
  }

  void contents(const Table& table) {
    for (std::uint32_t at = reservedFrom; at <= reservedTo; ++at) {
      for (const ByteValue& byte : table.values[at]) {
        if (byte.value == 0) continue;
        report(table, byte.writer, at, Width::Byte,
               fmt::format("byte {} of the table of {} must be 0 and gets {}", at, nameOf(table), byte.value),
               "bytes 5 and 6 are reserved; bytes 1 to 4 hold the address of the partner");
        break;
      }
    }
    for (const ByteValue& byte : table.values[lengthAt]) {
      if (byte.value >= 1 && byte.value <= table.mostData()) continue;
      report(table, byte.writer, lengthAt, Width::Byte,
             fmt::format("{} is to {} {} bytes; it can be 1 to {}", nameOf(table), table.isGet ? "read" : "write",
                         byte.value, table.mostData()),
             "split the data over several requests");
    }
    pointers(table, table.remote, remoteAt, "data of the partner");
    pointers(table, table.local, localAt, table.isGet ? "place for the data" : "data");
    if (facts_.hasHiddenCode()) return;
    const auto isEmpty = [&](std::uint32_t from, std::uint32_t to) {
      return std::none_of(table.isFilled.begin() + from, table.isFilled.begin() + to + 1, [](bool f) { return f; });
    };
    const std::string help = "fill it before the first request, or in the data block";
    if (isEmpty(1, tableBytes - 1)) {
      report(table, nullptr, 0, Width::Byte, fmt::format("nothing fills the table of {}", nameOf(table)), help);
    } else if (isEmpty(lengthAt, lengthAt)) {
      report(table, nullptr, lengthAt, Width::Byte, fmt::format("nothing writes the length of {}", nameOf(table)),
             help);
    } else if (isEmpty(localAt, localAt + 3) || isEmpty(remoteAt, remoteAt + 3)) {
      const std::uint32_t at = isEmpty(remoteAt, remoteAt + 3) ? remoteAt : localAt;
      report(table, nullptr, at, Width::DWord,
             fmt::format("nothing writes the pointer to the {} data of {}", at == remoteAt ? "partner's" : "own",
                         nameOf(table)),
             help);
    } else if (isEmpty(1, 4)) {
      report(table, nullptr, 1, Width::Byte, fmt::format("nothing writes the partner's address of {}", nameOf(table)),
             help);
    }
  }
  void pointers(const Table& table, const std::vector<PointerValue>& pointers, std::uint32_t at,
                std::string_view what) {
    for (const PointerValue& pointer : pointers) {
      const bool isAllowed = pointer.isPlace && (pointer.area == Area::I || pointer.area == Area::Q ||
                                                 pointer.area == Area::M || pointer.area == Area::V);
      if (isAllowed) continue;
      report(table, pointer.writer, at, Width::DWord,
             fmt::format("the {} of {} must lie in I, Q, M or V", what, nameOf(table)),
             "write a pointer such as &VB100");
    }
  }

  /// Tables that share bytes, and words of the program that reach into one.
  void overlaps() {
    for (std::size_t i = 0; i < tables_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Table &a = tables_[i], &b = tables_[k];
        const std::uint32_t distance = a.offset > b.offset ? a.offset - b.offset : b.offset - a.offset;
        if (a.area != b.area || distance >= tableBytes) continue;
        report(a, nullptr, 0, Width::Byte, fmt::format("the tables of {} and {} overlap", nameOf(b), nameOf(a)),
               fmt::format("a table has {} bytes", tableBytes))
            .related.push_back({b.request->span, "the other request"});
      }
    }
    for (const Table& table : tables_) {
      for (const Access& access : facts_.accesses().all()) {
        if (access.viaPointer || access.byNumber() || access.area != table.area || access.most > 1) continue;
        const std::uint32_t end = access.offset + access.certainLength(), last = table.offset + tableBytes;
        const bool crosses = access.offset < last && end > table.offset && (access.offset < table.offset || end > last);
        if (!crosses) continue;
        const Instruction& instruction = facts_.instruction(access.instruction);
        report(table, &instruction, 0, Width::Byte,
               fmt::format("{} in {} reaches into the table of {}", accessName(access), Facts::text(instruction),
                           nameOf(table)),
               fmt::format("the table is {} to {}", addressName(table.area, Width::Byte, table.offset),
                           addressName(table.area, Width::Byte, last - 1)));
        break;
      }
    }
  }

  // The data ----------------------------------------------------------------------------------------------------------

  void buffers(const Table& table) {
    std::int64_t length = 1;
    for (const ByteValue& byte : table.values[lengthAt]) {
      if (byte.value <= table.mostData()) length = std::max<std::int64_t>(length, byte.value);
    }
    for (const PointerValue& pointer : table.local) {
      if (!pointer.isPlace || pointer.area == Area::I) continue;
      const std::uint32_t last = pointer.offset + static_cast<std::uint32_t>(length) - 1;
      const std::string range = fmt::format("{} to {}", addressName(pointer.area, Width::Byte, pointer.offset),
                                            addressName(pointer.area, Width::Byte, last));
      if (last >= areaSize(facts_.target(), pointer.area)) {
        report(table, pointer.writer, localAt, Width::DWord,
               fmt::format("the data of {}, {}, reach beyond the end of {} memory", nameOf(table), range,
                           areaName(pointer.area)),
               "place the buffer further down");
        continue;
      }
      if (!table.isGet) continue;
      for (const Table& other : tables_) {
        if (other.area != pointer.area || last < other.offset || pointer.offset >= other.offset + tableBytes) continue;
        report(
            table, pointer.writer, localAt, Width::DWord,
            fmt::format("the data that {} reads, {}, fall into the table of {}", nameOf(table), range, nameOf(other)),
            "keep data and tables apart");
      }
      for (const Buffer& other : buffers_) {
        if (other.table == &table || pointer.area != Area::V || last < other.first || pointer.offset > other.last)
          continue;
        report(
            table, pointer.writer, localAt, Width::DWord,
            fmt::format("the data that {} reads, {}, overlap those of {}", nameOf(table), range, nameOf(*other.table)),
            "give each request a buffer of its own")
            .related.push_back({other.writer->span, "the other buffer"});
      }
      if (pointer.area == Area::V) buffers_.push_back({&table, pointer.writer, pointer.offset, last});
    }
  }

  /// Values that the program puts where GET puts its own.
  void bufferUses() {
    for (const Buffer& buffer : buffers_) {
      for (const Access& access : facts_.accesses().all()) {
        if (!access.write || access.viaPointer || access.area != Area::V || access.offset > buffer.last ||
            access.offset + access.certainLength() <= buffer.first)
          continue;
        const Instruction& instruction = facts_.instruction(access.instruction);
        if (isRequest(instruction) || isInTable(access) || !isOwnValue(instruction, access)) continue;
        Finding& finding = report(*buffer.table, &instruction, localAt, Width::DWord,
                                  fmt::format("{} writes {} into the data that {} reads", Facts::text(instruction),
                                              accessName(access), nameOf(*buffer.table)),
                                  "copy the data out of the buffer first, or move the word");
        finding.address = accessName(access);
        break;
      }
    }
  }
  bool isInTable(const Access& access) const {
    return std::ranges::any_of(tables_, [&](const Table& table) {
      return table.area == access.area && access.offset >= table.offset && access.offset < table.offset + tableBytes;
    });
  }
  /// Clearing the buffer, and working on what has been read, are no use of their own.
  static bool isOwnValue(const Instruction& instruction, const Access& access) {
    const Desc& desc = *instruction.desc;
    const bool isInPlace = desc.control != Control::Call && access.operand < desc.operandCount &&
                           desc.operands[access.operand].direction == Direction::InOut;
    if (isInPlace || isSet(desc.role) || isReset(desc.role) || desc.role == Role::Fill) return false;
    return desc.role != Role::Move || instruction.operands[0].kind != OperandKind::Constant;
  }

  const Facts& facts_;
  FindingSink& sink_;
  std::vector<Table> tables_;
  std::vector<Buffer> buffers_;
};

void checkGet001(const Facts& facts, FindingSink& sink) { TableCheck(facts, sink).run(); }

}  // namespace

extern constexpr Rule get001_request_table = {
    .id = "GET001",
    .title = "GET/PUT table wrong",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a table of GET or PUT that leaves its area, is never filled or overlaps another one; reserved bytes that are "
        "not 0, a length beyond 222 (GET) or 212 (PUT), pointers outside I, Q, M and V; a buffer of GET that the "
        "program or another request writes",
    .why = "the request ends with an error, or data from the network overwrite something else",
    .bad =
        "Network 1\nLD SM0.1\nMOVB 192, VB781\nMOVB 168, VB782\nMOVB 2, VB783\nMOVB 10, VB784\nMOVD &VB100, VD787\n"
        "MOVB 230, VB791\nMOVD &VB200, VD792\nNetwork 2\nLD I0.0\nEU\nGET VB780\n",
    .good =
        "Network 1\nLD SM0.1\nMOVB 192, VB781\nMOVB 168, VB782\nMOVB 2, VB783\nMOVB 10, VB784\nMOVW 0, VW785\n"
        "MOVD &VB100, VD787\nMOVB 20, VB791\nMOVD &VB200, VD792\nNetwork 2\nLD I0.0\nEU\nGET VB780\n",
    .exampleCpu = "ST40",
    .dialects = dialect::S7200,
    .check = checkGet001,
};

}  // namespace rungproof
