// The plant.
#include "tests/s7project/plant.hpp"

#include <algorithm>

namespace rungproof::test {

std::string plantSource() {
  return R"(TYPE UDT 1
STRUCT
  Speed : INT := 100 ;
  Run : BOOL ;
END_STRUCT ;
END_TYPE
TYPE UDT 2
STRUCT
  Level : REAL ;
END_STRUCT ;
END_TYPE
DATA_BLOCK DB 10
TITLE = Recipe
STRUCT
  Count : INT := 7 ;
  List : ARRAY [1 .. 4 ] OF WORD ;
  Motor : UDT 1 ;
  On : BOOL ;
END_STRUCT ;
BEGIN
  Count := 12 ;
  List[2] := W#16#1234 ;
END_DATA_BLOCK
DATA_BLOCK DB 11
STRUCT
  A : DINT ;
  B : REAL := 1.5 ;
END_STRUCT ;
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 12
STRUCT
  T : TIME := T#2S ;
END_STRUCT ;
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 13
STRUCT
  C : CHAR := 'x' ;
  D : DATE := D#2000-1-2 ;
END_STRUCT ;
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 21
FB 21
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 22
FB 22
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 23
FB 23
BEGIN
END_DATA_BLOCK
FUNCTION FC 1 : VOID
VAR_INPUT
  Start : BOOL ;
  Stop : BOOL ;
END_VAR
VAR_IN_OUT
  Motor : BOOL ;
END_VAR
BEGIN
NETWORK
TITLE = Self holding
      A(    ;
      O     #Start;
      O     #Motor;
      )     ;
      AN    #Stop;
      =     #Motor;
END_FUNCTION
FUNCTION FC 2 : VOID
VAR_INPUT
  Value : INT ;
  Limit : INT ;
END_VAR
VAR_OUTPUT
  Result : INT ;
END_VAR
VAR_TEMP
  Work : INT ;
END_VAR
BEGIN
NETWORK
TITLE = Limit
      L     #Value;
      T     #Work;
      L     #Limit;
      <=I   ;
      JC    ok;
      L     #Limit;
      T     #Work;
ok:   L     #Work;
      T     #Result;
END_FUNCTION
FUNCTION FC 3 : VOID
BEGIN
NETWORK
TITLE = Secret of the house
      A     M 77.3;
      =     M 77.4;
NETWORK
      L     4711;
      T     MW 78;
END_FUNCTION
FUNCTION FC 4 : VOID
BEGIN
NETWORK
      L     MB 90;
      JL    def;
      JU    one;
      JU    two;
def:  SET   ;
      =     M 91.0;
      BEU   ;
one:  SET   ;
      =     M 91.1;
      BEU   ;
two:  SET   ;
      =     M 91.2;
END_FUNCTION
FUNCTION FC 5 : VOID
BEGIN
NETWORK
      A     DB10.DBX 14.0;
      =     M 92.0;
END_FUNCTION
FUNCTION FC 6 : VOID
BEGIN
NETWORK
      NOP   0;
END_FUNCTION
FUNCTION_BLOCK FB 21
VAR_INPUT
  In : BOOL ;
END_VAR
VAR_OUTPUT
  Out : BOOL ;
END_VAR
VAR
  Count : INT ;
END_VAR
BEGIN
NETWORK
      A     #In;
      =     #Out;
      L     #Count;
      +     1;
      T     #Count;
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB 22
VAR
  Flag : BOOL ;
END_VAR
BEGIN
NETWORK
      A     #Flag;
      =     M 93.0;
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB 23
VAR
  Word : WORD ;
END_VAR
BEGIN
NETWORK
      L     #Word;
      T     MW 94;
END_FUNCTION_BLOCK
ORGANIZATION_BLOCK OB 100
BEGIN
NETWORK
TITLE = Start
      SET   ;
      R     Q 0.0;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
TITLE = Main
BEGIN
NETWORK
TITLE = Motor
      CALL  FC 1 (Start := I 0.0, Stop := I 0.1, Motor := Q 0.0);
NETWORK
TITLE = Limit
      CALL  FC 2 (Value := MW 10, Limit := DB10.DBW 0, Result := MW 12);
      CALL  FC 3;
      CALL  FC 4;
NETWORK
TITLE = Blocks
      CALL  FB 21 , DB 21 (In := I 0.2, Out := Q 0.2);
      CALL  FC 5;
END_ORGANIZATION_BLOCK
)";
}

ProjectPart plantPart() {
  ProjectPart part;
  const CompiledSource compiled = compileSource(plantSource());
  part.blocks = compiled.blocks;
  for (mc7::StoredBlock& block : part.blocks) {
    if (block.key == step7::BlockKey{step7::BlockKind::Fc, 3}) block.isProtected = true;
  }
  part.deleted = oldVersions(part.blocks);
  part.symbols = {{"Start", "I       0.0", "BOOL", "button"}, {"Motor", "Q       0.0", "BOOL", ""}};
  part.cpu = "CPU 315-2 DP";
  part.orderNumber = "6ES7 315-2AG10-0AB0";
  return part;
}

std::vector<mc7::StoredBlock> oldVersions(const std::vector<mc7::StoredBlock>& blocks) {
  std::vector<mc7::StoredBlock> old;
  for (int i = 0; i < 3; ++i) {
    for (mc7::StoredBlock block : blocks) {
      if (block.isCode()) {
        block.code = std::string("\x68\x1D\xDF\x80\x65\x00", 6);  // SET; = Q 0.7; BE
        block.table = std::string("\1\0\4\0\0\0", 6);
        block.checksum = mc7::checksumOf(block.key.kind, block.code);
      }
      old.push_back(std::move(block));
    }
  }
  return old;
}

std::string writeFiles(const TemporaryFolder& folder, const std::map<std::string, std::string>& files) {
  std::string project;
  for (const auto& [path, contents] : files) {
    const std::string written = folder.file("Plant/" + path, contents);
    if (path.ends_with(".s7p")) project = written;
  }
  return project;
}

}  // namespace rungproof::test
