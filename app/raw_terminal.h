#pragma once

namespace firstlight::app {

/// The terminal at the standard input, giving every key at once and not showing it. Its former mode comes back however
/// the program ends or is stopped: at the end of this object, on Ctrl-Z, and on signals that end the program at once.
/// At most one lives at a time.
class RawTerminal {
 public:
  /// Whether the standard input is a terminal.
  static bool exists();

  RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
  ~RawTerminal();

  /// Takes the terminal again after the shell has had it; does nothing while the program is in the background. To be
  /// called now and then by a thread that has called block_signals().
  void refresh();

  /// Puts the former mode back, if there is need to. May be called from a signal's handler.
  static void restore();
};

}  // namespace firstlight::app
