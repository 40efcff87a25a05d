// Rows by mnemonic; what stands in none changes nothing.
#include "ir/s7300/status_effect.hpp"

#include <algorithm>
#include <array>

namespace rungproof::s7300 {

namespace {

struct EffectRow {
  std::string_view bits;
  std::string_view mnemonics;  ///< with a comma before and behind each
};

constexpr auto effectRows = std::to_array<EffectRow>({
    {"-----xxx1", ",A,AN,"},
    {"-----0xx1", ",O,ON,X,XN,FP,FN,"},
    {"-----x1-x", ",OR,"},
    {"-----01-0", ",A(,AN(,O(,ON(,X(,XN(,MCR(,)MCR,JBI,JNBI,"},
    {"-----x1x1", ",),"},
    {"-----0x-0", ",=,S,R,"},
    {"------1x-", ",NOT,"},
    {"-------x-", ",ANY,"},
    {"-----0110", ",SET,"},
    {"-----0000", ",CLR,"},
    {"x--------", ",SAVE,ENO,"},
    {"xxxxxxxxx", ",T STW,"},
    {"-xxxx----", ",+I,-I,*I,/I,+D,-D,*D,/D,MOD,+R,-R,*R,/R,SQR,SQRT,EXP,LN,SIN,COS,TAN,ASIN,ACOS,ATAN,NEGI,NEGD,"},
    {"---xx----", ",ITB,DTB,RND,TRUNC,RND+,RND-,"},
    {"-x00-----", ",AW,OW,XOW,AD,OD,XOD,RLDA,RRDA,"},
    {"-xxx-----", ",SSI,SSD,SLW,SRW,SLD,SRD,RLD,RRD,"},  // a count of 0 changes nothing
    {"-xx0-0xx1", ",==I,<>I,>I,<I,>=I,<=I,==D,<>D,>D,<D,>=D,<=D,"},
    {"-xxxx0xx1", ",==R,<>R,>R,<R,>=R,<=R,"},
    {"----0----", ",JOS,"},
    {"-----0110", ",JC,JCN,"},
    {"x----0110", ",JCB,JNB,"},
    {"----001-0", ",BE,BEU,CALL,UC,"},
    {"----x0110", ",BEC,"},
    {"----00110", ",CC,"},
    {"-----0--0", ",SP,SE,SD,SS,SF,FR T,R T,CU,CD,S C,R C,FR C,"},
    {"", ",LABEL,INDEX,"},
});

}  // namespace

std::string_view statusEffect(const Desc& desc) {
  const auto row = std::ranges::find_if(effectRows, [&](const EffectRow& each) {
    const std::size_t at = each.mnemonics.find(desc.stl);
    for (std::size_t place = at; place != std::string_view::npos; place = each.mnemonics.find(desc.stl, place + 1)) {
      if (each.mnemonics[place - 1] == ',' && each.mnemonics[place + desc.stl.size()] == ',') return true;
    }
    return false;
  });
  return row == effectRows.end() ? std::string_view("---------") : row->bits;
}

}  // namespace rungproof::s7300
