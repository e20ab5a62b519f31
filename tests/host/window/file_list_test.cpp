// What a folder is listed as: sequences, order, words.
#include "host/window/files/file_list.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/media/frame_sequence.h"
#include "core/media/sequence_names.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian::window {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

Names names_of(const std::vector<FileEntry>& entries) {
  Names names;
  for (const FileEntry& entry : entries) names.push_back(entry.name);
  return names;
}

Names sorted(std::vector<FileEntry> entries, FileOrder order = {}) {
  sort_entries(entries, order);
  return names_of(entries);
}

Names groups(const Names& names) {
  Names found;
  for (const NameGroup& group : group_names(names)) found.push_back(group.name);
  std::sort(found.begin(), found.end());
  return found;
}

TEST(SequenceNames, FramesOfOnePatternAreOneWhateverTheirPadding) {
  EXPECT_EQ(groups({"a.0001.vdb", "a.0002.vdb", "a.0010.vdb"}), Names{"a.####.vdb"});
  EXPECT_EQ(groups({"a.8.vdb", "a.9.vdb", "a.10.vdb"}), Names{"a.#.vdb"}) << "not padded at all";
  EXPECT_EQ(groups({"a.1001.vdb", "a.1002.vdb"}), Names{"a.####.vdb"});
  EXPECT_EQ(groups({"a.0998.vdb", "a.9999.vdb", "a.10000.vdb"}), Names{"a.####.vdb"}) << "outgrown";
  EXPECT_EQ(groups({"a.01.vdb", "a.02.vdb", "a.001.vdb", "a.002.vdb"}), (Names{"a.###.vdb", "a.##.vdb"}));
  EXPECT_EQ(groups({"a1.vdb", "a2.vdb", "b1.vdb", "a1.exr"}), (Names{"a#.vdb", "a1.exr", "b1.vdb"}));
  EXPECT_EQ(groups({"ash_v1.vdb", "ash_v2.vdb", "v001.vdb", "v002.vdb"}),
            (Names{"ash_v1.vdb", "ash_v2.vdb", "v001.vdb", "v002.vdb"}))
      << "versions are no frames";
  EXPECT_EQ(groups({"wave1.vdb", "wave2.vdb", "mov1.vdb", "mov2.vdb"}), (Names{"mov#.vdb", "wave#.vdb"}));
  EXPECT_EQ(groups({"a.0001.vdb", "7.vdb", ".vdb", "a"}), (Names{".vdb", "7.vdb", "a", "a.0001.vdb"}));
}

// Whatever is listed as one line is what the pattern on it reads.
TEST(SequenceNames, ThePatternReadsTheFilesThatItStandsFor) {
  const TemporaryFolder folder;
  for (const char* name : {"a.0998.vdb", "a.9999.vdb", "a.10000.vdb", "b.8.vdb", "b.10.vdb", "c1001.vdb",
                           "c1002.vdb", "d.01.vdb", "d.02.vdb", "d.100.vdb"})
    folder.write(name, "x");
  const FolderListing listing = list_folder(folder.path(), {".vdb"});
  EXPECT_EQ(listing.entries.size(), 4u);
  for (const FileEntry& entry : listing.entries) {
    const auto pattern = FramePattern::parse((folder.path() / entry.name).string());
    ASSERT_TRUE(pattern) << entry.name;
    const std::vector<int> frames = pattern->frames_on_disk();
    EXPECT_EQ(int(frames.size()), entry.count) << entry.name;
    EXPECT_EQ(frames.front(), entry.first);
    EXPECT_EQ(frames.back(), entry.last);
  }
}

TEST(FileList, CollapsesSequencesAndPutsFoldersFirst) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "sub");
  for (const char* name :
       {"smoke.0001.vdb", "smoke.0002.vdb", "smoke.0010.vdb", "one.0001.vdb", "shot.plinian", "SHOUT.VDB",
        "picture.png", ".hidden.vdb", "take1.plinian", "take2.plinian"})
    folder.write(name, "four");
  const FolderListing listing = list_folder(folder.path(), {".vdb", ".plinian"});
  EXPECT_EQ(listing.problem, "");
  std::vector<FileEntry> entries = listing.entries;
  sort_entries(entries, {});
  EXPECT_EQ(names_of(entries), (Names{"sub", "one.0001.vdb", "shot.plinian", "SHOUT.VDB", "smoke.####.vdb",
                                      "take1.plinian", "take2.plinian"}));
  EXPECT_EQ(entries[0].kind, FileEntry::Kind::folder);
  EXPECT_EQ(entries[1].kind, FileEntry::Kind::file);
  EXPECT_EQ(entries[4].kind, FileEntry::Kind::sequence);
  EXPECT_EQ(entries[4].count, 3);
  EXPECT_EQ(entries[4].bytes, 12u) << "of all its files";
  EXPECT_EQ(range_text(entries[4]), "1-10, 7 missing");
  EXPECT_GT(entries[4].modified, 1'700'000'000);
  EXPECT_TRUE(list_folder(folder.path(), {".json"}).entries.size() == 1) << "the folder alone";
}

TEST(FileList, SaysWhyAFolderCannotBeRead) {
  const TemporaryFolder folder;
  folder.write("file.vdb", "x");
  for (const char* name : {"missing", "file.vdb"}) {
    const FolderListing listing = list_folder(folder.path() / name, {});
    EXPECT_TRUE(listing.entries.empty());
    EXPECT_NE(listing.problem.find(folder / name), std::string::npos);
    EXPECT_NE(listing.problem.find(name == std::string("missing") ? "No such" : "Not a directory"),
              std::string::npos)
        << listing.problem;
  }
  if (geteuid() == 0) return;  // who may read everything
  fs::create_directories(folder.path() / "shut");
  fs::permissions(folder.path() / "shut", fs::perms::none);
  EXPECT_NE(list_folder(folder.path() / "shut", {}).problem.find("Permission denied"), std::string::npos);
  fs::permissions(folder.path() / "shut", fs::perms::owner_all);
}

TEST(FileList, SortsByEachColumnAndKeepsFoldersOnTop) {
  using Kind = FileEntry::Kind;
  const std::vector<FileEntry> entries = {{Kind::file, "b10.vdb", 0, 0, 1, 5, 30},
                                          {Kind::file, "B9.vdb", 0, 0, 1, 7, 20},
                                          {Kind::folder, "z", 0, 0, 1, 0, 10},
                                          {Kind::folder, "y", 0, 0, 1, 0, 40},
                                          {Kind::sequence, "a.#.vdb", 1, 2, 2, 5, 25}};
  EXPECT_EQ(sorted(entries), (Names{"y", "z", "a.#.vdb", "B9.vdb", "b10.vdb"}))
      << "numbers as numbers, large and small letters alike";
  EXPECT_EQ(sorted(entries, {FileColumn::name, true}), (Names{"z", "y", "b10.vdb", "B9.vdb", "a.#.vdb"}));
  EXPECT_EQ(sorted(entries, {FileColumn::size, false}), (Names{"y", "z", "a.#.vdb", "b10.vdb", "B9.vdb"}));
  EXPECT_EQ(sorted(entries, {FileColumn::size, true}), (Names{"y", "z", "B9.vdb", "a.#.vdb", "b10.vdb"}));
  EXPECT_EQ(sorted(entries, {FileColumn::modified, true}), (Names{"y", "z", "b10.vdb", "a.#.vdb", "B9.vdb"}));
}

TEST(FileList, SpeaksInShortWords) {
  EXPECT_EQ(size_text(0), "0 bytes");
  EXPECT_EQ(size_text(999), "999 bytes");
  EXPECT_EQ(size_text(1536), "1.5 KiB");
  EXPECT_EQ(size_text(1023), "1.0 KiB") << "never four digits";
  EXPECT_EQ(size_text(std::uint64_t(5) << 40), "5.0 TiB");
  EXPECT_EQ(list_of({".a"}), ".a");
  EXPECT_EQ(list_of({".a", ".b", ".c"}), ".a, .b and .c");
  EXPECT_TRUE(matches("Smoke.vdb", "sMo"));
  EXPECT_TRUE(matches("Smoke.vdb", ""));
  EXPECT_FALSE(matches("Smoke.vdb", "ash"));
  FileEntry sequence{FileEntry::Kind::sequence, "a.#.vdb", -2, 3, 6};
  EXPECT_EQ(range_text(sequence), "-2-3");
}

}  // namespace
}  // namespace plinian::window
