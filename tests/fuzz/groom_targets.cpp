#include "fuzz/targets.h"

#include "groom/read_groom.h"
#include "groom/strand_files.h"

#include <algorithm>
#include <string>

namespace coif::fuzz {
namespace {

bool check(const tl::expected<groom::Groom, std::string>& groom) {
  if (!groom) {
    promise(!groom.error().empty() && groom.error().size() < 1000, "a refusal is a sentence");
    return false;
  }
  const std::string fault = groom::find_groom_fault(*groom);
  promise(fault.empty(), fault.c_str());
  promise(groom->warnings.size() < 20, "many faults give few warnings");
  return true;
}

}  // namespace

bool try_hair_file(Input input) { return check(groom::read_hair_file(std::as_bytes(input))); }

bool try_tressfx(Input input) { return check(groom::read_tressfx(std::as_bytes(input))); }

bool try_obj_lines(Input input) {
  return check(groom::read_obj_lines({reinterpret_cast<const char*>(input.data()), input.size()}));
}

bool try_gltf_lines(Input input) {
  static const LoneFile file("lines.glb");
  return check(groom::read_gltf_lines(file.with(input), {}));
}

bool try_groom_stream(Input input) {
  groom::GroomOutcome outcome = tl::unexpected(ToolError{ToolError::Kind::kInternal, "untouched"});
  if (!groom::decode_groom(input, outcome)) {
    promise(!outcome && outcome.error().message == "untouched", "a refusal leaves the outcome untouched");
    return false;
  }
  promise(!outcome || groom::find_groom_fault(*outcome).empty(), "a groom that was accepted has no fault");
  promise(std::ranges::equal(groom::encode_groom(outcome), input), "what was accepted is encoded to the same bytes");
  return true;
}

}  // namespace coif::fuzz
