#pragma once

namespace coif {

/// Adds skin_vertices() over the vertices of a head of hair, by how many bones move each of them.
void add_skin_benchmarks();

}  // namespace coif
