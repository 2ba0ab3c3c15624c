// What the OBJ loader says of bad meshes.

#include "tests/scenes/bad_scenes.h"

using namespace ropelight;
using namespace ropelight::bad;

TEST_CASE("a mesh that is missing is named with how to get it") {
  CHECK(ofShape(R"({"type": "mesh", "material": "white", "file": "no/such.obj"})") ==
        "no/such.obj: cannot be read: No such file or directory; s.json: /shapes/0/file names it, relative to the "
        "scene; check the path");
  CHECK(ofShape(R"({"type": "mesh", "material": "white", "file": "no.obj", "generator": "scripts/make.py"})") ==
        "no.obj: cannot be read: No such file or directory; s.json: /shapes/0/file names it, relative to the scene; "
        "run scripts/make.py to make it");
}

TEST_CASE("the bumpy scene says which script makes its mesh") {
  TemporaryFolder folder;
  std::string const text = fileBytes(fs::path(ROPELIGHT_ASSETS) / "bumpy.json");
  std::string const message = messageOf(folder, writeFile(folder, "bumpy.json", text));
  CHECK(contains(message, "generated/bumpy100k.obj: cannot be read: No such file"));
  CHECK(contains(message, "run scripts/make_bumpy_mesh.py to make it"));
}

TEST_CASE("bad meshes are refused with the line") {
  std::string const corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(ofObj("") == "m.obj: the file holds no faces; expected a Wavefront OBJ mesh");
  CHECK(ofObj(corners) == "m.obj: the file holds no faces; expected a Wavefront OBJ mesh");
  CHECK(ofObj(std::string("\x7f"
                          "ELF\0\xff\xfe\n\n\0",
                          10)) == "m.obj: byte 5 is zero, so this is no text; check the path");
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "1.0abc", "x", "0x10", "+-1", "--1", "1,5", "1e", ".", "+"})
    CHECK(ofObj("v 0 0 0\r\n\r\nv 0 " + std::string(bad) + " 0\r\n" + corners) ==
          "m.obj: line 3: expected a finite coordinate, found \"" + std::string(bad) + "\"");
  CHECK(ofObj("# two\r# lines\rv 1 2") == "m.obj: line 3: a vertex needs three coordinates");
  CHECK(ofObj(corners + "f 1 2\n") == "m.obj: line 4: a face needs at least three vertices, this has 2");
  CHECK(ofObj(corners + "f 1 2 4\n") == "m.obj: line 4: a face names vertex 4, but 3 were read so far");
  CHECK(ofObj(corners + "\nf 0 1 2\n") == "m.obj: line 5: a face names vertex 0, but 3 were read so far");
  CHECK(ofObj(corners + "f -4 -1 -2\n") == "m.obj: line 4: a face names vertex -4, but 3 were read so far");
  CHECK(ofObj(corners + "f 1 2 2147483647") == "m.obj: line 4: a face names vertex 2147483647, but 3 were read so far");
  CHECK(contains(ofObj(corners + "f 1 2 4294967297"), "m.obj: line 4: "));
  CHECK(ofObj(corners + "f 1 2 x\n") ==
        "m.obj: line 4: expected vertex indices such as 1, 1/2, 1//3 or 1/2/3, found \"x\"");
  CHECK(ofObj(corners + "f 1 2 \\ 3\n") ==
        "m.obj: line 4: expected vertex indices such as 1, 1/2, 1//3 or 1/2/3, found \"\\\"");
  CHECK(contains(ofObj(corners + "f 1/2/3/4 2 3\n"), "m.obj: line 4: "));
  CHECK(ofObj("v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n") ==
        "m.obj: none of its faces has an area (1 face); check how the file was written");
  CHECK(ofObj("v 1e30 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n") ==
        "m.obj: line 1: expected a coordinate in [-1e14, 1e14], found \"1e30\"; scale the mesh down");
  CHECK(ofObj(corners + "f 1 2 3\nf 1 2 " + std::string(100, 'x') + "\x1b") ==
        "m.obj: line 5: expected vertex indices such as 1, 1/2, 1//3 or 1/2/3, found \"" + std::string(60, 'x') +
            "...\"");
  CHECK(contains(ofObj(corners + "f 1 2 \x1b[2J"), "found \"?[2J\""));
}

TEST_CASE("joined lines are counted one by one") {
  std::string const corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(contains(ofObj(corners + "f 1 \\\n2 \\\r\n9\n"), "m.obj: line 6: a face names vertex 9"));
  CHECK(contains(ofObj(corners + "f 1 \\\r2\n"), "m.obj: line 4: a face needs at least three vertices, this has 2"));
  CHECK(contains(ofObj("v 0 \\\n0 \\\r\nx\n"), "m.obj: line 3: expected a finite coordinate, found \"x\""));
  CHECK(contains(ofObj(corners + "f 1 2 \\"), "m.obj: line 4: a face needs at least three vertices, this has 2"));
}

TEST_CASE("text that is not UTF-8 is named with the remedy, with a mark and without") {
  std::string const obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  auto widened = [&](std::size_t width, bool bigEndian) {
    std::string wide;
    for (char const c : obj) {
      std::string bytes(width, '\0');
      bytes[bigEndian ? width - 1 : 0] = c;
      wide += bytes;
    }
    return wide;
  };
  std::string const utf16 = "m.obj: the text is in UTF-16; save it in UTF-8";
  std::string const utf32 = "m.obj: the text is in UTF-32; save it in UTF-8";
  CHECK(ofObj("\xFF\xFE" + widened(2, false)) == utf16);
  CHECK(ofObj("\xFE\xFF" + widened(2, true)) == utf16);
  CHECK(ofObj(widened(2, false)) == utf16);
  CHECK(ofObj(std::string("\xFF\xFE\0\0", 4) + widened(4, false)) == utf32);
  CHECK(ofObj(std::string("\0\0\xFE\xFF", 4) + widened(4, true)) == utf32);
  CHECK(ofObj(widened(4, true)) == utf32);
  CHECK(messageOfText("\xFF\xFE" + widened(2, false)) == "s.json: the text is in UTF-16; save it in UTF-8");
}
