// What a command declares of its own: one row for each argument and option, with the variable that takes the value.
// Parsing, help and completion read these rows; CLI11, which does the parsing, is seen by
// frontend/cli/argument_parser.cpp alone. Common options are rows of frontend/settings/options.hpp. Tests:
// tests/golden/help, tests/cli/exit_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/files/failure.hpp"

namespace rungproof {

struct Argument {
  std::string_view names;  ///< "FILE" of an argument, "--props" or "-o,--output" of an option
  std::string_view value;  ///< what stands for the value in the help; empty for flags and arguments
  std::string_view help;
  bool required = false;
  bool repeatable = false;  ///< may be given several times; an argument: takes all that are left
  bool splits = false;      ///< values are separated by commas
  /// Keeps the texts given, or says why they are no values.
  std::function<std::optional<Failure>(const std::vector<std::string>&)> take;

  bool isOption() const { return names.starts_with('-'); }
  /// Programs: where none is given, the configuration may name them (inputs).
  bool isInputs() const { return names == "FILE" && required && repeatable; }
  bool isFlag() const { return isOption() && value.empty(); }
  /// "--output" of "-o,--output".
  std::string_view longName() const { return names.substr(names.rfind(',') + 1); }
};

/// The rows of one command. The variables must live until the values have been taken.
class ArgumentTable {
 public:
  void argument(std::string_view name, std::string& target, std::string_view help);
  /// Takes one or more, with `optional` none as well.
  void arguments(std::string_view name, std::vector<std::string>& target, std::string_view help, bool optional = false);
  void flag(std::string_view names, bool& target, std::string_view help);
  void option(std::string_view names, std::string& target, std::string_view value, std::string_view help);
  void option(std::string_view names, std::vector<std::string>& target, std::string_view value, std::string_view help);
  /// May be repeated, and each value may be a list: 1,2,5.
  void list(std::string_view names, std::vector<std::string>& target, std::string_view value, std::string_view help);
  /// One of the words; `value` names those that the help shows.
  void word(std::string_view names, std::string& target, std::vector<std::string_view> words, std::string_view value,
            std::string_view help);
  /// A whole number from low to high.
  template <class Number>
  void number(std::string_view names, Number& target, std::string_view value, std::string_view help,
              std::int64_t low = 0, std::int64_t high = std::numeric_limits<std::int32_t>::max()) {
    numberInto(
        names, [&target](std::int64_t number) { target = static_cast<Number>(number); }, value, help, low, high);
  }

  const std::vector<Argument>& rows() const { return rows_; }

 private:
  void numberInto(std::string_view names, std::function<void(std::int64_t)> keep, std::string_view value,
                  std::string_view help, std::int64_t low, std::int64_t high);

  std::vector<Argument> rows_;
};

}  // namespace rungproof
