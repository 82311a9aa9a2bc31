#pragma once

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <variant>
#include <vector>

namespace firstlight::render {

/// A list that has mostly one item: that one lies in the list itself, more of them beside it.
template <class T>
class MostlyOne {
 public:
  MostlyOne() = default;
  MostlyOne(std::vector<T> items) {
    if (items.size() == 1) {
      items_ = std::move(items.front());
    } else {
      items_ = std::move(items);
    }
  }
  MostlyOne(std::initializer_list<T> items) : MostlyOne(std::vector<T>(items)) {}

  const T* begin() const { return one() ? one() : several()->data(); }
  const T* end() const { return begin() + size(); }
  T* begin() { return const_cast<T*>(std::as_const(*this).begin()); }
  T* end() { return begin() + size(); }
  std::size_t size() const { return one() ? 1 : several()->size(); }
  bool empty() const { return size() == 0; }
  const T& operator[](std::size_t i) const { return begin()[i]; }
  T& operator[](std::size_t i) { return begin()[i]; }
  const T& front() const { return *begin(); }
  T& front() { return *begin(); }

  void push_back(T item) {
    if (empty()) {
      items_ = std::move(item);
      return;
    }
    if (T* first = std::get_if<T>(&items_)) {
      std::vector<T> both;
      both.push_back(std::move(*first));
      items_ = std::move(both);
    }
    std::get<std::vector<T>>(items_).push_back(std::move(item));
  }

 private:
  const T* one() const { return std::get_if<T>(&items_); }
  const std::vector<T>* several() const { return std::get_if<std::vector<T>>(&items_); }

  std::variant<std::vector<T>, T> items_;
};

}  // namespace firstlight::render
