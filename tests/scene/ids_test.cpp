// The table of a scene's things by id: numbers, tags, and how many there can be.
#include "scene/ids.h"

#include <gtest/gtest.h>

namespace ups {
namespace {

TEST(IdTable, NumbersCountFromOneBelowTheTag) {
  const SceneTag tag;
  EXPECT_GT(tag.bits(), max_id_number);
  IdTable<int> table(tag.bits());
  EXPECT_EQ(table.add(10), tag.bits() | 1);
  const uint32_t second = table.add(20);
  EXPECT_EQ(second, tag.bits() | 2);
  EXPECT_EQ(table.get(second, "thing"), 20);
  EXPECT_EQ(table.at(2), 20);
  table.remove(second, "thing");
  EXPECT_THROW(table.get(second, "thing"), Error);
  EXPECT_THROW(table.get(2, "thing"), Error) << "a number is no id";
  EXPECT_THROW(table.get(0, "thing"), Error);
  EXPECT_EQ(table.add(30), tag.bits() | 3);
}

TEST(IdTable, TheLastNumberIsHandedOutAndNoneAfterIt) {
  const SceneTag tag;
  IdTable<char> table(tag.bits());
  for (uint32_t i = 1; i < max_id_number; ++i) table.add('a');
  const uint32_t last = table.add('z');
  EXPECT_EQ(last, tag.bits() | max_id_number);
  EXPECT_EQ(table.get(last, "thing"), 'z');
  try {
    table.add('b');
    FAIL() << "it would have the id of another scene";
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), UPS_ERROR_UNSUPPORTED);
  }
}

}  // namespace
}  // namespace ups
