// An asset's data for renderers, apart from its buffers: levels of detail, draw orders, bounds. Types are in coif.d.ts.

import { RECORDS } from './records.mjs';

export class DrawnHair {
  constructor(asset) {
    this.asset = asset;
    this.coif = asset.coif;
    const { exports, memory } = this.coif;
    this.at = memory.take(RECORDS.DrawnHair.size, 'drawn hair');
    const status = exports.coif_drawn_hair_of(asset.open, this.at);
    if (status !== 0) {
      memory.give(this.at, RECORDS.DrawnHair.size);
      this.coif.check(status, 'drawnHair');
    }
    ++asset.users;
    const { lods, lodCount, ...rest } = this.coif.read('DrawnHair', this.at);
    Object.assign(this, rest, { lods: lods.slice(0, lodCount) });
    this.orderBytes = this.orderCount * this.indicesOfOrder * this.indexBytes;
  }

  /** Indices of all draw orders, to be uploaded once: level l of order k begins at k * indicesOfOrder + lods[l].first. */
  drawOrders() {
    const { exports, memory } = this.coif;
    this.orders ??= memory.take(this.orderBytes, 'draw orders');
    this.coif.check(exports.coif_write_draw_orders(this.asset.open, this.at, this.orders, this.orderBytes), 'drawOrders');
    const Indices = this.indexBytes === 2 ? Uint16Array : Uint32Array;
    return new Indices(memory.buffer, this.orders, this.orderCount * this.indicesOfOrder);
  }

  chooseOrder(direction) {
    const at = this.coif.fill('HeadVelocity', { linear: direction });
    return this.coif.exports.coif_choose_order(this.at, at);
  }

  /** The head's draw order; -1 if it is certainly out of view. */
  orderInView(head, eye, clipFromView) {
    const { exports, memory, scratch } = this.coif;
    this.coif.fill('HeadPose', head, 'coif_head_pose_init');
    const from = this.coif.fill('HeadVelocity', { linear: eye }, undefined, scratch + 64);
    const [clip, order] = [scratch + 128, scratch + 256];
    new Float32Array(memory.buffer, clip, 16).set(clipFromView);
    return exports.coif_is_in_view(this.at, scratch, from, clip, order) === 0 ? -1 : memory.view.getUint32(order, true);
  }

  /** Skins vertices on the processor: 9 floats each. The next call overwrites the view. */
  skinVertices(palette) {
    const { exports, memory } = this.coif;
    const count = this.asset.vertices.length / RECORDS.Vertex.size;
    this.skinnedBytes = count * RECORDS.SkinnedVertex.size;
    this.skinned ??= memory.take(this.skinnedBytes, 'skinned vertices');
    const status = exports.coif_skin_vertices(this.asset.open, palette.byteOffset, palette.length / 12, 0, this.skinned, count);
    this.coif.check(status, 'skinVertices');
    return new Float32Array(memory.buffer, this.skinned, count * 9);
  }

  /** A box around the hair in a pose, head space, metres. */
  bound(palette) {
    const { exports, memory, scratch } = this.coif;
    const count = this.boneCount;
    if (this.boxes === undefined) {
      this.boxes = memory.take(count * RECORDS.BoneBox.size, 'boxes of bones');
      this.coif.check(exports.coif_find_bone_boxes(this.asset.open, this.boxes, count), 'bound');
    }
    this.coif.check(exports.coif_bound_hair(this.boxes, palette.byteOffset, count, scratch), 'bound');
    return this.coif.read('Bounds', scratch);
  }

  dispose() {
    if (this.at === 0) return;
    const { memory } = this.coif;
    if (this.orders) memory.give(this.orders, this.orderBytes);
    if (this.skinned) memory.give(this.skinned, this.skinnedBytes);
    if (this.boxes) memory.give(this.boxes, this.boneCount * RECORDS.BoneBox.size);
    memory.give(this.at, RECORDS.DrawnHair.size);
    this.at = 0;
    --this.asset.users;
  }
}
