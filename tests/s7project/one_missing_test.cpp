// One thing that a project lacks does not switch the tool off: the double coil of Q 0.0 is still found, what does not
// depend on what is missing is proved and violated as ever, the program is shown, and it runs where what runs is whole.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using step7::BlockKey;
using step7::BlockKind;
using test::TemporaryFolder;

const char* const base =
    "TYPE UDT 7\nSTRUCT\n a : INT ;\nEND_STRUCT ;\nEND_TYPE\n"
    "DATA_BLOCK DB 5\nSTRUCT\n x : INT := 3 ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n"
    "FUNCTION_BLOCK FB 6\nVAR_INPUT\n go : BOOL ;\nEND_VAR\nVAR\n n : INT ;\nEND_VAR\nBEGIN\nNETWORK\n A #go;\n = Q "
    "2.0;\n"
    "END_FUNCTION_BLOCK\nDATA_BLOCK DB 6\nFB 6\nBEGIN\nEND_DATA_BLOCK\n"
    "FUNCTION FC 9 : VOID\nBEGIN\nNETWORK\n A I 1.0;\n JC out;\n SET;\n = Q 3.0;\nout: NOP 0;\nEND_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nTITLE = First\n A I 0.0;\n = Q 0.0;\nNETWORK\n A I 0.1;\n = Q 0.0;\n"
    "NETWORK\n A I 0.2;\n = Q 0.1;\nEND_ORGANIZATION_BLOCK\n";

struct OneLost {
  std::string name;
  void (*change)(test::ProjectPart& part, std::map<std::string, std::string>* files);  ///< blocks first, then files
};

mc7::StoredBlock& lostIn(test::ProjectPart& part, BlockKey key) {
  return *std::ranges::find(part.blocks, key, &mc7::StoredBlock::key);
}
void loseBlock(test::ProjectPart& part, BlockKey key) {
  std::erase_if(part.blocks, [&](const mc7::StoredBlock& block) { return block.key == key; });
}
void loseFiles(std::map<std::string, std::string>& files, std::string_view part) {
  std::erase_if(files, [&](const auto& file) { return file.first.find(part) != std::string::npos; });
}

const OneLost losses[] = {
    {"a type",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) loseBlock(part, {BlockKind::Udt, 7});
     }},
    {"the FB of an instance",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) loseBlock(part, {BlockKind::Fb, 6});
     }},
    {"a data block",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) loseBlock(part, {BlockKind::Db, 5});
     }},
    {"the code of a block",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) lostIn(part, {BlockKind::Fc, 9}).code = "\x6B\xFF";
     }},
    {"the checksum of a block",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) lostIn(part, {BlockKind::Fc, 9}).checksum = 1;
     }},
    {"the networks of a block",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) lostIn(part, {BlockKind::Fc, 9}).table = "\x05";
     }},
    {"the names of a block",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) lostIn(part, {BlockKind::Fb, 6}).declarationText.reset();
     }},
    {"the labels of a block",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) lostIn(part, {BlockKind::Fc, 9}).labels.clear();
     }},
    {"the declaration of a block",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) lostIn(part, {BlockKind::Fc, 9}).declaration = "\x7F";
     }},
    {"the values of a data block",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) lostIn(part, {BlockKind::Db, 5}).code.clear();
     }},
    {"the titles",
     [](test::ProjectPart& part, auto* files) {
       if (files == nullptr) lostIn(part, {BlockKind::Ob, 1}).networkTexts.clear();
     }},
    {"the symbols",
     [](test::ProjectPart&, auto* files) {
       if (files != nullptr) loseFiles(*files, "YDBS");
     }},
    {"the code page",
     [](test::ProjectPart&, auto* files) {
       if (files != nullptr) loseFiles(*files, "global");
     }},
    {"the hardware",
     [](test::ProjectPart&, auto* files) {
       if (files != nullptr) loseFiles(*files, "hOmSave7");
     }},
    {"the parameters of the CPU",
     [](test::ProjectPart&, auto* files) {
       if (files != nullptr) loseFiles(*files, "HATTRME1");
     }},
    {"the order number",
     [](test::ProjectPart&, auto* files) {
       if (files != nullptr) loseFiles(*files, ".s7h");
     }},
};

TEST(S7OneMissing, TheRestIsFoundProvedShownAndRun) {
  for (const OneLost& loss : losses) {
    test::ProjectPart part = test::plantPart();
    part.blocks = test::compileSource(base).blocks;
    loss.change(part, nullptr);
    std::map<std::string, std::string> files = test::writeProject({part}, 1252);
    loss.change(part, &files);
    const TemporaryFolder folder;
    const std::string project = writeFiles(folder, files);
    const test::ProgramRun lint = test::run({"lint", "--isolated", project});
    EXPECT_TRUE(lint.says("is driven by 2 coils")) << loss.name << lint.out << lint.err;
    const std::string properties = folder.file("p.prop", "prove same: Q0.1 = I0.2\nprove never: never Q0.1\n");
    const test::ProgramRun proof = test::run({"prove", "--isolated", "--props", properties, project});
    EXPECT_TRUE(proof.says("PROVED  same")) << loss.name << proof.out << proof.err;
    EXPECT_TRUE(proof.says("VIOLATED  never")) << loss.name << proof.out;
    const test::ProgramRun sim = test::run({"sim", "--isolated", "--scans", "2", project});
    EXPECT_TRUE(sim.says("scan,time_ms")) << loss.name << sim.out << sim.err;
    const test::ProgramRun show = test::run({"show", "--isolated", "--pou", "OB1", "--no-findings", project});
    EXPECT_TRUE(show.says("Network 3")) << loss.name << show.out << show.err;
  }
}

}  // namespace
}  // namespace rungproof
