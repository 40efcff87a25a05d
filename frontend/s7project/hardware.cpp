// Stations, CPUs and their parameters.
#include "frontend/s7project/hardware.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "frontend/s7project/dbase.hpp"

namespace rungproof::s7project {

namespace {

constexpr std::int64_t relationToProgram = 16, relationToStation = 1315827, parameterAttribute = 110717;

std::uint16_t parameterWord(std::string_view data, std::size_t at) {
  if (at + 2 > data.size()) return 0;
  return static_cast<std::uint16_t>(static_cast<std::uint8_t>(data[at]) << 8 | static_cast<std::uint8_t>(data[at + 1]));
}

/// Object types of CPUs whose order number stands in no file, as in projects before V5.2.
constexpr std::array<std::pair<std::int64_t, std::string_view>, 23> orderNumbers = {{
    {1316617, "315-2AG10"}, {2364935, "315-2AH14"}, {2363560, "315-2EG10"}, {1316180, "315-2AF03"},
    {1315174, "315-2AF01"}, {1316598, "313-5BE01"}, {1316291, "313-6CE00"}, {1316600, "313-6CE01"},
    {1315171, "313-1AD01"}, {2364506, "312-1AE14"}, {2364908, "312-5BF04"}, {1316174, "314-1AE04"},
    {1316183, "316-2AG00"}, {2363804, "412-1XF04"}, {1314877, "413-2XG00"}, {1316443, "414-2XG03"},
    {1316658, "417-4HL01"}, {2363875, "314C-2 DP"}, {1315712, "314"},       {1314821, "314"},
    {1315172, "314"},       {1315180, "414-1"},     {1315500, "416-1"},
}};

/// The first order number of a CPU in the slots of a station: texts of 19 characters behind the byte 0x13.
std::string orderNumberIn(std::string_view station) {
  constexpr std::size_t length = 19;
  constexpr std::array<std::string_view, 4> heads = {"6ES7 31", "6ES7 41", "6ES7 151-7", "6ES7 151-8"};
  for (std::size_t at = station.find('\x13'); at != std::string_view::npos; at = station.find('\x13', at + 1)) {
    const std::string_view text = station.substr(at + 1, length);
    if (text.size() == length &&
        std::ranges::any_of(heads, [&](std::string_view head) { return text.starts_with(head); }))
      return std::string(text);
  }
  return {};
}

std::optional<DbaseTable> tableIn(const ProjectFiles& files, const std::string& folder, std::string_view name,
                                  std::vector<std::string>& faults) {
  const std::string path = fmt::format("{}/{}.DBF", folder, name);
  std::optional<std::string> bytes = files.bytes(path);
  if (!bytes) return std::nullopt;
  std::vector<std::string> found;
  DbaseTable table(std::move(*bytes), files.bytes(fmt::format("{}/{}.DBT", folder, name)), found);
  for (const std::string& fault : found) faults.push_back(fmt::format("{}, {}", files.spelling(path), fault));
  return table;
}

/// Names and files of stations by their ID.
struct Stations {
  std::map<std::int64_t, std::string> names;
  std::map<std::int64_t, std::string> slots;
};

Stations readStations(const ProjectFiles& files, std::vector<std::string>& faults) {
  Stations stations;
  const std::string folder = "hOmSave7/s7hstatx";
  if (const auto table = tableIn(files, folder, "HOBJECT1", faults)) {
    for (std::size_t row = 0; row < table->rows(); ++row)
      stations.names[table->number(row, "ID").value_or(0)] = std::string(table->text(row, "NAME"));
  }
  for (const std::string& name : files.namesIn(folder)) {
    if (name.size() < 5 || (!name.ends_with(".s7h") && !name.ends_with(".S7H"))) continue;
    std::int64_t id = 0;
    const char* const end = name.data() + name.size() - 4;
    if (std::from_chars(name.data(), end, id, 16).ptr == end)
      stations.slots[id] = orderNumberIn(files.bytes(folder + "/" + name).value_or(""));
  }
  return stations;
}

}  // namespace

std::map<unsigned, std::string> dataSetsOf(std::string_view chain) {
  std::map<unsigned, std::string> sets;
  for (std::size_t at = 0; at + 2 <= chain.size();) {
    const std::size_t length = static_cast<std::uint8_t>(chain[at]);
    if (length < 2 || at + length > chain.size()) break;
    sets.emplace(static_cast<std::uint8_t>(chain[at + 1]), std::string(chain.substr(at + 2, length - 2)));
    at += length;
  }
  return sets;
}

void applyDataSets(const std::map<unsigned, std::string>& sets, CpuConfiguration& cpu) {
  constexpr unsigned cycle = 2, retention = 6, clock = 7, cyclic = 13;
  if (const auto set = sets.find(cycle); set != sets.end() && parameterWord(set->second, 2) != 0)
    cpu.scanLimitMs = parameterWord(set->second, 2);
  if (const auto set = sets.find(clock); set != sets.end() && set->second.size() >= 4 && (set->second[1] & 1) != 0)
    cpu.clockByte = parameterWord(set->second, 2);
  if (const auto set = sets.find(retention); set != sets.end() && set->second.size() >= 8) {
    CpuConfiguration::Retention& kept = cpu.retention.emplace();
    kept.markers = parameterWord(set->second, 0);
    kept.timers = parameterWord(set->second, 2);
    kept.counters = parameterWord(set->second, 4);
    const std::size_t count = std::min<std::size_t>(parameterWord(set->second, 6), 8);
    for (std::size_t i = 0; i < count && 8 + 6 * i + 6 <= set->second.size(); ++i)
      kept.blocks.push_back({parameterWord(set->second, 8 + 6 * i), parameterWord(set->second, 10 + 6 * i),
                             parameterWord(set->second, 12 + 6 * i)});
  }
  if (const auto set = sets.find(cyclic); set != sets.end()) {
    for (unsigned block = 30; block <= 38; ++block) {
      const std::uint16_t period = parameterWord(set->second, (block - 30) * 6 + 2);
      if (period != 0) cpu.cyclicMs[block] = period;
    }
  }
}

std::string cpuTypeOf(std::string_view text) {
  if (text.starts_with("6ES7 ")) text.remove_prefix(5);
  if (const std::size_t at = text.find("CPU"); at != std::string_view::npos) {
    text = text.substr(at + 3);
    while (text.starts_with(' ') || text.starts_with('-')) text.remove_prefix(1);
  }
  // A CPU without a row of its own has that of the next larger one.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 14> types = {{{"312", "312"},
                                                                                    {"313", "313C"},
                                                                                    {"314", "314"},
                                                                                    {"315", "315-2"},
                                                                                    {"316", "317-2"},
                                                                                    {"317", "317-2"},
                                                                                    {"318", "318-2"},
                                                                                    {"319", "319-3"},
                                                                                    {"412", "412"},
                                                                                    {"413", "414"},
                                                                                    {"414", "414"},
                                                                                    {"416", "416"},
                                                                                    {"417", "417"},
                                                                                    {"151", "314"}}};
  for (const auto& [head, type] : types) {
    if (text.starts_with(head)) return std::string(type);
  }
  return {};
}

std::vector<std::pair<std::string, std::string>> CpuConfiguration::options() const {
  std::vector<std::pair<std::string, std::string>> result;
  if (!type.empty()) result.emplace_back("cpu", type);
  if (scanLimitMs && *scanLimitMs <= 6000) result.emplace_back("cycle-monitoring", fmt::format("{}ms", *scanLimitMs));
  if (clockByte) result.emplace_back("clock-memory", fmt::format("MB{}", *clockByte));
  if (retention) {
    const auto range = [&](std::string_view letters, unsigned count) {
      if (count > 0) result.emplace_back("retentive", fmt::format("{0}0..{0}{1}", letters, count - 1));
    };
    range("MB", retention->markers);
    range("T", retention->timers);
    range("C", retention->counters);
    for (const Retention::Block& block : retention->blocks) {
      if (block.bytes > 0)
        result.emplace_back("retentive", fmt::format("DB{}.DBB{}..DBB{}", block.number, block.from,
                                                     unsigned{block.from} + block.bytes - 1));
    }
  }
  for (const auto& [block, period] : cyclicMs) {
    if (period <= 60000) result.emplace_back(fmt::format("ob{}", block), fmt::format("{}ms", period));
  }
  return result;
}

std::map<std::int64_t, CpuConfiguration> readHardware(const ProjectFiles& files, std::vector<std::string>& faults) {
  std::map<std::int64_t, CpuConfiguration> byProgram;
  const Stations stations = readStations(files, faults);
  for (const std::string folder : {"hOmSave7/S7HK31AX", "hOmSave7/S7HK41AX", "hOmSave7/s7hkcomx"}) {
    const auto objects = tableIn(files, folder, "HOBJECT1", faults);
    const auto relations = tableIn(files, folder, "HRELATI1", faults);
    const auto attributes = tableIn(files, folder, "HATTRME1", faults);
    if (!objects || !relations) continue;
    for (std::size_t row = 0; row < objects->rows(); ++row) {
      const std::optional<std::int64_t> id = objects->number(row, "ID");
      if (!id) continue;
      CpuConfiguration cpu;
      cpu.name = objects->text(row, "NAME");
      std::optional<std::int64_t> program, station;
      for (std::size_t i = 0; i < relations->rows(); ++i) {
        if (relations->number(i, "SOBJID") != id) continue;
        const std::optional<std::int64_t> kind = relations->number(i, "RELID");
        if (kind == relationToProgram) program = relations->number(i, "TOBJID");
        if (kind == relationToStation) station = relations->number(i, "TUNITID");
      }
      if (!program) continue;
      if (station && stations.names.contains(*station)) cpu.station = stations.names.at(*station);
      if (station && stations.slots.contains(*station)) cpu.orderNumber = stations.slots.at(*station);
      const std::int64_t objectType = objects->number(row, "OBJTYP").value_or(0);
      std::string_view known = cpu.orderNumber;
      const auto listed = std::ranges::find_if(
          orderNumbers, [&](const auto& entry) { return entry.first == objectType && objectType != 0; });
      if (known.empty() && listed != orderNumbers.end()) known = listed->second;
      cpu.type = cpuTypeOf(known.empty() ? cpu.name : known);
      if (attributes) {
        for (std::size_t i = 0; i < attributes->rows(); ++i) {
          if (attributes->number(i, "IDM") != id || attributes->number(i, "ATTRIIDM") != parameterAttribute) continue;
          const DbaseTable::Memo memo = attributes->memo(i, "MEMOARRAYM");
          if (!memo.fault.empty())
            faults.push_back(fmt::format("{}, record {}: {}", files.spelling(folder + "/HATTRME1.DBF"),
                                         attributes->record(i), memo.fault));
          applyDataSets(dataSetsOf(memo.bytes), cpu);
        }
      }
      byProgram.emplace(*program, std::move(cpu));
    }
  }
  return byProgram;
}

}  // namespace rungproof::s7project
