// What the OBJ loader says of bad meshes.

#include "tests/bad_scenes.h"

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
                          10)) == "m.obj: the file holds no faces; expected a Wavefront OBJ mesh");
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "1.0abc", "x", "0x10"})
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
  CHECK(ofObj(corners + "f 1 2 \\\n3\n") ==
        "m.obj: line 4: expected vertex indices such as 1, 1/2, 1//3 or 1/2/3, found \"\\\"");
  CHECK(contains(ofObj(corners + "f 1/2/3/4 2 3\n"), "m.obj: line 4: "));
  CHECK(ofObj("v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n") ==
        "m.obj: the mesh has no usable size: its vertices all coincide or lie too far apart");
  CHECK(contains(ofObj("v 1e30 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"), "m.obj: "));
}
