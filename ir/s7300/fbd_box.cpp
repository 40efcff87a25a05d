// One row for each box, in the order of the manual's table.
#include "ir/s7300/fbd_box.hpp"

#include <algorithm>
#include <array>

namespace rungproof::s7300 {

namespace {

using enum BoxFrame;

// clang-format off
constexpr auto boxRows = std::to_array<FbdBox>({
    {"NEG", "", "address negative edge detection", Plain, "A(; A $BOX; FN $M_BIT; ); = $Q", "003:20"},
    {"POS", "", "address positive edge detection", Plain, "A(; A $BOX; FP $M_BIT; ); = $Q", "003:21"},
    {"&", "", "AND", Plain, "A $IN1; A $IN2; = $Q", "003:22"},
    {"=", "", "assign", Plain, "A $IN; = $BOX", "003:23"},
    {"CD", "ZR", "down counter", Plain, "A $IN; CD $BOX", "003:42"},
    {"XOR", "", "exclusive or", Plain, "X $IN1; X $IN2; = $Q", "003:47"},
    {"SE", "SV", "extended pulse timer", Plain, "A $IN; L $TV; SE $BOX", "003:49"},
    {"", "", "a further input of a gate", Plain, "A $IN1; A $IN2; A $IN3; = $Q", "003:63"},
    {"#", "", "midline output", Plain, "A $IN; = $BOX; A $BOX; = $Q", "003:72"},
    {"o", "", "negate binary input", Plain, "AN $IN; = $Q", "003:76"},
    {"N", "", "negative RLO edge detection", Plain, "A $IN; FN $BOX; = $Q", "003:78"},
    {"SF", "SA", "off-delay timer", Plain, "A $IN; L $TV; SF $BOX", "003:80"},
    {"SD", "SE", "on-delay timer", Plain, "A $IN; L $TV; SD $BOX", "003:82"},
    {">=1", "", "OR", Plain, "O $IN1; O $IN2; = $Q", "003:86"},
    {"P", "", "positive RLO edge detection", Plain, "A $IN; FP $BOX; = $Q", "003:87"},
    {"SP", "SI", "pulse timer", Plain, "A $IN; L $TV; SP $BOX", "003:89"},
    {"R", "", "reset output", Plain, "A $IN; R $BOX", "003:90"},
    {"RS", "", "reset-set flip-flop, set wins", Plain, "A $R; R $BOX; A $S; S $BOX; A $BOX; = $Q", "003:91"},
    {"SS", "", "retentive on-delay timer", Plain, "A $IN; L $TV; SS $BOX", "003:100"},
    {"SAVE", "", "save RLO to BR", Plain, "A $IN; SAVE", "003:106"},
    {"S", "", "set output", Plain, "A $IN; S $BOX", "003:107"},
    {"SC", "SZ", "set counter value", Plain, "A $IN; L $PV; S $BOX", "003:108"},
    {"SR", "", "set-reset flip-flop, reset wins", Plain, "A $S; S $BOX; A $R; R $BOX; A $BOX; = $Q", "003:109"},
    {"CU", "ZV", "up counter", Plain, "A $IN; CU $BOX", "003:123"},
    {"S_PEXT", "S_VIMP", "extended pulse S5 timer", Timer, "A $S; L $TV; SE $BOX", "003:48"},
    {"S_OFFDT", "S_AVERZ", "off-delay S5 timer", Timer, "A $S; L $TV; SF $BOX", "003:79"},
    {"S_ODT", "S_EVERZ", "on-delay S5 timer", Timer, "A $S; L $TV; SD $BOX", "003:81"},
    {"S_PULSE", "S_IMPULS", "pulse S5 timer", Timer, "A $S; L $TV; SP $BOX", "003:88"},
    {"S_ODTS", "S_SEVERZ", "retentive on-delay S5 timer", Timer, "A $S; L $TV; SS $BOX", "003:99"},
    {"S_CD", "Z_RUECK", "down counter", Counter, "A $CD; CD $BOX", "003:41"},
    {"S_CU", "Z_VORW", "up counter", Counter, "A $CU; CU $BOX", "003:122"},
    {"S_CUD", "ZAEHLER", "up-down counter", Counter, "A $CU; CU $BOX; A $CD; CD $BOX", "003:124"},
    {"ADD_DI", "", "add double integer", Checked, "L $IN1; L $IN2; +D; T $OUT", "003:17"},
    {"ADD_I", "", "add integer", Checked, "L $IN1; L $IN2; +I; T $OUT", "003:18"},
    {"DIV_DI", "", "divide double integer", Checked, "L $IN1; L $IN2; /D; T $OUT", "003:36"},
    {"DIV_I", "", "divide integer", Checked, "L $IN1; L $IN2; /I; T $OUT", "003:37"},
    {"MUL_DI", "", "multiply double integer", Checked, "L $IN1; L $IN2; *D; T $OUT", "003:73"},
    {"MUL_I", "", "multiply integer", Checked, "L $IN1; L $IN2; *I; T $OUT", "003:74"},
    {"MOD", "", "return fraction double integer", Checked, "L $IN1; L $IN2; MOD; T $OUT", "003:102"},
    {"SUB_DI", "", "subtract double integer", Checked, "L $IN1; L $IN2; -D; T $OUT", "003:116"},
    {"SUB_I", "", "subtract integer", Checked, "L $IN1; L $IN2; -I; T $OUT", "003:117"},
    {"ADD_R", "", "add real", Checked, "L $IN1; L $IN2; +R; T $OUT", "003:19"},
    {"DIV_R", "", "divide real", Checked, "L $IN1; L $IN2; /R; T $OUT", "003:38"},
    {"ABS", "", "absolute value", Enabled, "L $IN; ABS; T $OUT", "003:51"},
    {"ACOS", "", "arc cosine", Checked, "L $IN; ACOS; T $OUT", "003:53"},
    {"ASIN", "", "arc sine", Checked, "L $IN; ASIN; T $OUT", "003:54"},
    {"ATAN", "", "arc tangent", Checked, "L $IN; ATAN; T $OUT", "003:55"},
    {"COS", "", "cosine", Checked, "L $IN; COS; T $OUT", "003:56"},
    {"EXP", "", "exponential value", Checked, "L $IN; EXP; T $OUT", "003:57"},
    {"LN", "", "natural logarithm", Checked, "L $IN; LN; T $OUT", "003:58"},
    {"SIN", "", "sine", Checked, "L $IN; SIN; T $OUT", "003:59"},
    {"SQR", "", "square", Checked, "L $IN; SQR; T $OUT", "003:60"},
    {"SQRT", "", "square root", Checked, "L $IN; SQRT; T $OUT", "003:61"},
    {"TAN", "", "tangent", Checked, "L $IN; TAN; T $OUT", "003:62"},
    {"MUL_R", "", "multiply real", Checked, "L $IN1; L $IN2; *R; T $OUT", "003:75"},
    {"SUB_R", "", "subtract real", Checked, "L $IN1; L $IN2; -R; T $OUT", "003:118"},
    {"CMP>=D", "", "compare double integer", Plain, "A(; L $IN1; L $IN2; >=D; ); = $Q", "003:33"},
    {"CMP>=I", "", "compare integer", Plain, "A(; L $IN1; L $IN2; >=I; ); = $Q", "003:34"},
    {"CMP>=R", "", "compare real", Plain, "A(; L $IN1; L $IN2; >=R; ); = $Q", "003:35"},
    {"MOVE", "", "assign a value", Enabled, "L $IN; T $OUT", "003:24"},
    {"BCD_DI", "", "BCD to double integer", Enabled, "L $IN; BTD; T $OUT", "003:25"},
    {"BCD_I", "", "BCD to integer", Enabled, "L $IN; BTI; T $OUT", "003:26"},
    {"CEIL", "", "ceiling", Checked, "L $IN; RND+; T $OUT", "003:32"},
    {"DI_BCD", "", "double integer to BCD", Checked, "L $IN; DTB; T $OUT", "003:39"},
    {"DI_R", "", "double integer to real", Enabled, "L $IN; DTR; T $OUT", "003:40"},
    {"FLOOR", "", "floor", Checked, "L $IN; RND-; T $OUT", "003:50"},
    {"I_BCD", "", "integer to BCD", Checked, "L $IN; ITB; T $OUT", "003:64"},
    {"I_DI", "", "integer to double integer", Enabled, "L $IN; ITD; T $OUT", "003:65"},
    {"NEG_R", "", "negate real number", Enabled, "L $IN; NEGR; T $OUT", "003:77"},
    {"INV_DI", "", "ones complement double integer", Enabled, "L $IN; INVD; T $OUT", "003:83"},
    {"INV_I", "", "ones complement integer", Enabled, "L $IN; INVI; T $OUT", "003:84"},
    {"ROUND", "", "round to double integer", Checked, "L $IN; RND; T $OUT", "003:105"},
    {"TRUNC", "", "truncate double integer part", Checked, "L $IN; TRUNC; T $OUT", "003:119"},
    {"NEG_DI", "", "twos complement double integer", Checked, "L $IN; NEGD; T $OUT", "003:120"},
    {"NEG_I", "", "twos complement integer", Checked, "L $IN; NEGI; T $OUT", "003:121"},
    {"WAND_DW", "", "AND of double word", Enabled, "L $IN1; L $IN2; AD; T $OUT", "003:125"},
    {"WAND_W", "", "AND of word", Enabled, "L $IN1; L $IN2; AW; T $OUT", "003:126"},
    {"WXOR_DW", "", "exclusive OR of double word", Enabled, "L $IN1; L $IN2; XOD; T $OUT", "003:127"},
    {"WXOR_W", "", "exclusive OR of word", Enabled, "L $IN1; L $IN2; XOW; T $OUT", "003:128"},
    {"WOR_DW", "", "OR of double word", Enabled, "L $IN1; L $IN2; OD; T $OUT", "003:129"},
    {"WOR_W", "", "OR of word", Enabled, "L $IN1; L $IN2; OW; T $OUT", "003:130"},
    {"ROL_DW", "", "rotate left double word", Enabled, "L $N; L $IN; RLD; T $OUT", "003:103"},
    {"ROR_DW", "", "rotate right double word", Enabled, "L $N; L $IN; RRD; T $OUT", "003:104"},
    {"SHL_DW", "", "shift left double word", Enabled, "L $N; L $IN; SLD; T $OUT", "003:110"},
    {"SHL_W", "", "shift left word", Enabled, "L $N; L $IN; SLW; T $OUT", "003:111"},
    {"SHR_DI", "", "shift right double integer", Enabled, "L $N; L $IN; SSD; T $OUT", "003:112"},
    {"SHR_DW", "", "shift right double word", Enabled, "L $N; L $IN; SRD; T $OUT", "003:113"},
    {"SHR_I", "", "shift right integer", Enabled, "L $N; L $IN; SSI; T $OUT", "003:114"},
    {"SHR_W", "", "shift right word", Enabled, "L $N; L $IN; SRW; T $OUT", "003:115"},
    {"OPN", "AUF", "open data block", Plain, "OPN $BOX", "003:85"},
    {"JMP", "", "jump", Plain, "A $IN; JC $BOX", "003:66"},
    {"JMPN", "", "jump-if-not", Plain, "A $IN; JCN $BOX", "003:67"},
    {"BR", "BIE", "exception bit binary result", Plain, "A BR; = $Q", "003:43"},
    {"OV", "", "exception bit overflow", Plain, "A OV; = $Q", "003:44"},
    {"OS", "", "exception bit overflow stored", Plain, "A OS; = $Q", "003:45"},
    {"UO", "", "exception bit unordered", Plain, "A UO; = $Q", "003:46"},
    {"==0", "", "result bit equal 0", Plain, "A ==0; = $Q", "003:92"},
    {">=0", "", "result bit greater equal 0", Plain, "A >=0; = $Q", "003:93"},
    {">0", "", "result bit greater than 0", Plain, "A >0; = $Q", "003:94"},
    {"<=0", "", "result bit less equal 0", Plain, "A <=0; = $Q", "003:95"},
    {"<0", "", "result bit less than 0", Plain, "A <0; = $Q", "003:97"},
    {"<>0", "", "result bit not equal 0", Plain, "A <>0; = $Q", "003:98"},
    {"CALL_FB", "", "call an FB from box", Call, "CALL $BOX, $DB", "003:27"},
    {"CALL_FC", "", "call an FC from box", Call, "CALL $BOX", "003:28"},
    {"CALL", "", "call an FC or SFC without parameters", Plain, "A $IN; CC $BOX", "003:29"},
    {"CALL_SFB", "", "call an SFB from box", Call, "CALL $BOX, $DB", "003:30"},
    {"CALL_SFC", "", "call an SFC from box", Call, "CALL $BOX", "003:31"},
    {"MCRA", "", "master control relay activate", Plain, "MCRA", "003:68"},
    {"MCRD", "", "master control relay deactivate", Plain, "MCRD", "003:69"},
    {"MCR>", "", "master control relay off", Plain, ")MCR", "003:70"},
    {"MCR<", "", "master control relay on", Plain, "A $IN; MCR(", "003:71"},
    {"RET", "", "return", Plain, "A $IN; SAVE; BEC", "003:101"},
});
// clang-format on

/// The pin whose sign $ stands at `at`.
std::string_view pinAt(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() &&
         ((text[end] >= 'A' && text[end] <= 'Z') || (text[end] >= '0' && text[end] <= '9') || text[end] == '_'))
    ++end;
  return text.substr(at + 1, end - at - 1);
}

}  // namespace

std::span<const FbdBox> fbdBoxes() { return boxRows; }

std::vector<const FbdBox*> fbdBoxesNamed(std::string_view name) {
  std::vector<const FbdBox*> found;
  for (const FbdBox& box : boxRows) {
    if (!name.empty() && (box.name == name || box.german == name)) found.push_back(&box);
  }
  return found;
}

std::string expansionOf(const FbdBox& box) {
  const std::string text(box.statements);
  const auto enabled = [&](std::string_view end) {
    return "A $EN; JNB _001; " + text + std::string(end) + "; _001: A BR; = $ENO";
  };
  switch (box.frame) {
    case Plain: return text;
    case Enabled: return enabled("; SET; SAVE; CLR");
    case Checked: return enabled("; AN OV; SAVE; CLR");
    case Call: return enabled("");
    case Timer: return text + "; A $R; R $BOX; L $BOX; T $BI; LC $BOX; T $BCD; A $BOX; = $Q";
    case Counter: return text + "; A $S; L $PV; S $BOX; A $R; R $BOX; L $BOX; T $CV; LC $BOX; T $CV_BCD; A $BOX; = $Q";
  }
  return text;
}

std::vector<std::string> pinsOf(const FbdBox& box) {
  const std::string text = expansionOf(box);
  std::vector<std::string> pins;
  for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1)) {
    std::string pin(pinAt(text, at));
    if (pin == "EN" || pin == "ENO" || std::ranges::find(pins, pin) != pins.end()) continue;
    pins.push_back(std::move(pin));
  }
  return pins;
}

}  // namespace rungproof::s7300
