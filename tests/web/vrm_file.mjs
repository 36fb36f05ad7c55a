// A VRM file, loaded in node by three-vrm: pictures are left out.

import { readFileSync } from 'node:fs';

globalThis.self ??= globalThis;
globalThis.createImageBitmap ??= async () => ({ width: 1, height: 1, close() {} });
const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
const { VRMLoaderPlugin } = await import('@pixiv/three-vrm');

export async function loadVrm(file) {
  const bytes = new Uint8Array(readFileSync(file)).slice();
  const loader = new GLTFLoader();
  loader.register((parser) => new VRMLoaderPlugin(parser));
  return (await loader.parseAsync(bytes.buffer, '')).userData.vrm;
}
