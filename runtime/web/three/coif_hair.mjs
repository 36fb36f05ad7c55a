// Hair in a scene of three's. ../three.d.ts documents types and members.

import { DynamicDrawUsage, InstancedBufferGeometry, InstancedInterleavedBuffer, InterleavedBufferAttribute, BufferAttribute, Matrix4, Mesh, Object3D,
  Quaternion, REVISION, Sphere, Vector3, Vector4 } from 'three';

import { CoifError } from '../memory.mjs';
import { attributesOf, paletteTexture, texturesOf } from './buffers.mjs';
import { FollowedHead } from './followed_head.mjs';
import { passMaterial, passesOf, shadowMaterials } from './passes.mjs';

const OLDEST_THREE = 157; // its shaders hand lights on as those of hair take them
const HEAD_FLOATS = 16; // three rows of a matrix, the head's number, and nothing

const toLocal = new Matrix4(), rowsOf = new Matrix4(), eye = new Vector3(), way = new Vector3(), back = new Quaternion();
const sphere = new Sphere();

/** Older ones would draw nothing and complain of shaders. */
function checkThree() {
  if (!(Number.parseInt(REVISION, 10) < OLDEST_THREE)) return;
  throw new CoifError(`coif/three draws with three 0.${OLDEST_THREE}.0 or later, and this page has loaded three 0.${REVISION}: ` +
    "run 'npm install three@latest', or change three's address in the page's import map");
}

export class CoifHair extends Object3D {
  constructor(asset, { instances = 1, transparency = 'blend', desc = {}, settings = {}, material = {} } = {}) {
    checkThree();
    super();
    this.type = 'CoifHair';
    this.asset = asset;
    this.settings = { ...settings };
    this.hair = asset.createHair({ ...desc, instances });
    this.drawn = asset.drawnHair();
    this.material = { ...this.drawn.material, ...material };
    this.skinning = this.drawn.skinning;
    this.attributes = attributesOf(asset);
    this.textures = texturesOf(asset, this.attributes.texture_place);
    this.palettes = this.skinning === 0 ? null : paletteTexture(asset.coif, this.hair);
    this.index = new BufferAttribute(this.drawn.drawOrders().slice(), 1);
    this.heads = Array.from({ length: instances }, (_, number) => new FollowedHead(number, this));
    this.reach = new Sphere(new Vector3(...this.drawn.reach.center), this.drawn.reach.radius);
    this.batches = new Map();
    this.casts = this.receives = true;
    this.uniforms = this.#uniforms();
    this.shadows = shadowMaterials(this);
    this.transparency = transparency;
    this.hasStarted = false;
  }

  /** Values of the shaders that materials share. */
  #uniforms() {
    const { base, shiftMask, normals, strands } = this.textures;
    const uniforms = { base_color: {}, primary: {}, secondary: {}, shift: {}, component: {}, fiber: {},
      base_texture: { value: base }, shift_mask_texture: { value: shiftMask }, normal_texture: { value: normals },
      strand_texture: { value: strands }, palette_texture: { value: this.palettes }, bone_count: { value: this.hair.boneCount } };
    this.uniforms = uniforms;
    this.updateMaterial();
    return uniforms;
  }

  /** Applies changed members of `material`. */
  updateMaterial(changes = {}) {
    const m = Object.assign(this.material, changes);
    const { uniforms } = this;
    uniforms.base_color.value = new Vector4(...m.baseColor);
    uniforms.primary.value = new Vector4(...m.primaryColor, m.primaryExponent);
    uniforms.secondary.value = new Vector4(...m.secondaryColor, m.secondaryExponent);
    uniforms.shift.value = new Vector4(m.primaryShift, m.secondaryShift, 0, 0);
    const lights = 1 - m.lightCut;
    uniforms.component.value = new Vector4(1, lights, lights, lights);
    uniforms.fiber.value = new Vector4(m.tilt, m.roughness, m.scatter, 0);
    if (this.way !== undefined) this.transparency = this.way; // thresholds and models are in the passes
  }

  get transparency() {
    return this.way;
  }
  set transparency(mode) {
    const passes = passesOf(mode, this.material, this.drawn.alpha);
    this.#dropBatches();
    this.way = mode;
    this.passes = passes.map((each) => ({ ...each, material: passMaterial(this, each) }));
  }

  /** Lets the head follow `object`; without it, this object. */
  follow(head, object = this, bone = {}) {
    if (!(head in this.heads)) throw new RangeError(`there is no head ${head}`);
    this.heads[head].follow(object, bone);
  }

  update(delta, camera) {
    if (this.hasStarted) {
      this.#place();
      this.hair.setHeads();
      this.settings.dt = delta;
      this.hair.step(this.settings);
    } else {
      this.reset();
    }
    if (this.palettes !== null) this.palettes.needsUpdate = true;
    this.#sort(camera);
  }

  /** Brings the hair to rest in its rest pose, at the heads' present places. */
  reset() {
    this.#place();
    for (const { number, isPlaced, position, rotation, scale } of this.heads) {
      if (isPlaced) this.hair.reset(number, { position, rotation, scale });
    }
    this.hasStarted = true;
  }

  /** Moves heads to the present places of the objects that they follow. */
  #place() {
    this.updateWorldMatrix(true, false);
    toLocal.copy(this.matrixWorld).invert();
    for (const head of this.heads) {
      if (head.followed !== this) head.followed.updateWorldMatrix(true, false);
      head.place(this.hair, toLocal);
    }
  }

  /** Heads that share a level of detail and an order of triangles are drawn at once, the far ones first. */
  #sort(camera) {
    camera.updateWorldMatrix(true, false);
    eye.setFromMatrixPosition(camera.matrixWorld);
    for (const batch of this.batches.values()) batch.heads.length = 0;
    for (const head of this.heads) {
      way.copy(eye).sub(head.position);
      head.distance = way.length();
      if (camera.isPerspectiveCamera) this.#chooseLevel(head, (camera.fov * Math.PI) / 180);
      way.applyQuaternion(back.copy(head.rotation).conjugate());
      const order = this.drawn.orderCount > 1 ? this.drawn.chooseOrder(way.toArray()) : 0;
      this.#batch(head.lod, order).heads.push(head);
    }
    for (const batch of this.batches.values()) this.#fill(batch);
  }

  #chooseLevel(head, fov) {
    if (this.drawn.lodCount < 2) return;
    const share = this.asset.coif.screenShare(2 * this.reach.radius, Math.max(head.distance / head.scale, 1e-3), fov);
    head.lod = this.asset.chooseLod(share, head.lod);
  }

  #batch(lod, order) {
    const key = lod * this.drawn.orderCount + order;
    let batch = this.batches.get(key);
    if (batch === undefined) this.batches.set(key, (batch = this.#makeBatch(lod, order)));
    return batch;
  }

  #makeBatch(lod, order) {
    const rows = new InstancedInterleavedBuffer(new Float32Array(HEAD_FLOATS * this.hair.instances), HEAD_FLOATS);
    rows.setUsage(DynamicDrawUsage);
    const geometry = new InstancedBufferGeometry();
    for (const [name, attribute] of Object.entries(this.attributes)) geometry.setAttribute(name, attribute);
    ['head_x', 'head_y', 'head_z'].forEach((name, row) => geometry.setAttribute(name, new InterleavedBufferAttribute(rows, 4, 4 * row)));
    geometry.setAttribute('head', new InterleavedBufferAttribute(rows, 1, 12));
    geometry.setIndex(this.index);
    const { first, count } = this.drawn.lods[lod];
    geometry.setDrawRange(order * this.drawn.indicesOfOrder + first, count);
    geometry.boundingSphere = new Sphere();
    const meshes = this.passes.map((each) => this.#makeMesh(geometry, each));
    meshes[meshes.length - 1].castShadow = this.casts;
    return { rows, geometry, meshes, heads: [] };
  }

  #makeMesh(geometry, { name, material, writesColor }) {
    const mesh = new Mesh(geometry, material);
    mesh.name = name;
    mesh.receiveShadow = this.receives && writesColor;
    mesh.customDepthMaterial = this.shadows.depth;
    mesh.customDistanceMaterial = this.shadows.distance;
    mesh.raycast = () => {}; // the drawn hair is not where the mesh at rest is
    this.add(mesh);
    return mesh;
  }

  #fill({ rows, geometry, meshes, heads }) {
    meshes.forEach((mesh) => (mesh.visible = heads.length > 0));
    geometry.instanceCount = heads.length;
    if (heads.length === 0) return;
    heads.sort((a, b) => b.distance - a.distance);
    const bound = geometry.boundingSphere.makeEmpty();
    heads.forEach(({ number, matrix }, i) => {
      const to = rows.array;
      const at = HEAD_FLOATS * i;
      rowsOf.copy(matrix).transpose();
      for (let k = 0; k < 12; ++k) to[at + k] = rowsOf.elements[k];
      to[at + 12] = number;
      bound.union(sphere.copy(this.reach).applyMatrix4(matrix));
    });
    rows.needsUpdate = true;
  }

  #dropBatches() {
    for (const { geometry, meshes } of this.batches.values()) {
      meshes.forEach((mesh) => this.remove(mesh));
      geometry.dispose();
    }
    this.batches.clear();
    this.passes?.forEach(({ material }) => material.dispose());
  }

  /** Frees its memory of three's and of the module's; the asset stays. */
  dispose() {
    this.#dropBatches();
    for (const texture of [...Object.values(this.textures), this.palettes]) texture?.dispose();
    this.shadows.depth.dispose();
    this.shadows.distance.dispose();
    this.drawn.dispose();
    this.hair.dispose();
  }
}
