// check(): one example of the manual as three short texts.
#pragma once

#include "plant.hpp"

namespace rungproof::manual {

/// Settings of the open points for one example: "increment-overflow=keeps".
struct Example {
  std::string statements;
  std::string given;
  std::string expected;
  std::string hazards{};  ///< codes, separated by blanks
  std::string choices{};
  Target target{};
};

/// Runs `statements` with power flow from `given` and demands exactly `expected`: every byte, register and status bit
/// that is not named must stay as it was. Each example runs with SM1 and ENO all 0 and all 1 before. "SM1.0=?" means a
/// value that the manual leaves open. ENO must be 1 after boxes without errors and 0 after a hazard.
inline void check(const Example& e) {
  SCOPED_TRACE(e.statements + " | " + e.given);
  for (const bool before : {false, true}) {
    SCOPED_TRACE(before ? "status bits 1 before" : "status bits 0 before");
    Plant plant("LD SM0.0; " + e.statements, e.target);
    for (const std::string& choice : split(e.choices, ' ')) {
      const std::size_t equal = choice.find('=');
      EXPECT_TRUE(plant.choices.set(choice.substr(0, equal), choice.substr(equal + 1))) << choice;
    }
    plant.set(before ? "SMB1=255 ENO[0]=1" : "SMB1=0 ENO[0]=0");
    plant.set(e.given);
    plant.outside.unknownStatus = before ? 0 : 1;
    Plant wanted("LD SM0.0");
    wanted.store = plant.store;
    setReadings(wanted.store, plant.choices);
    bool hasEno = false;
    for (const Instruction& instruction : plant.program().pous[0].networks[0].instructions)
      hasEno = hasEno || instruction.desc->eno;
    if (hasEno) wanted.set(e.hazards.empty() ? "ENO[0]=1" : "ENO[0]=0");
    for (const std::string& pair : split(e.expected, ' ')) {
      const std::size_t equal = pair.find('=');
      const std::string name = pair.substr(0, equal), value = pair.substr(equal + 1);
      wanted.set(name, value == "?" ? plant.outside.unknownStatus : numberOf(value));
    }
    plant.scan();
    std::string hazards;
    for (const Hazard hazard : plant.outside.hazards()) {
      hazards += (hazards.empty() ? "" : " ") + std::string(hazardInfo(hazard).code);
      if (hazardInfo(hazard).kind == HazardClass::NonFatal) wanted.set("SM4.3", 1);
    }
    EXPECT_EQ(hazards, e.hazards);
    for (const std::string& pair : split(e.expected, ' ')) {
      const std::string name = pair.substr(0, pair.find('='));
      EXPECT_EQ(plant.value(name), wanted.value(name)) << name;
    }
    EXPECT_EQ(plant.value("ENO[0]"), wanted.value("ENO[0]")) << "ENO";
    EXPECT_EQ(plant.value("SMB1"), wanted.value("SMB1")) << "status bits";
    EXPECT_TRUE(plant.store == wanted.store) << "something not named in the example changed";
  }
}
inline void check(std::initializer_list<Example> examples) {
  for (const Example& example : examples) check(example);
}

}  // namespace rungproof::manual
