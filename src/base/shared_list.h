// A list whose elements lists of the same kind may share: what a new build keeps of an earlier one.
#pragma once
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace ups {

template <class T>
class SharedList {
 public:
  size_t size() const { return items_.size(); }
  bool empty() const { return items_.empty(); }
  const T& operator[](size_t i) const { return *items_[i]; }
  const T& back() const { return *items_.back(); }
  T& operator[](size_t i) { return *items_[i]; }  // by whoever shares it with nobody yet
  const std::shared_ptr<T>& shared(size_t i) const { return items_[i]; }
  void push_back(T item) { items_.push_back(std::make_shared<T>(std::move(item))); }
  void push_back(std::shared_ptr<T> item) { items_.push_back(std::move(item)); }
  void resize(size_t size) {
    while (items_.size() < size) push_back(T{});
    items_.resize(size);
  }

  class Iterator {
   public:
    using Inner = typename std::vector<std::shared_ptr<T>>::const_iterator;
    explicit Iterator(Inner at) : at_(at) {}
    const T& operator*() const { return **at_; }
    Iterator& operator++() { return ++at_, *this; }
    bool operator==(const Iterator&) const = default;

   private:
    Inner at_;
  };
  Iterator begin() const { return Iterator(items_.begin()); }
  Iterator end() const { return Iterator(items_.end()); }

 private:
  std::vector<std::shared_ptr<T>> items_;
};

}  // namespace ups
