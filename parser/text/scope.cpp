#include "parser/text/scope.h"

#include <unordered_set>
#include <utility>

namespace firstlight::parser {

void Scopes::leave() {
  const std::uint32_t scope = current();
  for (; bound_.size() > scope_begins_.back(); bound_.pop_back()) {
    std::vector<Binding>& stack = bindings_[bound_.back()];
    while (!stack.empty() && stack.back().scope >= scope) stack.pop_back();
  }
  scope_begins_.pop_back();
}

const Scopes::Binding* Scopes::find(std::uint32_t symbol, Reach reach) const {
  if (reach == Reach::any || symbol >= bindings_.size() || bindings_[symbol].empty()) return find(symbol);
  const std::vector<Binding>& stack = bindings_[symbol];
  const bool local = reach == Reach::local;
  const Binding& binding = local ? stack.back() : stack.front();
  if (binding.scope != (local ? current() : kGlobal)) return nullptr;
  return std::holds_alternative<std::monostate>(*binding.slot) ? nullptr : &binding;
}

const Scopes::Slot& Scopes::target(std::uint32_t symbol, Reach reach) {
  if (reach != Reach::global) return target(symbol, reach == Reach::local);
  std::vector<Binding>& stack = bindings(symbol);
  if (stack.empty() || stack.front().scope != kGlobal) {
    stack.insert(stack.begin(), {kGlobal, std::make_shared<Value>()});
  }
  return stack.front().slot;
}

const Scopes::Slot& Scopes::new_target(std::uint32_t symbol, bool local) {
  std::vector<Binding>& stack = bindings(symbol);
  if (local) {
    bind(symbol, std::make_shared<Value>());
  } else {
    stack.push_back({kGlobal, std::make_shared<Value>()});
  }
  return stack.back().slot;
}

void Scopes::bind(std::uint32_t symbol, Slot slot) {
  bindings(symbol).push_back({current(), std::move(slot)});
  bound_.push_back(symbol);
}

std::size_t Scopes::bytes() const {
  constexpr std::size_t kSmall = 4096;  // not worth finding out whether it was counted
  std::unordered_set<const Value*> counted;
  std::size_t bytes = 0;
  for (const std::vector<Binding>& stack : bindings_) {
    for (const Binding& binding : stack) {
      const std::size_t size = bytes_of(*binding.slot);
      if (size < kSmall || counted.insert(binding.slot.get()).second) bytes += size;
    }
  }
  return bytes;
}

std::vector<std::string> Scopes::declared_names(const Symbols& symbols) const {
  std::vector<std::string> names;
  for (std::uint32_t symbol = 0; symbol < symbols.size(); ++symbol) {
    if (find(symbol) != nullptr) names.emplace_back(symbols.name(symbol));
  }
  return names;
}

void Scopes::remove(std::uint32_t symbol, Reach reach) {
  std::vector<Binding>& stack = bindings(symbol);
  if (stack.empty()) return;
  if (reach == Reach::any || (reach == Reach::local && stack.back().scope == current())) {
    stack.pop_back();
  } else if (reach == Reach::global && stack.front().scope == kGlobal) {
    stack.erase(stack.begin());
  }
}

}  // namespace firstlight::parser
