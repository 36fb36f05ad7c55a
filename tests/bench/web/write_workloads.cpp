// The crowds of workload.h as assets, a.coif and b.coif, for programs that are not C++.
#include "bench/workload.h"
#include "write/asset_writer.h"

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: coif_write_workloads FOLDER\n");
    return 2;
  }
  for (const char* name : {"a", "b"}) {
    const std::vector<std::byte> bytes = coif::write_asset(coif::crowd_contents(*name == 'a' ? coif::kCrowd : coif::kOneHead));
    std::ofstream file(std::string(argv[1]) + "/" + name + ".coif", std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    file.close();
    if (!file) return 1;
  }
  return 0;
}
