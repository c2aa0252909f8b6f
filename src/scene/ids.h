// The ids that a scene hands out. The low 24 bits are the thing's number among those of its kind, counted from 1 in the
// order in which they were added: what messages name it by. The bits above are the scene's tag, so that another scene
// refuses the id. Used by scene/description.h and the API.
#pragma once
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

// Things by number, and by id. A number that was removed never comes back, and keeps a null pointer alone. Things are
// immutable and shared with copies of the table: whoever holds one knows by its address that it was not set since.
template <class T>
class IdTable {
 public:
  explicit IdTable(uint32_t tag_bits = 0) : tag_bits_(tag_bits) {}

  uint32_t add(T item) {
    if (items_.size() >= max_id_number)
      throw Error(UPS_ERROR_UNSUPPORTED, "a scene holds at most " + std::to_string(max_id_number) + " of a kind");
    items_.push_back(std::make_shared<const T>(std::move(item)));
    return id_of(uint32_t(items_.size()));
  }
  void set(uint32_t id, T item, const char* noun) {
    get(id, noun);
    items_[number_of(id) - 1] = std::make_shared<const T>(std::move(item));
  }
  void remove(uint32_t id, const char* noun) {
    get(id, noun);
    items_[number_of(id) - 1].reset();
  }
  const T& get(uint32_t id, const char* noun) const {
    const uint32_t number = own_number_of(id, tag_bits_, noun);
    if (number == 0 || number > items_.size())
      fail_argument(std::string(noun) + " id " + std::to_string(number) +
                    " is not of this scene; it has numbers 1 to " + std::to_string(items_.size()));
    if (!items_[number - 1]) fail_argument(std::string(noun) + " id " + std::to_string(number) + " was removed");
    return *items_[number - 1];
  }
  uint32_t id_of(uint32_t number) const { return number ? number | tag_bits_ : 0; }
  uint32_t last_number() const { return uint32_t(items_.size()); }
  bool holds(uint32_t number) const { return number > 0 && number <= items_.size() && items_[number - 1]; }
  // By number, of a thing that is there.
  const T& at(uint32_t number) const { return *items_[number - 1]; }
  const std::shared_ptr<const T>& shared(uint32_t number) const { return items_[number - 1]; }
  // visit(number, item) in the order of numbers.
  template <class Visit>
  void each(const Visit& visit) const {
    for (size_t i = 0; i < items_.size(); ++i)
      if (items_[i]) visit(uint32_t(i + 1), *items_[i]);
  }

 private:
  uint32_t tag_bits_;
  std::vector<std::shared_ptr<const T>> items_;
};

}  // namespace ups
