// Checksums against the vectors of their standards.
#include "parapet/records/checksum.hpp"

#include <gtest/gtest.h>

namespace parapet::test {
namespace {

using records::check_line;
using records::LineChecksum;

TEST(Checksum, Crc32cOfRfc3720) {
  EXPECT_EQ(records::crc32c(""), 0U);
  EXPECT_EQ(records::crc32c("123456789"), 0xe3069283U);
  EXPECT_EQ(records::crc32c(std::string(32, '\0')), 0x8a9136aaU);
  EXPECT_EQ(records::crc32c(std::string(32, '\xff')), 0x62a8ab43U);
}

TEST(Checksum, Sha256OfFips180) {
  EXPECT_EQ(records::sha256(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(records::sha256("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(records::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(records::sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Checksum, OfALineIsOverTheBytesBeforeItsComma) {
  const std::string line = records::line_with_checksum({{"id", "0001"}, {"feasible", true}});
  EXPECT_EQ(line.substr(0, 30), R"({"id":"0001","feasible":true,")");
  EXPECT_EQ(line.substr(29, 10), "\"crc32c\":\"");
  EXPECT_TRUE(line.ends_with("\"}"));
  EXPECT_EQ(std::stoul(line.substr(39, 8), nullptr, 16),
            records::crc32c(R"({"id":"0001","feasible":true)"));
  EXPECT_EQ(check_line(line), LineChecksum::right);
  EXPECT_EQ(check_line(R"({"id":"0001","feasible":true})"), LineChecksum::none);
  EXPECT_EQ(check_line(""), LineChecksum::none);
  for (std::size_t k = 0; k < line.size(); ++k) {
    std::string other = line;
    other[k] = other[k] == '0' ? '1' : '0';
    EXPECT_NE(check_line(other), LineChecksum::right) << k;
  }
}

}  // namespace
}  // namespace parapet::test
