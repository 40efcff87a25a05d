// Findings about drawings: rules GRF001 to GRF003 with block, network and element. An error marks the network that
// is being worked on as incomplete. After a thousand findings of one program the rest is only counted.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "frontend/graphical/drawn_model.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

class DrawnSink {
 public:
  explicit DrawnSink(Program& program) : program_(program) {}

  void setPlace(std::string pou, int network) {
    pou_ = std::move(pou);
    network_ = network;
    isDamaged_ = false;
  }
  void setNetwork(int network) {
    network_ = network;
    isDamaged_ = false;
  }
  const std::string& pou() const { return pou_; }
  bool isDamaged() const { return isDamaged_; }

  /// GRF001: the circuit is not well formed.
  void circuit(const DrawnElement& element, const std::string& message);
  /// GRF001 as a warning: drawn, but without effect.
  void idle(const DrawnElement& element, const std::string& message);
  /// GRF002: an operand is missing, unknown, or of the wrong type.
  void operand(const DrawnElement& element, const std::string& message);
  /// GRF003: a negation or edge sign on a pin that is not Boolean.
  void negation(const DrawnElement& element, const std::string& message);
  void report(Syntax code, Span span, const std::string& message);

  /// Findings about elements whose network is not numbered yet.
  struct Pending {
    std::size_t finding;  ///< index in Program::findings
    const DrawnElement* element;
  };
  /// Hands them over, to be given their numbers.
  std::vector<Pending> takePending() { return std::move(pending_); }

 private:
  void add(std::string_view rule, Severity severity, const DrawnElement& element, const std::string& message,
           std::string_view help);

  static constexpr std::size_t limit = 1000;
  Program& program_;
  std::string pou_;
  int network_ = 0;
  bool isDamaged_ = false;
  std::size_t count_ = 0;
  std::vector<Pending> pending_;
};

/// "contact Start (element 12)".
std::string nameOf(const DrawnElement& element);

}  // namespace rungproof
