// The worked examples of the two course documents on engine and naive interpreter, with the values that follow from
// their text; and the rows of the instruction list in the table of instructions.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include "ir/s7300/isa.hpp"
#include "tests/agreement7/encoder_run.hpp"
#include "tests/agreement7/engine_run.hpp"
#include "tests/agreement7/ir_of_text.hpp"
#include "tests/naive7/case_table.hpp"

namespace rungproof::agreement7 {
namespace {

/// Statements with ; between them, in OB1 after the blocks given, on both machines.
class Twin {
 public:
  explicit Twin(const std::string& statements, const std::string& blocks = {}, bool is400 = false)
      : text_(dataBlocks + blocks + naive7::organizationBlock(lines(statements))),
        source_(naive7::readProgram(text_)),
        program_(irOf(source_, is400, faults_)),
        store_(Plan(program_)),
        plain_(source_, is400) {
    EXPECT_EQ(faults_, "");
  }

  void put(const std::string& name, std::int64_t value) {
    const naive7::Place p = plain_.direct(name);
    plain_.write(p, static_cast<std::uint32_t>(value));
    save(p, static_cast<std::uint32_t>(value));
  }
  /// Lets time pass and runs OB1 on both; all that they hold must agree.
  void scan(std::uint32_t ms = 10) {
    Around around;
    EXPECT_TRUE(runOnce(program_, store_, around, ms, nullptr, nullptr));
    plain_.advance(ms);
    plain_.setStatus("000000000");
    plain_.run("OB1");
    for (const char* area : {"IB", "QB", "MB"}) {
      for (int i = 0; i < 120; ++i) {
        const naive7::Place p = plain_.direct(area + std::to_string(i));
        EXPECT_EQ(plain_.read(p), load(p)) << area << i;
      }
    }
  }
  std::int64_t value(const std::string& name) const {
    const naive7::Place p = plain_.direct(name);
    const std::uint32_t value = load(p);
    EXPECT_EQ(plain_.read(p), value) << name;
    return p.width == 16 ? static_cast<std::int16_t>(value) : static_cast<std::int64_t>(value);
  }
  /// The transition system of the program makes the same scans as the engine.
  void encoded() const {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const AgreementOutcome outcome = compareWithEngine(program_, seed, 12);
      EXPECT_EQ(outcome.difference, "");
      EXPECT_TRUE(outcome.isExact) << outcome.approximation;
    }
  }

 private:
  static std::string lines(const std::string& statements) {
    std::string text;
    std::istringstream in(statements);
    for (std::string one; std::getline(in, one, ';');) text += "  " + one + " ;\n";
    return text;
  }
  static std::uint32_t bitOf(const naive7::Place& p) {
    return p.area == 'D' ? dataByte(static_cast<std::uint32_t>(p.number), p.bit / 8) * 8 + p.bit % 8 : p.bit;
  }
  static Area areaOf(const naive7::Place& p) {
    return p.area == 'I' ? Area::I : p.area == 'Q' ? Area::Q : p.area == 'M' ? Area::M : Area::DB;
  }
  void save(const naive7::Place& p, std::uint32_t value) { store_.save(areaOf(p), bitOf(p), p.width, value, true); }
  std::uint32_t load(const naive7::Place& p) const {
    return static_cast<std::uint32_t>(store_.load(areaOf(p), bitOf(p), p.width));
  }

  static inline const std::string dataBlocks =
      "DATA_BLOCK DB 1\nSTRUCT\n  b : ARRAY [0 .. 99] OF BYTE ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 2\nSTRUCT\n  b : ARRAY [0 .. 19] OF BYTE ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n";
  std::string text_, faults_;
  naive7::Program source_;
  Program program_;
  Concrete::Store store_;
  naive7::Machine plain_;
};

// 003:572-616: S1 or S3 starts the belt, S2, S4 or S5 stops it; the reset is written last and wins.
TEST(Examples7, ConveyorBelt) {
  Twin twin("A I 1.1;O I 1.3;S Q 4.0;A I 1.2;O I 1.4;O I 1.5;R Q 4.0");
  const std::pair<const char*, int> trace[] = {{"00000", 0}, {"10000", 1}, {"00000", 1}, {"01000", 0}, {"00000", 0},
                                               {"00100", 1}, {"00001", 0}, {"11000", 0}, {"10000", 1}, {"00010", 0}};
  for (const auto& [inputs, motor] : trace) {
    for (int i = 0; i < 5; ++i) twin.put("I1." + std::to_string(i + 1), inputs[i] - '0');
    twin.scan();
    EXPECT_EQ(twin.value("Q4.0"), motor) << inputs;
  }
  twin.encoded();
}

// 003:618-662: the sensor that is interrupted first tells the direction; both free: both outputs off.
TEST(Examples7, DirectionOfMotion) {
  Twin twin("A I 0.0;FP M 0.0;AN I 0.1;S Q 4.1;A I 0.1;FP M 0.1;AN I 0.0;S Q 4.0;AN I 0.0;AN I 0.1;R Q 4.0;R Q 4.1");
  const std::pair<const char*, const char*> trace[] = {{"00", "00"}, {"10", "01"}, {"11", "01"}, {"01", "01"},
                                                       {"00", "00"}, {"01", "10"}, {"11", "10"}, {"10", "10"},
                                                       {"00", "00"}, {"11", "00"}};
  const auto step = [&](const char* inputs) {
    twin.put("I0.0", inputs[0] - '0');
    twin.put("I0.1", inputs[1] - '0');
    twin.scan();
  };
  for (const auto& [inputs, outputs] : trace) {
    step(inputs);
    EXPECT_EQ(twin.value("Q4.0"), outputs[0] - '0') << inputs;
    EXPECT_EQ(twin.value("Q4.1"), outputs[1] - '0') << inputs;
  }
  step("00");
  step("10");
  step("01");  // two inputs change at once: both directions, the finding of the example
  EXPECT_TRUE(twin.value("Q4.0") == 1 && twin.value("Q4.1") == 1);
  twin.encoded();
}

// 003:666-756, 250 ms = 5 scans of 50 ms: the variant that scans M0.2 counts every sixth scan, the one that scans T1
// never.
TEST(Examples7, ClockGenerator) {
  const std::string rest =
      ";L S5T#250MS;SE T 1;A T 1;= M 0.2;A M 0.2;JC n001;L MW 100;+ 1;T MW 100;n001: L MW 100;T QW 12";
  Twin helper("AN M 0.2" + rest), timer("AN T 1" + rest);
  for (int scan = 0; scan < 36; ++scan) {
    helper.scan(50);
    timer.scan(50);
    EXPECT_EQ(helper.value("QW12"), (scan + 1) / 6) << scan;
    EXPECT_EQ(timer.value("QW12"), 0) << scan;
  }
  helper.encoded();
  timer.encoded();
}

// 003:758-787: lamps of the storage area over an up and down counter.
TEST(Examples7, StorageArea) {
  Twin twin(
      "A I 12.0;CU C 1;A I 12.1;CD C 1;A I 12.2;L C#10;S C 1;A I 12.3;R C 1;L C 1;T MW 110;A C 1;= Q 12.1;AN Q 12.1;"
      "= Q 12.0;L 50;L MW 110;<=I;= Q 15.2;L MW 110;L 90;>=I;= Q 15.3;L MW 110;L 100;>=I;= Q 15.4");
  const auto pulse = [&](const char* input, int times = 1) {
    for (int i = 0; i < times; ++i) {
      twin.put(input, 1);
      twin.scan();
      twin.put(input, 0);
      twin.scan();
    }
    return twin.value("MW110");
  };
  twin.scan();
  EXPECT_TRUE(twin.value("Q12.0") == 1 && twin.value("Q12.1") == 0);
  EXPECT_EQ(pulse("I12.2"), 10);
  EXPECT_EQ(pulse("I12.0", 39), 49);
  EXPECT_EQ(twin.value("Q15.2"), 0);
  EXPECT_EQ(pulse("I12.0"), 50);
  EXPECT_EQ(twin.value("Q15.2"), 1);
  EXPECT_EQ(pulse("I12.1"), 49);
  EXPECT_EQ(pulse("I12.0", 41), 90);
  EXPECT_TRUE(twin.value("Q15.3") == 1 && twin.value("Q15.4") == 0);
  EXPECT_EQ(pulse("I12.0", 10), 100);
  EXPECT_EQ(twin.value("Q15.4"), 1);
  EXPECT_EQ(pulse("I12.0", 1000), 999);
  EXPECT_EQ(pulse("I12.1"), 998);
  twin.put("I12.0", 1);
  for (int i = 0; i < 3; ++i) twin.scan();
  EXPECT_EQ(twin.value("MW110"), 999);  // held: one step
  twin.put("I12.0", 0);
  EXPECT_EQ(pulse("I12.3"), 0);
  EXPECT_EQ(pulse("I12.1"), 0);
  twin.encoded();
}

// 003:789-802: three boxes chained by ENO, as the compiler writes them.
TEST(Examples7, IntegerArithmetic) {
  Twin twin(
      "OPN DB 1;L IW 0;L DBW 3;+I;T MW 100;AN OV;SAVE;CLR;A BR;JNB e1;L MW 100;L 15;*I;T MW 102;AN OV;SAVE;CLR;A BR;"
      "JNB e1;L MW 102;L MW 0;/I;T MW 4;AN OV;SAVE;CLR;e1: A BR;= M 20.0");
  struct Row {
    int in, data, divisor, result, eno;
  };
  for (const Row& row :
       {Row{100, 50, 5, 450, 1}, Row{100, 50, 7, 321, 1}, Row{2000, 184, 3, 10920, 1}, Row{2000, 185, 3, 7, 0},
        Row{32767, 1, 3, 7, 0}, Row{10, -20, 4, -37, 1}, Row{10, -20, -4, 37, 1}}) {
    twin.put("MW4", 7);  // stays where ENO breaks off
    twin.put("IW0", row.in);
    twin.put("DB1.DBW3", row.data);
    twin.put("MW0", row.divisor);
    twin.scan();
    EXPECT_EQ(twin.value("MW4"), row.result) << row.in;
    EXPECT_EQ(twin.value("M20.0"), row.eno) << row.in;
    if (row.data == 185) {
      EXPECT_EQ(twin.value("MW102"), -32761);
    }
    if (row.in == 32767) {
      EXPECT_EQ(twin.value("MW100"), -32768);
    }
  }
  twin.put("MW0", 0);
  twin.scan();
  EXPECT_EQ(twin.value("M20.0"), 0);
}

// 003:804-837: the time from the thumbwheel, 2 s in scans of 500 ms: the heating is on for three scans, one late.
TEST(Examples7, OvenHeating) {
  Twin twin("A T 1;= Q 4.0;A T 1;BEC;L IW 0;AW W#16#0FFF;T MW 1;L MW 1;OW W#16#2000;T MW 2;L MW 2;A I 0.7;SE T 1");
  twin.put("IW0", 0x0127);
  twin.scan(500);
  EXPECT_EQ(twin.value("MW2"), 0x2127);
  EXPECT_EQ(twin.value("MW1"), 0x0121);  // MB2 belongs to both
  twin.put("IW0", 0x8002);
  for (const int heating : {0, 1, 1, 1, 0, 0, 0}) {  // held: it does not start again
    twin.scan(500);
    EXPECT_EQ(twin.value("Q4.0"), heating);
  }
  twin.put("IW0", 0x0002);
  twin.scan(500);
  twin.put("IW0", 0x8002);
  twin.scan(500);
  twin.scan(500);
  EXPECT_EQ(twin.value("Q4.0"), 1);
}

// 002:405-433: the sum of three numbers wraps at 16 bits.
TEST(Examples7, SumOfThree) {
  const std::string fc =
      "FUNCTION FC 5 : VOID\nVAR_INPUT\n  p : INT ;\n  q : INT ;\n  r : INT ;\nEND_VAR\nVAR_OUTPUT\n  sum : INT "
      ";\nEND_VAR\n"
      "BEGIN\nNETWORK\n  L #p ;\n  L #q ;\n  +I ;\n  L #r ;\n  +I ;\n  T #sum ;\nEND_FUNCTION\n";
  Twin twin("CALL FC 5 ( p := MW 10, q := MW 12, r := MW 14, sum := MW 16 )", fc);
  for (const auto& [p, q, r, sum] :
       std::vector<std::array<int, 4>>{{1, 2, 3, 6}, {32767, 1, 0, -32768}, {30000, 30000, 10000, 4464}}) {
    twin.put("MW10", p);
    twin.put("MW12", q);
    twin.put("MW14", r);
    twin.scan();
    EXPECT_EQ(twin.value("MW16"), sum);
  }
  twin.encoded();
}

// 002:1715-1787: words from one data block to another; the address registers stay as the block leaves them, DB does
// not.
TEST(Examples7, CopyBetweenDataBlocks) {
  const std::string fc =
      "FUNCTION FC 10 : VOID\nVAR_INPUT\n  from : INT ;\n  first : INT ;\n  into : INT ;\n  place : INT ;\n  count : "
      "INT ;\n"
      "END_VAR\nVAR_TEMP\n  number : WORD ;\n  left : INT ;\nEND_VAR\nBEGIN\nNETWORK\n"
      "  L #from ;\n  T #number ;\n  OPN DB [#number] ;\n  L #into ;\n  T #number ;\n  OPN DI [#number] ;\n"
      "  L #first ;\n  SLD 3 ;\n  LAR1 ;\n  L #place ;\n  SLD 3 ;\n  LAR2 ;\n  L #count ;\n  next: T #left ;\n"
      "  L DBW [AR1,P#0.0] ;\n  T DIW [AR2,P#0.0] ;\n  +AR1 P#2.0 ;\n  +AR2 P#2.0 ;\n  L #left ;\n  LOOP next ;\n"
      "END_FUNCTION\n";
  Twin twin(
      "OPN DB 2;CALL FC 10 ( from := 1, first := 10, into := 2, place := 0, count := 10 );TAR1 MD 20;TAR2 MD 24;"
      "L DBNO;T MW 28",
      fc);
  for (int i = 0; i < 10; ++i) twin.put("DB1.DBW" + std::to_string(10 + 2 * i), 1000 + i);
  twin.scan();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(twin.value("DB2.DBW" + std::to_string(2 * i)), 1000 + i);
  EXPECT_EQ(twin.value("MD20"), 30 * 8);
  EXPECT_EQ(twin.value("MD24"), 20 * 8);
  EXPECT_EQ(twin.value("MW28"), 2);
}

// 002:1252-1274: the interrupt handler's mask leaves all but Q4.0; JP because AD tells that a bit was left.
TEST(Examples7, HandlerOfAnInterruptPattern) {
  Twin twin("L MD 40;L W#16#4;AD;JP m1;JU m2;m1: L QB 4;L 2#11111110;AW;T QB 4;m2: NOP 0");
  for (const auto& [pattern, outputs] : std::vector<std::pair<std::int64_t, int>>{
           {4, 0xFE}, {5, 0xFE}, {0x80000004, 0xFE}, {0, 0xFF}, {1, 0xFF}, {0xFFFFFFFB, 0xFF}}) {
    twin.put("QB4", 0xFF);
    twin.put("MD40", pattern);
    twin.scan();
    EXPECT_EQ(twin.value("QB4"), outputs) << pattern;
  }
  twin.encoded();
}

// 002:2275-2288: an ANY of 26 bytes from DB60 on, put together in local data.
TEST(Examples7, AnyInLocalData) {
  Twin twin(
      "L W#16#1002;T LW 20;L 26;T LW 22;L 60;T LW 24;L P#DBX 0.0;T LD 26;L LD 20;T MD 10;L LW 24;T MW 14;L LD 26;T MD "
      "16");
  twin.scan();
  EXPECT_EQ(twin.value("MD10"), 0x1002001A);
  EXPECT_EQ(twin.value("MW14"), 60);
  EXPECT_EQ(twin.value("MD16"), 0x84000000);
}

// 002:595-603, 002:635-653: a full address leaves its block open; the operand that was loaded first stands left of the
// relation.
TEST(Examples7, FullAddressesOpenTheirBlock) {
  Twin twin("OPN DB 2;L DB1.DBD 22;T MD 30;L DBNO;T MW 40;L DB1.DBD 22;L DB2.DBD 12;>=R;= M 50.0;L DBNO;T MW 42");
  const auto real = [](float value) { return static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(value)); };
  for (const auto& [left, right, isAtLeast] : {std::tuple{2.5F, 1.5F, 1}, {1.5F, 2.5F, 0}, {-1.0F, -1.0F, 1}}) {
    twin.put("DB1.DBD22", real(left));
    twin.put("DB2.DBD12", real(right));
    twin.scan();
    EXPECT_EQ(twin.value("MD30"), real(left));
    EXPECT_EQ(twin.value("MW40"), 1);
    EXPECT_EQ(twin.value("M50.0"), isAtLeast) << left;
    EXPECT_EQ(twin.value("MW42"), 2);
  }
}

// 002:1454-1476 and 002:1528-1545: with 3, 4, 10, 2 the chain gives 10 * (10 - 2) on two accumulators and
// (10 - 2) * ACCU4 on four, where ACCU4 is 0; with ENT (3 + 4) * (10 - 2).
TEST(Examples7, AccumulatorChain) {
  const std::string chain = "L L#3;L L#4;+D;L L#10;L L#2;-D;*D;T MD 20";
  Twin two(chain), four("L 0;PUSH;PUSH;PUSH;" + chain, "", true);
  Twin entered("L L#3;L L#4;+D;L L#10;ENT;L L#2;-D;*D;T MD 20", "", true);
  two.scan();
  four.scan();
  entered.scan();
  EXPECT_EQ(two.value("MD20"), 80);
  EXPECT_EQ(four.value("MD20"), 0);
  EXPECT_EQ(entered.value("MD20"), 56);
}

// 002:1484-1494: constants are added to the accumulator, INC and DEC count its lowest byte alone.
TEST(Examples7, ConstantsInTheAccumulator) {
  Twin twin("L 100;+ -33;T MW 10;L L#65535;+ L#1;T MD 12;L W#16#01FE;INC 5;T MW 16;L W#16#0103;DEC 7;T MW 18");
  twin.scan();
  EXPECT_EQ(twin.value("MW10"), 67);
  EXPECT_EQ(twin.value("MD12"), 65536);
  EXPECT_EQ(twin.value("MW16"), 0x0103);
  EXPECT_EQ(twin.value("MW18"), 0x01FC);
}

/// Mnemonics of the instruction list that the table of instructions has in several forms.
std::vector<std::string> namesInTable(const std::string& row) {
  if (row.starts_with("A ")) return {"A"};  // conditions are operands
  if (row == "L (T,C)") return {"L T", "L C"};
  if (row == "LC") return {"LC T", "LC C"};
  if (row == "FR") return {"FR T", "FR C"};
  if (row == "R (T,C)") return {"R T", "R C"};
  if (row == "S (C)") return {"S C"};
  if (row == "O") return {"O", "OR"};
  if (row.ends_with(" <D>")) return {row.substr(0, 4)};
  return {row};
}

TEST(Rows7, EveryInstructionIsInTheTable) {
  std::ifstream in(std::string(RUNGPROOF_SOURCE_DIR) + "/tests/data/s7300_rows.tsv");
  std::set<const Desc*> met;
  int rows = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream columns(line);
    std::string category, mnemonic, german;
    std::getline(columns, category, '\t');
    std::getline(columns, mnemonic, '\t');
    std::getline(columns, german, '\t');
    ++rows;
    for (const std::string& name : namesInTable(mnemonic)) {
      const Desc* desc = s7300Instructions().named(name);
      ASSERT_NE(desc, nullptr) << name;
      met.insert(desc);
      EXPECT_FALSE(desc->meaning.empty()) << name;
      EXPECT_FALSE(desc->manual.empty()) << name;
      if (name == mnemonic) {
        EXPECT_EQ(s7300Instructions().namedGerman(german), desc) << german;
      }
    }
  }
  EXPECT_EQ(rows, 181);
  for (const Desc& desc : s7300Instructions().all()) {
    EXPECT_TRUE(met.contains(&desc) || desc.stl == "LABEL" || desc.drawingOnly) << desc.stl << " stands in no row";
  }
}

}  // namespace
}  // namespace rungproof::agreement7
