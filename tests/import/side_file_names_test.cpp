// Buffers and images beside a glTF, as exporters of every system write their names.

#include "import/gltf_builder.h"
#include "import/imported_model.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace coif::importer::side_file_names_test {

using nlohmann::json;
using test::GltfBuilder;
using test::import_or_fail;

class SideFileNames : public testing::Test {
 protected:
  /// A .gltf whose buffer lies in `file` and is called `uri`.
  std::filesystem::path write(const std::string& uri, const std::string& file) const {
    const GltfBuilder builder;
    json document = builder.document;
    document["buffers"] = {{{"byteLength", builder.buffer.size()}, {"uri", uri}}};
    std::filesystem::create_directories((folder_.path() / file).parent_path());
    folder_.write(file, builder.buffer);
    return folder_.write("m.gltf", document.dump());
  }
  test::TemporaryFolder folder_;
};

TEST_F(SideFileNames, OfBuffersMayBeRespelledWithAWarning) {
  for (const std::string uri : {"bin\\Hair 1.bin", "bin%5CHair%201.bin", ".\\bin\\hair 1.BIN", "Bin/Hair%201.bin"}) {
    const SourceModel model = import_or_fail(write(uri, "bin/Hair 1.bin"));
    EXPECT_EQ(model.meshes.size(), 1u);
    ASSERT_EQ(model.warnings.size(), 1u) << uri;
    EXPECT_EQ(model.warnings[0].message,
              "'" + uri + "' is named, and there is no such file; 'bin/Hair 1.bin' is taken for it");
    EXPECT_EQ(model.side_files, (std::vector<std::string>{(folder_.path() / "bin/Hair 1.bin").string()}));
  }
  const SourceModel model = import_or_fail(write("C:\\Users\\me\\hair.bin", "hair.bin"));
  EXPECT_TRUE(test::warns(model, "'hair.bin' is taken for it"));
}

TEST_F(SideFileNames, MayBeEncodedOrNot) {
  for (const std::string uri : {"./hair%2520 1.bin", "hair%2520 1.bin", "sub/../hair%2520%201.bin"}) {
    std::filesystem::create_directory(folder_.path() / "sub");
    EXPECT_TRUE(import_or_fail(write(uri, "hair%20 1.bin")).warnings.empty()) << uri;
  }
  EXPECT_TRUE(import_or_fail(write("100%25.bin", "100%25.bin")).warnings.empty()) << "a writer that encodes nothing";
}

TEST_F(SideFileNames, DoNotLeadOutOfTheFolder) {
  folder_.write("secret.bin", std::string(1000, 'x'));
  std::filesystem::create_directories(folder_.path() / "model/sub");
  for (const std::string uri : {"..\\secret.bin", "sub\\..\\..\\secret.bin", "../Secret.bin"}) {
    const std::filesystem::path path = write(uri, "model/unused.bin");
    std::filesystem::rename(path, folder_.path() / "model/m.gltf");
    const auto model = import_model(folder_.path() / "model/m.gltf");
    ASSERT_FALSE(model) << uri;
    EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput);
    EXPECT_NE(model.error().message.find("--root"), std::string::npos) << model.error().message;
  }
}

}  // namespace coif::importer::side_file_names_test
