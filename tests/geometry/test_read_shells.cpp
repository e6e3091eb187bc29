// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/import_shells/read_shells.h"

#include "geometry/import_shells/text_lines.h"
#include "tests/geometry/shell_decks.h"
#include "tests/geometry/shell_measures.h"
#include "tests/geometry/temporary_folder.h"

#include <random>

using namespace birdstrike;
using namespace birdstrike::test;

TEST_CASE("every deck of the same mesh gives the same mesh", "[read_shells]")
{
  const TemporaryFolder folder;
  for (const auto& [name, text] : deck_texts()) {
    INFO(name);
    ShellMesh expected = deck_mesh();
    if (name.ends_with(".msh"))
      for (auto& part : expected.parts)
        part.thickness = 0;
    const ShellImport import = read_shells(folder.write(name, text), 1e-3);
    CHECK(same_mesh(import.mesh, expected, 1e-15));
    CHECK(is_sound(import.mesh));
    CHECK(import.mesh.points.size() == 7);
    // The same with the line ends of other systems, and with metres.
    std::string dos;
    for (const char c : text)
      dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
    CHECK(same_mesh(read_shells(folder.write(name, dos), 1e-3).mesh, expected, 1e-15));
    const ShellMesh large = read_shells(folder.write(name, text), 1.0).mesh;
    CHECK(area(large) == Approx(1e6 * area(expected)));
    CHECK(large.parts[1].thickness == Approx(1e3 * expected.parts[1].thickness));
    CHECK(import.warnings.empty());
  }
}

TEST_CASE("surfaces give one part an object, joined where they touch", "[read_shells]")
{
  const TemporaryFolder folder;
  const auto file = folder.write("two.obj", "o left\nv 0 0 0\nv 0 1 0\nv 0 1 1\nv 0 0 1\nf 1 2 3\nf 1 3 4\n"
                                            "o right\nv 0 0 0\nv 0 0 1\nv 0 -1 1\nf 5 6 7\n");
  const ShellImport import = read_shells(file, 0.1);
  CHECK(import.warnings.empty());
  REQUIRE(import.mesh.parts.size() == 2);
  CHECK(import.mesh.parts[0].name == "left");
  CHECK(import.mesh.parts[1].name == "right");
  CHECK(import.mesh.points.size() == 5);
  CHECK(import.mesh.part == std::vector<std::uint16_t>{0, 0, 1});
  CHECK(area(import.mesh, 0) == Approx(0.01));
  CHECK(area(import.mesh, 1) == Approx(0.005));

  const auto stl =
      folder.write("one.stl", "solid plate\nfacet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\n"
                              "vertex 0 1 0\nendloop\nendfacet\nendsolid plate\n");
  CHECK(area(read_shells(stl).mesh) == Approx(0.5));
  CHECK(read_shells(stl).mesh.part.empty());
}

TEST_CASE("a file that is no mesh is refused by name", "[read_shells]")
{
  const TemporaryFolder folder;
  const auto message = [&](const std::filesystem::path& file) {
    return input_error([&] { read_shells(file); });
  };
  CHECK_THAT(message(folder / "none.inp"), Catch::Contains("none.inp' does not exist"));
  CHECK_THAT(message(folder / "mesh.step"),
             Catch::Contains("unknown format '.step'; known are .msh, .inp, .bdf"));
  for (const auto& [name, text] : deck_texts()) {
    CHECK_THAT(message(folder.write(name, "")), Catch::Contains(name + "' is empty"));
    CHECK_THAT(message(folder.write(name, "some words\nand more\n")), Catch::Contains(name + "'"));
    CHECK_THAT(message(folder.write(name, std::string("\0\1\2\3 PK\4\5", 10))),
               Catch::Contains("is not text (binary data after 0 bytes)"));
    std::filesystem::remove(folder / name);
    std::filesystem::create_directory(folder / name);
    CHECK_THAT(message(folder / name), Catch::Contains("is not a file"));
    std::filesystem::remove(folder / name);
    folder.write(name, text);
    CHECK_THAT(input_error([&] { read_shells(folder / name, 0); }), Catch::Contains("must be positive"));
  }
}

TEST_CASE("decks cut short or spoiled give an InputError or a sound mesh, never worse", "[read_shells]")
{
  const TemporaryFolder folder;
  std::mt19937 random(20240607);
  const std::string bytes = "0123456789 .,*$+-eE\n\r\tSPC=&\"'\x01\xff";
  int refused = 0, read = 0;
  const auto attempt = [&](const std::string& name, const std::string& text) {
    try {
      const ShellImport import = read_shells(folder.write(name, text));
      if (!is_sound(import.mesh))
        FAIL(name << " gives an unsound mesh:\n" << text);
      ++read;
    } catch (const InputError& error) {
      if (std::string(error.what()).find(name) == std::string::npos)
        FAIL(name << ": " << error.what());
      ++refused;
    }
  };
  for (const auto& [name, text] : deck_texts()) {
    for (std::size_t length = 0; length < text.size(); length += 7)
      attempt(name, text.substr(0, length));
    for (int k = 0; k < 300; ++k) {
      std::string spoiled = text;
      for (int n = 0; n <= k % 4; ++n)
        spoiled[random() % spoiled.size()] = bytes[random() % bytes.size()];
      attempt(name, spoiled);
    }
    for (int k = 0; k < 20; ++k) {
      std::string noise(400, ' ');
      for (char& c : noise)
        c = static_cast<char>(random());
      attempt(name, noise);
    }
  }
  CHECK(refused > 1000);
  CHECK(read > 100);
}

TEST_CASE("numbers are read as solvers write them", "[text_lines]")
{
  CHECK(to_real("1.5") == 1.5);
  CHECK(to_real(" +1.5e3 ") == 1500.0);
  CHECK(to_real("-1.5D-3") == -1.5e-3);
  CHECK(to_real("2.15+1") == 21.5);
  CHECK(to_real("-.5-2") == -0.005);
  CHECK(to_real("7.+2") == 700.0);
  for (const char* text : {"", "abc", "1.5.2", "nan", "inf", "1e999", "1 2", "+-3", "--3", "0x10", "1e"})
    CHECK(!to_real(text));
  CHECK(to_integer(" +12 ") == 12);
  CHECK(to_integer("-3") == -3);
  for (const char* text : {"", "1.0", "12a", "99999999999999999999", "+-3", "-"})
    CHECK(!to_integer(text));
}
