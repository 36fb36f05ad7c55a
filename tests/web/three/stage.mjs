// In the browser: a scene of three's with hair in it, and what tests ask about its pictures.

import * as THREE from 'three';
import { loadCoif } from 'coif';
import { CoifHair } from 'coif/three';

const SIZE = 256;

export async function makeStage() {
  const renderer = new THREE.WebGLRenderer({ antialias: true });
  renderer.setSize(SIZE, SIZE, false);
  renderer.shadowMap.enabled = true;
  document.body.append(renderer.domElement);
  const coif = await loadCoif({ memoryBytes: 32 << 20 });
  const asset = coif.openAsset(await (await fetch('/asset.coif')).arrayBuffer());
  return new Stage(renderer, coif, asset);
}

class Stage {
  constructor(renderer, coif, asset) {
    Object.assign(this, { renderer, coif, asset, three: THREE });
    this.clear();
  }

  /** An empty scene with a sun in front of it, and a camera that looks at the origin from +Z. */
  clear() {
    this.hair?.dispose();
    this.hair = undefined;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(0, 0, 1);
    this.scene.add(new THREE.AmbientLight(0xffffff, 0.5));
    this.sun = new THREE.DirectionalLight(0xffffff, 3);
    this.sun.position.set(0, 1, 2);
    this.sun.shadow.mapSize.set(512, 512);
    this.sun.shadow.bias = -0.003;
    Object.assign(this.sun.shadow.camera, { left: -0.6, right: 0.6, top: 0.6, bottom: -0.6, near: 0.1, far: 5 });
    this.scene.add(this.sun);
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.05, 20);
    this.camera.position.set(0, 0, 1.4);
  }

  wear(options) {
    this.hair?.removeFromParent();
    this.hair?.dispose();
    this.hair = new CoifHair(this.asset, options);
    this.scene.add(this.hair);
    return this.hair;
  }

  /** What a head may follow, turned about the vertical. */
  holder(place, turn = 0) {
    const object = new THREE.Object3D();
    object.position.set(...place);
    object.rotation.y = turn;
    this.scene.add(object);
    return object;
  }

  /** A thing of three's own: a plate that faces the camera. */
  plate(z, { color = 0x00ff00, opacity = 1, size = 1 } = {}) {
    const material = new THREE.MeshBasicMaterial({ color, opacity, transparent: opacity < 1, side: THREE.DoubleSide });
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(size, size), material);
    mesh.position.z = z;
    this.scene.add(mesh);
    return mesh;
  }

  /** RGBA bytes, bottom row first. */
  picture(delta = 0) {
    this.hair?.update(delta, this.camera);
    this.renderer.render(this.scene, this.camera);
    const gl = this.renderer.getContext();
    const pixels = new Uint8Array(4 * SIZE * SIZE);
    gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  }

  /** Counts a picture's pixels that are not the background's blue, and averages their colours. */
  look(pixels = this.picture()) {
    let count = 0;
    const mean = [0, 0, 0];
    for (let i = 0; i < pixels.length; i += 4) {
      if (pixels[i] === 0 && pixels[i + 1] === 0 && pixels[i + 2] === 255) continue;
      ++count;
      for (let k = 0; k < 3; ++k) mean[k] += pixels[i + k];
    }
    return { count, mean: mean.map((sum) => sum / Math.max(count, 1)) };
  }

  /** How many pixels of two pictures differ by more than rounding, and the largest difference. */
  compare(a, b) {
    let count = 0, most = 0;
    for (let i = 0; i < a.length; ++i) {
      const off = Math.abs(a[i] - b[i]);
      if (off > 2) ++count;
      most = Math.max(most, off);
    }
    return { count, most };
  }

  async loseContext() {
    const loss = this.renderer.getContext().getExtension('WEBGL_lose_context');
    const once = (name) => new Promise((done) => this.renderer.domElement.addEventListener(name, () => setTimeout(done, 50), { once: true }));
    const [lost, back] = [once('webglcontextlost'), once('webglcontextrestored')];
    loss.loseContext();
    await lost;
    loss.restoreContext();
    await back;
  }
}
