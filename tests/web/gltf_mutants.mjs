// Small damages of a .glb, each of one kind: what exporters, packers and bad disks do to files.

/** @returns {{json: object, bin: Buffer}} of a .glb with one binary chunk. */
function split(glb) {
  const length = glb.readUInt32LE(12);
  return { json: JSON.parse(glb.subarray(20, 20 + length).toString()), bin: Buffer.from(glb.subarray(28 + length)) };
}

function join({ json, bin }) {
  let text = Buffer.from(JSON.stringify(json));
  text = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const head = (size, type) => {
    const out = Buffer.alloc(8);
    out.writeUInt32LE(size, 0);
    out.write(type, 4, 'latin1');
    return out;
  };
  const start = Buffer.alloc(12);
  start.write('glTF', 0, 'latin1');
  start.writeUInt32LE(2, 4);
  start.writeUInt32LE(28 + text.length + bin.length, 8);
  return Buffer.concat([start, head(text.length, 'JSON'), text, head(bin.length, 'BIN\0'), bin]);
}

/** Where an element of an accessor lies in the binary chunk. */
function at({ json }, accessor, element, width, size) {
  const { bufferView, byteOffset = 0 } = json.accessors[accessor];
  return (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset + element * width * size;
}

const primitive = (file) => file.json.meshes[0].primitives[0];
const attribute = (file, name) => primitive(file).attributes[name];
const setFloat = (file, accessor, element, width, k, value) => file.bin.writeFloatLE(value, at(file, accessor, element, width, 4) + 4 * k);
const setIndex = (file, i, value) => {
  const { componentType } = file.json.accessors[primitive(file).indices];
  const place = at(file, primitive(file).indices, i, 1, componentType === 5123 ? 2 : 4);
  if (componentType === 5123) file.bin.writeUInt16LE(value & 0xffff, place);
  else file.bin.writeUInt32LE(value >>> 0, place);
};

/** A vertex whose weights are of at least two joints. */
function sharedVertex(file) {
  const accessor = attribute(file, 'WEIGHTS_0');
  for (let v = 0; v < file.json.accessors[accessor].count; ++v) {
    if (file.bin.readFloatLE(at(file, accessor, v, 4, 4) + 4) > 0.1) return v;
  }
  throw new Error('no vertex with two joints');
}

/** Appends an animation of the first node with these key times and values. */
function addAnimation(file, times, values, path, more = {}) {
  const add = (numbers, type, bounds) => {
    const bytes = Buffer.alloc(4 * numbers.length);
    numbers.forEach((number, i) => bytes.writeFloatLE(number, 4 * i));
    file.json.bufferViews.push({ buffer: 0, byteOffset: file.bin.length, byteLength: bytes.length });
    file.bin = Buffer.concat([file.bin, bytes]);
    file.json.buffers[0].byteLength = file.bin.length;
    const width = { SCALAR: 1, VEC3: 3, VEC4: 4 }[type];
    const entry = { bufferView: file.json.bufferViews.length - 1, componentType: 5126, count: numbers.length / width, type };
    const finite = numbers.filter(Number.isFinite).map(Math.fround);
    if (bounds) Object.assign(entry, { min: [Math.min(...finite)], max: [Math.max(...finite)] });
    file.json.accessors.push(entry);
    return file.json.accessors.length - 1;
  };
  const input = add(times, 'SCALAR', true);
  const output = add(values, path === 'rotation' ? 'VEC4' : 'VEC3', false);
  file.json.animations = [{ samplers: [{ input, output }], channels: [{ sampler: 0, target: { node: 0, path, ...more } }] }];
}

const NAN = Number.NaN;

/** Name of the damage, what does it. Those of numbers touch vertex 7 of the first mesh. */
const DAMAGES = {
  index_beyond: (f) => setIndex(f, 5, f.json.accessors[attribute(f, 'POSITION')].count),
  index_restart: (f) => setIndex(f, 9, 0xffffffff),
  position_nan: (f) => setFloat(f, attribute(f, 'POSITION'), 7, 3, 1, NAN),
  position_infinite: (f) => setFloat(f, attribute(f, 'POSITION'), 7, 3, 0, Infinity),
  position_out_of_bounds: (f) => setFloat(f, attribute(f, 'POSITION'), 7, 3, 0, 3),
  position_without_bounds: (f) => delete f.json.accessors[attribute(f, 'POSITION')].min,
  position_bounds_of_two: (f) => f.json.accessors[attribute(f, 'POSITION')].max.pop(),
  normal_zero: (f) => [0, 1, 2].forEach((k) => setFloat(f, attribute(f, 'NORMAL'), 7, 3, k, 0)),
  normal_long: (f) => setFloat(f, attribute(f, 'NORMAL'), 7, 3, 1, 2),
  normal_short: (f) => [0.5, 0.5, 0.5].forEach((n, k) => setFloat(f, attribute(f, 'NORMAL'), 7, 3, k, n)),
  normal_nan: (f) => setFloat(f, attribute(f, 'NORMAL'), 7, 3, 2, NAN),
  uv_nan: (f) => setFloat(f, attribute(f, 'TEXCOORD_0'), 7, 2, 0, NAN),
  uv_infinite: (f) => setFloat(f, attribute(f, 'TEXCOORD_0'), 7, 2, 1, -Infinity),
  weight_nan: (f) => setFloat(f, attribute(f, 'WEIGHTS_0'), 7, 4, 0, NAN),
  weight_sum_low: (f) => setFloat(f, attribute(f, 'WEIGHTS_0'), 7, 4, 0, 0.25),
  weight_sum_high: (f) => setFloat(f, attribute(f, 'WEIGHTS_0'), 7, 4, 1, 0.9),
  weight_all_zero: (f) => [0, 1, 2, 3].forEach((k) => setFloat(f, attribute(f, 'WEIGHTS_0'), 7, 4, k, 0)),
  weight_negative: (f) => [1.5, -0.5, 0, 0].forEach((w, k) => setFloat(f, attribute(f, 'WEIGHTS_0'), 7, 4, k, w)),
  joint_beyond: (f) => f.bin.writeUInt8(200, at(f, attribute(f, 'JOINTS_0'), 7, 4, 1)),
  joint_twice: (f) => {
    const place = at(f, attribute(f, 'JOINTS_0'), sharedVertex(f), 4, 1);
    f.bin.writeUInt8(f.bin.readUInt8(place), place + 1);
  },
  joints_without_weights: (f) => delete primitive(f).attributes.WEIGHTS_0,
  weights_without_joints: (f) => delete primitive(f).attributes.JOINTS_0,
  joints_of_floats: (f) => (primitive(f).attributes.JOINTS_0 = attribute(f, 'WEIGHTS_0')),
  uv_of_three: (f) => (primitive(f).attributes.TEXCOORD_0 = attribute(f, 'NORMAL')),
  second_uv_without_first: (f) => {
    primitive(f).attributes.TEXCOORD_1 = attribute(f, 'TEXCOORD_0');
    delete primitive(f).attributes.TEXCOORD_0;
  },
  attribute_unknown: (f) => (primitive(f).attributes.HAIR = attribute(f, 'NORMAL')),
  attribute_dangling: (f) => (primitive(f).attributes.NORMAL = 9999),
  attributes_of_two_sizes: (f) => (primitive(f).attributes.NORMAL = f.json.meshes[1].primitives[0].attributes.NORMAL),
  mesh_without_primitives: (f) => (f.json.meshes[1].primitives = []),
  mesh_mode: (f) => (primitive(f).mode = 9),
  indices_dangling: (f) => (primitive(f).indices = 9999),
  indices_of_floats: (f) => (primitive(f).indices = attribute(f, 'WEIGHTS_0')),
  material_dangling: (f) => (primitive(f).material = 77),
  material_texture_dangling: (f) => (f.json.materials[0].pbrMetallicRoughness.baseColorTexture.index = 5),
  material_texture_text: (f) => (f.json.materials[0].pbrMetallicRoughness.baseColorTexture = 'strands'),
  material_name_number: (f) => (f.json.materials[0].name = 7),
  texture_source_dangling: (f) => (f.json.textures[0].source = 3),
  texture_sampler_dangling: (f) => (f.json.textures[0].sampler = 3),
  image_view_dangling: (f) => (f.json.images[0].bufferView = 999),
  accessor_too_many: (f) => (f.json.accessors[attribute(f, 'NORMAL')].count *= 3),
  accessor_offset_odd: (f) => (f.json.accessors[attribute(f, 'NORMAL')].byteOffset = 2),
  accessor_offset_far: (f) => (f.json.accessors[attribute(f, 'NORMAL')].byteOffset = 400),
  accessor_type: (f) => (f.json.accessors[attribute(f, 'NORMAL')].type = 'VEC5'),
  accessor_component: (f) => (f.json.accessors[attribute(f, 'NORMAL')].componentType = 5124),
  accessor_count_zero: (f) => (f.json.accessors[attribute(f, 'NORMAL')].count = 0),
  accessor_count_text: (f) => (f.json.accessors[attribute(f, 'NORMAL')].count = 'many'),
  accessor_view_dangling: (f) => (f.json.accessors[attribute(f, 'NORMAL')].bufferView = 999),
  sparse_beyond: (f) => (f.json.accessors[attribute(f, 'NORMAL')].sparse = { count: 1, indices: { bufferView: 0, componentType: 5125 }, values: { bufferView: 0 } }),
  view_too_long: (f) => (f.json.bufferViews[1].byteLength = f.bin.length + 4),
  view_stride_odd: (f) => (f.json.bufferViews[f.json.accessors[attribute(f, 'NORMAL')].bufferView].byteStride = 13),
  view_buffer_dangling: (f) => (f.json.bufferViews[1].buffer = 4),
  view_offset_negative: (f) => (f.json.bufferViews[1].byteOffset = -4),
  buffer_too_long: (f) => (f.json.buffers[0].byteLength += 4096),
  bin_cut_off: (f) => (f.bin = f.bin.subarray(0, f.bin.length - 4096)),
  node_mesh_dangling: (f) => (f.json.nodes.at(-1).mesh = 55),
  node_skin_dangling: (f) => (f.json.nodes.at(-1).skin = 55),
  node_child_dangling: (f) => f.json.nodes[0].children.push(999),
  node_two_parents: (f) => f.json.nodes[1].children.push(f.json.nodes[2].children[0]),
  node_loop: (f) => (f.json.nodes[2].children = [0]),
  node_rotation_long: (f) => (f.json.nodes[1].rotation = [0, 0, 0, 2]),
  node_rotation_three: (f) => (f.json.nodes[1].rotation = [0, 0, 1]),
  node_translation_text: (f) => (f.json.nodes[1].translation = ['a', 0, 0]),
  skin_joint_dangling: (f) => (f.json.skins[0].joints[1] = 999),
  skin_joint_twice: (f) => (f.json.skins[0].joints[1] = f.json.skins[0].joints[0]),
  skin_without_joints: (f) => delete f.json.skins[0].joints,
  skin_few_binds: (f) => (f.json.accessors[f.json.skins[0].inverseBindMatrices].count -= 3),
  skin_bind_nan: (f) => setFloat(f, f.json.skins[0].inverseBindMatrices, 1, 16, 12, NAN),
  skin_bind_row: (f) => setFloat(f, f.json.skins[0].inverseBindMatrices, 1, 16, 3, 0.5),
  skin_root_dangling: (f) => (f.json.skins[0].skeleton = 999),
  scene_dangling: (f) => (f.json.scene = 3),
  scene_node_dangling: (f) => f.json.scenes[0].nodes.push(999),
  asset_without_version: (f) => delete f.json.asset.version,
  extensions_list: (f) => (f.json.extensions = []),
  extension_text: (f) => (f.json.materials[0].extensions = { KHR_materials_unlit: 'yes' }),
  nodes_no_list: (f) => (f.json.cameras = {}),
  animation_value_nan: (f) => addAnimation(f, [0, 1], [0, 0, 0, 0, NAN, 0], 'translation'),
  animation_time_nan: (f) => addAnimation(f, [0, NAN], [0, 0, 0, 0, 1, 0], 'translation'),
  animation_time_back: (f) => addAnimation(f, [0, 2, 1], [0, 0, 0, 0, 1, 0, 0, 2, 0], 'translation'),
  animation_time_negative: (f) => addAnimation(f, [-1, 1], [0, 0, 0, 0, 1, 0], 'translation'),
  animation_few_values: (f) => addAnimation(f, [0, 1, 2], [0, 0, 0, 0, 1, 0], 'translation'),
  animation_rotation_long: (f) => addAnimation(f, [0, 1], [0, 0, 0, 1, 0, 0, 0, 3], 'rotation'),
  animation_of_no_node: (f) => addAnimation(f, [0, 1], [0, 0, 0, 0, 1, 0], 'translation', { node: 999 }),
  animation_no_sampler: (f) => {
    addAnimation(f, [0, 1], [0, 0, 0, 0, 1, 0], 'translation');
    f.json.animations[0].channels[0].sampler = 3;
  },
};

/** Damages of the container itself. */
const OF_BYTES = {
  glb_version: (glb) => (glb.writeUInt32LE(3, 4), glb),
  glb_length_more: (glb) => (glb.writeUInt32LE(glb.length + 4, 8), glb),
  glb_length_less: (glb) => (glb.writeUInt32LE(glb.length - 8, 8), glb),
  glb_chunk_longer: (glb) => (glb.writeUInt32LE(glb.readUInt32LE(12) + 4, 12), glb),
  glb_chunk_type: (glb) => (glb.write('JSOM', 16, 'latin1'), glb),
  glb_cut_off: (glb) => glb.subarray(0, glb.length >> 1),
};

/** All mutants of a sound .glb as [name, bytes]. */
export function* mutants(glb) {
  yield ['none', join(split(glb))];
  for (const [name, damage] of Object.entries(DAMAGES)) {
    const file = split(glb);
    damage(file);
    yield [name, join(file)];
  }
  for (const [name, damage] of Object.entries(OF_BYTES)) yield [name, damage(Buffer.from(glb))];
}
