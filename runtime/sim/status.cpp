#include <coif/status.h>

namespace coif {

const char* describe(Status status) {
  switch (status) {
    case Status::kOk: return "ok";
    case Status::kBadTimeStep: return "the time step is not a number, below zero or infinite";
    case Status::kBadPose: return "a pose has a NaN, an infinity or a rotation that is not a unit quaternion";
    case Status::kBadArgument:
      return "an argument is not finite or outside its documented range; explain() of coif/explain.h says which";
    case Status::kBadIndex: return "there is no such instance or bone";
    case Status::kMemoryTooSmall: return "the memory given is smaller than memory_need() says, or not aligned";
    case Status::kNotCreated: return "the object has not been created, or its creation failed";
    case Status::kAssetLacksData: return "the asset is not open or has no chunk that this call needs";
    case Status::kSizeMismatch: return "the spans of a job do not belong together";
    case Status::kForeignState: return "the saved state is of another asset, solver, number of heads or version";
    case Status::kNotAsked: return "the hair was created without what this call needs; see HairDesc";
    case Status::kDamagedState: return "the saved state is none, or was changed or cut after it was saved";
    case Status::kBadScale:
      return "a head's scale is outside of 0.05 to 20; 1 is the size of the asset, 0 was never set";
    case Status::kDriver: return "OpenGL ES refused: function missing, shader not compiled, or out of memory";
  }
  return "unknown status";
}

}  // namespace coif
