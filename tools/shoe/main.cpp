// make_shoe FILE.glb: writes the default scene.
#include <cstdio>

#include "tools/shoe/shoe.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_shoe FILE.glb\n", stderr);
    return 2;
  }
  const vamp::shoe::Scene scene = vamp::shoe::make_shoe_scene();
  size_t triangles = 0;
  for (const auto& part : scene.parts) {
    std::printf("%-14s %7zu triangles\n", part.name.c_str(), part.mesh.triangles());
    if (part.name != "Studio floor") triangles += part.mesh.triangles();
  }
  const std::vector<std::byte> bytes = vamp::shoe::to_glb(scene);
  if (const auto status = vamp::write_file_atomically(argv[1], bytes); !status) {
    std::fprintf(stderr, "%s\n", status.error().message().c_str());
    return static_cast<int>(status.error().kind);
  }
  std::printf("%-14s %7zu triangles, %zu bytes\n", "shoe", triangles, bytes.size());
  return 0;
}
