// References that lead out of the model's folder where no fence of the kernel's stands in the way, and machines that
// have none.

#include "import/assimp_scene.h"
#include "import/import.h"
#include "import/model_files.h"
#include "platform/child_process.h"
#include "platform/job.h"

#include <gtest/gtest.h>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <fstream>

namespace coif::importer::sandbox_test {

namespace fs = std::filesystem;

constexpr const char* kObj = "mtllib LIBRARY\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl hair\nf 1 2 3\n";

/// A folder with a model's folder in it, and files beside that one.
class References : public testing::Test {
 protected:
  References() {
    fs::create_directory(folder_.path() / "model");
    folder_.write("secret.mtl", "newmtl hair\nKd 0.25 0 0\n");
    fs::create_symlink("../secret.mtl", folder_.path() / "model" / "link.mtl");
    folder_.write("model/own.mtl", "newmtl hair\nKd 0 1 0\n");
  }

  /// In this process, which no fence is around.
  SourceModel read(const std::string& library, std::vector<fs::path> roots = {}) const {
    std::string text = kObj;
    text.replace(text.find("LIBRARY"), 7, library);
    const fs::path path = folder_.write("model/hair.obj", text);
    ImportSettings settings;
    settings.roots = std::move(roots);
    auto model = read_with_assimp(path, *find_suffix(path), settings);
    EXPECT_TRUE(model) << model.error().message;
    return model ? std::move(*model) : SourceModel{};
  }
  static float red(const SourceModel& model) {
    for (const SourceMaterial& material : model.materials) {
      if (material.name == "hair") return material.base_color.x();
    }
    return -1;
  }

  test::TemporaryFolder folder_;
};

TEST_F(References, OfTheModelsOwnFolderAreRead) { EXPECT_EQ(red(read("own.mtl")), 0); }

TEST_F(References, ThatLeadOutAreNotReadAndSaid) {
  for (const std::string& library :
       {std::string("../secret.mtl"), (folder_.path() / "secret.mtl").string(), std::string("link.mtl")}) {
    const SourceModel model = read(library);
    EXPECT_EQ(red(model), 1) << library << ": white, as without a library";
    ASSERT_FALSE(model.warnings.empty()) << library;
    const char* const why = library[0] == '/' ? "was not read" : "of the model's folder, which --root allows";
    EXPECT_NE(model.warnings[0].message.find(why), std::string::npos) << model.warnings[0].message;
  }
}

TEST_F(References, MayLeadIntoRoots) {
  EXPECT_EQ(red(read("../secret.mtl", {folder_.path()})), 0.25f);
  EXPECT_EQ(red(read("link.mtl", {folder_.path()})), 0.25f);
}

TEST_F(References, NameEveryImage) {
  folder_.write("model/own.mtl", "newmtl hair\nmap_Kd color.png\nmap_Ks gloss.png\nmap_d alpha.png\nbump relief.png\n");
  EXPECT_EQ(read("own.mtl").named_images,
            (std::vector<std::string>{"alpha.png", "color.png", "gloss.png", "relief.png"}));
}

/// From now on this process has a kernel without Landlock.
void take_landlock_away() {
  sock_filter program[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                           BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_landlock_create_ruleset, 0, 1),
                           BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
                           BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog filter{std::size(program), program};
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0);
}

/// Reads the model at the path behind two flags: whether there is a sandbox, and whether one is required.
const platform::Job kImport("test.import", [](const platform::JobCall& call) -> platform::Bytes {
  const std::string request(call.request().begin(), call.request().end());
  if (request[0] == 'n') take_landlock_away();
  ImportSettings settings;
  settings.requires_sandbox = request[1] == 'y';
  const auto model = import_model(request.substr(2), settings);
  const std::string text = model ? "read, " + platform::missing_sandbox() : model.error().message;
  return {text.begin(), text.end()};
});

TEST_F(References, ReadNothingWithoutASandboxWhereOneIsRequired) {
  if (!platform::missing_sandbox().empty()) GTEST_SKIP() << platform::missing_sandbox();
  const fs::path path = folder_.write("model/hair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto told = [&](bool is_there, bool is_required) {
    const std::string request = std::string(is_there ? "y" : "n") + (is_required ? "y" : "n") + path.string();
    const auto result = platform::run_in_child(kImport, platform::Bytes(request.begin(), request.end()),
                                               {.kind = platform::ChildKind::kWorker});
    return std::string(result.output.begin(), result.output.end());
  };
  EXPECT_EQ(told(true, true), "read, ");
  EXPECT_EQ(told(false, false), "read, this kernel has no Landlock, or it is turned off");
  EXPECT_NE(
      told(false, true).find("was not read: this kernel has no Landlock, or it is turned off, and --require-sandbox"),
      std::string::npos);
}

}  // namespace coif::importer::sandbox_test
