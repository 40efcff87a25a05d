// The symbolic state: big-endian words over bits, guarded writes, cells made at the first touch only.
#include <gtest/gtest.h>

#include "analysis/encoding/symbolic_store.hpp"
#include "tests/encoder/statements.hpp"

namespace rungproof {
namespace {

/// Every cell is a state variable of its own.
class NamedCells final : public CellSource {
 public:
  explicit NamedCells(Graph& graph) : graph_(graph) {}
  Cell cellAt(const Place& place) override {
    ++asked;
    return {place, CellKind::State, graph_.variable(nameOf(place), place.width, true)};
  }
  Node localByte(std::uint32_t entry, std::uint32_t byte) override { return graph_.constantNode(entry * 64 + byte, 8); }

  int asked = 0;

 private:
  Graph& graph_;
};

struct StoreRig {
  explicit StoreRig(std::string_view touched)
      : program(programOf(touched)),
        plan(program),
        layout(plan),
        cells(graph),
        store((layout.add(program, plan), graph), layout, cells, plan) {}
  Program program;
  Plan plan;
  Graph graph;
  MemoryLayout layout;
  NamedCells cells;
  Graph::Store store;
};

TEST(Store, WordsHaveTheirHighByteFirst) {
  // 001:1272-1277: VW0 is VB0 and VB1, VB0 above.
  StoreRig rig("LD SM0.0\nMOVW 0, VW0");
  rig.store.save(Area::V, 0, 16, rig.graph.literal(0x1234, 16), rig.graph.constant(true));
  EXPECT_EQ(rig.graph.known(rig.store.load(Area::V, 0, 8)), 0x12U);
  EXPECT_EQ(rig.graph.known(rig.store.load(Area::V, 8, 8)), 0x34U);
  EXPECT_EQ(rig.graph.known(rig.store.load(Area::V, 8 + 2, 1)), 1U);  // V1.2 of 0011 0100
  EXPECT_EQ(rig.graph.known(rig.store.load(Area::V, 8 + 3, 1)), 0U);
}

TEST(Store, AWordThatWasWrittenReadsAsTheSameNode) {
  StoreRig rig("LD SM0.0\nMOVW VW10, VW20");
  const Graph::Bits word = rig.store.load(Area::V, 80, 16);
  rig.store.save(Area::V, 160, 16, word, rig.graph.constant(true));
  EXPECT_EQ(rig.store.load(Area::V, 160, 16).node, word.node);
}

TEST(Store, GuardedWritesKeepTheOldValueElsewhere) {
  StoreRig rig("LD M0.0\n= M0.1");
  const Graph::Bits old = rig.store.load(Area::M, 1, 1), guard = rig.store.load(Area::M, 0, 1);
  rig.store.save(Area::M, 1, 1, rig.graph.literal(1, 1), {guard.node});
  EXPECT_EQ(rig.store.load(Area::M, 1, 1).node, rig.graph.lor({guard.node}, {old.node}).node);
}

TEST(Store, OnlyWhatIsTouchedBecomesACell) {
  StoreRig rig("LD M0.0\n= M0.1\nMOVW VW0, VW2");
  EXPECT_EQ(rig.cells.asked, 0);
  rig.store.load(Area::M, 0, 1);
  rig.store.load(Area::M, 0, 1);
  EXPECT_EQ(rig.cells.asked, 1);
  rig.store.load(Area::V, 0, 16);
  ASSERT_EQ(rig.store.cells().size(), 2U);
  EXPECT_EQ(nameOf(rig.store.cells()[0].place), "M0.0");
  EXPECT_EQ(nameOf(rig.store.cells()[1].place), "VW0");
}

TEST(Store, HavocLeavesAnyValueWhereTheGuardHolds) {
  StoreRig rig("LD M0.0\n= M0.1");
  const Graph::Bits guard = rig.store.load(Area::M, 0, 1), old = rig.store.load(Area::M, 1, 1);
  const Node any = rig.graph.variable("any", 1, false);
  rig.store.havoc({guard.node}, [&](const Place&) { return any; });
  EXPECT_EQ(rig.store.load(Area::M, 1, 1).node,
            rig.graph.select({guard.node}, Graph::Bool{any}, Graph::Bool{old.node}).node);
}

}  // namespace
}  // namespace rungproof
