// GET001: tables of GET and PUT, byte by byte.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "lint.hpp"

namespace rungproof::testing {
namespace {

constexpr Target requestTarget{s7200Cpu("ST40"), Edition::Smart28};

/// A table at VB780 that is right, for a GET of 20 bytes into VB200.
std::string requestTable(const std::string& length = "20", const std::string& local = "&VB200",
                         const std::string& remote = "&VB100") {
  return "Network 1\nLD SM0.1\nMOVB 192, VB781\nMOVB 168, VB782\nMOVB 2, VB783\nMOVB 10, VB784\nMOVW 0, VW785\nMOVD " +
         remote + ", VD787\nMOVB " + length + ", VB791\nMOVD " + local + ", VD792\n";
}
const std::string get = "Network 2\nLD I0.0\nEU\nGET VB780\n", put = "Network 2\nLD I0.0\nEU\nPUT VB780\n";

std::string requestMessages(const std::string& text) {
  std::string result;
  for (const std::string& message : Linted(text, requestTarget).messages("GET001"))
    result += (result.empty() ? "" : "\n") + message;
  return result;
}

TEST(Get001, FindsWrongTables) {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {requestTable("223") + get, "GET VB780 is to read 223 bytes; it can be 1 to 222"},
           {requestTable("213") + put, "PUT VB780 is to write 213 bytes; it can be 1 to 212"},
           {requestTable("0") + get, "GET VB780 is to read 0 bytes; it can be 1 to 222"},
           {requestTable() + "MOVB 1, VB785\n" + get, "byte 5 of the table of GET VB780 must be 0 and gets 1"},
           {requestTable("20", "&SMB200") + get, "the place for the data of GET VB780 must lie in I, Q, M or V"},
           {requestTable("20", "&VB200", "&AIW0") + get,
            "the data of the partner of GET VB780 must lie in I, Q, M or V"},
           {requestTable("20", "16#05000064") + get, "the place for the data of GET VB780 must lie in I, Q, M or V"},
           {get, "nothing fills the table of GET VB780"},
           {"Network 1\nLD SM0.1\nMOVB 192, VB781\nMOVD &VB100, VD787\nMOVD &VB200, VD792\n" + get,
            "nothing writes the length of GET VB780"},
           {"Network 1\nLD SM0.1\nMOVB 192, VB781\nMOVD &VB100, VD787\nMOVB 20, VB791\n" + get,
            "nothing writes the pointer to the own data of GET VB780"},
           {"Network 1\nLD SM0.1\nMOVB 20, VB791\nMOVD &VB100, VD787\nMOVD &VB200, VD792\n" + get,
            "nothing writes the partner's address of GET VB780"},
           {requestTable("20", "&VB20470") + get,
            "the data of GET VB780, VB20470 to VB20489, reach beyond the end of V memory"},
           {requestTable("20", "&VB770") + get,
            "the data that GET VB780 reads, VB770 to VB789, fall into the table of GET VB780"},
           {requestTable() + get + "MOVW AIW16, VW210\n",
            "MOVW AIW16, VW210 writes VW210 into the data that GET VB780 reads"},
           {requestTable() + get + "MOVW AIW16, VW795\n",
            "VW795 in MOVW AIW16, VW795 reaches into the table of GET VB780"}})
    EXPECT_EQ(requestMessages(text), message) << text;
  // ST40 with firmware V2.8 has VB0 to VB20479: the table would end at VB20480.
  EXPECT_EQ(requestMessages("Network 1\nLD SM0.1\nFILL 0, VW20464, 8\nNetwork 2\nLD I0.0\nEU\nGET VB20465\n"),
            "the table of GET VB20465 has 16 bytes and reaches beyond the end of V memory");
}

TEST(Get001, FindsRequestsThatDisturbEachOther) {
  const std::string second =
      "MOVB 192, VB801\nMOVD &VB100, VD807\nMOVB 4, VB811\nMOVD &VB216, VD812\nNetwork 3\nLD I0.1\nEU\nGET VB800\n";
  EXPECT_EQ(requestMessages(requestTable() + second + get),
            "the data that GET VB780 reads, VB200 to VB219, overlap those of GET VB800");
  EXPECT_NE(requestMessages(requestTable() + get + "Network 3\nLD I0.1\nEU\nGET VB790\n")
                .find("the tables of GET VB780 and GET VB790 overlap"),
            std::string::npos);
}

TEST(Get001, RightTablesAreSilent) {
  for (const std::string& text :
       {requestTable() + get, requestTable("222") + get, requestTable("212") + put, requestTable("20", "&MB0") + get,
        requestTable("20", "&QB0") + put, requestTable("20", "16#080000C8") + get,  // &VB200 as a number
        requestTable("VB5") + get,                                                  // a length that is calculated
        requestTable() + get + "MOVW VW210, VW0\n",                                 // the data are used
        requestTable() + get + "Network 3\nLD SM0.1\nFILL 0, VW200, 10\n",          // and cleared before
        requestTable() + put + "MOVW AIW16, VW210\n",                               // what is sent is written
        requestTable() + get + "Network 3\nLD V780.7\n= Q0.0\nNetwork 4\nLDB= VB780, 16#80\n= Q0.1\n",
        requestTable() + "BMB VB0, VB785, 2\n" + get})
    EXPECT_EQ(requestMessages(text), "") << text;
  // The data block fills the table.
  EXPECT_EQ(requestMessages("DATA_BLOCK DB1\nBEGIN\nVB780 0\nVB781 192,168,2,10,0,0\nVD787 16#08000064\nVB791 20\n"
                            "VD792 16#080000C8\nEND_DATA_BLOCK\nORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" +
                            get + "END_ORGANIZATION_BLOCK\n"),
            "");
  EXPECT_EQ(requestMessages("//@ external VB780..VB795\n" + get), "") << "a panel may fill it";
}

}  // namespace
}  // namespace rungproof::testing
