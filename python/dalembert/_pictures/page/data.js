// What pages get: a JSON head, and arrays behind it. The data of a motion (replay.py) are compressed, of floats their differences, and bytes
// sorted by significance; messages of the live page (messages.py) are as they are.

async function unpacked(base64) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const SPARE_BITS = 7; // of floats, that are not kept

// Whole numbers of four bytes each: all lowest bytes come first.
function gathered(bytes, count) {
  const result = new Uint8Array(4 * count);
  for (let k = 0; k < 4; ++k) for (let i = 0; i < count; ++i) result[4 * i + k] = bytes[k * count + i];
  return new Uint32Array(result.buffer);
}

// Floats, of whose bits as whole numbers there are the differences.
function summed(differences) {
  let bits = 0;
  return new Float32Array(differences.map((difference) => (bits = (bits + difference) | 0) << SPARE_BITS).buffer);
}

// Numbers of all frames, of what stands still in something that moves by its rows; number by number, as those are.
function carried(rows, local, form) {
  const frames = rows.length / 12, ball = form === "ball", result = new Float32Array(local.length * frames);
  const stay = (i) => result.fill(local[i], i * frames, (i + 1) * frames);
  // Three numbers, so far from each other: a point if it goes with the place, or a vector.
  const move = (first, step, goes) => {
    const [x, y, z] = [0, 1, 2].map((k) => local[first + k * step]);
    for (let row = 0; row < 3; ++row) {
      const [a, b, c, d] = [0, 1, 2, 3].map((k) => rows.subarray((4 * row + k) * frames, (4 * row + k + 1) * frames));
      const target = result.subarray((first + row * step) * frames, (first + row * step + 1) * frames);
      for (let i = 0; i < frames; ++i) target[i] = a[i] * x + b[i] * y + c[i] * z + (goes ? d[i] : 0);
    }
  };
  if (form === "points" || ball) {
    for (let first = 0; first + 2 < local.length; first += 3) move(first, 1, true);
    if (ball) stay(3);
    return result;
  }
  if (form === "place") local.forEach((_, i) => stay(i));
  else for (let column = 0; column < 3; ++column) move(column, 4, false);
  move(3, 4, true);
  return result;
}

export async function read(base64) {
  const bytes = await unpacked(base64);
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  let offset = 4 + length;
  const arrays = [];
  for (const { kind, bytes: size, by, form } of head.arrays) {
    const part = bytes.subarray(offset, offset + size);
    offset += size;
    if (kind === "u1") {
      arrays.push(part.slice());
      continue;
    }
    const words = gathered(part, size / 4);
    arrays.push(kind === "u4" ? words : kind === "f4" ? summed(words) : carried(arrays[by], summed(words), form));
  }
  return { head, arrays };
}

// Numbers of one frame out of those of all frames, number by number; `size` numbers per frame.
export function frame(values, size, number, target) {
  const frames = values.length / size;
  const at = Math.min(number, frames - 1);
  for (let i = 0; i < size; ++i) target[i] = values[i * frames + at];
  return target;
}

// Places, 12 numbers each, of six words: position, and the first two rows of the rotation; the third one is across them.
function turned(buffer, offset, count) {
  const numbers = new Float32Array(buffer, offset, count), turns = new Int16Array(buffer, offset, 2 * count), rows = new Float32Array(2 * count);
  for (let i = 0, k = 0; i < count; i += 6, k += 12) {
    for (let j = 0; j < 3; ++j) {
      rows[k + j] = turns[2 * i + 6 + j] / 32000;
      rows[k + 4 + j] = turns[2 * i + 9 + j] / 32000;
      rows[k + 4 * j + 3] = numbers[i + j];
    }
    for (let j = 0; j < 3; ++j) {
      const m = (j + 1) % 3, n = (j + 2) % 3;
      rows[k + 8 + j] = rows[k + m] * rows[k + 4 + n] - rows[k + n] * rows[k + 4 + m];
    }
  }
  return rows;
}

// A message of the server; null stands for an array that is as before.
export function message(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const types = { f4: Float32Array, u4: Uint32Array, u1: Uint8Array };
  let offset = 4 + length;
  const arrays = head.arrays.map((entry) => {
    if (!entry) return null;
    const [kind, count] = entry, Type = types[kind], start = offset;
    offset += kind === "u1" ? Math.ceil(count / 4) * 4 : 4 * count;
    return kind === "r6" ? turned(buffer, start, count) : new Type(buffer, start, count);
  });
  return { head, arrays };
}

// Numbers of which some are as they were: [where, from where in the ones before, how many], and those between them were sent.
export function joined(sent, kept, before) {
  const all = new Float32Array(kept.reduce((sum, [, , count]) => sum + count, sent.length));
  let filled = 0, used = 0;
  for (const [at, from, count] of [...kept, [all.length, 0, 0]]) {
    all.set(sent.subarray(used, used + at - filled), filled);
    used += at - filled;
    all.set(before.subarray(from, from + count), at);
    filled = at + count;
  }
  return all;
}
