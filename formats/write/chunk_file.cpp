#include "write/chunk_file.h"

#include "payload_hash.h"

#include <cstring>

namespace coif {
namespace {

std::size_t round_up(std::size_t value, std::size_t alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

/// The table of chunks with their places in the file.
std::vector<ChunkEntry> lay_out(std::span<const PendingChunk> chunks) {
  std::vector<ChunkEntry> table;
  std::size_t end = sizeof(FileHeader) + chunks.size() * sizeof(ChunkEntry);
  for (const PendingChunk& chunk : chunks) {
    const std::size_t offset = round_up(end, chunk.alignment);
    table.push_back({chunk.id, chunk.flags, offset, chunk.bytes.size(), xxh64(chunk.bytes)});
    end = offset + chunk.bytes.size();
  }
  return table;
}

}  // namespace

std::string chunk_name(std::uint32_t id) {
  std::string name;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    const char c = static_cast<char>(id >> shift & 0xFF);
    name += c >= 0x20 && c < 0x7F ? c : '?';
  }
  return name;
}

std::size_t chunk_alignment(std::uint32_t id) { return id == chunk::kTexels ? 64 : 16; }

std::vector<std::byte> write_chunks(std::span<const PendingChunk> chunks, std::uint16_t minor) {
  const std::vector<ChunkEntry> table = lay_out(chunks);
  std::vector<std::byte> file(table.empty() ? sizeof(FileHeader) : table.back().offset + table.back().bytes);
  FileHeader header{};
  std::memcpy(header.magic, kAssetMagic, sizeof header.magic);
  header.major = kAssetMajor;
  header.minor = minor;
  header.chunk_count = std::uint32_t(table.size());
  header.total_bytes = file.size();
  std::memcpy(file.data(), &header, sizeof header);
  if (!table.empty()) std::memcpy(file.data() + sizeof header, table.data(), table.size() * sizeof(ChunkEntry));
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    if (chunks[i].bytes.empty()) continue;
    std::memcpy(file.data() + table[i].offset, chunks[i].bytes.data(), chunks[i].bytes.size());
  }
  header.table_hash = table_hash(file, header.chunk_count);
  std::memcpy(file.data(), &header, sizeof header);
  return file;
}

}  // namespace coif
