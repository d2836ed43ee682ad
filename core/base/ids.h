// Typed indices: a FaceId cannot index an array of vertices. Arrays come as IdVector, which is indexed by
// one kind of id only, and loops as IdRange.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace netwright {

/// An index of one kind; -1 means "none".
template <class Tag>
struct Id {
  std::int32_t value = -1;

  constexpr Id() = default;
  constexpr explicit Id(std::int32_t v) : value(v) {}
  constexpr explicit Id(std::size_t v) : value(static_cast<std::int32_t>(v)) {}

  [[nodiscard]] constexpr bool is_valid() const { return value >= 0; }
  [[nodiscard]] constexpr std::size_t index() const { return static_cast<std::size_t>(value); }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;
using FaceId = Id<struct FaceTag>;
/// A directed side of a face. Halfedge and corner are one thing: halfedge h starts at its corner's vertex.
using HalfedgeId = Id<struct HalfedgeTag>;
using EdgeId = Id<struct EdgeTag>;

/// The ids first, first+1, …, last-1.
template <class Key>
class IdRange {
 public:
  class Iterator {
   public:
    constexpr explicit Iterator(std::int32_t v) : value_(v) {}
    constexpr Key operator*() const { return Key(value_); }
    constexpr Iterator& operator++() {
      ++value_;
      return *this;
    }
    constexpr bool operator==(const Iterator&) const = default;

   private:
    std::int32_t value_;
  };

  constexpr IdRange(std::int32_t first, std::int32_t last) : first_(first), last_(last) {}
  constexpr explicit IdRange(std::size_t count) : IdRange(0, static_cast<std::int32_t>(count)) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(first_); }
  [[nodiscard]] constexpr Iterator end() const { return Iterator(last_); }
  [[nodiscard]] constexpr std::size_t size() const { return static_cast<std::size_t>(last_ - first_); }

 private:
  std::int32_t first_;
  std::int32_t last_;
};

/// A vector that only one kind of id can index.
template <class Key, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t n, const T& value = T()) : items_(n, value) {}
  explicit IdVector(std::vector<T> items) : items_(std::move(items)) {}

  decltype(auto) operator[](Key key) { return items_[key.index()]; }
  decltype(auto) operator[](Key key) const { return items_[key.index()]; }

  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  void assign(std::size_t n, const T& value) { items_.assign(n, value); }
  void resize(std::size_t n) { items_.resize(n); }
  Key push_back(T value) {
    items_.push_back(std::move(value));
    return Key(items_.size() - 1);
  }
  [[nodiscard]] IdRange<Key> ids() const { return IdRange<Key>(items_.size()); }

  auto begin() { return items_.begin(); }
  auto end() { return items_.end(); }
  [[nodiscard]] auto begin() const { return items_.begin(); }
  [[nodiscard]] auto end() const { return items_.end(); }
  [[nodiscard]] const std::vector<T>& raw() const { return items_; }
  std::vector<T>& raw() { return items_; }

  bool operator==(const IdVector&) const = default;

 private:
  std::vector<T> items_;
};

}  // namespace netwright
