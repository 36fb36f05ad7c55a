// Structs of the C interface as they lie in the module's memory, and how they become plain objects. Members are those of the C
// headers in their order, in the spelling of JavaScript; a test compares both. Vectors are arrays: [x, y, z], [x, y, z, w].

import { CoifError } from './memory.mjs';

const TYPES = { u8: 1, i16: 2, u16: 2, u32: 4, f32: 4, f64: 8, u64: 8 };
const READ = { u8: 'getUint8', i16: 'getInt16', u16: 'getUint16', u32: 'getUint32', f32: 'getFloat32', f64: 'getFloat64', u64: 'getBigUint64' };
const WRITE = { u8: 'setUint8', i16: 'setInt16', u16: 'setUint16', u32: 'setUint32', f32: 'setFloat32', f64: 'setFloat64' };
const AXES = ['x', 'y', 'z', 'w'];

export const RECORDS = {};

/** Adds a record: `members` are "type name" or "type name[count]", separated by commas; types are those above and other records. */
function record(name, members) {
  const fields = new Map();
  let size = 0;
  let alignment = 1;
  for (const member of members.split(',')) {
    const [, type, key, count] = /^\s*(\w+) (\w+)(?:\[(\d+)\])?\s*$/.exec(member);
    const inner = RECORDS[type];
    const [bytes, align] = inner ? [inner.size, inner.alignment] : [TYPES[type], TYPES[type]];
    size = Math.ceil(size / align) * align;
    fields.set(key, { type, inner, bytes, offset: size, count: count === undefined ? 0 : Number(count) });
    size += bytes * (count === undefined ? 1 : Number(count));
    alignment = Math.max(alignment, align);
  }
  RECORDS[name] = { name, fields, alignment, size: Math.ceil(size / alignment) * alignment };
}

record('HeadPose', 'f64 position[3], f32 rotation[4], f32 scale, f32 reserved');
record('BoneMatrix', 'f64 m[12]');
record('HeadBone', 'BoneMatrix rest, f64 origin[3], f64 metresPerUnit, f64 largestStretch');
record('HeadVelocity', 'f32 linear[3], f32 angular[3]');
record('HairDesc', 'u32 instances, u32 solver, u32 longestInterval, u32 movingColliders, u32 followsBody, u32 followsPoses, ' +
  'u32 hasOwnAir, u32 feelsGusts, u32 dynamicsSets, u32 keepsLinks');
record('WorldDesc', 'u32 assets, u32 heads, u32 hairBytes, u32 solver, u32 instructionSet, u32 longestInterval, u32 movingColliders, ' +
  'u32 followsBody, u32 followsPoses, u32 hasOwnAir, u32 feelsGusts, u32 dynamicsSets, u32 keepsLinks');
record('StepSettings', 'f32 dt, u32 substeps, u32 iterations, f32 gravity[3], f32 wind[3], f32 airFollow, f32 stiffness, f32 damping, ' +
  'f32 friction, f32 inertia, f32 teleportDistance, f32 teleportAngle, f32 sleepAfter, f32 sleepSpeed, ' +
  'u32 trueGravity');
record('Detail', 'u32 level, u32 interval, u32 simulated');

record('HeadAir', 'f32 wind[3], f32 exposure');
record('Gusts', 'f32 amplitude, f32 length, f32 speed, f32 direction[3], u32 seed');
record('Impulse', 'f64 center[3], f32 axis[3], f32 radius, f32 speed, f32 velocity[3], u32 strokes');
record('MovingCollider', 'f64 center[3], f32 rotation[4], f32 axis[3], f32 halfExtents[3], f32 radius, f32 endRadius, u32 shape, ' +
  'u32 isVelocityKnown, HeadVelocity velocity');
record('BodyPose', 'f64 position[3], f32 rotation[4]');

record('Skeleton', 'u32 boneCount, u32 simulatedCount, u32 chainCount, u32 flags, f32 headJoint[3], f32 headRotation[4], f32 airLag');
record('Bone', 'u32 parent, u32 kind, u32 chain, u32 name, f32 joint[3], f32 length, f32 restDirection[3], u32 colliders');
record('Link', 'u32 bone, u32 to, f32 shortest, f32 longest');
record('Limit', 'u32 kind, f32 angles[2], f32 reserved, f32 rotation[4]');
record('Chain', 'u32 firstBone, u32 boneCount, u32 root, u32 model');
record('Collider', 'u32 shape, u32 bone, u32 flags, u32 reserved, f32 center[3], f32 reservedCenter, f32 radii[3], f32 reservedRadii, ' +
  'f32 rotation[4], f32 axis[3], f32 reservedAxis');
record('BodyBone', 'u32 name, f32 joint[3], f32 rotation[4]');
record('Vertex', 'f32 position[3], i16 normal[4], i16 tangent[4], f32 uv[2]');
record('Skin', 'u16 bone[4], u8 weight[4]');
record('Patch', 'u32 firstIndex, u32 indexCount, f32 headDistance, u32 bone, u32 filePlace');
record('Lod', 'u32 firstPatch, u32 patchCount, f32 screenSize, f32 error');
record('Material', 'f32 baseColor[4], f32 ambient[3], f32 opaqueThreshold, f32 primaryColor[3], f32 primaryExponent, ' +
  'f32 secondaryColor[3], f32 secondaryExponent, f32 primaryShift, f32 secondaryShift, f32 discardThreshold, u32 flags, u32 shading, ' +
  'f32 tilt, f32 roughness, f32 scatter, f32 lightCut, f32 glow, f32 rootShade, f32 variation');
record('Texture', 'u32 role, u32 format, u32 width, u32 height, u32 mipCount, u32 reserved, u64 offset, u64 bytes');

record('IndexRange', 'u32 first, u32 count');
record('Reach', 'f32 center[3], f32 radius');
record('AlphaRange', 'f32 lowest, f32 highest');
record('DrawnHair', 'IndexRange lods[8], u32 lodCount, u32 orderCount, u32 indicesOfOrder, u32 indexBytes, u8 orderOfView[96], ' +
  'Reach reach, AlphaRange alpha, u32 boneCount, u32 skinning, Material material');
record('SkinnedVertex', 'f32 position[3], f32 normal[3], f32 tangent[3]');
record('BoneBox', 'f32 center[3], f32 half[3]');
record('Bounds', 'f32 lowest[3], f32 highest[3]');
record('BoneTransform', 'f32 translation[3], f32 rotation[4]');

/** Enumerators by their numbers. */
export const ENUMS = {
  solver: ['coif', 'thesis', 'passive', 'cascade', 'character'],
  shape: ['sphere', 'ellipsoid', 'capsule', 'plane', 'tapered-capsule', 'box'],
};

/** The record at `at` as an object of numbers and arrays. */
export function read(view, { fields }, at) {
  const object = {};
  for (const [key, field] of fields) {
    const one = (i) => field.inner ? read(view, field.inner, at + field.offset + i * field.bytes)
      : Number(view[READ[field.type]](at + field.offset + i * field.bytes, true));
    object[key] = field.count === 0 ? one(0) : Array.from({ length: field.count }, (_, i) => one(i));
  }
  return object;
}

function number(value, key) {
  if (typeof value === 'boolean') return value ? 1 : 0;
  if (typeof value === 'string' && ENUMS[key]?.includes(value)) return ENUMS[key].indexOf(value);
  if (typeof value === 'number') return value;
  const cure = ENUMS[key] ? `one of ${ENUMS[key].join(', ')}` : 'a number';
  throw new CoifError(`'${key}' is ${String(value)}; it must be ${cure}`, 'COIF_BAD_ARGUMENT');
}

function writeVector(view, field, at, value, key) {
  const write = WRITE[field.type];
  const isList = typeof value?.length === 'number'; // three's vectors have a function of that name
  for (let i = 0; i < field.count; ++i) {
    const each = isList ? value[i] : value?.[AXES[i]];
    if (typeof each !== 'number') {
      throw new CoifError(`'${key}' needs ${field.count} numbers, as a list or as ${AXES.slice(0, field.count).join(', ')}`, 'COIF_BAD_ARGUMENT');
    }
    view[write](at + i * field.bytes, each, true);
  }
}

/** Writes a matrix of 16 numbers, column after column, or what has them as `elements`, as C's three rows of four. */
export function writeMatrix(view, at, matrix, key) {
  const columns = matrix?.elements ?? matrix;
  if (columns?.length !== 16) throw new CoifError(`'${key}' needs 16 numbers, column after column, as three's Matrix4 has them`, 'COIF_BAD_ARGUMENT');
  for (let row = 0; row < 3; ++row) {
    for (let column = 0; column < 4; ++column) view.setFloat64(at + 8 * (4 * row + column), columns[4 * column + row], true);
  }
}

/**
 * Writes those members that `object` has; the others stay as they are. Vectors may be lists or have x, y, z and w. Throws for a
 * member that the record does not have, and for a value that is not a number.
 */
export function write(view, { name, fields }, at, object) {
  for (const key in object) {
    const field = fields.get(key);
    const value = object[key];
    if (value === undefined) continue;
    if (field === undefined) {
      throw new CoifError(`'${key}' is no member of ${name}; it has ${[...fields.keys()].join(', ')}`, 'COIF_BAD_ARGUMENT');
    }
    if (field.inner === RECORDS.BoneMatrix) writeMatrix(view, at + field.offset, value, key);
    else if (field.inner) write(view, field.inner, at + field.offset, value);
    else if (field.count > 0) writeVector(view, field, at + field.offset, value, key);
    else view[WRITE[field.type]](at + field.offset, number(value, key), true);
  }
}
