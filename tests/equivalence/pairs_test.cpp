// Pairs of programs whose truth was reasoned out by hand, half of them different. The reason stands beside each.
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

constexpr Equality equal = Equality::Equal, different = Equality::Different;
constexpr const char* oneBit = "LD I0.0;= Q0.0";

const std::vector<Pair> pairs = {
    // Logic
    {"itself", "LD I0.0;O Q0.0;AN I0.1;= Q0.0", "LD I0.0;O Q0.0;AN I0.1;= Q0.0", equal, "the same text"},
    {"german", "LD I0.0;A I0.1;= Q0.0", "LD E0.0;U E0.1;= A0.0", equal, "the same instructions in German"},
    {"networks_swapped", "LD I0.0;= Q0.0|LD I0.1;= Q0.1", "LD I0.1;= Q0.1|LD I0.0;= Q0.0", equal, "neither reads the other"},
    {"reader_before_writer", "LD I0.0;= M0.0|LD M0.0;= Q0.0", "LD M0.0;= Q0.0|LD I0.0;= M0.0", different,
     "NEW shows the input of the scan before"},
    {"de_morgan", "LD I0.0;A I0.1;NOT;= Q0.0", "LDN I0.0;ON I0.1;= Q0.0", equal, "not (a and b) = not a or not b"},
    {"de_morgan_slip", "LD I0.0;A I0.1;NOT;= Q0.0", "LDN I0.0;AN I0.1;= Q0.0", different, "one input on is enough"},
    {"contacts_swapped", "LD I0.0;A I0.1;= Q0.0", "LD I0.1;A I0.0;= Q0.0", equal, "and commutes"},
    {"contact_negated", "LD I0.0;A I0.1;= Q0.0", "LD I0.0;AN I0.1;= Q0.0", different, "another contact"},
    {"stack_unfolded", "LD I0.0;LPS;A I0.1;= Q0.0;LPP;A I0.2;= Q0.1", "LD I0.0;A I0.1;= Q0.0|LD I0.0;A I0.2;= Q0.1", equal,
     "LPS and LPP keep the first contact"},
    {"branch_order", "LD I0.0;LD I0.1;A I0.2;OLD;= Q0.0", "LD I0.0;O I0.1;A I0.2;= Q0.0", different,
     "I0.0 alone is enough for OLD only"},
    {"always_on_removed", "LD SM0.0;A I0.0;= Q0.0", oneBit, equal, "SM0.0 is 1"},
    {"bit_in_between", "LD I0.0;A I0.1;= M0.0|LD M0.0;O I0.2;= Q0.0", "LD I0.0;A I0.1;O I0.2;= Q0.0", equal,
     "M0.0 is written before it is read"},
    {"two_coils", "LD I0.0;= Q0.0|LD I0.1;= Q0.0", "LD I0.1;= Q0.0|LD I0.0;= Q0.0", different, "the last coil wins"},
    {"dead_coil_removed", "LD I0.0;= Q0.0|LD I0.1;= Q0.0", "LD I0.1;= Q0.0", equal, "the first coil is overwritten"},
    {"unused_word_removed", "LD I0.0;= Q0.0|LD SM0.0;MOVW 7,VW0", oneBit, equal, "nothing reads VW0"},
    {"output_removed", "LD I0.0;= Q0.0|LD I0.1;= Q0.1", oneBit, different, "Q0.1 counts as 0 in NEW"},
    {"output_that_is_never_on", "LD I0.0;= Q0.0|LD I0.1;AN I0.1;= Q0.1", oneBit, equal, "Q0.1 is 0 in both"},
    {"xor_by_hand", "LD I0.0;AN I0.1;LDN I0.0;A I0.1;OLD;= Q0.0", "LD I0.0;O I0.1;LD I0.0;A I0.1;NOT;ALD;= Q0.0", equal,
     "two forms of exclusive or"},
    // Latches
    {"latch_reset_last", "LD I0.0;S Q0.0,1|LD I0.1;R Q0.0,1", "LD I0.0;O Q0.0;AN I0.1;= Q0.0", equal, "reset wins in both"},
    {"latch_set_last", "LD I0.1;R Q0.0,1|LD I0.0;S Q0.0,1", "LD I0.0;O Q0.0;AN I0.1;= Q0.0", different,
     "with both inputs on set wins in OLD"},
    {"latch_set_last_sealed", "LD I0.1;R Q0.0,1|LD I0.0;S Q0.0,1", "LD Q0.0;AN I0.1;O I0.0;= Q0.0", equal, "set wins in both"},
