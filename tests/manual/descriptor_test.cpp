// What the descriptors say besides operands: class of execution, effect on the stack, ENO, status bits, restrictions.
#include <gtest/gtest.h>

#include <set>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof::manual {
namespace {

using Names = std::set<std::string_view>;

/// Instructions of sections A 2 to 18 and B 1 to 2, by class.
const Names contacts = {"LD", "LDN", "A", "AN", "O", "ON", "LDI", "LDNI", "AI", "ANI", "OI", "ONI"};
const Names others = {"NOT", "EU", "ED", "ALD", "OLD", "LPS", "LRD", "LPP", "LDS", "AENO", "NOP"};
const Names coils = {"=", "=I"};
const Names sampled = {"SR", "RS", "CTU", "CTD", "CTUD", "CTU.IEC", "CTD.IEC", "CTUD.IEC"};
const Names boxes = {"S",    "R",     "SI",    "RI",  "TODR", "TODW", "TODRX", "TODWX", "NETR", "NETW",
                     "XMT",  "RCV",   "GPA",   "SPA", "BTI",  "ITB",  "ITD",   "DTI",   "DTR",  "BCDI",
                     "IBCD", "ROUND", "TRUNC", "SEG", "ATH",  "HTA",  "ITA",   "DTA",   "RTA",  "ITS",
                     "DTS",  "RTS",   "STI",   "STD", "STR",  "ENCO", "DECO",  "HDEF",  "HSC",  "PLS",
                     "+I",   "-I",    "*I",    "/I",  "+D",   "-D",   "*D",    "/D",    "MUL",  "DIV"};

Names compares() {
  Names names;
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.group == "boolean / compare") names.insert(desc.stl);
  }
  return names;
}

void expectStack(std::string_view name, int needs, int pops, int pushes) {
  const StackEffect& stack = s7200Instructions().named(name)->stack;
  EXPECT_EQ(stack.needs, needs) << name;
  EXPECT_EQ(stack.pops, pops) << name;
  EXPECT_EQ(stack.pushes, pushes) << name;
}

TEST(Descriptor, ClassesOfExecution) {
  const auto expectClass = [](const Names& names, Execution execution, bool eno) {
    for (const std::string_view name : names) {
      const Desc* desc = s7200Instructions().named(name);
      ASSERT_NE(desc, nullptr) << name;
      EXPECT_EQ(desc->execution, execution) << name;
      EXPECT_EQ(desc->eno, eno) << name;
      EXPECT_EQ(desc->control, Control::None) << name;
    }
  };
  EXPECT_EQ(compares().size(), 78U) << "72 numeric and 6 of strings";
  expectClass(contacts, Execution::Stack, false);
  expectClass(others, Execution::Stack, false);
  expectClass(compares(), Execution::Compare, false);
  expectClass(coils, Execution::Coil, false);
  expectClass(sampled, Execution::Sampled, false);
  expectClass(boxes, Execution::Conditional, true);
}

TEST(Descriptor, EffectsOnTheStack) {
  Names loading = compares();
  loading.insert(contacts.begin(), contacts.end());
  for (const std::string_view name : loading) {
    if (name.starts_with("LD"))
      expectStack(name, 0, 0, 1);
    else
      expectStack(name, 1, 0, 0);
  }
  for (const std::string_view name : {"NOT", "EU", "ED", "AENO"}) expectStack(name, 1, 0, 0);
  for (const std::string_view name : {"ALD", "OLD", "LPP"}) expectStack(name, 2, 1, 0);
  for (const std::string_view name : {"LPS", "LDS"}) expectStack(name, 1, 0, 1);
  expectStack("LRD", 2, 0, 0);
  expectStack("NOP", 0, 0, 0);
  for (const std::string_view name : coils) expectStack(name, 1, 0, 0);
  for (const std::string_view name : boxes) expectStack(name, 1, 0, 0);
  for (const std::string_view name : {"SR", "RS"}) expectStack(name, 2, 1, 0);
  for (const std::string_view name : {"CTU", "CTD", "CTU.IEC", "CTD.IEC"}) expectStack(name, 2, 0, 0);
  expectStack("CTUD", 3, 0, 0);
  expectStack("CTUD.IEC", 4, 0, 0);
}

TEST(Descriptor, StatusBits) {
  const Names overflow = {"ITB", "DTI", "ROUND", "TRUNC", "STI", "STD", "STR"};
  const Names arithmetic = {"+I", "-I", "*I", "+D", "-D", "*D"};
  const Names division = {"/I", "/D", "MUL", "DIV"};
  for (const Names& names : {contacts, others, coils, sampled, boxes}) {
    for (const std::string_view name : names) {
      StatusBits expected = 0;
      if (overflow.contains(name)) expected = status::Overflow;
      if (name == "BCDI" || name == "IBCD") expected = status::NotBcd;
      if (name == "ATH") expected = status::NotAscii;
      if (arithmetic.contains(name)) expected = status::Zero | status::Overflow | status::Negative;
      if (division.contains(name)) expected = status::Zero | status::Overflow | status::Negative | status::DivideByZero;
      EXPECT_EQ(s7200Instructions().named(name)->affects, expected) << name;
    }
  }
}

TEST(Descriptor, Restrictions) {
  const Names since2004 = {"TODRX", "TODWX"}, notInInterrupt = {"HDEF", "SPA"},
              drawing = {"SR", "RS", "CTU.IEC", "CTD.IEC", "CTUD.IEC"};
  for (const Names& names : {contacts, others, coils, sampled, boxes, compares()}) {
    for (const std::string_view name : names) {
      const Desc& desc = *s7200Instructions().named(name);
      EXPECT_EQ(desc.since2004, since2004.contains(name)) << name;
      EXPECT_EQ(desc.notInInterrupt, notInInterrupt.contains(name)) << name;
      EXPECT_EQ(desc.drawingOnly, drawing.contains(name)) << name;
      const bool isOnSmart = name != "NETR" && name != "NETW";
      EXPECT_EQ(desc.cpus, isOnSmart ? everyCpu : s7200Cpus) << name;
    }
  }
}

/// Whether a constant is allowed for operand `at` on that CPU.
bool allows(std::string_view name, int at, std::int64_t value, Cpu cpu) {
  for (const ValueRange& range : s7200Instructions().named(name)->operand(at).ranges) {
    if ((range.cpus & cpuBit(cpu)) != 0 && value >= range.low && value <= range.high) return true;
  }
  return false;
}

TEST(Descriptor, ConstantsByCpu) {
  for (const Cpu cpu :
       {s7200Cpu("221"), s7200Cpu("222"), s7200Cpu("224"), s7200Cpu("224XP"), s7200Cpu("226"), s7200Cpu("226XM")}) {
    const bool small = cpu == s7200Cpu("221") || cpu == s7200Cpu("222");
    const bool twoPorts = cpu == s7200Cpu("224XP") || cpu == s7200Cpu("226") || cpu == s7200Cpu("226XM");
    for (int value = -1; value <= 7; ++value) {
      const bool counter = value >= 0 && value <= 5 && (!small || (value != 1 && value != 2));  // 001:4166
      EXPECT_EQ(allows("HSC", 0, value, cpu), counter) << value;
      EXPECT_EQ(allows("HDEF", 0, value, cpu), counter) << value;
      EXPECT_EQ(allows("PLS", 0, value, cpu), value == 0 || value == 1) << value;
      for (const char* name : {"XMT", "RCV", "NETR", "NETW", "GPA", "SPA"}) {
        EXPECT_EQ(allows(name, 1, value, cpu), value == 0 || (value == 1 && twoPorts)) << name << value;
      }
    }
    for (int value = -1; value <= 14; ++value) {
      EXPECT_EQ(allows("HDEF", 1, value, cpu), value >= 0 && value <= 12) << value;
      EXPECT_EQ(allows("LDS", 0, value, cpu), value >= 0 && value <= 8) << value;
    }
    for (const int value : {-1, 0, 255, 256})
      EXPECT_EQ(allows("NOP", 0, value, cpu), value == 0 || value == 255) << value;
  }
}

}  // namespace
}  // namespace rungproof::manual
