#include "host/sdk/plugin_description.h"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <random>

#include "host/graph/files/scene_reader.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/graph/message_of.h"

namespace plinian::sdk {
namespace {

using graph::message_of;
const std::string folder = PLINIAN_TEST_PLUGINS;

TEST(PluginDescription, IsReadFromTheLibraryWithoutLoadingIt) {
  const PluginDescription wobble = read_description(folder + "/wobble.so");
  EXPECT_EQ(wobble.name, "wobble");
  EXPECT_EQ(wobble.version, "1.2");
  EXPECT_EQ(wobble.vendor, "A. Artist");
  EXPECT_EQ(wobble.abi_major, 1);
  EXPECT_EQ(wobble.abi_minor, 3);
  EXPECT_EQ(wobble.registers,
            (std::vector<std::string>{"node:wobble", "node:wobbleTotal", "command:wobbleAll"}));
}

TEST(PluginDescription, StandsInANoteThatNobodyMayWriteTo) {
  const std::string file = graph::read_text_file(folder + "/wobble.so");
  Elf64_Ehdr header;
  std::memcpy(&header, file.data(), sizeof(header));
  const auto section = [&](std::size_t index) {
    Elf64_Shdr found;
    std::memcpy(&found, file.data() + header.e_shoff + index * sizeof(found), sizeof(found));
    return found;
  };
  const std::size_t names = section(header.e_shstrndx).sh_offset;
  int notes = 0;
  for (std::size_t i = 0; i < header.e_shnum; ++i) {
    if (std::string(file.data() + names + section(i).sh_name) != ".note.plinian") continue;
    ++notes;
    EXPECT_EQ(section(i).sh_type, unsigned(SHT_NOTE));
    EXPECT_EQ(section(i).sh_flags, unsigned(SHF_ALLOC)) << "else the assembler warns of it";
  }
  EXPECT_EQ(notes, 1);
}

TEST(PluginDescription, MayStandInAFileBesideTheLibrary) {
  const TemporaryFolder own;
  const std::string library = own / "plain.so";
  std::filesystem::copy_file(folder + "/plain.so", library);  // loading it would end the program
  EXPECT_EQ(
      message_of([&] { read_description(library); }),
      library + ": is no plug-in: it has neither a description within nor a file " + library + ".plinian");
  std::ofstream(library + ".plinian") << "name plain\nversion 3\nabi 1.0\n";
  EXPECT_EQ(read_description(library).name, "plain");
  std::ofstream(library + ".plinian") << "name plain\nversion 3\nabi one\n";
  EXPECT_EQ(message_of([&] { read_description(library); }),
            library + ": its description has no ABI version: 'one'");
  std::ofstream(library + ".plinian") << "version 3\nabi 1.0\n";
  EXPECT_EQ(message_of([&] { read_description(library); }), library + ": its description has no name");
}

TEST(PluginDescription, AnotherMajorOrANewerMinorVersionIsRefused) {
  const auto problem = [](int major, int minor) {
    PluginDescription description;
    description.abi_major = major;
    description.abi_minor = minor;
    return abi_problem(description);
  };
  EXPECT_EQ(problem(1, 0), "");
  EXPECT_EQ(problem(0, 9),
            "was built for version 0.9 of the plug-in interface, this program has 1.3: build it again");
  EXPECT_EQ(
      problem(2, 0),
      "was built for version 2.0 of the plug-in interface, this program has 1.3: it needs a newer Plinian");
  EXPECT_EQ(problem(1, 3), "");
  EXPECT_NE(problem(1, 4), "");
}

TEST(PluginDescription, WhatIsNoLibraryOrADamagedOneCostsALine) {
  const TemporaryFolder own;
  std::ofstream(own / "text.so") << "int main() {}\n";
  EXPECT_EQ(message_of([&] { read_description(own / "text.so"); }),
            own / "text.so" + std::string(": is not a shared library"));
  EXPECT_EQ(message_of([&] { read_description(own.path().string()); }),
            own.path().string() + ": is a folder, not a plug-in");
  const std::string whole = graph::read_text_file(folder + "/wobble.so");
  std::mt19937 random(7);
  for (int run = 0; run < 300; ++run) {
    std::string damaged = whole;
    if (run % 2) damaged.resize(random() % damaged.size());
    // The headers, at both ends, are what is read.
    for (int i = 0; i < 20 && !damaged.empty(); ++i) {
      const std::size_t from_edge = random() % std::min<std::size_t>(damaged.size(), 4096);
      damaged[random() % 2 ? from_edge : damaged.size() - 1 - from_edge] = char(random());
    }
    std::ofstream(own / "damaged.so", std::ios::binary) << damaged;
    try {
      read_description(own / "damaged.so");
    } catch (const graph::GraphError&) {
    }
  }
}

}  // namespace
}  // namespace plinian::sdk
