// SPDX-License-Identifier: GPL-3.0-or-later
// What is on the screen, as numbers: the browser itself decodes its screenshots.
export class Pixels {
  constructor(width, height, data) { Object.assign(this, { width, height, data }); }

  static async of(page, selector) {
    const png = (await page.locator(selector).screenshot({ style: '#time-stamp, .looks { visibility: hidden }' })).toString('base64');
    const { width, height, data } = await page.evaluate(async (text) => {
      const image = new Image();
      image.src = `data:image/png;base64,${text}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      let bytes = '';
      for (let i = 0; i < data.length; i += 4096) bytes += String.fromCharCode(...data.subarray(i, i + 4096));
      return { width: image.width, height: image.height, data: btoa(bytes) };
    }, png);
    return new Pixels(width, height, Buffer.from(data, 'base64'));
  }

  at(x, y) {
    const i = 4 * (Math.round(y) * this.width + Math.round(x));
    return [this.data[i], this.data[i + 1], this.data[i + 2]];
  }

  // Number of pixels for which the test of (r, g, b) holds.
  count(test) {
    let count = 0;
    for (let i = 0; i < this.data.length; i += 4) count += test(this.data[i], this.data[i + 1], this.data[i + 2]) ? 1 : 0;
    return count;
  }

  // Different colours, in steps of 16.
  colours() {
    const seen = new Set();
    for (let i = 0; i < this.data.length; i += 4) seen.add((this.data[i] >> 4) * 256 + (this.data[i + 1] >> 4) * 16 + (this.data[i + 2] >> 4));
    return seen.size;
  }

  // Share of the pixels that differ clearly.
  differs(other) {
    let count = 0;
    for (let i = 0; i < this.data.length; i += 4)
      count += Math.abs(this.data[i] - other.data[i]) + Math.abs(this.data[i + 1] - other.data[i + 1]) + Math.abs(this.data[i + 2] - other.data[i + 2]) > 24 ? 1 : 0;
    return count / (this.width * this.height);
  }
}
