// The table of library blocks. Parameters in the order of CALL: NAME, < for an input or > for an output, and the type:
// b BOOL, B BYTE, W WORD, D DWORD, I DINT, R REAL, N DINT or REAL; "?": here stand others, which differ.
#include "ir/s7200/library_block.hpp"

#include <algorithm>
#include <vector>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

struct Row {
  std::string_view name;
  std::string_view parameters;
  std::string_view manual;
  LibraryReach reach = LibraryReach::Nothing;
  std::uint32_t ownBytes = 0;
};

using enum LibraryReach;

// clang-format off
constexpr Row rows[] = {
    {"PWMx_RUN", "Cycle<W Pulse<W Error>B", "001:8073"},
    {"PTOx_CTRL", "I_STOP<b D_STOP<b Done>b Error>B C_Pos>D", "001:8205"},
    {"PTOx_RUN", "START<b Profile<B Abort<b Done>b Error>B C_Profile>B C_Step>B C_Pos>I", "001:8231"},
    {"PTOx_MAN", "RUN<b Speed<I Error>B C_Pos>I", "001:8261"},
    {"PTOx_LDPOS", "START<b New_Pos<I Done>b Error>B C_Pos>I", "001:8291"},
    {"PTOx_ADV", "", "001:8314"},
    {"POSx_CTRL", "MOD_EN<b Done>b Error>B C_Pos>N C_Speed>N C_Dir>b", "001:8601"},
    {"POSx_MAN", "RUN<b JOG_P<b JOG_N<b Speed<N Dir<b Error>B C_Pos>N C_Speed>N C_Dir>b", "001:8637"},
    {"POSx_GOTO", "START<b Pos<N Speed<N Mode<B Abort<b Done>b Error>B C_Pos>N C_Speed>N", "001:8678"},
    {"POSx_RUN", "START<b Profile<B Abort<b Done>b Error>B C_Profile>B C_Step>B C_Pos>N C_Speed>N", "001:8719"},
    {"POSx_RSEEK", "START<b Done>b Error>B", "001:8756"},
    {"POSx_LDOFF", "START<b Done>b Error>B", "001:8781"},
    {"POSx_LDPOS", "START<b New_Pos<N Done>b Error>B C_Pos>N", "001:8802"},
    {"POSx_SRATE", "START<b ACCEL_Time<I DECEL_Time<I JERK_Time<I Done>b Error>B", "001:8828"},
    {"POSx_DIS", "DIS_ON<B Error>B", "001:8851"},
    {"POSx_CLR", "START<b Done>b Error>B", "001:8866"},
    {"POSx_CFG", "START<b Done>b Error>B", "001:8886"},
    {"MODx_CTRL", "", "001:9695"},
    {"MODx_XFR", "START<b Phone<B Data<B Done>b Error>B", "001:9703", Record},
    {"MODx_MSG", "START<b Phone<B Msg<B Done>b Error>B", "001:9727"},
    {"USS_INIT", "Mode<B Baud<D Active<D Done>b Error>B", "001:10105-10107", Nothing, 400},
    {"USS_CTRL", "RUN<b OFF2<b OFF3<b F_ACK<b DIR<b Drive<B Type<B Speed_SP<R Resp_R>b Error>B Status>W Speed>R Run_EN>b D_Dir>b Inhibit>b Fault>b", "001:10149", Nothing, 400},
    {"USS_RPM_W", "XMT_REQ<b Drive<B Param<W Index<W DB_Ptr<D Done>b Error>B Value>W", "001:10252", Scratch, 400},
    {"USS_RPM_D", "XMT_REQ<b Drive<B Param<W Index<W DB_Ptr<D Done>b Error>B Value>D", "001:10252", Scratch, 400},
    {"USS_RPM_R", "XMT_REQ<b Drive<B Param<W Index<W DB_Ptr<D Done>b Error>B Value>R", "001:10252", Scratch, 400},
    {"USS_WPM_W", "XMT_REQ<b EEPROM<b Drive<B Param<W Index<W Value<W DB_Ptr<D Done>b Error>B", "001:10285", Scratch, 400},
    {"USS_WPM_D", "XMT_REQ<b EEPROM<b Drive<B Param<W Index<W Value<D DB_Ptr<D Done>b Error>B", "001:10285", Scratch, 400},
    {"USS_WPM_R", "XMT_REQ<b EEPROM<b Drive<B Param<W Index<W Value<R DB_Ptr<D Done>b Error>B", "001:10285", Scratch, 400},
    {"MBUS_INIT", "Mode<B Addr<B Baud<D Parity<B Delay<W MaxIQ<W MaxAI<W MaxHold<W HoldStart<D Done>b Error>B", "001:10726-10728", Nothing, 779},
    {"MBUS_SLAVE", "Done>b Error>B", "001:10773", Slave, 779},
    {"RCPx_READ", "Rcp<W Error>B", "001:11020", Record},
    {"RCPx_WRITE", "Rcp<W Error>B", "001:11034"},
    {"DATx_WRITE", "? Error>B", "001:11235"},  // the S7-200 SMART gives the fields of the log here
    {"DATx_WRITE", "Error>B", "001:11235"},
    // Modbus master of the S7-200, and what the S7-200 SMART brings.
    {"MBUS_CTRL", "Mode<b Baud<D Parity<B Timeout<W Done>b Error>B", "", Nothing, 286},
    {"MBUS_CTRL", "Mode<b Baud<D Parity<B Port<B Timeout<W Done>b Error>B", "", Nothing, 286},
    {"MBUS_CTRL_P1", "Mode<b Baud<D Parity<B Timeout<W Done>b Error>B", "", Nothing, 286},
    {"MBUS_MSG_P1", "First<b Slave<B RW<B Addr<D Count<W DataPtr<D Done>b Error>B", "", Message, 286},
    {"MB_CTRL2", "Mode<b Baud<D Parity<B Port<B Timeout<W Done>b Error>B", "", Nothing, 286},
    {"MBUS_MSG", "First<b Slave<B RW<B Addr<D Count<W DataPtr<D Done>b Error>B", "", Message, 286},
    {"MB_MSG2", "First<b Slave<B RW<B Addr<D Count<W DataPtr<D Done>b Error>B", "", Message, 286},
    {"MBUS_INIT", "Mode<B Addr<B Baud<D Parity<B Port<B Delay<W MaxIQ<W MaxAI<W MaxHold<W HoldStart<D Done>b Error>B", "", Nothing, 786},
    {"MBUS_CLIENT", "Req<b Connect<b IPAddr1<B IPAddr2<B IPAddr3<B IPAddr4<B IP_Port<W RW<B Addr<D Count<W DataPtr<D Done>b Error>B", "", Message, 638},
    {"MBUS_SERVER", "Connect<b IP_Port<W MaxIQ<W MaxAI<W MaxHold<W HoldStart<D Done>b Error>B", "", Holding, 445},
    {"TCP_CONNECT", "?", "", Nothing, 50},
    {"ISO_CONNECT", "?", "", Nothing, 50},
    {"UDP_CONNECT", "?", "", Nothing, 50},
    {"TCP_SEND", "?", "", Nothing, 50},
    {"UDP_SEND", "?", "", Nothing, 50},
    {"TCP_RECV", "?", "", Received, 50},
    {"UDP_RECV", "?", "", Received, 50},
    {"DISCONNECT", "?", "", Nothing, 50},
    {"PIDx_CTRL", "PV_I<W Setpoint<R ?", "", Nothing, 240},
    {"PIDx_INIT", "PV_I<W Setpoint<R ?", "", Nothing, 120},
    // Network wizards move data between partners and V memory that they have placed (001:3035, 001:13390).
    {"NET_EXE", "Timeout<W ?", "", Record},
    {"ETHx_CTRL", "?", ""},
    {"ETHx_XFR", "START<b Chan_ID<B Data<B Abort<b ?", "", Record},
    {"AXISx_CTRL", "MOD_EN<b Done>b Error>B C_Pos>N C_Speed>N C_Dir>b", ""},
    {"AXISx_MAN", "RUN<b JOG_P<b JOG_N<b Speed<N Dir<b Error>B C_Pos>N C_Speed>N C_Dir>b", ""},
    {"AXISx_GOTO", "START<b Pos<N Speed<N Mode<B Abort<b Done>b Error>B C_Pos>N C_Speed>N", ""},
    {"AXISx_RUN", "START<b Profile<B Abort<b Done>b Error>B C_Profile>B C_Step>B C_Pos>N C_Speed>N", ""},
    {"AXISx_RSEEK", "START<b Done>b Error>B", ""},
    {"AXISx_LDOFF", "START<b Done>b Error>B", ""},
    {"AXISx_LDPOS", "START<b New_Pos<N Done>b Error>B C_Pos>N", ""},
    {"AXISx_SRATE", "START<b ACCEL_Time<I DECEL_Time<I JERK_Time<I Done>b Error>B", ""},
    {"AXISx_DIS", "DIS_ON<B Error>B", ""},
    {"AXISx_CFG", "START<b Done>b Error>B", ""},
};
// clang-format on

DataType typeOf(char letter) {
  switch (letter) {
    case 'b': return DataType::Bool;
    case 'B': return DataType::Byte;
    case 'W': return DataType::Word;
    case 'D': return DataType::DWord;
    case 'R': return DataType::Real;
    default: return DataType::DInt;
  }
}

std::vector<LibraryParameter> parametersOf(std::string_view text) {
  std::vector<LibraryParameter> parameters;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (word == "?") continue;
    const std::size_t mark = word.find_first_of("<>");
    parameters.push_back({word.substr(0, mark), word[mark] == '<' ? Direction::In : Direction::Out, typeOf(word.back()),
                          word.back() == 'N'});
  }
  return parameters;
}

struct Table {
  std::vector<std::vector<LibraryParameter>> parameters;
  std::vector<LibraryBlock> blocks;
  Table() {
    for (const Row& row : rows) parameters.push_back(parametersOf(row.parameters));
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const Row& row = rows[i];
      blocks.push_back({row.name, parameters[i], row.manual, row.reach, row.ownBytes,
                        row.parameters.find('?') != std::string_view::npos});
    }
  }
};

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool matches(std::string_view pattern, std::string_view name) {
  if (pattern.size() != name.size()) return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool isSame = pattern[i] == 'x' ? name[i] >= '0' && name[i] <= '9' : upper(pattern[i]) == upper(name[i]);
    if (!isSame) return false;
  }
  return true;
}

}  // namespace

std::span<const LibraryBlock> libraryBlocks() {
  static const Table table;
  return table.blocks;
}

const LibraryBlock* libraryBlockNamed(std::string_view name) {
  for (const LibraryBlock& block : libraryBlocks()) {
    if (matches(block.name, name)) return &block;
  }
  return nullptr;
}

const LibraryBlock* libraryBlockWith(std::string_view name, std::size_t parameters) {
  for (const LibraryBlock& block : libraryBlocks()) {
    if (!block.isOpen && block.parameters.size() == parameters && matches(block.name, name)) return &block;
  }
  return nullptr;
}

bool hasFixedParameters(const Target& target, std::string_view name) {
  const LibraryBlock* block = libraryBlockNamed(name);
  return block != nullptr && !block->manual.empty() && !isSmart(target);
}

const LibraryParameter* libraryOutput(const LibraryBlock& block, std::size_t place) {
  if (place == 0 || place > block.parameters.size()) return nullptr;
  const LibraryParameter& parameter = block.parameters[place - 1];
  return parameter.direction == Direction::Out ? &parameter : nullptr;
}

std::uint32_t libraryOutputNamed(const LibraryBlock& block, std::string_view name) {
  for (std::uint32_t place = 1; place <= block.parameters.size(); ++place) {
    const LibraryParameter* output = libraryOutput(block, place);
    if (output != nullptr && output->name == name) return place;
  }
  return 0;
}

}  // namespace rungproof
