// The body beneath the hair, from `coif view --body`.

/** The numbers of a text in base64. */
function bytesOf(text) {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
}

/** Pixels of a file's image, RGBA, as the file has them: without the screen's colours and without alpha in the colour. */
async function pixelsOf(bytes) {
  const image = await createImageBitmap(new Blob([bytes], { type: 'image/webp' }),
    { premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  const pen = canvas.getContext('2d', { willReadFrequently: true });
  pen.drawImage(image, 0, 0);
  return pen.getImageData(0, 0, image.width, image.height);
}

/**
 * Gives `wasm` the body in `text`, which is {"meshes": base64, "images": [base64 of a WebP file]}; does nothing where the page has
 * none. Before an asset is opened.
 */
export async function takeBody(wasm, text) {
  if (!text.startsWith('{')) return;
  const { meshes, images } = JSON.parse(text);
  wasm.body(bytesOf(meshes));
  for (const [number, image] of images.entries()) {
    try {
      const { width, height, data } = await pixelsOf(bytesOf(image));
      wasm.bodyImage(number, width, height, data);
    } catch (error) {
      console.warn(`image ${number} of the body: ${error.message}`);  // it stays without one
    }
  }
}
