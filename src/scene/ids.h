// The ids that a scene hands out. The low 24 bits are the thing's number among those of its kind, counted from 1 in the
// order in which they were added: what messages name it by. The bits above are the scene's tag, so that another scene
// refuses the id. Used by scene/description.h and the API.
#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace ups {

inline constexpr int id_number_bits = 24;
inline constexpr uint32_t max_id_number = (1u << id_number_bits) - 1;

// Differs between scenes that exist at the same time, as long as there are no more than 255; beyond, a tag that the
// fewest have is shared. Tags are handed out in turn, so that one comes back as late as possible. None is 0: not even
// the first scene takes a mere number for an id.
class SceneTag {
 public:
  SceneTag();
  ~SceneTag();
  SceneTag(const SceneTag&) = delete;
  SceneTag& operator=(const SceneTag&) = delete;
  uint32_t bits() const { return value_ << id_number_bits; }
  static constexpr uint32_t last = (1u << (32 - id_number_bits)) - 1;
  // No two scenes of the process have one: room for 2^40 edits of each.
  uint64_t first_revision() const { return first_revision_; }

 private:
  uint32_t value_;
  uint64_t first_revision_;
};

inline uint32_t number_of(uint32_t id) { return id & max_id_number; }

// The same of an id from outside: throws where its tag is not that of the scene (tag_bits).
inline uint32_t own_number_of(uint32_t id, uint32_t tag_bits, const char* noun) {
  const uint32_t number = number_of(id);
  if (id != 0 && id != (number | tag_bits))
    fail_argument(std::string(noun) + " id " + std::to_string(id) + " is not of this scene" +
                  (id == number ? ": none has such an id"
                                : ", but of another, where it is number " + std::to_string(number) + " of its kind"));
  return number;
}

// Things by number, and by id. A number that was removed never comes back; a page of numbers that all were is let go.
// Things are immutable and shared with copies of the table: whoever holds one knows by its address that it was not set
// since.
template <class T>
class IdTable {
 public:
  explicit IdTable(uint32_t tag_bits = 0) : tag_bits_(tag_bits) {}
  IdTable(IdTable&&) noexcept = default;
  IdTable& operator=(IdTable&&) noexcept = default;
  IdTable(const IdTable& b) : tag_bits_(b.tag_bits_), last_(b.last_) {
    pages_.reserve(b.pages_.size());
    for (const auto& page : b.pages_) pages_.push_back(page ? std::make_unique<Page>(*page) : nullptr);
  }
  IdTable& operator=(const IdTable& b) { return *this = IdTable(b); }

  uint32_t add(T item) {
    if (last_ >= max_id_number)
      throw Error(UPS_ERROR_UNSUPPORTED, "a scene holds at most " + std::to_string(max_id_number) + " of a kind");
    auto shared = std::make_shared<const T>(std::move(item));
    if (last_ / page_size == pages_.size()) pages_.emplace_back();
    auto& page = pages_[last_ / page_size];
    if (!page) page = std::make_unique<Page>();
    slot(++last_) = std::move(shared);
    return id_of(last_);
  }
  void set(uint32_t id, T item, const char* noun) {
    get(id, noun);
    slot(number_of(id)) = std::make_shared<const T>(std::move(item));
  }
  // As it was before it was set: takes no memory.
  void put_back(uint32_t number, std::shared_ptr<const T> item) noexcept { slot(number) = std::move(item); }
  void remove(uint32_t id, const char* noun) {
    get(id, noun);
    slot(number_of(id)).reset();
    auto& page = pages_[(number_of(id) - 1) / page_size];
    if (std::none_of(page->begin(), page->end(), [](const auto& item) { return bool(item); })) page.reset();
  }
  const T& get(uint32_t id, const char* noun) const {
    const uint32_t number = own_number_of(id, tag_bits_, noun);
    if (number == 0 || number > last_)
      fail_argument(std::string(noun) + " id " + std::to_string(number) +
                    " is not of this scene; it has numbers 1 to " + std::to_string(last_));
    if (!holds(number)) fail_argument(std::string(noun) + " id " + std::to_string(number) + " was removed");
    return at(number);
  }
  uint32_t id_of(uint32_t number) const { return number ? number | tag_bits_ : 0; }
  bool holds(uint32_t number) const {
    return number > 0 && number <= last_ && pages_[(number - 1) / page_size] && shared(number);
  }
  // By number, of a thing that is there.
  const T& at(uint32_t number) const { return *shared(number); }
  const std::shared_ptr<const T>& shared(uint32_t number) const {
    return (*pages_[(number - 1) / page_size])[(number - 1) % page_size];
  }
  // Null where there is none.
  std::shared_ptr<const T> find(uint32_t number) const { return holds(number) ? shared(number) : nullptr; }
  // visit(number, item) in the order of numbers.
  template <class Visit>
  void each(const Visit& visit) const {
    for (size_t p = 0; p < pages_.size(); ++p)
      for (uint32_t i = 0; pages_[p] && i < page_size; ++i)
        if ((*pages_[p])[i]) visit(uint32_t(p * page_size + i + 1), *(*pages_[p])[i]);
  }
  // Of the same numbers, none set since.
  bool operator==(const IdTable& b) const {
    if (last_ != b.last_) return false;
    for (size_t p = 0; p * page_size < last_; ++p)
      if (bool(pages_[p]) != bool(b.pages_[p]) || (pages_[p] && *pages_[p] != *b.pages_[p])) return false;
    return true;
  }

 private:
  static constexpr uint32_t page_size = 64;
  using Page = std::array<std::shared_ptr<const T>, page_size>;

  std::shared_ptr<const T>& slot(uint32_t number) { return (*pages_[(number - 1) / page_size])[(number - 1) % page_size]; }

  uint32_t tag_bits_;
  uint32_t last_ = 0;  // number
  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace ups
