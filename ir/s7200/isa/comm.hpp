// Communication: XMT, RCV in Freeport mode, NETR, NETW as PPI master, GPA, SPA (001:3022-3360). The
// instructions check and start; what arrives and when a request ends come from outside. Port 0 is set by SMB30 and
// SMB86 to SMB94, port 1 by SMB130 and SMB186 to SMB194. Tests: tests/manual/comm_test.cpp.
#pragma once

#include "ir/s7200/device_end.hpp"
#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

constexpr OperandDesc portOperand() {
  constexpr CpuSet two = cpusWith([](const CpuRow& row) { return row.features.ports == 2; });
  return in("PORT", Type::Byte, form::Const).within({{0, 0, everyCpu & ~two}, {0, 1, two}});  // 001:3041
}
constexpr Desc commDesc(Role role, std::string_view stl, std::string_view box, std::string_view meaning,
                        OperandDesc first, std::uint32_t time, std::string_view manual) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = "communication",
                       .role = role,
                       .drawn = box,
                       .stack = {1, 0, 0},
                       .eno = true,
                       .time = time,
                       .manual = manual},
                      {first, portOperand()});
}

/// The port of operand 1, or nothing with error 0091 when the CPU lacks it.
template <class D>
std::optional<std::uint32_t> portOf(Machine<D>& m, const Args<D>& a) {
  const std::uint32_t port = a.number(1);
  const bool exists = static_cast<int>(port) < cpuFeatures(m.target).ports;
  m.hazard(Hazard::OutOfRange, m.d.constant(!exists));
  return exists ? std::optional(port) : std::nullopt;
}

/// Mode of a port, bits 1-0 of its control byte: 1 Freeport, 2 PPI master, else PPI slave (001:14176).
inline constexpr std::uint64_t freeport = 1, ppiMaster = 2;
template <class D>
typename D::Bool portIs(Machine<D>& m, std::uint32_t port, std::uint64_t mode) {
  const auto control = m.load(Area::SM, port == 0 ? 30 : 130, Width::Byte);
  return m.d.equal(m.d.extract(control, 1, 0), m.number(mode, 2), 2);
}

/// Address of operand i in pointer form; `unknownAddress` if it could not be found.
inline constexpr std::uint32_t unknownAddress = 0xFFFFFFFF;
template <class D>
typename D::Bits addressOf(Machine<D>& m, Args<D>& a, std::size_t i) {
  auto address = m.number(unknownAddress, 32);
  a.eachPlace(i, [&](typename D::Bool here, Area area, std::uint32_t offset) {
    address = m.d.select(here, m.number(pointer::encode(area, offset), 32), address, 32);
  });
  return address;
}

inline constexpr int sending = 0, receiving = 1;                     ///< bits of Reg::PortBusy
inline constexpr Forms messageBuffer = form::byteBuffer & ~form::L;  // 001:3153

/// The common gate of XMT and RCV: Freeport mode, the other direction idle; `busy` itself by Choice::PortAgain.
template <class D>
typename D::Bool mayUsePort(Machine<D>& m, std::uint32_t port, int direction) {
  D& d = m.d;
  const auto state = m.get(Reg::PortBusy, port);
  const auto clash = port == 0 ? Hazard::SimultaneousPort0 : Hazard::SimultaneousPort1;
  const auto isFree = portIs(m, port, freeport);
  m.hazard(Hazard::PortMode, d.lnot(isFree));
  m.hazard(clash, d.land(isFree, d.bit(state, 1 - direction)));
  m.hazard(clash, d.land(m.reads({Choice::PortAgain, "error"}), d.land(isFree, d.bit(state, direction))));
  return d.land(isFree, d.lnot(d.bit(state, 1 - direction)));
}
template <class D>
void setPortBusy(Machine<D>& m, std::uint32_t port, std::uint64_t state) {
  m.set(Reg::PortBusy, port, m.number(state, 2));
}

/// XMT TBL, PORT: byte 0 is the number of characters behind it, 0 a break (001:3194). SM4.5 or SM4.6 is 0 until the
/// transmission has ended.
struct Transmit {
  static constexpr Desc desc = commDesc(Role::Xmt, "XMT", {}, "transmit in freeport mode",
                                        in("TBL", Type::Byte, messageBuffer).elements(1, 256), 4200, "001:3153");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto port = portOf(m, a);
    if (!port) return;
    const auto open = d.land(mayUsePort(m, *port, sending), d.lnot(d.bit(m.get(Reg::PortBusy, *port), sending)));
    const auto fits = a.fits(0, d.add(d.zext(a.value(0), 8, 16), m.number(1, 16), 16), Width::Byte);
    m.hazard(Hazard::OutOfRange, d.land(open, d.lnot(fits)));
    m.when(d.land(open, fits), [&] {
      setPortBusy(m, *port, 1U << sending);
      m.set(Reg::PortTable, *port * 2, addressOf(m, a, 0));
      m.setSm(4, *port == 0 ? 5 : 6, d.constant(false));
      m.signal(Signal::TransmitStarted, *port);
    });
  }
};

/// RCV TBL, PORT: with the enable bit off it ends a running reception (n = 1, 001:3217); otherwise it checks the start
/// and end conditions (r = 1 and ENO 0 if one is missing) and starts; SMB86 or SMB186 is 0 while it runs (001:3207).
struct Receive {
  static constexpr Desc desc = commDesc(Role::Rcv, "RCV", {}, "receive a message in freeport mode",
                                        out("TBL", Type::Byte, messageBuffer).elements(1, 256), 5100, "001:3153");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto port = portOf(m, a);
    if (!port) return;
    const std::uint32_t status = *port == 0 ? 86 : 186;
    const std::uint32_t control = status + 1, maximum = status + 8;
    const auto runs = d.bit(m.get(Reg::PortBusy, *port), receiving);
    const auto usable = mayUsePort(m, *port, receiving), enabled = m.sm(control, 7);
    m.when(d.land(usable, d.land(d.lnot(enabled), runs)), [&] {
      setPortBusy(m, *port, 0);
      m.save(Area::SM, status, Width::Byte, m.number(0x80, 8));
      m.signal(Signal::ReceiveEnded, *port);
    });
    m.when(d.land(usable, d.land(enabled, d.lnot(runs))), [&] {
      const auto count = m.load(Area::SM, maximum, Width::Byte);
      const auto starts = d.lor(m.sm(control, 6), d.lor(m.sm(control, 4), m.sm(control, 1)));
      const auto bad = d.lor(d.lnot(starts), d.equal(count, m.number(0, 8), 8));
      const auto fits = a.fits(0, d.add(d.zext(count, 8, 16), m.number(1, 16), 16), Width::Byte);
      m.hazard(Hazard::PortParameter, bad);
      m.when(bad, [&] { m.save(Area::SM, status, Width::Byte, m.number(0x40, 8)); });
      m.hazard(Hazard::OutOfRange, d.land(d.lnot(bad), d.lnot(fits)));
      m.when(d.land(d.lnot(bad), fits), [&] {
        setPortBusy(m, *port, 1U << receiving);
        m.set(Reg::PortTable, *port * 2 + 1, addressOf(m, a, 0));
        m.set(Reg::PortLimit, *port, count);
        m.save(Area::SM, status, Width::Byte, m.number(0, 8));
        m.signal(Signal::ReceiveStarted, *port);
      });
    });
  }
};

/// A request over a network takes the first free entry of the queue. `length`: data bytes, 8 bits; `buffer`: see
/// Reg::NetBuffer, nothing on CPUs without.
template <class D>
void enterRequest(Machine<D>& m, typename D::Bits address, typename D::Bits length, bool isWrite,
                  const std::optional<typename D::Bits>& buffer = {}) {
  constexpr int width = regInfo(Reg::NetActive).width;
  m.set(Reg::NetActive, 0, m.d.add(m.get(Reg::NetActive), m.number(1, width), width));
  auto placed = m.d.constant(false);
  for (std::uint32_t i = 0; i < networkRequests(m.target); ++i) {
    const auto here = m.d.land(m.d.lnot(placed), m.d.equal(m.get(Reg::NetTable, i), m.number(0, 32), 32));
    placed = m.d.lor(placed, here);
    m.when(here, [&] {
      m.set(Reg::NetTable, i, address);
      m.setBit(Reg::NetIsWrite, i, m.d.constant(isWrite));
      m.set(Reg::NetLength, i, length);
      if (buffer) m.set(Reg::NetBuffer, i, *buffer);
      m.signal(Signal::NetworkStarted, i);
    });
  }
}
/// Whether the queue has no entry left.
template <class D>
typename D::Bool isQueueFull(Machine<D>& m) {
  constexpr int width = regInfo(Reg::NetActive).width;
  return m.d.ule(m.number(networkRequests(m.target), width), m.get(Reg::NetActive), width);
}

/// The S7-200 SMART has GET and PUT instead (ir/s7200/isa/ethernet.hpp).
constexpr Desc onS7200(Desc desc) {
  desc.cpus = s7200Cpus;
  return desc;
}

/// NETR, NETW TBL, PORT: at most eight at a time (001:3033). Byte 0 of the table is the status D A E 0 eeee; an active
/// table keeps its address in Reg::NetTable until the answer has come. Error codes 001:3052-3065.
template <bool writes, Name stlName, Name meaning, std::uint32_t time>
struct Network {
  static constexpr Desc desc =
      onS7200(commDesc(writes ? Role::Netw : Role::Netr, stlName.view(), {}, meaning.view(),
                       inout("TBL", Type::Byte, form::V | form::M | form::Pointers).elements(7, 23), time, "001:3040"));
  static constexpr std::uint64_t active = 0x40, error = 0x20, queueFull = 4, notMaster = 5, badParameter = 6;

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto port = portOf(m, a);
    if (!port) return;
    const auto length = a.element(0, 6, Width::Byte);
    const auto fits = a.fits(0, d.add(d.zext(length, 8, 16), m.number(7, 16), 16), Width::Byte);
    const auto isActive = d.bit(a.value(0), 6);
    const auto again = d.land(isActive, m.reads({Choice::NetworkAgain, "ignored"}));
    const auto lengthBad = d.lor(d.equal(length, m.number(0, 8), 8), d.ult(m.number(16, 8), length, 8));
    const auto full = isQueueFull(m);
    m.hazard(Hazard::OutOfRange, d.land(d.lnot(lengthBad), d.lnot(fits)));
    m.when(d.land(d.lnot(again), d.lor(lengthBad, fits)), [&] {
      const auto master = portIs(m, *port, ppiMaster);
      const auto code = d.select(d.lnot(master), m.number(notMaster, 8),
                                 d.select(lengthBad, m.number(badParameter, 8), m.number(queueFull, 8), 8), 8);
      const auto refused = d.lor(d.lnot(master), d.lor(lengthBad, full));
      m.hazard(Hazard::PortParameter, refused);
      a.store(0, d.select(refused, d.bor(code, m.number(error, 8), 8), m.number(active, 8), 8));
      m.when(d.lnot(refused), [&] { enterRequest(m, addressOf(m, a, 0), length, writes); });
    });
  }
};

/// GPA ADDR, PORT: the station address in use, from SPA or else the system block (001:3348).
struct GetPortAddress {
  static constexpr Desc desc = commDesc(Role::Gpa, "GPA", "GET_ADDR", "get port address",
                                        out("ADDR", Type::Byte, form::byteOut), 1600, "001:3348");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto port = portOf(m, a);
    if (!port) return;
    const auto set = m.get(Reg::StationAddress, *port);
    const auto fromProgram = m.d.extract(m.d.sub(set, m.number(1, 9), 9), 7, 0);
    const auto isDefault = m.d.equal(set, m.number(0, 9), 9);
    a.store(0, m.d.select(isDefault, m.external(External::StationAddress, *port, 8), fromProgram, 8));
  }
};

/// SPA ADDR, PORT: until the next restart; not in an interrupt routine (001:3348-3353).
struct SetPortAddress {
  static constexpr Desc desc = [] {
    Desc d = commDesc(Role::Spa, "SPA", "SET_ADDR", "set port address", in("ADDR", Type::Byte, form::byteIn), 37100,
                      "001:3348");
    d.notInInterrupt = true;
    return d;
  }();
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto port = portOf(m, a);
    m.hazard(Hazard::NotInInterrupt, m.d.constant(m.inInterrupt));
    if (!port || m.inInterrupt) return;
    m.set(Reg::StationAddress, *port, m.d.add(m.d.zext(a.value(0), 8, 9), m.number(1, 9), 9));
  }
};

using NetworkRead = Network<false, "NETR", "network read", 9900>;
using NetworkWrite = Network<true, "NETW", "network write", 9500>;

using CommGroup = Group<Transmit, Receive, NetworkRead, NetworkWrite, GetPortAddress, SetPortAddress>;

}  // namespace rungproof::isa
