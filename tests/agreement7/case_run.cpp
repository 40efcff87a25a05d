// A case becomes a program whose statements stand between two marks.
#include "tests/agreement7/case_run.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "tests/agreement7/engine_run.hpp"
#include "tests/agreement7/ir_of_text.hpp"

namespace rungproof::agreement7 {
namespace {

using naive7::Case;

void putIn(const Case& c, RegisterValues& values) {
  for (std::size_t i = 0; i < 9; ++i) values.status[i] = c.status[i] == '1';
  for (std::size_t i = 0; i < 4; ++i) values.accu[i] = c.regs.at(std::to_string(i + 1));
  values.ar = {c.regs.at("AR1"), c.regs.at("AR2")};
  values.db = c.regs.at("DB");
  values.di = c.regs.at("DI");
}

struct Taken {
  std::string status;
  std::map<std::string, std::uint32_t> regs;
};

void takeOut(Taken& taken, const RegisterValues& values) {
  taken.status.clear();
  for (const bool bit : values.status) taken.status += bit ? '1' : '0';
  for (std::size_t i = 0; i < 4; ++i) taken.regs[std::to_string(i + 1)] = static_cast<std::uint32_t>(values.accu[i]);
  taken.regs["AR1"] = static_cast<std::uint32_t>(values.ar[0]);
  taken.regs["AR2"] = static_cast<std::uint32_t>(values.ar[1]);
  taken.regs["DB"] = static_cast<std::uint32_t>(values.db);
  taken.regs["DI"] = static_cast<std::uint32_t>(values.di);
}

void putByte(Concrete::Store& store, const naive7::Place& place, std::uint32_t i, std::uint8_t value) {
  static const std::map<char, Area> areas = {{'I', Area::I}, {'Q', Area::Q}, {'M', Area::M}, {'D', Area::DB}};
  const std::uint32_t byte = place.bit / 8 + i;
  const std::uint32_t at = place.area == 'D' ? dataByte(static_cast<std::uint32_t>(place.number), byte) : byte;
  store.save(areas.at(place.area), at * 8, 8, value, true);
}

/// Bytes of the areas that the naive machine has, as the engine holds them.
void copyMemory(const naive7::Machine& from, Concrete::Store& to) {
  const auto copy = [&](char area, int number, const std::vector<std::uint8_t>& bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      putByte(to, {area, number, 0, 8, false, 0}, static_cast<std::uint32_t>(i), bytes[i]);
  };
  copy('I', 0, from.inputs, from.inputs.size());
  copy('Q', 0, from.outputs, from.outputs.size());
  copy('M', 0, from.memory, 256);
  for (const auto& [number, bytes] : from.dataBlocks) copy('D', number, bytes, bytes.size());
}

std::string memoryDifference(const naive7::Machine& wanted, const Concrete::Store& store) {
  std::ostringstream text;
  const auto compare = [&](const char* name, Area area, std::uint32_t first, const std::vector<std::uint8_t>& bytes,
                           std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto actual = store.load(area, (first + i) * 8, 8);
      if (actual != bytes[i]) text << " " << name << i << "=" << std::hex << actual << std::dec;
    }
  };
  compare("IB", Area::I, 0, wanted.inputs, wanted.inputs.size());
  compare("QB", Area::Q, 0, wanted.outputs, wanted.outputs.size());
  compare("MB", Area::M, 0, wanted.memory, 256);
  compare("PQB", Area::PQ, 0, wanted.peripheralOut, wanted.peripheralOut.size());
  for (const auto& [number, bytes] : wanted.dataBlocks) {
    const std::string name = "DB" + std::to_string(number) + ".DBB";
    compare(name.c_str(), Area::DB, dataByte(static_cast<std::uint32_t>(number), 0), bytes, bytes.size());
  }
  return text.str();
}

}  // namespace

std::string differences(const Case& c) {
  const naive7::Program blocks = naive7::readProgram(c.blocks);
  naive7::Machine before(blocks, c.is400), wanted(blocks, c.is400);
  for (naive7::Machine* m : {&before, &wanted}) {
    for (const auto& [key, value] : c.bytes) {
      const naive7::Place p = m->direct(key);
      if (!key.starts_with("PI")) {
        m->write(p, value);
        continue;
      }
      for (int i = 0; i < p.width / 8; ++i) {
        m->peripheralIn[p.bit / 8 + static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>(value >> (p.width - 8 - 8 * i));
      }
    }
  }
  for (const auto& [key, value] : c.bytesAfter) wanted.write(wanted.direct(key), value);
  Around around;
  around.value = [&](const ExternalSite& site, int width) -> std::uint64_t {
    if (site.kind != External::AnalogInput) return 0;
    std::uint64_t value = 0;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(width) / 8; ++i)
      value = value << 8 | before.peripheralIn[site.index + i];
    return value;
  };
  std::unique_ptr<Concrete::Store> store;
  Taken taken;
  std::string text;
  bool runs = true;
  for (std::size_t i = 0; i < c.scans.size() && runs; ++i) {
    naive7::Program one = naive7::readProgram(
        c.blocks + naive7::organizationBlock(c.scans[i] + "  BLD " + std::to_string(takeMark) + " ;\n"));
    const Program program = irOf(one, c.is400, text);
    if (!text.empty()) return text;
    if (store == nullptr) {
      store = std::make_unique<Concrete::Store>(Plan(program));
      copyMemory(before, *store);
      for (std::size_t b = 0; b < before.peripheralIn.size(); ++b)
        store->save(Area::PI, static_cast<std::uint32_t>(b) * 8, 8, before.peripheralIn[b], true);
    }
    runs = runOnce(
        program, *store, around, i == 0 ? 0 : static_cast<std::uint32_t>(c.pauses[i - 1]),
        [&](RegisterValues& values) { putIn(c, values); },
        [&](const RegisterValues& values) { takeOut(taken, values); });
  }
  static const std::map<int, Hazard> faults = {{0x21, Hazard::S7Bcd},          {0x22, Hazard::S7AreaLength},
                                               {0x23, Hazard::S7AreaLength},   {0x28, Hazard::S7Alignment},
                                               {0x29, Hazard::S7Alignment},    {0x3A, Hazard::S7BlockMissing},
                                               {0x3C, Hazard::S7BlockMissing}, {0x3E, Hazard::S7BlockMissing}};
  if (c.stop != 0) {
    if (runs) text += " did not stop";
    if (around.hazards != std::set<Hazard>{faults.at(c.stop)}) text += " other error";
    return text + memoryDifference(wanted, *store);
  }
  if (!runs || taken.status.empty()) return " stopped";
  for (std::size_t i = 0; i < 9; ++i) {
    const char stated = c.statusAfter[i] == '.' ? c.status[i] : c.statusAfter[i];
    if (stated != '?' && stated != taken.status[i]) {
      text += " status " + taken.status;
      break;
    }
  }
  for (const auto& [key, value] : taken.regs) {
    const bool isOpen = std::ranges::find(c.openRegs, key) != c.openRegs.end();
    const bool isLacking = !c.is400 && (key == "3" || key == "4");
    std::ostringstream number;
    number << std::hex << std::uppercase << value;
    if (!isOpen && !isLacking && c.regsAfter.at(key) != value) text += " " + key + "=" + number.str();
  }
  return text + memoryDifference(wanted, *store);
}

}  // namespace rungproof::agreement7
