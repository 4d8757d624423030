#include "common/store/fingerprint.h"

#include <gtest/gtest.h>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

TEST(FingerprintTest, IsThatOfTheContent) {
  const TemporaryFolder folder;
  std::string content(200'000, 'a');
  const std::string first = FingerprintOf(folder.Write("a", content)).value();
  EXPECT_EQ(FingerprintOf(folder.Write("copy", content)).value(), first);
  for (const size_t at : {size_t{0}, content.size() - 1}) {
    std::string other = content;
    other[at] = 'b';
    EXPECT_NE(FingerprintOf(folder.Write("b", other)).value(), first) << at;
  }
  EXPECT_NE(FingerprintOf(folder.Write("c", content + "a")).value(), first);
  EXPECT_NE(FingerprintOf(folder.Write("d", "")).value(), FingerprintOf(folder.Write("e", "x")).value());
}

TEST(FingerprintTest, NamesWhatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_TRUE(absl::IsNotFound(FingerprintOf(folder / "none").status()));
  EXPECT_TRUE(absl::IsInvalidArgument(FingerprintOf(folder.path()).status()));
}

TEST(HaveSameContentTest, LooksAtEveryByte) {
  const TemporaryFolder folder;
  const std::string a = folder.Write("a", std::string(200'000, 'a'));
  EXPECT_TRUE(HaveSameContent(a, a));
  EXPECT_TRUE(HaveSameContent(a, folder.Write("b", std::string(200'000, 'a'))));
  EXPECT_FALSE(HaveSameContent(a, folder.Write("c", std::string(100'000, 'a') + 'b' + std::string(99'999, 'a'))));
  EXPECT_FALSE(HaveSameContent(a, folder.Write("d", std::string(200'001, 'a'))));
  EXPECT_FALSE(HaveSameContent(a, folder / "none"));
  EXPECT_FALSE(HaveSameContent(folder / "none", folder / "none"));
}

TEST(DigestOfFileTest, IsThatOfTheBytes) {
  const TemporaryFolder folder;
  for (const size_t size : {size_t{0}, size_t{1} << 20, (size_t{3} << 20) + 7}) {
    std::string content(size, 'a');
    if (size > 0) content.back() = 'b';
    const std::string path = folder.Write("a", content);
    EXPECT_EQ(DigestOfFile(path).value(), FileDigest(content));
    EXPECT_TRUE(FileHasDigest(path, FileDigest(content)).value());
    EXPECT_TRUE(FileHasDigest(path, Sha256Hex(content)).value());
    EXPECT_FALSE(FileHasDigest(path, FileDigest("b")).value());
    EXPECT_FALSE(FileHasDigest(path, Sha256Hex("b")).value());
    EXPECT_FALSE(FileHasDigest(path, "").value());
  }
  EXPECT_TRUE(absl::IsNotFound(DigestOfFile(folder / "none").status()));
  EXPECT_TRUE(absl::IsNotFound(FileHasDigest(folder / "none", Sha256Hex("")).status()));
}

TEST(ChangedInJobTest, NamesTheFileAndMayBeTriedAgain) {
  const absl::Status changed = ChangedInJob("a.mtl");
  EXPECT_TRUE(absl::IsAborted(changed));
  EXPECT_EQ(changed.message().substr(0, 6), "a.mtl:");
}

}  // namespace
}  // namespace tilemend
