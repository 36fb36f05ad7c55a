#pragma once

// Small FBX files that tests write for themselves.

#include <cstdint>
#include <string>
#include <vector>

namespace coif::importer::test {

/// A record of a binary file: values as the file has them, and the records within.
struct FbxTree {
  std::string name;
  std::vector<std::string> values = {};
  std::vector<FbxTree> records = {};
};

[[nodiscard]] std::string fbx_int32(std::int32_t value);
[[nodiscard]] std::string fbx_long(std::int64_t value);
[[nodiscard]] std::string fbx_double(double value);
[[nodiscard]] std::string fbx_text(const std::string& value);
[[nodiscard]] std::string fbx_doubles(const std::vector<double>& values);
[[nodiscard]] std::string fbx_ints(const std::vector<std::int32_t>& values);
/// An array that claims to hold `count` numbers, packed as `bytes`.
[[nodiscard]] std::string fbx_packed_array(char type, std::uint32_t count, const std::string& bytes);
/// The name of an object of a binary file.
[[nodiscard]] std::string fbx_name(const std::string& name, const std::string& of);

/// A binary file of version 7400 (32-bit sizes), 7500 (64-bit sizes) and others.
[[nodiscard]] std::string binary_fbx(std::uint32_t version, const std::vector<FbxTree>& records);

/// A hidden group (object 1) of levels of detail with the mesh 2, whose key "Long" is on by 50 %, between shapes at 25
/// and 75.
[[nodiscard]] std::string small_binary_fbx(std::uint32_t version);

/// A shape key of a model's triangle: its shapes move the third corner, one after the other, by 10, 20 ... along X.
struct FbxKey {
  std::string name;
  double percent = 0;
  int shapes = 1;
  std::string full_weights = {};  ///< As numbers with commas, or none.
};

/// A model of a text file. One of the class "Mesh" has a triangle (0,0,0) (1,0,0) (0,2,3).
struct FbxModel {
  int id = 0;  ///< From 1 to 99.
  std::string name;
  int parent = 0;               ///< 0: the scene.
  std::string properties = {};  ///< Lines of Properties70.
  std::string model_class = "Mesh";
  std::vector<FbxKey> keys = {};
};

[[nodiscard]] std::string text_fbx(const std::vector<FbxModel>& models);
/// One line of Properties70 with a number.
[[nodiscard]] std::string fbx_property(const std::string& name, const std::string& type, double value);

}  // namespace coif::importer::test
