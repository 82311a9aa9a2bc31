#pragma once

#include "parser/text/lexer.h"
#include "parser/text/value.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace firstlight::parser {

/// The declared names. Scopes nest by what is being read: the scene (1), then each included file and each macro call. A
/// name means what the innermost scope that has it says, whoever calls whom. [POV-Ray 3.7 manual, "Identifier name
/// collisions"]
///
/// Cost     find O(1): each symbol keeps its own stack of bindings.
class Scopes {
 public:
  static constexpr std::uint32_t kGlobal = 1;

  /// A place that holds a value: a name's own, or one element of an array, or, for a macro parameter, the caller's.
  using Slot = std::shared_ptr<Value>;
  struct Binding {
    std::uint32_t scope = 0;
    Slot slot;
  };

  Scopes() { enter(); }

  std::uint32_t current() const { return static_cast<std::uint32_t>(scope_begins_.size()); }
  void enter() { scope_begins_.push_back(bound_.size()); }
  void leave();

  /// Null when the name is not declared; one declared but without a value yet counts as undeclared.
  const Binding* find(std::uint32_t symbol) const {
    if (symbol >= bindings_.size() || bindings_[symbol].empty()) return nullptr;
    const Binding& binding = bindings_[symbol].back();
    return std::holds_alternative<std::monostate>(*binding.slot) ? nullptr : &binding;
  }
  /// Where a name is looked for. `local.Name` is of the innermost scope and `global.Name` of the scene, whatever the
  /// name alone means. [POV-Ray 3.8]
  enum class Reach : std::uint8_t { any, local, global };
  const Binding* find(std::uint32_t symbol, Reach reach) const;
  /// The slot that `#declare` (`local` false) or `#local` writes to; made when there is none.
  /// The reference holds until the next name is bound.
  const Slot& target(std::uint32_t symbol, bool local) {
    if (symbol < bindings_.size() && !bindings_[symbol].empty()) {
      const Binding& binding = bindings_[symbol].back();
      if (!local || binding.scope == current()) return binding.slot;
    }
    return new_target(symbol, local);
  }
  const Slot& target(std::uint32_t symbol, Reach reach);
  /// Binds the name in the current scope, over any other meaning.
  void bind(std::uint32_t symbol, Slot slot);
  /// The bytes_of() of all values together; one that goes by several names counts once.
  std::size_t bytes() const;
  /// All names that have a value.
  std::vector<std::string> declared_names(const Symbols& symbols) const;
  /// Removes a meaning of the name: with Reach::any the innermost.
  void remove(std::uint32_t symbol, Reach reach = Reach::any);

 private:
  const Slot& new_target(std::uint32_t symbol, bool local);
  std::vector<Binding>& bindings(std::uint32_t symbol) {
    if (symbol >= bindings_.size()) bindings_.resize(std::max<std::size_t>(symbol + 1, bindings_.size() * 2));
    return bindings_[symbol];
  }

  std::vector<std::vector<Binding>> bindings_;  // by symbol; the innermost last
  std::vector<std::uint32_t> bound_;            // symbols, in the order in which bind() has bound them
  std::vector<std::size_t> scope_begins_;       // in bound_, by scope - 1
};

}  // namespace firstlight::parser
