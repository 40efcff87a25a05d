// Writing projects.
#include "tests/s7project/project_writer.hpp"

#include <fmt/format.h>
#include <zlib.h>

namespace rungproof::test {

namespace {

using mc7::StoredBlock;
using step7::BlockKind;

void addNumber(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i));
}

std::string stampBytes(mc7::TimeStamp stamp) {
  std::string bytes;
  const std::uint64_t ofDay = stamp % 86'400'000, day = stamp / 86'400'000;
  for (int i = 3; i >= 0; --i) bytes += static_cast<char>(ofDay >> (8 * i));
  bytes += static_cast<char>(day >> 8);
  bytes += static_cast<char>(day);
  return bytes;
}

/// SUBBLKTYP of code, declaration and comments.
struct PartTypes {
  int code, declaration, comments, used;
};
PartTypes typesOf(BlockKind kind) {
  switch (kind) {
    case BlockKind::Ob: return {8, 3, 17, 67};
    case BlockKind::Fc: return {12, 5, 19, 65};
    case BlockKind::Fb: return {14, 4, 18, 64};
    case BlockKind::Sfc: return {13, 7, 22, 70};
    case BlockKind::Sfb: return {15, 9, 21, 71};
    case BlockKind::Db: return {10, 6, 20, 66};
    default: return {-1, 1, 39, 69};
  }
}

std::string titleRecord(const std::string& title, const std::string& comment) {
  std::string record = "\x06";
  addNumber(record, 7 + title.size(), 2);
  addNumber(record, 8 + title.size() + comment.size(), 2);
  record += "\x06" + title + '\0' + comment + '\0';
  return record;
}

class ContainerWriter {
 public:
  void add(const StoredBlock& block, bool isDeleted) {
    ++id_;
    blocks_.add({{"ID", fmt::format("{:05}", id_)},
                 {"TYP", fmt::format("{:05}", mc7::typeOfKind(block.key.kind))},
                 {"NUMMER", fmt::format("{:05}", block.key.number)}},
                isDeleted);
    const PartTypes types = typesOf(block.key.kind);
    if (types.code >= 0) part(block, types.code, block.code, block.declaration, block.table, isDeleted);
    if (block.declarationText) part(block, types.declaration, *block.declarationText + '\0', "", "", isDeleted);
    comments(block, types.comments, isDeleted);
    if (!block.used.empty()) {
      std::string list;
      for (const mc7::UsedBlock& used : block.used)
        list += toString(used.key) + "," + stampBytes(used.interface) + stampBytes(0) + ";";
      part(block, types.used, list, "", "", isDeleted);
    }
  }

  void write(const std::string& folder, std::map<std::string, std::string>& files) const {
    // Letters in mixed case, as they differ from project to project.
    files[folder + "/BAUSTEIN.DBF"] = blocks_.table();
    files[folder + "/Baustein.dbt"] = blocks_.memos();
    files[folder + "/subblk.DBF"] = parts_.table();
    files[folder + "/SUBBLK.DBT"] = parts_.memos();
  }

 private:
  void part(const StoredBlock& block, int type, const std::string& code, const std::string& head,
            const std::string& info, bool isDeleted) {
    const std::uint16_t sum = block.checksum.value_or(0);
    parts_.add({{"OBJECTID", fmt::format("{:05}", id_)},
                {"BLKLANG", fmt::format("{:05}", block.language)},
                {"SUBBLKTYP", fmt::format("{:05}", type)},
                {"BLKNUMBER", fmt::format("{:05}", block.key.number)},
                {"ATTRIBUTE", "00001"},
                {"BLKTOTLEN", fmt::format("{:05}", code.size() + head.size() + info.size() + 78)},
                {"MC5LEN", fmt::format("{:05}", code.size())},
                {"SSBLEN", fmt::format("{:05}", head.size())},
                {"ADDLEN", fmt::format("{:05}", info.size())},
                {"LOCDATALEN", fmt::format("{:05}", block.localBytes)},
                {"TIMESTAMP1", stampBytes(block.codeTime)},
                {"TIMESTAMP2", stampBytes(block.interfaceTime)},
                {"PASSWORD", block.isProtected ? "00003" : "00000"},
                {"USERNAME", block.author},
                {"BLOCKFNAME", block.family},
                {"BLOCKNAME", block.name},
                {"VERSION", fmt::format("{:05}", block.version)},
                {"CHECKSUM", fmt::format("{:05}", (sum & 0xFF) << 8 | sum >> 8)},
                {"MC5CODE", parts_.memo(code)},
                {"SSBPART", parts_.memo(head)},
                {"ADDINFO", parts_.memo(info)}},
               isDeleted);
  }

  void comments(const StoredBlock& block, int type, bool isDeleted) {
    if (block.networkTexts.empty() && block.title.empty()) return;
    std::string texts, info;
    addNumber(info, block.networkTexts.size(), 2);
    for (const StoredBlock::NetworkText& network : block.networkTexts) {
      const std::string record = titleRecord(network.title, network.comment) + std::string("\0\0\0\0\x20\xFF", 6);
      addNumber(info, record.size(), 2);
      texts += record;
    }
    addNumber(info, block.labels.size(), 2);
    for (const std::string& label : block.labels) {
      std::string field = label;
      field.resize(5);
      info += field;
    }
    info += "stale bytes";
    std::string head = "\x03";
    addNumber(head, 4 + block.title.size(), 2);
    head += block.title + '\0' + block.comment + '\0';
    part(block, type, texts, head, info, isDeleted);
  }

  int id_ = 0;
  TableWriter blocks_{{{"ID", 'N', 5}, {"TYP", 'C', 5}, {"NUMMER", 'C', 5}, {"ATTRIBS", 'C', 40}, {"UDA", 'M', 10}}};
  TableWriter parts_{{{"OBJECTID", 'N', 5},  {"BLKLANG", 'C', 5},    {"SUBBLKTYP", 'C', 5},  {"BLKNUMBER", 'C', 5},
                      {"ATTRIBUTE", 'C', 5}, {"BLKTOTLEN", 'C', 5},  {"MC5LEN", 'C', 5},     {"SSBLEN", 'C', 5},
                      {"ADDLEN", 'C', 5},    {"LOCDATALEN", 'C', 5}, {"TIMESTAMP1", 'C', 6}, {"TIMESTAMP2", 'C', 6},
                      {"PASSWORD", 'C', 5},  {"USERNAME", 'C', 8},   {"BLOCKFNAME", 'C', 8}, {"BLOCKNAME", 'C', 8},
                      {"VERSION", 'C', 5},   {"CHECKSUM", 'C', 5},   {"MC5CODE", 'M', 10},   {"SSBPART", 'M', 10},
                      {"ADDINFO", 'M', 10}}};
};

}  // namespace

void TableWriter::add(const std::map<std::string, std::string>& fields, bool isDeleted) {
  std::string row(1, isDeleted ? '*' : ' ');
  for (const Column& column : columns_) {
    const auto value = fields.find(column.name);
    std::string field = value == fields.end() ? "" : value->second;
    field.resize(column.length, column.type == 'C' ? '\0' : ' ');
    row += field;
  }
  rows_.push_back(std::move(row));
}

std::string TableWriter::memo(const std::string& contents) {
  if (contents.empty()) return "";
  const std::size_t number = memos_.size() / 512;
  memos_ += std::string("\xFF\xFF\x08\x00", 4);
  addNumber(memos_, contents.size() + 8, 4);
  memos_ += contents;
  memos_.resize((memos_.size() + 511) / 512 * 512, '\xA5');
  return fmt::format("{:010}", number);
}

std::string TableWriter::table() const {
  std::string bytes = "\x8B";
  bytes.append(3, '\1');
  std::size_t record = 1;
  for (const Column& column : columns_) record += column.length;
  addNumber(bytes, rows_.size(), 4);
  addNumber(bytes, 32 + 32 * columns_.size() + 1, 2);
  addNumber(bytes, record, 2);
  bytes.resize(32);
  for (const Column& column : columns_) {
    std::string field = column.name;
    field.resize(11);
    field += column.type;
    field.resize(16);
    field += static_cast<char>(column.length);
    field.resize(32);
    bytes += field;
  }
  bytes += '\r';
  for (const std::string& row : rows_) bytes += row;
  return bytes + '\x1A';
}

std::string TableWriter::memos() const {
  std::string bytes = memos_;
  bytes[20] = '\0';
  bytes[21] = '\2';
  return bytes;
}

namespace {

/// A container of text sources; those that were deleted stay among its rows.
void writeSources(const std::map<std::string, std::string>& sources, const std::string& folder,
                  std::map<std::string, std::string>& files) {
  if (sources.empty()) return;
  TableWriter rows({{"NAME", 'C', 24}, {"TYPE", 'N', 10}, {"FILENAME", 'C', 12}});
  int number = 0;
  for (const auto& [name, text] : sources) {
    const std::string file = fmt::format("{:08x}.AWL", ++number);
    rows.add({{"NAME", name}, {"TYPE", "1122309"}, {"FILENAME", file}});
    rows.add({{"NAME", "old " + name}, {"TYPE", "1122309"}, {"FILENAME", "gone.AWL"}}, true);
    files[folder + "/" + file] = text;
  }
  files[folder + "/S7CONTAI.DBF"] = rows.table();
}

}  // namespace

std::map<std::string, std::string> writeProject(const std::vector<ProjectPart>& programs, unsigned page,
                                                const std::string& name) {
  std::map<std::string, std::string> files;
  std::string project(4, '\0');
  project += static_cast<char>(name.size());
  files[name + ".s7p"] = project + name + std::string(4, '\0');
  if (page != 0) files["global/Language"] = fmt::format("1\n1033\n?\n{}\n850\nEnglish\n", page);
  TableWriter rows({{"ID", 'N', 10}, {"NAME", 'C', 40}, {"HWTYPE", 'N', 10}, {"RSRVD4_L", 'N', 10}});
  TableWriter links({{"TOT", 'N', 10}, {"TOI", 'N', 10}, {"SOI", 'N', 10}}),
      lists({{"_ID", 'N', 10}, {"_DBPATH", 'C', 10}});
  TableWriter cpus({{"ID", 'N', 10}, {"OBJTYP", 'N', 10}, {"NAME", 'C', 30}});
  TableWriter relations({{"SOBJID", 'N', 10}, {"RELID", 'N', 10}, {"TOBJID", 'N', 10}, {"TUNITID", 'N', 10}});
  TableWriter attributes({{"IDM", 'N', 10}, {"ATTRIIDM", 'N', 10}, {"MEMOARRAYM", 'M', 10}});
  TableWriter stations({{"ID", 'N', 10}, {"OBJTYP", 'N', 10}, {"NAME", 'C', 30}});
  std::string chain = "KNIL";
  chain.resize(16);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const ProjectPart& part = programs[i];
    const std::size_t id = 100 + i, container = 13 + i, list = 7 + i, cpu = 40 + i, station = 0x1A + i;
    rows.add({{"ID", std::to_string(id)}, {"NAME", part.name}, {"RSRVD4_L", std::to_string(chain.size())}});
    rows.add({{"ID", std::to_string(id)}, {"NAME", "old " + part.name}, {"RSRVD4_L", "4"}}, true);
    const std::size_t offset = chain.size();
    addNumber(chain, offset, 4);
    addNumber(chain, 2, 4);
    chain.resize(offset + 0x18);
    const std::size_t sources = 3 + i;
    for (const auto& [type, target] :
         {std::pair<std::uint32_t, std::size_t>{0x113001, list}, {0x116001, container}, {0x112004, sources}}) {
      addNumber(chain, type, 4);
      addNumber(chain, target, 4);
      chain.resize(chain.size() + 16);
    }
    writeSources(part.sources, fmt::format("s7asrcom/{:08x}", sources), files);
    ContainerWriter blocks;
    for (const StoredBlock& block : part.deleted) blocks.add(block, true);
    for (const StoredBlock& block : part.blocks) blocks.add(block, false);
    blocks.write(fmt::format("OMBSTX/offline/{:08X}", container), files);
    links.add({{"TOT", "1327361"}, {"TOI", std::to_string(id)}, {"SOI", std::to_string(list)}});
    lists.add({{"_ID", std::to_string(list)}, {"_DBPATH", std::to_string(list)}});
    TableWriter symbols({{"_SKZ", 'C', 24}, {"_OPIEC", 'C', 12}, {"_DATATYP", 'C', 10}, {"_COMMENT", 'C', 80}});
    for (const ProjectPart::Symbol& symbol : part.symbols) {
      symbols.add(
          {{"_SKZ", symbol.name}, {"_OPIEC", symbol.address}, {"_DATATYP", symbol.type}, {"_COMMENT", symbol.comment}});
      symbols.add({{"_SKZ", "gone " + symbol.name}, {"_OPIEC", symbol.address}}, true);
    }
    files[fmt::format("YDBS/{}/Symlist.dbf", list)] = symbols.table();
    if (part.cpu.empty()) continue;
    cpus.add({{"ID", std::to_string(cpu)}, {"OBJTYP", "1316617"}, {"NAME", part.cpu}});
    relations.add({{"SOBJID", std::to_string(cpu)}, {"RELID", "16"}, {"TOBJID", std::to_string(id)}});
    relations.add({{"SOBJID", std::to_string(cpu)}, {"RELID", "1315827"}, {"TUNITID", std::to_string(station)}});
    stations.add(
        {{"ID", std::to_string(station)}, {"OBJTYP", "1314969"}, {"NAME", fmt::format("SIMATIC 300({})", i + 1)}});
    std::string sets;
    for (const auto& [number, data] : part.dataSets) {
      sets += static_cast<char>(data.size() + 2);
      sets += static_cast<char>(number);
      sets += data;
    }
    if (!sets.empty())
      attributes.add(
          {{"IDM", std::to_string(cpu)}, {"ATTRIIDM", "110717"}, {"MEMOARRAYM", attributes.memo(sets + '\0')}});
    if (!part.orderNumber.empty())
      files[fmt::format("hOmSave7/s7hstatx/{:08x}.s7h", station)] =
          "\x03"
          "002\x06"
          "CPU\x13" +
          part.orderNumber + "\x04V2.0";
  }
  files["hrs/S7RESOFF.DBF"] = rows.table();
  files["hrs/linkhrs.lnk"] = chain;
  files["YDBS/YLNKLIST.DBF"] = links.table();
  files["YDBS/SYMLISTS.DBF"] = lists.table();
  if (cpus.rows() > 0) {
    files["hOmSave7/S7HK31AX/HOBJECT1.DBF"] = cpus.table();
    files["hOmSave7/S7HK31AX/HRELATI1.DBF"] = relations.table();
    files["hOmSave7/S7HK31AX/HATTRME1.DBF"] = attributes.table();
    files["hOmSave7/S7HK31AX/HATTRME1.DBT"] = attributes.memos();
    files["hOmSave7/s7hstatx/HOBJECT1.DBF"] = stations.table();
  }
  return files;
}

std::string zipOf(const std::map<std::string, std::string>& files, const std::string& folder) {
  std::string archive, directory;
  std::size_t count = 0;
  for (const auto& [path, contents] : files) {
    std::string name = folder + "\\" + path;
    for (char& c : name) c = c == '/' ? '\\' : c;
    // Every second file is packed.
    std::string packed = contents;
    const bool isPacked = count++ % 2 == 0;
    if (isPacked) {
      z_stream stream{};
      deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
      packed.resize(deflateBound(&stream, contents.size()));
      std::string input = contents;
      stream.next_in = reinterpret_cast<Bytef*>(input.data());
      stream.avail_in = static_cast<uInt>(input.size());
      stream.next_out = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_out = static_cast<uInt>(packed.size());
      deflate(&stream, Z_FINISH);
      packed.resize(stream.total_out);
      deflateEnd(&stream);
    }
    std::string head;
    addNumber(head, 20, 2);
    addNumber(head, 0, 2);
    addNumber(head, isPacked ? 8 : 0, 2);
    addNumber(head, 0, 4);
    addNumber(head, 0, 4);
    addNumber(head, packed.size(), 4);
    addNumber(head, contents.size(), 4);
    addNumber(head, name.size(), 2);
    addNumber(head, 0, 2);
    directory += std::string("PK\1\2\x14\0", 6) + head;
    addNumber(directory, 0, 2);
    addNumber(directory, 0, 2);
    addNumber(directory, 0, 2);
    addNumber(directory, 0, 4);
    addNumber(directory, archive.size(), 4);
    directory += name;
    archive += std::string("PK\3\4", 4) + head + name + packed;
  }
  std::string end("PK\5\6\0\0\0\0", 8);
  addNumber(end, count, 2);
  addNumber(end, count, 2);
  addNumber(end, directory.size(), 4);
  addNumber(end, archive.size(), 4);
  addNumber(end, 0, 2);
  return archive + directory + end;
}

}  // namespace rungproof::test
