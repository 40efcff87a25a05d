// The head of a certificate file says what was proved of which program and how to check it.
#include <gtest/gtest.h>

#include "frontend/cli/cli.hpp"
#include "frontend/explain/certificate_head.hpp"
#include "frontend/files/sha256.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

/// Examples of FIPS 180-4, and lengths around the end of a block.
TEST(Sha256, KnownDigests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(CertificateFile, HeadNamesProgramPropertyAssumptionsAndTheCommand) {
  const TemporaryFolder folder;
  const std::string text = "//@ assume quiet: not I0.7\n//@ prove lamp follows: Q0.0 implies I0.0\n" +
                           mainBlock("Network 1\nLD I0.0\n= Q0.0\n");
  const std::string program = folder.file("p.awl", text);
  ASSERT_EQ(run({"prove", "--isolated", program, "--certificate", folder.path("out")}).exit, 0);
  const std::string file = contentOf(folder.path("out/lamp_follows.smt2"));
  for (const std::string& line :
       {"; rungproof: " + std::string(programVersion()) + ", certificate of a proof in SMT-LIB 2\n",
        std::string("; check: cvc5 --incremental lamp_follows.smt2\n"),
        std::string("; holds if: every answer is unsat\n"), std::string("; property: lamp follows: "),
        "; program: " + program + ", SHA-256 " + sha256(text) + "\n", std::string("; assumes: CPU 226"),
        std::string("; assumes: every scan lasts"), std::string("; assumes: assume quiet: not I0.7")}) {
    EXPECT_NE(file.find(line), std::string::npos) << line << file.substr(0, 900);
  }
  EXPECT_TRUE(file.starts_with("; ")) << "the head comes first";
  EXPECT_NE(file.find("(declare-fun |I0.0"), std::string::npos) << "the program is in it";
}

}  // namespace
}  // namespace rungproof::test
