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
    {"range_cut", "LD I0.0;S Q0.0,3", "LD I0.0;S Q0.0,2", different, "Q0.2 is set in OLD only"},
    {"range_split", "LD I0.0;S Q0.0,3", "LD I0.0;S Q0.0,1;S Q0.1,2", equal, "the same three bits"},
    // Scan 1 and edges
    {"edge_by_hand", "LD I0.0;EU;= Q0.0", "LD I0.0;AN M0.0;= Q0.0|LD I0.0;= M0.0", different,
     "in scan 1 EU sees no edge (001:2763), the hand-made one does"},
    {"edge_by_hand_but_scan_1", "LD I0.0;EU;= Q0.0", "LD I0.0;AN M0.0;AN SM0.1;= Q0.0|LD I0.0;= M0.0", equal,
     "the first scan is left out"},
    {"falling_edge_by_hand", "LD I0.0;ED;= Q0.0", "LDN I0.0;A M0.0;= Q0.0|LD I0.0;= M0.0", equal,
     "in scan 1 M0.0 is 0, so neither sees an edge"},
    {"set_once_is_for_ever", "LD SM0.1;S Q0.0,1", "LD SM0.0;= Q0.0", equal, "set in scan 1 and never reset"},
    {"first_scan_only", "LD SM0.1;= Q0.0", "LD SM0.1;AN SM0.0;= Q0.0", different, "only scan 1 differs"},
    // Words
    {"bytes_of_a_word", "LD SM0.0;MOVW IW0,QW0", "LD SM0.0;MOVB IB0,QB0;MOVB IB1,QB1", equal, "a word is its two bytes"},
    {"bytes_swapped", "LD SM0.0;MOVW IW0,QW0", "LD SM0.0;MOVB IB1,QB0;MOVB IB0,QB1", different, "the bytes are swapped"},
    {"swap_twice", "LD SM0.0;MOVW IW0,VW0;SWAP VW0;SWAP VW0;MOVW VW0,QW0", "LD SM0.0;MOVW IW0,QW0", equal, "swapped back"},
    {"block_move", "LD SM0.0;BMB IB0,QB0,2", "LD SM0.0;MOVW IW0,QW0", equal, "two bytes either way"},
    {"sum_reordered",
     "LD SM0.0;MOVW IW0,VW0;ANDW 16#0FFF,VW0;MOVW IW2,VW2;ANDW 16#0FFF,VW2;+I VW2,VW0;MOVW VW0,QW0",
     "LD SM0.0;MOVW IW2,VW0;ANDW 16#0FFF,VW0;MOVW IW0,VW2;ANDW 16#0FFF,VW2;+I VW2,VW0;MOVW VW0,QW0", equal,
     "two numbers below 4096 do not overflow, and + commutes"},
    {"sum_reordered_overflow", "LD SM0.0;MOVW IW0,VW0;+I IW2,VW0;MOVW VW0,QW0", "LD SM0.0;MOVW IW2,VW0;+I IW0,VW0;MOVW VW0,QW0",
     different, "after an overflow VW0 keeps the first number (001:4814)"},
    {"increments", "LD SM0.0;MOVB IB0,VB1;MOVB 0,VB0;INCW VW0;INCW VW0;MOVW VW0,QW0", "LD SM0.0;MOVB IB0,VB1;MOVB 0,VB0;+I 2,VW0;MOVW VW0,QW0",
     equal, "1 + 1 = 2 far from the border"},
    {"mask_slip", "LD SM0.0;MOVB IB0,QB0;ANDB 16#0F,QB0", "LD SM0.0;MOVB IB0,QB0;ANDB 16#1F,QB0", different, "bit 4"},
    {"compare_by_one", "LDW>= IW0,5;= Q0.0", "LDW> IW0,4;= Q0.0", equal, "whole numbers"},
    {"compare_sign", "LDW> IW0,0;= Q0.0", "LDW<> IW0,0;= Q0.0", different, "words are signed (001:3371)"},
    {"words_overlap", "LD SM0.0;MOVW IW0,VW0;MOVW IW2,VW2;MOVW VW0,QW0", "LD SM0.0;MOVW IW0,VW0;MOVW IW2,VW1;MOVW VW0,QW0", different,
     "VW1 covers VB1"},
    {"words_moved", "LD SM0.0;MOVW IW0,VW0;MOVW IW2,VW2;MOVW VW0,QW0", "LD SM0.0;MOVW IW0,VW10;MOVW IW2,VW20;MOVW VW10,QW0", equal,
     "other places that do not overlap"},
    // Addresses
    {"map", "LD I0.0;AN I0.1;= Q0.0", "LD I1.0;AN I1.1;= Q1.0", equal, "renamed by the map", "I0.0..I0.1 = I1.0..I1.1;Q0.0 = Q1.0"},
    {"map_missing", "LD I0.0;= Q0.0", "LD I1.0;= Q1.0", different, "without a map these are other terminals"},
    {"map_crossed", "LD I0.0;AN I0.1;= Q0.0", "LD I0.0;AN I0.1;= Q0.0", different, "the map swaps the two inputs",
     "I0.0 = I0.1;I0.1 = I0.0"},
    {"memory_renamed", "LD I0.0;S M0.0,1|LD I0.1;R M0.0,1|LD M0.0;= Q0.0", "LD I0.0;S V7.3,1|LD I0.1;R V7.3,1|LD V7.3;= Q0.0", equal,
     "memory is no output"},
    // Timers and counters
    {"timer_renamed", "LD I0.0;TON T37,30|LD T37;= Q0.0", "LD I0.0;TON T38,30|LD T38;= Q0.0", equal, "two timers of 100 ms"},
    {"preset_longer", "LD I0.0;TON T37,30|LD T37;= Q0.0", "LD I0.0;TON T37,31|LD T37;= Q0.0", different, "one tick more"},
    {"preset_much_later", "LD I0.0;TON T37,30000|LD T37;= Q0.0", "LD I0.0;TON T37,30001|LD T37;= Q0.0", different,
     "they differ after 30,000 ticks"},
    {"other_resolution", "LD I0.0;TON T37,10|LD T37;= Q0.0", "LD I0.0;TON T33,100|LD T33;= Q0.0", different, "100 ms against 10 ms"},
    {"timers_in_a_row", "LD I0.0;TON T37,10|LD T37;TON T38,20|LD T38;= Q0.0", "LD I0.0;TON T39,30|LD T39;= Q0.0", equal,
     "scans of at most 50 ms pass one tick at a time, and T38 starts with the tick that ends T37", "", "", 10, 50},
    {"timers_in_a_row_slow", "LD I0.0;TON T37,10|LD T37;TON T38,20|LD T38;= Q0.0", "LD I0.0;TON T39,30|LD T39;= Q0.0", different,
     "a scan of 500 ms carries T37 beyond its preset, and T38 starts at 0"},
    {"counter_renamed", "LD I0.0;LD I0.1;CTU C0,3|LD C0;= Q0.0", "LD I0.0;LD I0.1;CTU C5,3|LD C5;= Q0.0", equal, "two counters"},
    {"counter_preset", "LD I0.0;LD I0.1;CTU C0,3|LD C0;= Q0.0", "LD I0.0;LD I0.1;CTU C0,4|LD C0;= Q0.0", different, "after three edges"},
    // Steps
    {"steps_by_scr",
     "LD SM0.1;S S0.0,1|LSCR S0.0|LD I0.0;SCRT S0.1|SCRE|LSCR S0.1|LD I0.1;SCRT S0.0|SCRE|LD S0.0;= Q0.0|LD S0.1;= Q0.1",
     "LD SM0.1;S M0.0,1|LD M0.0;A I0.0;S M0.1,1;R M0.0,1|LD M0.1;A I0.1;S M0.0,1;R M0.1,1|LD M0.0;= Q0.0|LD M0.1;= Q0.1", equal,
     "SCRT sets one and resets the other at once"},
    {"steps_in_other_order",
     "LD SM0.1;S M0.0,1|LD M0.0;A I0.0;S M0.1,1;R M0.0,1|LD M0.1;A I0.1;S M0.0,1;R M0.1,1|LD M0.0;= Q0.0",
     "LD SM0.1;S M0.0,1|LD M0.1;A I0.1;S M0.0,1;R M0.1,1|LD M0.0;A I0.0;S M0.1,1;R M0.0,1|LD M0.0;= Q0.0", different,
     "with both inputs on OLD passes both steps in one scan"},
    // Blocks
    {"subroutine_inlined", "LD I0.0;CALL SBR0@SBR0:LD I0.1;S Q0.0,1", "LD I0.0;A I0.1;S Q0.0,1", equal, "called where I0.0 is on"},
    {"subroutine_coil", "LD I0.0;CALL SBR0@SBR0:LD I0.1;= Q0.0", "LD I0.0;A I0.1;= Q0.0", different,
     "a coil that is not executed keeps its value"},
    {"loop_unrolled", "LD SM0.0;MOVB 0,QB0|LD SM0.0;FOR VW0,1,3|LD SM0.0;INCB QB0|NEXT", "LD SM0.0;MOVB 3,QB0", equal, "three rounds"},
    {"loop_one_more", "LD SM0.0;MOVB 0,QB0|LD SM0.0;FOR VW0,1,4|LD SM0.0;INCB QB0|NEXT", "LD SM0.0;MOVB 3,QB0", different, "four rounds"},
    {"jump_by_gate", "LD I0.0;JMP 1|LD I0.1;= Q0.0|LBL 1", "LD I0.0;A Q0.0;LDN I0.0;A I0.1;OLD;= Q0.0", equal,
     "what is jumped over keeps its value"},
    {"jump_removed", "LD I0.0;JMP 1|LD I0.1;= Q0.0|LBL 1", "LD I0.1;= Q0.0", different, "NEW follows I0.1 always"},
    {"stop", "LD I0.0;STOP|LD I0.1;= Q0.0", "LD I0.1;= Q0.0", different, "OLD stops"},
    {"stop_never", "LD I0.0;AN I0.0;STOP|LD I0.1;= Q0.0", "LD I0.1;= Q0.0", equal, "the STOP never runs"},
    {"undefined_local", "LD SM0.0;CALL SBR0@SBR0:LD L0.0;= Q0.0", "LD SM0.0;CALL SBR0@SBR0:LD L0.0;= Q0.0", different,
     "local memory is undefined on entry (001:1373), each program has its own"},
    // Immediate reads
    {"immediate_for_image", "LD I0.0;= Q0.0", "LDI I0.0;= Q0.0", different, "the input may change within the scan"},
    {"immediate_steady", "LD I0.0;= Q0.0", "LDI I0.0;= Q0.0", equal, "inputs are held", "", "", 1, 500, 0, 0, true},
    {"immediate_itself", "LDI I0.0;= Q0.0|LDI I0.1;= Q0.1", "LDI I0.1;= Q0.1|LDI I0.0;= Q0.0", equal, "the same reads in the same networks"},
    // Start and delays
    {"retentive_start", "LDW= VW0,0;= Q0.0", "LD SM0.0;= Q0.0", different, "VW0 starts with any value", "", "initial retentive"},
    {"zero_start", "LDW= VW0,0;= Q0.0", "LD SM0.0;= Q0.0", equal, "VW0 starts with 0 and is never written"},
    {"initialised_start", "LD SM0.1;MOVW 0,VW0|LDW= VW0,0;= Q0.0", "LD SM0.0;= Q0.0", equal, "scan 1 writes VW0", "", "initial retentive"},
    {"retentive_same", "LD V0.0;= Q0.0", "LD V0.0;= Q0.0", equal, "equal where paired", "", "initial retentive"},
    {"latency", "LD I0.0;= M0.0|LD M0.0;= Q0.0", "LD M0.0;= Q0.0|LD I0.0;= M0.0", equal, "one scan later", "", "", 1, 500, 1},
    {"latency_too_long", "LD I0.0;= M0.0|LD M0.0;= Q0.0", "LD M0.0;= Q0.0|LD I0.0;= M0.0", different, "one scan, not two", "", "", 1, 500, 2},
    {"settle", "LD I0.0;= M0.0|LD M0.0;= Q0.0", "LD M0.0;= Q0.0|LD I0.0;= M0.0", different,
     "an input that changes in every scan keeps them apart without a break", "", "", 1, 500, 0, 600},
    {"settle_pulse", "LD I0.0;EU;= Q0.0", "LD I0.0;AN I0.0;= Q0.0", equal, "a pulse of one scan is gone at the next scan end", "", "", 1, 500, 0, 501},
    {"assumption", "LD I0.0;A I0.1;= Q0.0", "LD I0.0;= Q0.0", equal, "I0.1 is assumed to follow I0.0", "", "assume a: I0.0 implies I0.1"},
    {"assumption_missing", "LD I0.0;A I0.1;= Q0.0", "LD I0.0;= Q0.0", different, "I0.0 alone"},
    // Interrupts
    {"interrupt_itself", "LD SM0.1;ATCH INT0,0;ENI|LD M0.0;= Q0.0@INT0:LD SM0.0;S M0.0,1", "LD SM0.1;ATCH INT0,0;ENI|LD M0.0;= Q0.0@INT0:LD SM0.0;S M0.0,1",
     equal, "the same events in both"},
    {"interrupt_between_scans", "LD SM0.1;ATCH INT0,0;ENI|LD M0.0;= Q0.0|LD SM0.0;R M0.0,1@INT0:LD SM0.0;S M0.0,1",
     "LD SM0.1;ATCH INT0,0;ENI|LD SM0.0;R M0.0,1|LD M0.0;= Q0.0@INT0:LD SM0.0;S M0.0,1", different,
     "only an interrupt between two scans shows in OLD"},
    {"interrupt_routine_longer", "LD SM0.1;ATCH INT0,0;ENI@INT0:LD SM0.0;S Q0.0,1", "LD SM0.1;ATCH INT0,0;ENI@INT0:LD SM0.0;= M9.0;S Q0.0,1", equal,
     "one instruction more that changes no output"},
};

}  // namespace

class HandStated : public testing::TestWithParam<Pair> {};

TEST_P(HandStated, HasTheVerdictThatWasReasonedOut) {
  const Pair& pair = GetParam();
  const ProgramInput before = pairSide("old.awl", exportOf(pair.before), pair.properties);
  const ProgramInput after = pairSide("new.awl", exportOf(pair.after), pair.properties);
  const Side oldSide{&before.program, before.properties}, newSide{&after.program, after.properties};
  const Equivalence found = compareBehaviour(oldSide, newSide, optionsOf(pair, before.program, after.program));
  EXPECT_EQ(equalityText(found.equality), equalityText(pair.truth)) << pair.why;
  EXPECT_EQ(found.run.has_value(), pair.truth == Equality::Different);
  EXPECT_TRUE(found.disagreements.empty());
  for (const std::string& note : found.notes) EXPECT_EQ(note, "") << "a note is only made where nothing is decided";
}

INSTANTIATE_TEST_SUITE_P(Pairs, HandStated, testing::ValuesIn(pairs),
                         [](const testing::TestParamInfo<Pair>& info) { return info.param.name; });

TEST(HandStatedPairs, AreEnoughAndHalfOfThemDiffer) {
  const auto count = [](Equality truth) { return std::ranges::count(pairs, truth, &Pair::truth); };
  EXPECT_GE(pairs.size(), 60U);
  EXPECT_GE(count(different) * 5, static_cast<std::ptrdiff_t>(pairs.size()) * 2);
}

}  // namespace rungproof::test
