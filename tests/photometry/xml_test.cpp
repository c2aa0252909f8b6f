// Does the reader of XML refuse what is broken, with its line, and give back text and attributes?
#include "photometry/xml.h"

#include <gtest/gtest.h>

#include "photometry/files.h"

namespace ups::test {
namespace {

using photometry::ParseError;
using photometry::test::expect_refused;

TEST(Xml, BrokenFilesNameTheirLine) {
  const auto refused = [](const std::string& xml, const std::string& part) { expect_refused<ParseError>(xml, part); };
  refused("<IESTM33-22>\n<Header>\n</Emitter>", "line 3: </Emitter> stands where </Header> is expected");
  refused("<IESTM33-22>\r\n<Header>\r\n", "line 3: the file ends inside <Header>");
  refused("<IESTM33-22>\r<!-- ", "line 2: the file ends inside a comment");
  refused("<IESTM33-22 a>", "the attribute \"a\" of <IESTM33-22> has no value");
  refused("<IESTM33-22 a=1>", "is not in quotes");
  refused("<IESTM33-22 a='1'\nb='2' a='3'>", "line 2: <IESTM33-22> has the attribute \"a\" twice");
  refused("<IESTM33-22 a='1'b='2'>", "does not end with");
  refused("<IESTM33-22 a='1", "the file ends inside an attribute's value");
  refused("<IESTM33-22", "does not end with");
  refused("<", "a name of an element or attribute");
  refused("<1>", "a name of an element or attribute");
  refused("<IESTM33-22>&nbsp;", "\"&nbsp;\": only");
  refused("<IESTM33-22>&#xZZ;", "is no character reference");
  refused("<IESTM33-22>&#0;", "is no character reference");
  refused("<!DOCTYPE x [", "inside a document type");
  refused("<!DOCTYPE x [<!-- ' ]>", "inside a comment");
  refused("<?xml ", "inside a processing instruction");
  refused("<!-- x -->", "the file has no element");
  refused("<IESTM33-22><![CDATA[", "inside CDATA");
  std::string deep = "<IESTM33-22>";
  for (int i = 0; i < 70; ++i) deep += "<a>";
  refused(deep, "more than 64 deep");
}

TEST(Xml, TextAndAttributes) {
  photometry::XmlReader xml(
      "<a x='1 &lt; 2' n:y=\"&#x20AC;&#65;\"><b>one<c>no</c> <![CDATA[<two>]]>&apos;</b><d/></a>");
  xml.enter_root();
  EXPECT_EQ(xml.name(), "a");
  ASSERT_TRUE(xml.attribute("x") && xml.attribute("y") && !xml.attribute("z"));
  EXPECT_EQ(*xml.attribute("x"), "1 < 2");
  EXPECT_EQ(*xml.attribute("y"),
            "\xE2\x82\xAC"
            "A");
  ASSERT_TRUE(xml.enter_child());
  EXPECT_EQ(xml.name(), "b");
  EXPECT_EQ(xml.text(), "one <two>'");
  ASSERT_TRUE(xml.enter_child());
  EXPECT_EQ(xml.name(), "d");
  EXPECT_FALSE(xml.enter_child());
  EXPECT_EQ(xml.name(), "a");
  EXPECT_FALSE(xml.enter_child());
  EXPECT_EQ(xml.name(), "");
}

}  // namespace
}  // namespace ups::test
