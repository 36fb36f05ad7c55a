// The module's memory: allocation of its parts, and views into it. It never grows, so views stay valid.

const ALIGNMENT = 64; // of assets, crowds and all else

/** An error with a sentence; `status` is the name of the C interface's status, or 'COIF_REFUSED' if the call never reached it. */
export class CoifError extends Error {
  constructor(message, status = 'COIF_REFUSED') {
    super(message);
    this.name = 'CoifError';
    this.status = status;
  }
}

const rounded = (bytes) => Math.ceil(Math.max(bytes, 1) / ALIGNMENT) * ALIGNMENT;
const megabytes = (bytes) => (bytes / 1048576).toFixed(1);

/** First fit over a list of free parts, in order of address. Used when objects are created, never in a frame. */
export class Memory {
  /** @param {WebAssembly.Memory} memory @param {number} begin first byte that the module itself does not use */
  constructor(memory, begin) {
    this.buffer = memory.buffer;
    this.bytes = new Uint8Array(this.buffer);
    this.view = new DataView(this.buffer);
    const first = rounded(begin);
    this.free = [{ at: first, size: this.buffer.byteLength - first }];
  }

  /** Address of `bytes` zero bytes. Throws if there is no room. */
  take(bytes, what) {
    const size = rounded(bytes);
    const part = this.free.find((each) => each.size >= size);
    if (part === undefined) {
      throw new CoifError(
        `${what} of ${megabytes(size)} MB does not fit: ${megabytes(this.freeBytes)} of ${megabytes(this.buffer.byteLength)} MB are free; ` +
          'give loadCoif() more memoryBytes, or dispose() of what is no longer needed', 'COIF_MEMORY_TOO_SMALL');
    }
    const at = part.at;
    part.at += size;
    part.size -= size;
    if (part.size === 0) this.free.splice(this.free.indexOf(part), 1);
    this.bytes.fill(0, at, at + size);
    return at;
  }

  /** Frees `bytes` bytes at the address `at`, which take() returned. */
  give(at, bytes) {
    const part = { at, size: rounded(bytes) };
    const next = this.free.findIndex((each) => each.at > at);
    const place = next < 0 ? this.free.length : next;
    this.free.splice(place, 0, part);
    this.#join(place);
    if (place > 0) this.#join(place - 1);
  }

  get freeBytes() {
    return this.free.reduce((sum, part) => sum + part.size, 0);
  }

  /** The text that ends with a zero byte at `at`. */
  text(at) {
    let end = at;
    while (this.bytes[end] !== 0) ++end;
    return new TextDecoder().decode(this.bytes.subarray(at, end));
  }

  #join(place) {
    const [part, next] = [this.free[place], this.free[place + 1]];
    if (next === undefined || part.at + part.size !== next.at) return;
    part.size += next.size;
    this.free.splice(place + 1, 1);
  }
}
