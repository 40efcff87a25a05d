// Instances of timers, counters and blocks in exports of TIA Portal: data named TON_TIME or IEC_TIMER, and data blocks
// that the export lacks.
#include <gtest/gtest.h>

#include "tests/step7/flgnet_text.hpp"
#include "tests/step7/read7.hpp"
#include "tests/step7/run7.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

using test7::DrawnNet, test7::drawnBlock, test7::drawnDocument, test7::instanceText, test7::member, test7::section,
    test7::unit;

/// I0.0 starts the part with T#1s or 3, its Q goes to Q0.0.
std::string timed(const std::string& part, const std::string& instance, const std::string& input = "IN") {
  DrawnNet net;
  const int contact = net.part("Contact");
  const int box = net.part(part, instanceText(instance) + (input == "IN" ? test7::typed("time_type", "Time")
                                                                         : test7::typed("value_type", "Int")));
  net.rail({{contact, "in"}});
  net.in("I0.0", contact, "operand");
  net.flow({contact, "out"}, {{box, input}});
  if (input == "IN")
    net.in("T#1S:Time", box, "PT");
  else
    net.in("3:Int", box, "PV");
  net.out(box, "Q", "Q0.0");
  return unit(net.text(), "LAD");
}
std::string instanceDb(const std::string& name, const std::string& of) {
  return drawnBlock("InstanceDB", name, 12, "", "", "<InstanceOfName>" + of + "</InstanceOfName>");
}
std::string main(const std::string& units, const std::string& sections = "") {
  return drawnBlock("OB", "Main", 1, sections, units);
}

/// Whether Q0.0 follows I0.0 after a second less a scan, in which the time of a timer may pass early, and what the
/// verdict assumes.
test7::Output proofOfDelay(const std::string& blocks) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("t.xml", drawnDocument(blocks));
  const std::string properties = folder.file(
      "p.prop", "prove late: Q0.0 implies held(I0.0, 900ms)\nprove once: held(I0.0, 1500ms) implies Q0.0\n");
  return test7::run({"prove", file, "--props", properties, "--scan-time", "10ms..100ms"});
}

TEST(TiaInstance, DataOfATimerByEachName) {
  for (const std::string of : {"TON_TIME", "TON", "IEC_TIMER", "ton_time"}) {
    const test7::Output proof = proofOfDelay(main(timed("TON", "\"Wait\"")) + instanceDb("Wait", of));
    EXPECT_TRUE(proof.has("PROVED  late") && proof.has("PROVED  once")) << of << '\n' << proof.text;
    EXPECT_FALSE(proof.has("which no file holds")) << of << '\n' << proof.text;
  }
}

TEST(TiaInstance, InsideAnInstance) {
  for (const std::string type : {"TON_TIME", "IEC_TIMER"}) {
    const std::string block =
        drawnBlock("FB", "Late", 5, section("Static", member("wait", type)), timed("TON", "#wait"));
    DrawnNet call;
    call.call("<CallInfo Name=\"Late\" BlockType=\"FB\">" + instanceText("\"Late_DB\"") + "</CallInfo>");
    const test7::Output proof =
        proofOfDelay(main(unit(call.text(), "LAD")) + block +
                     drawnBlock("InstanceDB", "Late_DB", 13, "", "", "<InstanceOfName>Late</InstanceOfName>"));
    EXPECT_TRUE(proof.has("PROVED  late") && proof.has("PROVED  once")) << type << '\n' << proof.text;
  }
}

// An instance inside of a global data block, as an S7-1500 may have it, is refused and leaves its network open.
TEST(TiaInstance, InsideGlobalDataIsRefused) {
  const std::string global = drawnBlock("GlobalDB", "Waits", 14, section("Static", member("one", "TON_TIME")), "");
  const test7::Output proof = proofOfDelay(main(timed("TON", "\"Waits.one\"")) + global);
  EXPECT_TRUE(proof.has("an instance is a data block") && proof.has("NOT COVERED  late")) << proof.text;
}

// The export has the blocks and not the data. The verdict says what was taken for it.
TEST(TiaInstance, DataThatNoFileHolds) {
  const test7::Output proof = proofOfDelay(main(timed("TON", "\"Wait\"")));
  EXPECT_TRUE(proof.has("PROVED  late") && proof.has("PROVED  once")) << proof.text;
  EXPECT_TRUE(proof.has("the instance \"Wait\", which no file holds, begins with the start values of its block"))
      << proof.text;
  // The same name for a timer and for a pulse: one of the calls works on data of another block.
  const test7::Output both = proofOfDelay(main(timed("TON", "\"Wait\"") + timed("TP", "\"Wait\"")));
  EXPECT_FALSE(both.has("PROVED")) << both.text;
  // A name that a tag has stays what it is.
  const std::string tags =
      "<SW.Tags.PlcTagTable ID=\"0\"><ObjectList><SW.Tags.PlcTag ID=\"1\"><AttributeList><DataTypeName>Bool"
      "</DataTypeName><LogicalAddress>%I0.7</LogicalAddress><Name>Wait</Name></AttributeList></SW.Tags.PlcTag>"
      "</ObjectList></SW.Tags.PlcTagTable>";
  const test7::Output tagged = proofOfDelay(main(timed("TON", "\"Wait\"")) + tags);
  EXPECT_FALSE(tagged.has("PROVED")) << tagged.text;
}

// Three edges reach the preset of a counter.
TEST(TiaInstance, Counters) {
  for (const std::string of : {"CTU_INT", "IEC_COUNTER"}) {
    const test::TemporaryFolder folder;
    const std::string file =
        folder.file("c.xml", drawnDocument(main(timed("CTU", "\"Parts\"", "CU")) + instanceDb("Parts", of)));
    const std::string stimulus = folder.file("s.csv", "scan,I0.0\n1,1\n2,0\n3,1\n4,0\n5,1\n6,0\n");
    const test7::Output run =
        test7::run({"sim", file, "--stimulus", stimulus, "--signals", "Q0.0", "--trace", "-", "--scans", "6"});
    EXPECT_TRUE(run.has("4,40,10,0\n")) << of << run.text;
    EXPECT_TRUE(run.has("5,50,10,1\n")) << of << run.text;
  }
  const test7::Output wide = proofOfDelay(main(timed("CTU", "\"Parts\"", "CU")) + instanceDb("Parts", "CTU_DINT"));
  EXPECT_TRUE(wide.has("CTU_DINT")) << wide.text;
}

}  // namespace
}  // namespace rungproof
