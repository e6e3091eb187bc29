// SPDX-License-Identifier: GPL-3.0-or-later
// From the texts that vtkio/packed_text.h makes back to numbers.
import { unzlibSync } from 'fflate';

function bytesOf(text) {
  return unzlibSync(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));
}

// Bytes come lowest first for all numbers, then the next one; numbers are differences to those a row before.
function unpack(text, Numbers, row) {
  const bytes = bytesOf(text);
  const size = Numbers.BYTES_PER_ELEMENT;
  const count = bytes.length / size;
  const numbers = new Numbers(count);
  for (let b = 0; b < size; ++b)
    for (let i = 0; i < count; ++i) numbers[i] |= bytes[b * count + i] << (8 * b);
  if (row > 0) for (let i = row; i < count; ++i) numbers[i] += numbers[i - row]; // modulo, as typed arrays do
  return numbers;
}

// Positions, fields and gaps of the bird or the target, frame by frame.
class Tracks {
  constructor(data) {
    this.count = data.count;
    this.row = 3 * data.count;
    this.low = data.low;
    this.step = data.high.map((high, k) => (high - data.low[k]) / 65535);
    this.moves = data.moves;
    this.places = unpack(data.position, Uint16Array, this.row);
    this.gone = data.gone ? unpack(data.gone, Uint8Array, data.cells) : null;
    this.fields = data.fields.map((field) => {
      const row = field.of === 'cells' ? data.cells : data.count;
      let values; // unpacked at first use
      return { ...field, at: (frame) => {
        values ??= unpack(field.values, Uint8Array, row);
        return values.subarray(frame * row, (frame + 1) * row);
      } };
    });
  }

  // Places of a frame: x y z of every point [m], into an array of the caller's.
  positions(frame, into) {
    const start = this.moves ? frame * this.row : 0;
    for (let i = 0; i < this.row; ++i) into[i] = this.low[i % 3] + this.step[i % 3] * this.places[start + i];
    return into;
  }

  field(name) { return this.fields.find((field) => field.name === name); }
}

export function decode(text) {
  const data = JSON.parse(text);
  const bird = new Tracks(data.bird);
  bird.spacing = data.bird.spacing;
  bird.parts = data.bird.parts;
  bird.part = unpack(data.bird.part, Uint8Array, 0);
  let target = null;
  if (data.target) {
    target = new Tracks(data.target);
    target.faces = unpack(data.target.faces, Uint32Array, 0);
    target.cells = data.target.cells;
  }
  const colours = data.colours.map((c) => [1, 3, 5].map((at) => parseInt(c.slice(at, at + 2), 16)));
  return { times: data.times, bird, target, colours, colourNames: data.colours };
}
